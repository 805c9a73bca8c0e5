#include <gmock/gmock.h>

#include "scenegraph/judging/SceneJudge.h"
#include "tests/scenegraph/SceneTesting.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using testing::read;
using testing::textOf;

/// What the judge says of a scene; the header is line 1, what precedes every body stands there too.
std::string judgement(const std::string& body) {
  const SceneFile scene = read(body);
  const CompiledScene compiled = SceneCompiler().compile(scene.root.get(), scene.lineOf, scene.path);
  if (!compiled.scene) return "not compiled: " + textOf(compiled.diagnostics);
  Diagnostics found = judgeScene({*compiled.scene, compiled.origins, loadDeviceDescription("vishard10")});
  locate(found, scene.lineOf, scene.path);
  return textOf(found);
}

const std::string kTool = "HapticTool { home 0.35 0 0 }\n";
const std::string kPlace = "Translation { translation 0.35 0.25 0 }\n";  // a wall's, beside the ball

std::string wall(const std::string& surface, const std::string& cube = "width 0.2 height 0.2 depth 0.2") {
  return kTool + kPlace + "HapticSurface { " + surface + " }\nCube { " + cube + " }";
}

TEST(SceneJudge, HasNothingToSayOfAGoodScene) {
  EXPECT_EQ(judgement(wall("label \"a\"")), "");
  EXPECT_EQ(judgement(kTool + kPlace + "HapticSpringZone { }\nSphere { radius 0.1 }"), "");
}

struct Judged {
  std::string name;
  std::string body;
  std::string expected;
};
std::ostream& operator<<(std::ostream& out, const Judged& judged) {
  return out << judged.name;
}
class SceneJudgement : public ::testing::TestWithParam<Judged> {};

TEST_P(SceneJudgement, SaysItOnceWithLineAndNode) {
  const std::string text = judgement(GetParam().body);
  EXPECT_THAT(text, HasSubstr(GetParam().expected));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
}

INSTANTIATE_TEST_SUITE_P(
    Rules, SceneJudgement,
    ::testing::Values(
        Judged{"HomeOutOfReach", "HapticTool { home 5 0 0 }",
               "test.iv:2: error: HapticTool: home is out of the arm's reach"},
        Judged{"HomeInAWall",
               kTool + "HapticSurface { }\nTranslation { translation 0.35 0.205 0 } DEF w Cube { width 0.4 height 0.4 "
                       "depth 0.4 }",
               "test.iv:2: warning: HapticTool: its home is inside a wall, the Cube \"w\""},
        Judged{"Thin", wall("stiffness 2000", "width 0.2 height 0.005 depth 0.2"),
               "test.iv:5: warning: Cube: is 5 mm thick, and the device's peak force of 170 N presses the ball 85 mm "
               "deep"},
        Judged{"ThinBall", kTool + kPlace + "HapticSurface { }\nSphere { radius 0.04 }", "Sphere: is 80 mm thick"},
        Judged{"ThinMesh",
               kTool + kPlace +
                   "HapticSurface { }\nVRMLShape { geometry VRMLElevationGrid { xDimension 2 zDimension 2 xSpacing 0.1 "
                   "zSpacing 0.1 height [ 0 0 0 0.05 ] } }",
               "is 50 mm thick"},
        Judged{"Sampled", wall("stiffness 9e6"),
               "test.iv:4: warning: HapticSurface: cannot be rendered stably at 1000 Hz: k dt^2/m + 2 b dt/m is 4.52"},
        Judged{"Damped", wall("damping 4100"), "write a damping below 2 m/dt = 4000 N s/m"},
        Judged{"BeyondTheDrives", wall("stiffness 400000 damping 100"),
               "write a stiffness below 320000 N/m, or a larger mass; the optimal stiffness b^2/2m is 2500 N/m"},
        Judged{"HeavyMedium",
               kTool + kPlace + "HapticViscousZone { damping 5000 }\nCube { width 0.1 height 0.1 depth 0.1 }",
               "test.iv:4: warning: HapticViscousZone: cannot be rendered stably"},
        Judged{"FreeMotion", "HapticTool { home 0.35 0 0 damping 5000 }",
               "test.iv:2: warning: HapticTool: cannot be rendered"},
        Judged{"Millimetres",
               kTool + "HapticSurface { }\nTranslation { translation 0 300 0 } Cube { width 100 height 100 depth 100 }",
               "is it written in millimetres?"},
        Judged{"Tiny",
               kTool + "HapticSurface { stiffness 1e5 } Translation { translation 0.3 0 0 } Cube { width 0.0005 height "
                       "0.0005 depth 0.0005 }",
               "what is felt is 0.5 mm across"},
        Judged{"BallInMillimetres", "HapticTool { home 0.35 0 0 radius 10 }",
               "test.iv:2: warning: HapticTool: radius is 10 m"},
        Judged{"Grams", "HapticTool { home 0.35 0 0 mass 2000 }", "the hand feels a mass of 2000 kg"},
        Judged{"FarZone", kTool + "Translation { translation 3 0 0 }\nHapticViscousZone { }\nSphere { radius 0.1 }",
               "test.iv:5: warning: Sphere: is a zone that the arm cannot reach, by 1.89 m"},
        Judged{
            "HighZone",
            kTool + "Translation { translation 0 0 1 }\nHapticViscousZone { }\nCube { width 0.1 height 0.1 depth 0.1 }",
            "is a zone that the arm cannot reach, by 516 mm"},
        Judged{"BuriedZone", wall("") + " HapticViscousZone { }\nCube { width 0.1 height 0.1 depth 0.1 }",
               "test.iv:6: warning: Cube: is a zone wholly inside a wall"},
        Judged{"Anchor",
               kTool + kPlace + "HapticSpringZone { anchor 0 0.2 0 }\nCube { width 0.1 height 0.1 depth 0.1 }",
               "test.iv:4: warning: HapticSpringZone: its anchor is 150 mm outside of the zone"},
        Judged{"Band", kTool + kPlace + "HapticRubberBand { anchor 0 0.2 0 }\nCube { width 0.1 height 0.1 depth 0.1 }",
               "HapticRubberBand: its anchor is 150 mm outside"},
        Judged{"Labels", wall("label \"door\"") + " HapticSurface { label \"door\" }",
               "test.iv:5: warning: HapticSurface \"door\": has the label of a property before it"}),
    [](const auto& one) { return one.param.name; });

TEST(SceneJudge, TellsTheWorstOfManyWallsThatShareAProperty) {
  const std::string text = judgement(kTool + kPlace +
                                     "HapticSurface { }\nArray { numElements1 5 separation1 0 0.1 0\n"
                                     "Cube { width 0.2 height 0.02 depth 0.2 } }\nScale { scaleFactor 1 0.5 1 }\n"
                                     "Translation { translation 0.3 0 0 } Cube { width 0.2 height 0.02 depth 0.2 }");
  EXPECT_THAT(text, HasSubstr("test.iv:8: warning: Cube: is the thinnest of 6 walls that are too thin, 10 mm thick"));
}

TEST(SceneJudge, CountsWhatItDoesNotList) {
  std::string body = kTool + kPlace;
  for (int i = 0; i < 30; ++i)
    body += "HapticSurface { } Translation { translation 0 0.01 0 } Cube { width 0.1 height 0.001 depth 0.1 }\n";
  EXPECT_THAT(judgement(body), HasSubstr("and 10 more such places"));
}

TEST(SceneJudge, MeasuresInTheArmsOwnMetres) {
  const std::string device =
      "HapticDevice { scale 1000 position -350 0 0 }\nHapticTool { mass 0.002 damping 0.005 radius 10 home 0 0 "
      "0 }\nHapticSurface { stiffness 9 damping 0.1 }\n";
  EXPECT_EQ(judgement(device + "Translation { translation 0 100 0 } Cube { width 100 height 100 depth 100 }"), "");
}

}  // namespace
}  // namespace haptiv
