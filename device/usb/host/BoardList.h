#pragma once

#include <string>
#include <vector>

namespace haptiv::usb {

/// An interface board that is plugged in.
struct ListedBoard {
  std::string serial;   ///< empty: could not be read
  std::string product;  ///< as it calls itself
  int bus = 0, address = 0;
  bool highSpeed = false;
  std::string trouble;  ///< why it cannot be opened, and what to do; empty: it can
};

/// All of them. Throws UsbFailure where USB devices cannot be listed. Waits for each; not for the servo.
std::vector<ListedBoard> listBoards();

}  // namespace haptiv::usb
