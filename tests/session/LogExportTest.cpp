#include "app/session/log/reading/LogExport.h"

#include <gmock/gmock.h>

#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "app/session/log/writing/SessionLogWriter.h"
#include "tests/session/SessionFixtures.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;
using namespace haptiv::testing;

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

TEST(LogExport, GivesSiUnitsUnderNamesThatSaySo) {
  const TemporaryFolder folder;
  TickRecord tick;
  tick.tick = 3;
  tick.time = 3'000'001;
  tick.wakeLateness = -250;
  tick.position = Vector3(0.1, -1e-300, std::numeric_limits<double>::quiet_NaN());
  tick.reading.encoderCounts[9] = -12345;
  {
    SessionLogWriter writer(folder / "s.h5", someHeader());
    writer.addScene(wallScene(), "");
    writer.append({&tick, 1});
    writer.close(0);
  }
  exportCsv(SessionLog(folder / "s.h5"), folder / "s.csv");
  std::ifstream stream(folder / "s.csv");
  std::string head, row, none;
  ASSERT_TRUE(std::getline(stream, head) && std::getline(stream, row));
  EXPECT_FALSE(std::getline(stream, none));
  const std::vector<std::string> names = cellsOf(head), cells = cellsOf(row);
  ASSERT_EQ(names.size(), cells.size());
  EXPECT_EQ(names[0], "t_s");
  EXPECT_THAT(names, IsSupersetOf({"tick", "wake_lateness_s", "encoder10_counts", "position_x_m",
                                   "desired_velocity_z_m_per_s", "hand_force_y_N", "penetration_m", "faults"}));
  EXPECT_THAT(head, Not(HasSubstr("_ns")));
  std::map<std::string, std::string> value;
  for (std::size_t i = 0; i < names.size(); ++i) value[names[i]] = cells[i];
  EXPECT_EQ(value.size(), names.size()) << "two columns have the same name";
  EXPECT_EQ(value["t_s"], "0.003000001");
  EXPECT_EQ(value["tick"], "3");
  EXPECT_EQ(value["wake_lateness_s"], "-2.5e-07");
  EXPECT_EQ(value["encoder10_counts"], "-12345");
  EXPECT_EQ(value["position_x_m"], "0.1");
  EXPECT_EQ(value["position_y_m"], "-1e-300");
  EXPECT_EQ(value["position_z_m"], "nan");
}

TEST(LogExport, TellsAFileThatCannotBeWritten) {
  const TemporaryFolder folder;
  SessionLogWriter(folder / "s.h5", someHeader()).close(0);
  EXPECT_THAT(messageOf([&] { exportCsv(SessionLog(folder / "s.h5"), folder / "no/s.csv"); }), HasSubstr("s.csv"));
}

}  // namespace
}  // namespace haptiv
