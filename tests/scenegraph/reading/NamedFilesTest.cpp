#include <Inventor/SbImage.h>
#include <Inventor/VRMLnodes/SoVRMLImageTexture.h>
#include <Inventor/VRMLnodes/SoVRMLInline.h>
#include <Inventor/nodes/SoTexture2.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>
#include <map>

#include "scenegraph/writing/SceneWriter.h"
#include "tests/scenegraph/SceneTesting.h"

namespace haptiv {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::kHeader;
using ::testing::Not;
using testing::put;
using testing::ScratchFolder;
using testing::textOf;
using testing::trianglesOf;

/// A scene in a folder of its own, with files beside it and outside.
class NamedFiles : public ::testing::Test {
 protected:
  NamedFiles() {
    put(folder_.path() / "outside.iv", kHeader + "Cube { }");
    fs::create_directories(home_ / "parts");
    put(home_ / "parts/cube.iv", kHeader + "Cube { }");
    fs::create_symlink("../outside.iv", home_ / "link.iv");
    if (::mkfifo((home_ / "pipe.iv").c_str(), 0600) != 0) throw std::runtime_error("no pipe can be made");
  }

  SceneFile read(const std::string& text) {
    put(home_ / "test.iv", text);
    return readScene(home_ / "test.iv");
  }

  const ScratchFolder folder_;
  const fs::path home_ = folder_.path() / "scene";
};

TEST_F(NamedFiles, AreNotOpenedOutsideOfTheScenesFolder) {
  for (const std::string name : {"../outside.iv", "/dev/zero", "link.iv", "pipe.iv", "parts/../../outside.iv"}) {
    const std::string quoted = "\"" + name + "\"";
    for (const std::string& body :
         {"Texture2 { filename " + quoted + " }", "Texture2 { filename " + name + " }",
          "TextureCubeMap { filenames [ " + quoted + " ] }", "VRMLImageTexture { url [ \"a.png\", " + quoted + " ] }",
          "FragmentShader { sourceProgram " + quoted + " }", "VRMLBackground { backUrl " + quoted + " }"}) {
      const SceneFile scene = read(kHeader + body);
      EXPECT_TRUE(scene.root) << body;
      EXPECT_THAT(textOf(scene.diagnostics), HasSubstr("test.iv:2: warning: ")) << body;
    }
    for (const std::string& body : {"File { name " + quoted + " }", "WWWInline { name " + quoted + " }",
                                    "VRMLInline { url [ \"a.wrl\", " + quoted + " ] }"}) {
      const SceneFile scene = read(kHeader + body);
      EXPECT_FALSE(scene.root) << body;
      EXPECT_THAT(textOf(scene.diagnostics), HasSubstr("test.iv:2: error: ")) << body;
    }
  }
}

TEST_F(NamedFiles, AreNotOpenedWhereAPrototypeOrAConnectionNamesThem) {
  for (const std::string text :
       {"#VRML V2.0 utf8\nPROTO T [ field MFString u \"/dev/zero\" ] { Appearance { texture "
        "ImageTexture { url IS u } } }\n"
        "Shape { appearance T { } geometry Box { } }",
        "#Inventor V2.1 ascii\nTexture2 { filename \"\" = Info { string \"/dev/zero\" } . string } Cube { }"}) {
    const SceneFile scene = read(text);
    EXPECT_TRUE(scene.root) << textOf(scene.diagnostics);
    EXPECT_THAT(textOf(scene.diagnostics), ::testing::AnyOf(HasSubstr("\"/dev/zero\" is outside of the scene's folder"),
                                                            HasSubstr("name that is computed is not followed")))
        << text;
  }
}

constexpr const char* kTwoTextures =
    "Texture2 { filename \"parts/a.png\" }\nVRMLImageTexture { url [ \"none.png\", \"parts/a.png\" ] }\n";

TEST_F(NamedFiles, OfPicturesAreDecodedOnceAndStayNames) {
  put(home_ / "parts/a.png", "two pixels");
  put(home_ / "test.iv", kHeader + kTwoTextures);
  const auto decode = [](const std::string& contents) {
    if (contents != "two pixels") throw std::runtime_error("another file");
    return Picture{2, 1, 3, "abcdef"};
  };
  const SceneFile scene = readScene(home_ / "test.iv", decode);
  ASSERT_TRUE(scene.root);
  EXPECT_EQ(textOf(scene.diagnostics), "");
  const auto* texture = dynamic_cast<SoTexture2*>(scene.root->getChild(0));
  const auto* vrml = dynamic_cast<SoVRMLImageTexture*>(scene.root->getChild(1));
  ASSERT_TRUE(texture && vrml);
  SbVec2s size;
  int components = 0;
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(texture->image.getValue(size, components)), 6), "abcdef");
  EXPECT_EQ(size, SbVec2s(2, 1));
  EXPECT_EQ(components, 3);
  EXPECT_EQ(vrml->getImage()->getSize(), SbVec3s(2, 1, 0));
  const std::string saved = writeSceneText(scene.root.get());
  EXPECT_THAT(saved, AllOf(HasSubstr("filename \"parts/a.png\""), Not(HasSubstr("image"))));
}

TEST_F(NamedFiles, OfPicturesMayBringTheirDecoderDown) {
  put(home_ / "parts/a.png", "bytes");
  put(home_ / "test.iv", kHeader + kTwoTextures);
  const std::map<std::string, DecodePicture> decoders = {
      {"it is damaged", [](const std::string&) -> Picture { throw std::runtime_error("it is damaged"); }},
      {"its decoder crashes or takes too long", [](const std::string&) -> Picture { std::abort(); }},
      {"it has no pixels", [](const std::string&) {
         return Picture{1000, 1000, 4, "few"};
       }}};
  for (const auto& [why, decode] : decoders) {
    const SceneFile scene = readScene(home_ / "test.iv", decode);
    EXPECT_TRUE(scene.root);
    EXPECT_THAT(textOf(scene.diagnostics), HasSubstr("test.iv:2: warning: Texture2: the texture \"parts/a.png\" "
                                                     "cannot be shown: " +
                                                     why));
    EXPECT_EQ(scene.diagnostics.size(), 2u) << textOf(scene.diagnostics);
  }
}

TEST_F(NamedFiles, ThatAreMissingAreWarningsWithTheirLine) {
  const SceneFile scene = read(kHeader +
                               "\nTexture2 { filename \"none.png\" }\nFile { name \"none.iv\" }\n"
                               "WWWInline { name \"http://example.org/a.wrl\" alternateRep Cube { } } Sphere { }");
  ASSERT_TRUE(scene.root);
  for (const char* expected : {"test.iv:3: warning: Texture2: the texture \"none.png\" is not there",
                               "test.iv:4: warning: File: \"none.iv\" is not there",
                               "test.iv:5: warning: WWWInline: \"http://example.org/a.wrl\" is not there"}) {
    EXPECT_THAT(textOf(scene.diagnostics), HasSubstr(expected));
  }
}

TEST_F(NamedFiles, ArePutWhereTheyAreNamed) {
  for (const std::string body : {"File { name \"parts/cube.iv\" }", "WWWInline { name \"parts/cube.iv\" }",
                                 "VRMLInline { url \"parts/cube.iv\" }"}) {
    const SceneFile scene = read(kHeader + body);
    ASSERT_TRUE(scene.root) << textOf(scene.diagnostics);
    EXPECT_EQ(trianglesOf(scene), 12) << body;
    EXPECT_THAT(writeSceneText(scene.root.get()), HasSubstr("parts/cube.iv"));
    EXPECT_THAT(writeSceneText(scene.root.get()), Not(HasSubstr("Cube {"))) << "a file that is included stays one";
  }
}

TEST_F(NamedFiles, AreNamedByTheDiagnosticsOfTheirNodes) {
  put(home_ / "parts/deep.iv", kHeader + "\n\nHapticSurface { stiffness -1 } Cube { }");
  put(home_ / "parts/middle.iv", kHeader + "File { name \"deep.iv\" }");
  const SceneFile scene = read(kHeader + "HapticTool { home 9 9 9 } File { name \"parts/middle.iv\" }");
  ASSERT_TRUE(scene.root) << textOf(scene.diagnostics);
  EXPECT_THAT(textOf(SceneCompiler().compile(scene).diagnostics),
              HasSubstr("scene/parts/deep.iv:4: error: HapticSurface: stiffness is -1"));
}

TEST_F(NamedFiles, IncludedAgainAndAgainAreReadOnce) {
  std::string text = kHeader;
  for (int i = 0; i < 2000; ++i) text += "File { name \"parts/cube.iv\" }\n";
  const SceneFile scene = read(text);
  ASSERT_TRUE(scene.root) << textOf(scene.diagnostics);
  EXPECT_EQ(trianglesOf(scene), 24000);
}

TEST_F(NamedFiles, MayDefineExternalPrototypes) {
  put(home_ / "parts/box.wrl",
      "#VRML V2.0 utf8\nPROTO B [ field SFVec3f s 1 1 1 ] { Shape { geometry Box { size IS s } } }");
  const SceneFile scene =
      read("#VRML V2.0 utf8\nEXTERNPROTO B [ field SFVec3f s ] [ \"none.wrl\" \"parts/box.wrl#B\" ]\nB { s 2 2 2 }");
  ASSERT_TRUE(scene.root) << textOf(scene.diagnostics);
  EXPECT_EQ(trianglesOf(scene), 12);
  const SceneFile bad = read("#VRML V2.0 utf8\nEXTERNPROTO B [ ] \"../outside.iv\"\nB { }");
  EXPECT_THAT(textOf(bad.diagnostics),
              HasSubstr(":2: error: EXTERNPROTO: \"../outside.iv\" is outside of the scene's"));
  EXPECT_FALSE(bad.root);
}

TEST_F(NamedFiles, AreNotOpenedWhenAFieldIsSetLater) {
  const SceneFile scene = read(kHeader + "Texture2 { } VRMLInline { } File { }");
  ASSERT_TRUE(scene.root);
  static_cast<SoTexture2*>(scene.root->getChild(0))->filename = (home_ / "pipe.iv").c_str();  // opening it would hang
  static_cast<SoVRMLInline*>(scene.root->getChild(1))->url = (home_ / "pipe.iv").c_str();
  static_cast<SoSFString*>(scene.root->getChild(2)->getField("name"))->setValue((home_ / "pipe.iv").c_str());
  EXPECT_EQ(trianglesOf(scene), 0);
}

}  // namespace
}  // namespace haptiv
