#include "app/commands/device/DeviceCommand.h"

#include "app/commands/device/DeviceCheckCommand.h"
#include "app/commands/device/DeviceListCommand.h"

namespace haptiv {

void addDeviceCommand(const Command& program) {
  const Command device = program.addGroup("device", "What devices there are, and what an arm can do");
  addDeviceListCommand(device);
  addDeviceCheckCommand(device);
}

}  // namespace haptiv
