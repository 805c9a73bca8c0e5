#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

// The arrows of ARCHITECTURE.md, read off the #include lines: app -> scenegraph -> haptics -> device.

namespace {

namespace fs = std::filesystem;

struct Include {
  std::string file;  // from the project's root
  int line = 0;
  std::string target;
};

std::vector<Include> includesBelow(const std::string& folder) {
  const fs::path root = HAPTIV_SOURCE_DIR;
  const std::regex pattern(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::vector<Include> includes;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    std::ifstream stream(entry.path());
    std::string text;
    std::smatch match;
    for (int line = 1; std::getline(stream, text); ++line) {
      if (std::regex_search(text, match, pattern))
        includes.push_back({fs::relative(entry.path(), root).string(), line, match[1]});
    }
  }
  return includes;
}

// Nothing below `folder`, files that match `except` aside, may include what matches `forbidden`.
void expectNoInclude(const std::string& folder, const std::string& forbidden, const std::string& except = "$^") {
  const std::regex wrong(forbidden), allowed(except);
  const std::vector<Include> includes = includesBelow(folder);
  EXPECT_FALSE(includes.empty()) << folder << " holds no sources: has it moved?";
  for (const Include& include : includes) {
    if (std::regex_search(include.file, allowed)) continue;
    EXPECT_FALSE(std::regex_search(include.target, wrong))
        << include.file << ":" << include.line << " includes " << include.target;
  }
}

constexpr const char* kCoin = "^Inventor/|^SoQt";
constexpr const char* kQt = "^Q[A-Z]|^Qt|^Inventor/Qt|^qwt";
constexpr const char* kHdf5 = "^(hdf5|H5)";
constexpr const char* kLibusb = "^libusb";

}  // namespace

TEST(Layers, DeviceKnowsNoneOfTheOthers) {
  expectNoInclude("device", "^(haptics|scenegraph|app)/");
}
TEST(Layers, HapticsKnowsOnlyTheDevice) {
  expectNoInclude("haptics", "^(scenegraph|app)/");
}
TEST(Layers, WhatATickIsMadeOfDoesNotKnowTheTick) {
  expectNoInclude("haptics", "^haptics/(tick|servo)/", "^haptics/(tick|servo)/");
  expectNoInclude("haptics/tick", "^haptics/servo/");
}
TEST(Layers, ScenegraphKnowsNothingOfTheApplication) {
  expectNoInclude("scenegraph", "^app/");
}

TEST(Layers, CoinStaysInScenegraphAndApp) {
  expectNoInclude("device", kCoin);
  expectNoInclude("haptics", kCoin);
  expectNoInclude("app/session", kCoin);
  expectNoInclude("app/devicecheck", kCoin);
}

TEST(Layers, QtStaysInApp) {
  for (const char* folder : {"device", "haptics", "scenegraph", "app/session", "app/devicecheck"})
    expectNoInclude(folder, kQt);
}

TEST(Layers, Hdf5StaysInTheSessionLog) {
  for (const char* folder : {"device", "haptics", "scenegraph"}) expectNoInclude(folder, kHdf5);
  expectNoInclude("app", kHdf5, "^app/session/log/");
}

TEST(Layers, LibusbStaysInTheUsbTransport) {
  expectNoInclude("device", kLibusb, "^device/usb/");
  for (const char* folder : {"haptics", "scenegraph", "app"}) expectNoInclude(folder, kLibusb);
}

TEST(Layers, TheBoardsSideOfTheWireKnowsNothingOfTheHosts) {
  for (const char* folder : {"device/board", "device/usb/peripheral", "device/usb/protocol", "device/usb/virtual"})
    expectNoInclude(folder, "^device/usb/(host|libusb|falcon|spacemouse|UsbDevice)|^libusb");
}
TEST(Layers, TheSessionLibraryNeedsNoSceneGraph) {
  expectNoInclude("app/session", "^scenegraph/");
}
TEST(Layers, TheSceneViewKnowsNothingOfEditorReplayAndWindow) {
  expectNoInclude("app/view", "^app/(editor|replay|window|commands)/");
}
TEST(Layers, TheEditorKnowsNothingOfSessionsAndReplay) {
  expectNoInclude("app/editor", "^app/(session|replay|window)/");
}
TEST(Layers, FiguresKnowNothingOfWhatTheyShow) {
  expectNoInclude("app/figures", "^(device|haptics|scenegraph)/|^app/(?!figures/)");
}
TEST(Layers, TheExperimentsNeedNoQt) {
  expectNoInclude("app/experiments", kQt);
  expectNoInclude("app/experiments", "^app/(?!experiments/|figures/Figure.h)");
}
