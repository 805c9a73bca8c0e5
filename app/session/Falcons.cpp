#include "app/session/Falcons.h"

#include <string_view>

namespace haptiv {
namespace {

constexpr std::string_view kFalconOf = "falcon:";  // and its serial number or port

}  // namespace

bool isFalcon(const std::string& device) {
  return device == "falcon" || device.starts_with(kFalconOf);
}

FalconChoice falconChoiceOf(const std::string& device, const std::string& firmware) {
  FalconChoice choice;
  if (device.starts_with(kFalconOf)) choice.which = device.substr(kFalconOf.size());
  choice.firmware = firmware;
  return choice;
}

}  // namespace haptiv
