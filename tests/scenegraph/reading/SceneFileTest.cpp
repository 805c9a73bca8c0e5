#include "scenegraph/reading/SceneFile.h"

#include <Inventor/SoDB.h>
#include <Inventor/VRMLnodes/SoVRMLTransform.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoInfo.h>
#include <Inventor/nodes/SoTranslation.h>
#include <Inventor/sensors/SoSensorManager.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "tests/scenegraph/SceneTesting.h"

namespace haptiv {
namespace {

namespace fs = std::filesystem;
using testing::contentsOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kHeader;
using testing::put;
using testing::read;
using testing::ScratchFolder;
using testing::textOf;

std::string errorsOf(const std::string& text) {
  const SceneFile scene = readSceneText(text, "test.iv");
  EXPECT_FALSE(scene.root);
  return textOf(scene.diagnostics);
}

TEST(SceneFile, KnowsTheLineOfEachNode) {
  const SceneFile scene =
      read("# a comment { \"\nSeparator {\n  Cube { }\n\n  DEF x Cube { width 1\n height 2 } }\nUSE x Cube { }\n");
  ASSERT_TRUE(scene.root);
  auto* group = static_cast<SoSeparator*>(scene.root->getChild(0));
  EXPECT_EQ(scene.lineOf.at(group), 3);
  EXPECT_EQ(scene.lineOf.at(group->getChild(0)), 4);
  EXPECT_EQ(scene.lineOf.at(group->getChild(1)), 6);
  EXPECT_EQ(scene.lineOf.at(scene.root->getChild(2)), 8);
}

TEST(SceneFile, KnowsTheLinesOfVrmlWhoseFieldsStandInAnotherOrder) {
  const SceneFile scene = readSceneText(
      "#VRML V2.0 utf8\nTransform { children [\n Shape {\n geometry Box { }\n appearance Appearance { } }\n Shape {\n"
      " geometry Sphere { } } ] }\n",
      "test.wrl");
  ASSERT_TRUE(scene.root) << textOf(scene.diagnostics);
  std::vector<int> lines;
  for (const auto& [node, line] : scene.lineOf) lines.push_back(line);
  EXPECT_THAT(lines, ::testing::UnorderedElementsAre(2, 2, 3, 4, 5, 6, 7)) << "the root stands where the text begins";
}

TEST(SceneFile, SaysWhatIsWrongWithAFileThatIsNoScene) {
  const ScratchFolder folder;
  const auto fault = [&](const fs::path& path) { return textOf(readScene(path).diagnostics); };
  EXPECT_THAT(fault(folder.path() / "none.iv"), HasSubstr("there is no such file"));
  EXPECT_THAT(fault(folder.path()), HasSubstr("is a folder"));
  put(folder.path() / "empty.iv", "");
  EXPECT_THAT(fault(folder.path() / "empty.iv"), HasSubstr("the file is empty"));
  ASSERT_EQ(::mkfifo((folder.path() / "pipe.iv").c_str(), 0600), 0);
  EXPECT_THAT(fault(folder.path() / "pipe.iv"), HasSubstr("not a regular file"));
  EXPECT_THAT(fault(std::string(5000, 'x')), HasSubstr("cannot be looked at"));
  if (::geteuid() != 0) {  // root reads everything
    put(folder.path() / "secret.iv", kHeader);
    fs::permissions(folder.path() / "secret.iv", fs::perms::none);
    EXPECT_THAT(fault(folder.path() / "secret.iv"), HasSubstr("check its permissions"));
  }
}

TEST(SceneFile, RefusesBytesThatAreNoText) {
  EXPECT_THAT(errorsOf(kHeader + std::string("Cube { width 1\0 }", 17)), HasSubstr("test.iv:2: error"));
  EXPECT_THAT(errorsOf(std::string("\0\0\0", 3)), HasSubstr("is this an Open Inventor file?"));
  EXPECT_THAT(errorsOf("#Inventor V2.1 binary\n..."), HasSubstr("holds no node that can be read"));
}

TEST(SceneFile, RefusesWhatIsTooLongOrTooDeepForCoin) {
  EXPECT_THAT(errorsOf(kHeader + "DEF " + std::string(100000, 'a') + " Cube { }"), HasSubstr("longer than 1000"));
  EXPECT_THAT(errorsOf(kHeader + "Info { string \"" + std::string(100000, 'a') + "\" }"),
              HasSubstr("longer than 65536"));
  std::string deep;
  for (int i = 0; i < 20000; ++i) deep += "Group {";
  EXPECT_THAT(errorsOf(kHeader + deep + std::string(20000, '}')), HasSubstr("deeper than 1000 levels"));
}

TEST(SceneFile, RefusesFacesThatCrowdOnePoint) {
  std::string faces;
  for (int i = 0; i < 40'000; ++i) faces += "0 1 2 -1\n";
  const SceneFile crowded = readSceneText(
      kHeader + "Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0 ] }\nIndexedFaceSet { coordIndex [ " + faces + " ] }",
      "test.iv");
  EXPECT_FALSE(crowded.root);
  EXPECT_THAT(textOf(crowded.diagnostics), HasSubstr("3: error: IndexedFaceSet: has 40000 corners on one point"));
}

/// Without indices, corners are on one point where their coordinates are equal. Normals spare Coin the work.
TEST(SceneFile, RefusesFacesWithoutIndicesThatCrowdOnePoint) {
  std::string points, counts;
  for (int i = 0; i < 50'000; ++i) {
    points += (i % 2 ? "0 0 0, 1 " : "-0 0 0, 1 ") + std::to_string(i) + " 0, 1 " + std::to_string(i + 1) + " 0,\n";
    counts += "3 ";
  }
  for (const std::string shape : {"FaceSet", "TriangleStripSet"}) {
    const std::string faces =
        "Coordinate3 { point [ " + points + "] }\n" + shape + " { numVertices [ " + counts + "] }";
    const SceneFile crowded = readSceneText(kHeader + faces, "test.iv");
    EXPECT_FALSE(crowded.root);
    EXPECT_THAT(textOf(crowded.diagnostics), HasSubstr("error: " + shape + ": has 50000 corners on one point"));
    const std::string lit = "Normal { vector 0 0 1 } NormalBinding { value OVERALL }\n";
    EXPECT_TRUE(readSceneText(kHeader + lit + faces, "test.iv").root) << shape;
  }
}

TEST(SceneFile, RefusesADeepChainOfUses) {
  std::string chain = kHeader + "DEF a0 Separator { Cube { } }";
  for (int i = 1; i < 3000; ++i) {
    chain += "DEF a" + std::to_string(i) + " Separator { USE a" + std::to_string(i - 1) + " }\n";
  }
  EXPECT_THAT(errorsOf(chain), ::testing::AnyOf(HasSubstr("deeper than 1000"), HasSubstr("too large")));
}

TEST(SceneFile, ReadsSceneryAsCoinDoes) {
  for (const std::string body :
       {"Info { string \"braces } and { and \\\" quotes # are text\" }", "Cube { } # the end", "DEF a-b_c+1 Cube { }",
        "Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0 ] } IndexedFaceSet { coordIndex [ 0, 1, 2, -1 ] }",
        "Foo { fields [ SFFloat x ] x 2 }", "Switch { whichChild 0 DEF A Cube { } } USE A", "IndexedFaceSet { }",
        "HapticSurface { fields [ SFFloat stiffness, SFString label ] stiffness 3 label \"x\" }",
        "Translation { translation 0 0 0 = ComposeVec3f { x 1 } . vector } Cube { }", "SoCube { }",
        "VRMLAnchor { url \"http://example.org\" }", "PointSet { }", "",
        "Normal { vector [ 0 0 1 ] } NormalBinding { value OVERALL } Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0 ] } "
        "FaceSet { numVertices -1 } LineSet { } TriangleStripSet { numVertices 3 }",
        "Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] } Material { diffuseColor [ 1 0 0, 0 1 0 ] } "
        "MaterialBinding { value PER_FACE } IndexedFaceSet { coordIndex [ 0, 1, 2, -1, 0, 2, 3, -1 ] }",
        "Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] } QuadMesh { verticesPerRow 2 verticesPerColumn 2 }",
        "VRMLShape { geometry VRMLElevationGrid { xDimension 2 zDimension 2 height [ 0 0 0 0 ] } }",
        "Texture2 { image 2 1 1 0xff 0x00 } Cube { }"}) {
    const SceneFile scene = readSceneText(kHeader + body, "test.iv");
    EXPECT_TRUE(scene.root) << body << "\n" << textOf(scene.diagnostics);
    EXPECT_THAT(textOf(scene.diagnostics), IsEmpty()) << body;
  }
}

TEST(SceneFile, IsNotDeceivedByAStringThatCoinReadsToAnotherEnd) {
  // For Coin a quote after a backslash never ends a string, not even after two backslashes.
  const SceneFile scene = read("Info { string \"a\\\\\" } File { name \\\"/dev/zero\\\" } #\" }");
  ASSERT_TRUE(scene.root);
  for (const std::string body : {"Info { string a\"\n} File { name \"/dev/zero\" } #\" \n}",
                                 "Info { string a#b } File { name \"/dev/zero\" }\n"}) {
    EXPECT_THAT(errorsOf(kHeader + body), HasSubstr("\"/dev/zero\" is outside of the scene's folder"));
  }
}

TEST(SceneFile, SurvivesEveryBeginningOfAScene) {
  const std::string text = contentsOf(testing::sourceDir() / "scenes/zones.iv");
  ASSERT_FALSE(text.empty());
  for (std::size_t size = 0; size < text.size(); size += 7) {
    const SceneFile scene = readSceneText(text.substr(0, size), "test.iv");
    EXPECT_EQ(!scene.root, hasErrors(scene.diagnostics));
  }
}

TEST(SceneFile, StandsStillForWhatIsSeenMustBeFeltThere) {
  const SceneFile scene = readSceneText(
      "#VRML V2.0 utf8\nDEF C TimeSensor { loop TRUE cycleInterval 0.5 }\n"
      "DEF W PositionInterpolator { key [ 0 1 ] keyValue [ 0 0 0, 1 0 0 ] }\nDEF M Transform { children Shape { } }\n"
      "ROUTE C.fraction_changed TO W.set_fraction\nROUTE W.value_changed TO M.set_translation\n",
      "moving.wrl");
  ASSERT_TRUE(scene.root) << textOf(scene.diagnostics);
  const auto* moved = static_cast<SoVRMLTransform*>(SoNode::getByName("M"));
  const SbVec3f before = moved->translation.getValue();
  for (int i = 0; i < 3; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    SoDB::getSensorManager()->processTimerQueue();
    SoDB::getSensorManager()->processDelayQueue(TRUE);
    EXPECT_EQ(moved->translation.getValue(), before);
  }
}

}  // namespace
}  // namespace haptiv
