// haptiv run MODEL --solid: files that are only seen are felt.
#include <gmock/gmock.h>

#include "tests/app/commands/HaptivProgram.h"
#include "tests/app/commands/TestFolder.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;

const std::string kInventor = R"(#Inventor V2.1 ascii
Separator {
  Coordinate3 { point [ -1 -1 0, 1 -1 0, 1 1 0, -1 1 0, 0 0 1 ] }
  IndexedFaceSet { coordIndex [ 0, 1, 4, -1, 1, 2, 4, -1, 2, 3, 4, -1, 3, 0, 4, -1, 3, 2, 1, 0, -1 ] }
}
)";
const std::string kVrml1 = R"(#VRML V1.0 ascii
Separator { Scale { scaleFactor 1 2 1 } Sphere { radius 1 } }
)";
const std::string kVrml2 = R"(#VRML V2.0 utf8
Transform { scale 100 100 100 children Shape { appearance Appearance { material Material { } }
  geometry IndexedFaceSet { coord Coordinate { point [ -1 -1 0, 1 -1 0, 1 1 0, -1 1 0 ] } coordIndex [ 0 1 2 3 -1 ] } } }
)";

struct Model {
  std::string name;
  std::string text;
  double top;  ///< its z over the middle
  double size;
};

class SolidModel : public ::testing::TestWithParam<Model> {};

TEST_P(SolidModel, PressesBackWhereTheHandGoesIntoIt) {
  const TestFolder folder;
  const Model& model = GetParam();
  const std::string file = folder.write("model", model.text);
  const double above = model.top + 0.05 * model.size;
  const double below = model.top - 0.05 * model.size;
  const std::string hand =
      folder.write("hand.csv", "t,x,y,z\n0,0,0," + std::to_string(above) + "\n1.5,0,0," + std::to_string(below) + "\n");
  const Ended plain = runHaptiv({"run", file, "--fast"});
  EXPECT_EQ(plain.code, 1);
  EXPECT_THAT(plain.err, HasSubstr("--solid"));

  const std::string log = folder / "s.h5";
  const Ended ended = runHaptiv({"run", file, "--solid", "--hand", hand, "--fast", "--log", log, "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_GT(ended.json()["final_contact_force_N"], 1);
  EXPECT_GT(ended.json()["final_position_m"][2], below);
  EXPECT_EQ(ended.json()["faults"].size(), 0u);
  EXPECT_EQ(readFile(file), model.text) << "the file stays as it is";
  const Ended verified = runHaptiv({"replay", log, "--verify", "--json"});
  EXPECT_EQ(verified.code, 0) << verified.err << verified.out;
}

INSTANTIATE_TEST_SUITE_P(Formats, SolidModel,
                         ::testing::Values(Model{"Inventor", kInventor, 1, 2}, Model{"Vrml1", kVrml1, 1, 4},
                                           Model{"Vrml2", kVrml2, 0, 200}),
                         [](const auto& one) { return one.param.name; });

TEST(Solid, FeelsNegativeLengthsAsTheyAreDrawn) {
  const TestFolder folder;
  const std::string file = folder.write("model.wrl", "#VRML V1.0 ascii\nSeparator {\n  Cube { width -2 }\n}\n");
  const Ended ended = runHaptiv({"run", file, "--solid", "--fast", "--seconds", "0.1"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("model.wrl:3: warning: Cube: width is -2: --solid takes it as 2"));
}

TEST(Solid, SaysWhyNothingCanBeMadeSolid) {
  const TestFolder folder;
  const std::string file = folder.write("empty.iv", "#Inventor V2.1 ascii\nInfo { string \"nothing\" }\n");
  const Ended ended = runHaptiv({"run", file, "--solid", "--fast", "--seconds", "0.1"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.err, HasSubstr("it shows no shape"));
  EXPECT_THAT(ended.err, ::testing::Not(HasSubstr("has no tool")));
}

TEST(Solid, DoesWithoutWhatIsDrawnOnTheScreen) {
  const TestFolder folder;
  const std::string file =
      folder.write("model.iv",
                   "#Inventor V2.1 ascii\nCube { }\nImage { image 2 2 1 0 255 255 0 width 100 height "
                   "100 }\nText2 { string \"here\" }\nTranslate1Dragger { }\n");
  const Ended ended = runHaptiv({"run", file, "--solid", "--fast", "--seconds", "0.1", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("model.iv:3: warning: Image: is not felt"));
}

TEST(Solid, PassesOnNoRemarksOfCoinOnPrototypesWithinEachOther) {
  const TestFolder folder;
  const std::string file =
      folder.write("robot.wrl",
                   "#VRML V2.0 utf8\n"
                   "PROTO Joint [ exposedField MFNode children [] ] { Group { children IS children } }\n"
                   "Joint { children Joint { children Shape { geometry Box { } } } }\n");
  const Ended ended = runHaptiv({"run", file, "--solid", "--fast", "--seconds", "0.1"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, ::testing::Not(HasSubstr("Coin warning")));
}

TEST(Solid, LeavesASceneAloneThatSaysWhatIsFelt) {
  const TestFolder folder;
  const Ended ended = runHaptiv(
      {"run", folder.write("scene.iv", wallScene() + "HapticDevice { }"), "--solid", "--fast", "--seconds", "0.1"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("Separator: --solid has nothing to add"));
}

}  // namespace
}  // namespace haptiv
