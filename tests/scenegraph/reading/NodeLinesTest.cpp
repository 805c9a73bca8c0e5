#include <Inventor/nodes/SoNode.h>
#include <gmock/gmock.h>

#include "scenegraph/GraphWalk.h"
#include "scenegraph/Keyword.h"
#include "scenegraph/writing/SceneWriter.h"
#include "tests/scenegraph/SceneTesting.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using testing::kHeader;
using testing::textOf;

/// "LINE KEYWORD" of each node of a type, in the order of the graph; 0 for a node without a line.
std::vector<std::string> linesOf(const SceneFile& scene, const std::string& type) {
  std::vector<std::string> lines;
  for (const SoNode* node : writtenNodes(scene.root.get())) {
    if (!describe(node).starts_with(type)) continue;
    const auto line = scene.lineOf.find(node);
    lines.push_back(std::to_string(line == scene.lineOf.end() ? 0 : line->second) + " " + describe(node));
  }
  return lines;
}

SceneFile readText(const std::string& text) {
  SceneFile scene = readSceneText(text, "test.iv");
  EXPECT_TRUE(scene.root) << textOf(scene.diagnostics);
  return scene;
}

void expectSolidCubesOnTheirLines(const SceneFile& scene) {
  std::vector<std::string> lines;
  std::istringstream text(scene.text);
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    for (const std::string name : {"before", "after"}) {
      if (line.find("DEF " + name + " Cube") != std::string::npos)
        lines.push_back(std::to_string(number) + " Cube \"" + name + "\"");
    }
  }
  EXPECT_THAT(linesOf(scene, "Cube \""), ::testing::ElementsAreArray(lines));
}

TEST(NodeLines, AreKnownAroundDraggersWhichHoldNodesOfTheSameTypes) {
  const SceneFile scene = readText(kHeader + "Separator {\n  DEF before Cube { }\n  Translate1Dragger { }\n" +
                                   "  TransformerManip { }\n  TrackballDragger { }\n  DEF after Cube { }\n}\n");
  expectSolidCubesOnTheirLines(scene);
  EXPECT_THAT(linesOf(scene, "Translate1Dragger"), ::testing::ElementsAre("4 Translate1Dragger"));
  EXPECT_THAT(linesOf(scene, "Cube"), ::testing::Contains("4 Cube")) << "a part has the line of its dragger";
  const SceneFile saved = readText(writeSceneText(scene.root.get()));
  EXPECT_EQ(saved.lineOf.size(), writtenNodes(saved.root.get()).size());
  expectSolidCubesOnTheirLines(saved);
}

TEST(NodeLines, AreThoseOfTheInstanceForWhatAPrototypeMakes) {
  const SceneFile scene = readText(
      "#VRML V2.0 utf8\nPROTO Wall [ ] {\n Shape { geometry Box { } } }\nShape {\n geometry Box { } }\nWall { }\n");
  EXPECT_THAT(linesOf(scene, "VRMLBox"), ::testing::ElementsAre("5 VRMLBox", "6 VRMLBox"));
  EXPECT_THAT(linesOf(scene, "VRMLShape"), ::testing::ElementsAre("4 VRMLShape", "6 VRMLShape"));
}

TEST(NodeLines, AreThoseOfTheFieldThatANodeStandsIn) {
  const SceneFile scene = readText(kHeader +
                                   "Separator {\n  Foo { fields [ SFNode a, SFNode b ]\n    b Cube { width 2 }\n"
                                   "    a DEF first Cube { }\n  }\n  Translation {\n"
                                   "    translation 0 0 0 = ComposeVec3f { x 1 } . vector\n  }\n  Cube { }\n}\n");
  EXPECT_THAT(linesOf(scene, "Cube"), ::testing::ElementsAre("5 Cube \"first\"", "4 Cube", "10 Cube"));
  EXPECT_THAT(linesOf(scene, "Translation"), ::testing::ElementsAre("7 Translation"));
}

TEST(NodeLines, AreThoseOfTheDefinitionWhereANodeIsUsed) {
  const SceneFile scene = readText(kHeader +
                                   "Separator {\n  Switch { whichChild -1\n    DEF a Cube { }\n    Cube { } }\n"
                                   "  USE a\n  Separator {\n USE a\n    Cube { } }\n}\n");
  EXPECT_THAT(linesOf(scene, "Cube"), ::testing::ElementsAre("4 Cube \"a\"", "5 Cube", "9 Cube"));
}

/// A node of the only Separator's is not taken for the root's.
TEST(NodeLines, AreKnownWhereTheOnlySeparatorIsTheRoot) {
  const SceneFile scene = readText(kHeader + "\nSeparator {\n Separator {\n Separator { } } }\n");
  EXPECT_THAT(linesOf(scene, "Separator"), ::testing::ElementsAre("3 Separator", "4 Separator", "5 Separator"));
}

TEST(NodeLines, AreNoneWhereTheTextCanBeReadInTwoWays) {
  const SceneFile scene = readText(kHeader + "Separator {\n Info { string a\"b }\n Cube { }\n}\n");
  EXPECT_THAT(linesOf(scene, "Cube"), ::testing::ElementsAre("0 Cube"));
}

TEST(NodeLines, AndNodesAreToldWithWhatCoinSaysOfAText) {
  const auto said = [](const std::string& body) {
    return textOf(readSceneText(kHeader + body, "test.iv").diagnostics);
  };
  EXPECT_THAT(said("Separator {\n Translation { translation 0 0 x } Cube { width 1 }\n}"),
              HasSubstr("test.iv:3: error: Translation: Couldn't read value"));
  EXPECT_THAT(said("Separator {\n DEF box Cube {\n  width 1e400\n }\n}"),
              HasSubstr("test.iv:4: error: Cube \"box\": Detected non-valid"));
  EXPECT_THAT(said("Separator {\n Cube { width 1e400 } Sphere { }\n}"),
              HasSubstr("test.iv:3: error: Detected non-valid"))
      << "which of the two is not certain";
}

TEST(NodeLines, AreToldOfPrototypes) {
  const auto said = [](const std::string& body) {
    return textOf(readSceneText("#VRML V2.0 utf8\n" + body, "test.wrl").diagnostics);
  };
  EXPECT_THAT(said("Group { }\nEXTERNPROTO Wall [ ]\n \"none.wrl\"\nWall { }\n"),
              HasSubstr("test.wrl:3: error: EXTERNPROTO \"Wall\": Error reading EXTERNPROTO definition: no file"));
  EXPECT_THAT(said("Group { }\nPROTO Wall [ field SFNode c NULL ] {\n IndexedFaceSet { coord IS c\n"
                   " coord Coordinate { point IS p } } }\nWall { }"),
              HasSubstr("test.wrl:3: warning: PROTO \"Wall\": Coin warning"));
}

}  // namespace
}  // namespace haptiv
