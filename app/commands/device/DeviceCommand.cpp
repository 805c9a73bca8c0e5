#include "app/commands/device/DeviceCommand.h"

#include "app/commands/device/DeviceCalibrateCommand.h"
#include "app/commands/device/DeviceCheckCommand.h"
#include "app/commands/device/DeviceHomeCommand.h"
#include "app/commands/device/DeviceListCommand.h"
#include "app/commands/device/DeviceMonitorCommand.h"

namespace haptiv {

void addDeviceCommand(const Command& program) {
  const Command device =
      program.addGroup("device", "What devices there are, what an arm can do; calibration and homing");
  addDeviceListCommand(device);
  addDeviceCheckCommand(device);
  addDeviceMonitorCommand(device);
  addDeviceCalibrateCommand(device);
  addDeviceHomeCommand(device);
}

}  // namespace haptiv
