#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/CommandLine.h"
#include "tests/app/commands/TestFolder.h"
#include "tests/device/usb/bench/BoardOnUsb.h"
#include "tests/device/usb/falcon/BenchedFalcon.h"
#include "tests/device/usb/spacemouse/VirtualSpaceMouse.h"
#include "tests/support/usb/RunningBus.h"

namespace haptiv {

/// The command line on a machine with a virtual USB bus below real libusb: in this process, as the bus is.
class BusCommands : public ::testing::Test {
 protected:
  BusCommands() {
    unsetenv("HAPTIV_FALCON_FIRMWARE");
    setenv("XDG_DATA_HOME", (folder_ / "data").c_str(), 1);
  }

  /// Runs `haptiv ARGS`: its exit code, and what it says.
  int run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "haptiv");
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    const int code = runCommandLine(static_cast<int>(argv.size()), argv.data());
    out_ = ::testing::internal::GetCapturedStdout();
    err_ = ::testing::internal::GetCapturedStderr();
    return code;
  }
  nlohmann::json json() const { return nlohmann::json::parse(out_, nullptr, false); }

  test::VirtualPort& plugBoard(const std::string& serial) {
    board_ = std::make_shared<test::BoardOnUsb>(loadDeviceDescription("vishard10"), serial);
    return bus_.plug(board_);
  }
  test::VirtualPort& plugFalcon() {
    falcon_ = std::make_shared<falcon::test::FalconOnUsb>(loadDeviceDescription("falcon"));
    return bus_.plug(falcon_);
  }
  test::VirtualPort& plugMouse() { return bus_.plug(std::make_shared<test::VirtualSpaceMouse>()); }
  std::string firmware() { return folder_.write("novint.bin", std::string(4096, '\x7f')); }

  TestFolder folder_;
  test::VirtualBus bus_;
  std::shared_ptr<test::BoardOnUsb> board_;
  std::shared_ptr<falcon::test::FalconOnUsb> falcon_;
  std::string out_, err_;
};

}  // namespace haptiv
