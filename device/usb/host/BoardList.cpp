#include "device/usb/host/BoardList.h"

#include "device/usb/host/BoardRequests.h"

namespace haptiv::usb {

std::vector<ListedBoard> listBoards() {
  const UsbContext context;
  std::vector<ListedBoard> list;
  for (const FoundUsb& found : findUsb(context, boardKind()))
    list.push_back({found.serial, found.product, found.bus, found.address, found.highSpeed, found.trouble});
  return list;
}

}  // namespace haptiv::usb
