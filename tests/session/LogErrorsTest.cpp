#include <gmock/gmock.h>
#include <hdf5.h>

#include <cmath>
#include <fstream>

#include "app/session/log/writing/SessionLogWriter.h"
#include "tests/session/SessionFixtures.h"

namespace haptiv {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using namespace haptiv::testing;

TEST(LogErrors, TellsAFolderThatDoesNotExist) {
  const TemporaryFolder folder;
  EXPECT_THAT(messageOf([&] { SessionLogWriter(folder / "no/s.h5", someHeader()); }), HasSubstr("Choose a folder"));
}

TEST(LogErrors, RefusesASceneThatCouldNotBeReadAgain) {
  const TemporaryFolder folder;
  SessionLogWriter writer(folder / "s.h5", someHeader());
  HapticScene wrong;
  wrong.walls.resize(1);
  wrong.walls[0].id = 7;
  wrong.walls[0].surface.damping = std::nan("");
  EXPECT_THAT(messageOf([&] { writer.addScene(wrong, ""); }),
              AllOf(HasSubstr("s.h5"), HasSubstr("the damping of the wall with id 7 is no finite number")));
}

TEST(LogErrors, TellsAFileThatIsNone) {
  const TemporaryFolder folder;
  EXPECT_THAT(messageOf([&] { SessionLog(folder / "s.h5"); }), HasSubstr("no such file"));
  std::ofstream(folder / "s.h5") << "t,x,y,z\n";
  EXPECT_THAT(messageOf([&] { SessionLog(folder / "s.h5"); }), HasSubstr("not an HDF5 file"));
  std::ofstream(folder / "s.h5", std::ios::trunc);
  EXPECT_THAT(messageOf([&] { SessionLog(folder / "s.h5"); }), HasSubstr("not an HDF5 file"));
}

TEST(LogErrors, TellsAnHdf5FileOfAnotherKind) {
  const TemporaryFolder folder;
  H5Fclose(H5Fcreate((folder / "s.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_THAT(messageOf([&] { SessionLog(folder / "s.h5"); }), HasSubstr("no session log of Haptiv"));
}

TEST(LogErrors, TellsANewerFormat) {
  const TemporaryFolder folder;
  SessionLogWriter(folder / "s.h5", someHeader()).close(0);
  const hid_t file = H5Fopen((folder / "s.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t attribute = H5Aopen(file, "format_version", H5P_DEFAULT);
  const std::uint64_t version = 4;
  H5Awrite(attribute, H5T_NATIVE_UINT64, &version);
  H5Aclose(attribute);
  H5Fclose(file);
  EXPECT_THAT(messageOf([&] { SessionLog(folder / "s.h5"); }),
              AllOf(HasSubstr("newer Haptiv"), HasSubstr("log format 4")));
}

}  // namespace
}  // namespace haptiv
