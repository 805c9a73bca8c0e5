#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "tests/architecture/Sources.h"

// The arrows of ARCHITECTURE.md, read off the #include lines: app -> scenegraph -> haptics -> device.

namespace {

using haptiv::testing::find;
using haptiv::testing::Found;

// Nothing below `folder`, files that match `except` aside, may include what matches `forbidden`.
void expectNoInclude(const std::string& folder, const std::string& forbidden, const std::string& except = "$^") {
  const std::regex wrong(forbidden), allowed(except);
  const std::vector<Found> includes = haptiv::testing::includesBelow(folder);
  EXPECT_FALSE(includes.empty()) << folder << " holds no sources: has it moved?";
  for (const Found& include : includes) {
    if (std::regex_search(include.file, allowed)) continue;
    EXPECT_FALSE(std::regex_search(include.text, wrong))
        << include.file << ":" << include.line << " includes " << include.text;
  }
}

constexpr const char* kCoin = "^Inventor/|^SoQt";
constexpr const char* kQt = "^Q[A-Z]|^Qt|^Inventor/Qt|^qwt";
constexpr const char* kHdf5 = "^(hdf5|H5)";
constexpr const char* kLocks = "^(mutex|shared_mutex|condition_variable|semaphore|future|semaphore.h)$";
constexpr const char* kLibusb = "^libusb";

constexpr const char* kWithoutWindow[] = {"device",          "haptics",   "app/session",  "app/calibration",
                                          "app/devicecheck", "app/board", "app/generate", "app/experiments"};

}  // namespace

TEST(Layers, DeviceKnowsNoneOfTheOthers) {
  expectNoInclude("device", "^(haptics|scenegraph|app)/");
}
TEST(Layers, ADeviceIsDescribedAndDrivenWithoutItsSimulation) {
  expectNoInclude("device", "^device/simulated/", "^device/(simulated|usb/virtual)/");
}
TEST(Layers, HapticsKnowsOnlyTheDevice) {
  expectNoInclude("haptics", "^(scenegraph|app)/");
}
TEST(Layers, ShapesAndMeshesKnowNoScene) {
  for (const char* folder : {"haptics/geometry", "haptics/shapes", "haptics/meshes", "haptics/index"})
    expectNoInclude(folder, "^haptics/(?!geometry|shapes|meshes|index)");
}
TEST(Layers, WhatATickIsMadeOfDoesNotKnowTheTick) {
  expectNoInclude("haptics", "^haptics/(tick|servo)/", "^haptics/(tick|servo)/");
  expectNoInclude("haptics/tick", "^haptics/servo/");
}
TEST(Layers, ScenegraphKnowsNothingOfTheApplication) {
  expectNoInclude("scenegraph", "^app/");
}

TEST(Layers, CoinStaysInScenegraphAndApp) {
  for (const char* folder : kWithoutWindow) expectNoInclude(folder, kCoin);
}

TEST(Layers, QtStaysInApp) {
  for (const char* folder : kWithoutWindow) expectNoInclude(folder, kQt);
  expectNoInclude("scenegraph", kQt);
}

TEST(Layers, NobodyWaitsForALockWhereTheServoComes) {
  expectNoInclude("haptics", kLocks);
  expectNoInclude("device", kLocks, "^device/usb/libusb/");
}

TEST(Layers, UsbIpIsSpokenWithoutSockets) {
  expectNoInclude("app/board/usbip", "^(sys/|netinet/|arpa/|poll.h|unistd.h)");
}

TEST(Layers, Hdf5StaysInItsWrapperInTheSessionLog) {
  for (const char* folder : {"device", "haptics", "scenegraph"}) expectNoInclude(folder, kHdf5);
  expectNoInclude("app", kHdf5, "^app/session/log/hdf5/");
}

TEST(Layers, WhatALogHoldsIsKnownByWriterAndReaderAlike) {
  expectNoInclude("app/session/log/hdf5", "^app/session/(?!log/hdf5/)");
  expectNoInclude("app/session/log/contents", "^app/session/log/(writing|reading)/");
  expectNoInclude("app/session/log/writing", "^app/session/log/reading/");
  expectNoInclude("app/session/log/reading", "^app/session/log/writing/");
}

TEST(Layers, WhatIsKeptOfASessionIsKeptWithoutKnowingIt) {
  expectNoInclude("app/session/recording", "^app/session/(?!recording/|log/)");
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
TEST(Layers, WhatIsDrawnDoesNotKnowTheViewOfIt) {
  expectNoInclude("app/view/drawn", "^app/view/(?!drawn/|ellipsoids/)");
  expectNoInclude("app/view/ellipsoids", "^app/view/(?!ellipsoids/)");
}
TEST(Layers, TheEditorKnowsNothingOfSessionsAndReplay) {
  expectNoInclude("app/editor", "^app/(session|replay|window)/");
}
TEST(Layers, TheEditedDocumentKnowsNothingOfWhatEditsIt) {
  for (const std::string room : {"document", "items"})
    expectNoInclude("app/editor/" + room, "^app/editor/(?!" + room + "/)");
  expectNoInclude("app/editor/commands", "^app/editor/(edits|panels|handles)/");
  expectNoInclude("app/editor/edits", "^app/editor/(panels|handles)/");
}
TEST(Layers, FiguresKnowNothingOfWhatTheyShow) {
  expectNoInclude("app/figures", "^(device|haptics|scenegraph)/|^app/(?!figures/)");
}
TEST(Layers, TheExperimentsNeedFiguresAlone) {
  expectNoInclude("app/experiments", "^app/(?!experiments/|figures/Figure.h)");
}

// But for HDF5's one lock, and for constants that Coin wants to have the address of.
TEST(Absences, NothingIsRememberedOutsideOfValues) {
  const std::regex allowed("^(app/session/log/hdf5/Hdf5|scenegraph/reading/coin/NurbsContext)\\.cpp$");
  for (const char* folder : {"device", "haptics", "scenegraph", "app"}) {
    for (const Found& found : find(folder, R"(^\s*(?:static|thread_local)\s+(?!const\b|constexpr\b)([^()]*)[;={])"))
      EXPECT_TRUE(std::regex_match(found.file, allowed)) << found.file << ":" << found.line << ": " << found.text;
  }
}

TEST(Absences, CoinOpensNoFile) {
  for (const char* folder : {"scenegraph", "app"}) {
    for (const Found& found : find(folder, R"(((?:\.|->)(?:openFile|pushFile)\(|\baddDirectory(?:First|Last)\())"))
      ADD_FAILURE() << found.file << ":" << found.line << " has Coin open a file: " << found.text;
  }
}
