#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/device/parsing/Refusal.h"

namespace haptiv {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

struct BadFile {
  const char* what;
  std::string toml;
  const char* where;
  const char* says;
};

/// So many more entries of a list of bodies.
std::string moreBodies(int count) {
  std::string bodies;
  for (int i = 0; i < count; ++i) bodies += ", {}";
  return bodies;
}

class BadDescription : public testing::TestWithParam<BadFile> {};

TEST_P(BadDescription, IsRefusedWithLineAndColumn) {
  EXPECT_THAT(refusal(GetParam().toml), AllOf(StartsWith(GetParam().where), HasSubstr(GetParam().says)));
}

INSTANTIATE_TEST_SUITE_P(
    All, BadDescription,
    testing::Values(
        BadFile{"Syntax", "schema = 1\n[links\n", "arm.toml:2:", "correct the TOML"},
        BadFile{"OtherSchema", "schema = 2\n", "arm.toml:1:10: ", "schema = 1"},
        BadFile{"SchemaAsText", "schema = '1'\n", "arm.toml:1:10: ", "schema = 1"},
        BadFile{"NameAsNumber", "schema = 1\nname = 3\n", "arm.toml:2:8: ", "name"},
        BadFile{"UnknownSection", "schema = 1\n[motors]\nx = 1\n", "arm.toml:2:2: ", "motors"},
        BadFile{"UnknownKey", "schema = 1\n[links]\nscra = 0.25\n", "arm.toml:3:1: ", "links.scra"},
        BadFile{"SectionAsNumber", "schema = 1\nlinks = 3\n", "arm.toml:2:9: ", "[links]"},
        BadFile{"TextForNumber", "schema = 1\n[links]\nlift = 'long'\n", "arm.toml:3:8: ", "links.lift"},
        BadFile{"NumberForList", "schema = 1\n[drives]\ngearRatio = 100\n", "arm.toml:3:13: ", "drives.gearRatio"},
        BadFile{"ShortList", "schema = 1\n[drives]\ninertia = [1, 2]\n", "arm.toml:3:11: ", "2 entries; give 10"},
        BadFile{"TextInList", "schema = 1\n[home]\nangles = [0,0,'a',0,0,0,0,0,0,0]\n", "arm.toml:3:15: ", "joint 3"},
        BadFile{"NegativeLength", "schema = 1\n[links]\nscara = -0.25\n", "arm.toml:3:9: ", "greater than zero"},
        BadFile{"ZeroGear", "schema = 1\n[drives]\ngearRatio = [1,1,1,1,1,1,1,1,1,0]\n", "arm.toml:3:32: ", "joint 10"},
        BadFile{"NotANumber", "schema = 1\n[home]\nangles = [nan,0,0,0,0,0,0,0,0,0]\n", "arm.toml:3:11: ", "finite"},
        BadFile{"Infinite", "schema = 1\n[control]\njointGain = inf\n", "arm.toml:3:13: ", "finite"},
        BadFile{"NegativeNoise", "schema = 1\n[sensor]\nforceNoise = -1\n", "arm.toml:3:14: ", "negative"},
        BadFile{"RangeBeyondCounts", "schema = 1\n[sensor]\nforceRange = 1e4\n", "arm.toml:3:14: ", "32767"},
        BadFile{"TooManyCounts", "schema = 1\n[drives]\ngearRatio = [1e9,1,1,1,1,1,1,1,1,1]\n",
                "arm.toml:3:13: ", "32-bit"},
        BadFile{"UnknownStrategy", "schema = 1\n[redundancy]\nstrategy = 'best'\n", "arm.toml:3:12: ", "'cond'"},
        BadFile{"NumberForSteps", "schema = 1\n[redundancy]\nstepFull = 3\n", "arm.toml:3:12: ", "section"},
        BadFile{"UnknownStep", "schema = 1\n[redundancy]\nstepFull = {best = 3}\n", "arm.toml:3:13: ", "stepFull.best"},
        BadFile{"NumberForTruth", "schema = 1\n[redundancy]\nweighByRateLimits = 1\n", "arm.toml:3:21: ", "true"},
        BadFile{"ShortPose", "schema = 1\n[redundancy]\nnormalisationPoses = [[1, 2]]\n", "arm.toml:3:23: ", "pose 1"},
        BadFile{"ShutOffInUse", "schema = 1\n[safety]\ncountThreshold = [9e6,9e6,1,9e6,9e6,9e6,9e6,9e6,9e6,9e6]\n",
                "arm.toml:3:18: ", "joint 3 is below its rateLimit"},
        BadFile{"TooFewBodies", "schema = 1\n[[bodies.link]]\nmass = 1\n", "arm.toml:2:", "10 bodies"},
        BadFile{"BodyOfNoMatter",
                "schema = 1\n[bodies]\nlink = [{inertia = [1, 1, 3, 0, 0, 0]}" + moreBodies(9) + "]\n",
                "arm.toml:3:9: ", "bodies.link 1.inertia is of no body"},
        BadFile{"BodyOfNegativeMass", "schema = 1\n[bodies]\nlink = [{mass = -1}" + moreBodies(9) + "]\n",
                "arm.toml:3:17: ", "negative"},
        BadFile{"UnknownKeyOfBodies", "schema = 1\n[bodies]\nlinks = []\n", "arm.toml:3:1: ", "bodies.links"},
        BadFile{"GripSofterThanTheHand", "schema = 1\n[hand]\ngripStiffness = 300\n", "arm.toml:3:17: ", "raise"},
        BadFile{"HandWithoutMass", "schema = 1\n[hand]\nmass = 1e-6\n", "arm.toml:3:8: ", "swing"},
        BadFile{"LinksOfMillimetres", "schema = 1\n[links]\nscara = 250\n", "arm.toml:3:9: ", "metres"},
        BadFile{"ShortBias", "schema = 1\n[sensor]\nbias = [1, 2]\n", "arm.toml:3:8: ", "2 entries; give 6"},
        BadFile{"BiasOfHalfTheRange", "schema = 1\n[sensor]\nbias = [0, 0, 201, 0, 0, 0]\n", "arm.toml:3:8: ", "half"},
        BadFile{"MatrixAsRow", "schema = 1\n[sensor]\nmatrix = [1, 0, 0, 0, 0, 0]\n", "arm.toml:3:", "row 1"},
        BadFile{"SingularMatrix",
                "schema = 1\n[sensor]\nmatrix = [[1,0,0,0,0,0],[0,1,0,0,0,0],[0,0,1,0,0,0],[0,0,0,1,0,0],"
                "[0,0,0,0,1,0],[0,0,0,0,1,0]]\n",
                "arm.toml:3:10: ", "calibrate anew"},
        BadFile{"FiveRows", "schema = 1\n[sensor]\nmatrix = [[], [], [], [], []]\n",
                "arm.toml:3:10: ", "5 rows; give 6"},
        BadFile{"ZeroOfHalfACount", "schema = 1\n[encoders]\nzero = [0,0,0,0.5,0,0,0,0,0,0]\n",
                "arm.toml:3:8: ", "joint 4 is no whole number"},
        BadFile{"ZeroBeyondCounts",
                "schema = 1\n[encoders]\nzero = [9e8,0,0,0,0,0,0,0,0,0]\nreference = "
                "[99999,0,0,0,0,0,0,0,0,0]\n",
                "arm.toml:3:8: ", "joint 1 is beyond the 32-bit"},
        BadFile{"HomeBeyondCounts", "schema = 1\n[home]\nangles = [1e6,0,0,0,0,0,0,0,0,0]\n",
                "arm.toml:3:10: ", "turns"}),
    [](const auto& instance) { return std::string(instance.param.what); });

}  // namespace
}  // namespace haptiv
