#include <Inventor/SoOutput.h>
#include <Inventor/actions/SoWriteAction.h>
#include <gmock/gmock.h>
#include <zlib.h>

#include <cstdlib>
#include <fstream>

#include "tests/scenegraph/SceneTesting.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using testing::textOf;
using testing::trianglesOf;

std::string gzipped(const std::string& text) {
  std::string packed(compressBound(text.size()) + 64, '\0');
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::string binary(SoNode* root) {
  SoOutput output;
  output.setBinary(TRUE);
  output.setBuffer(std::malloc(1), 1, &std::realloc);
  SoWriteAction(&output).apply(root);
  void* bytes = nullptr;
  std::size_t size = 0;
  output.getBuffer(bytes, size);
  std::string text(static_cast<const char*>(bytes), size);
  std::free(bytes);
  return text;
}

/// What a file says of itself in comments: "# triangles: N" and, of each warning, "# expect: PART".
std::vector<std::string> saidIn(const std::string& text, const std::string& mark) {
  std::vector<std::string> said;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with('\r')) line.pop_back();
    if (const auto at = line.find(mark); at != std::string::npos) said.push_back(line.substr(at + mark.size()));
  }
  return said;
}

class GoodScene : public ::testing::TestWithParam<std::filesystem::path> {};

TEST_P(GoodScene, LoadsWithItsTrianglesAndNoMoreThanItsWarnings) {
  const SceneFile scene = readScene(GetParam());
  ASSERT_TRUE(scene.root) << textOf(scene.diagnostics);
  EXPECT_EQ(std::to_string(trianglesOf(scene)), saidIn(scene.text, "# triangles: ").at(0));
  const auto expected = saidIn(scene.text, "# expect: ");
  for (const std::string& part : expected) EXPECT_THAT(textOf(scene.diagnostics), HasSubstr(part));
  EXPECT_EQ(scene.diagnostics.size(), expected.size()) << textOf(scene.diagnostics);
}

TEST_P(GoodScene, LoadsAsBinaryAndGzippedToo) {
  const SceneFile scene = readScene(GetParam());
  ASSERT_TRUE(scene.root) << textOf(scene.diagnostics);
  const SceneFile packed = readSceneText(gzipped(scene.text), GetParam());
  ASSERT_TRUE(packed.root) << textOf(packed.diagnostics);
  EXPECT_EQ(packed.text, scene.text);
  if (!saidIn(scene.text, "# text only").empty()) return;
  const SceneFile converted = readSceneText(gzipped(binary(scene.root.get())), GetParam());
  ASSERT_TRUE(converted.root) << textOf(converted.diagnostics);
  EXPECT_EQ(trianglesOf(converted), trianglesOf(scene));
  EXPECT_EQ(converted.lineOf.size(), converted.fileOf.size()) << "only what is included has lines";
}

INSTANTIATE_TEST_SUITE_P(Data, GoodScene,
                         ::testing::ValuesIn(testing::scenesIn(testing::sourceDir() / "tests/data/scenes/good")),
                         testing::nameOfFile);

TEST(SceneFormats, RefuseAFileThatUnpacksToTooMuch) {
  const std::string bomb = gzipped(std::string(300u << 20, ' '));
  EXPECT_LT(bomb.size(), 1u << 20);
  EXPECT_THAT(textOf(readSceneText(bomb, "test.iv").diagnostics), HasSubstr("unpacks to more than 256 MB"));
}

TEST(SceneFormats, RefuseEveryBeginningOfAPackedOrBinaryFile) {
  const SceneFile whole =
      testing::read("Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0 ] } IndexedFaceSet { coordIndex [ 0, 1, 2, -1 ] }");
  const std::string bytes = binary(whole.root.get());
  const std::string packed = gzipped(whole.text);
  for (std::size_t size = 1; size + 9 < packed.size(); size += 5)
    EXPECT_FALSE(readSceneText(packed.substr(0, size), "test.iv").root) << size;
  for (std::size_t size = 1; size < bytes.size(); size += 9)
    EXPECT_FALSE(readSceneText(bytes.substr(0, size), "test.iv").root) << size;
}

TEST(SceneFormats, KeepEveryBitOfABinaryFloat) {
  const SceneFile first = testing::read("Translation { translation 0.1 0.3 1e-30 }");
  auto* field = static_cast<SoNode*>(first.root->getChild(0))->getField("translation");
  ASSERT_TRUE(field->set("0.100000009 16777217 3.40282347e38"));
  const SceneFile second = readSceneText(binary(first.root.get()), "test.iv");
  ASSERT_TRUE(second.root) << textOf(second.diagnostics);
  EXPECT_TRUE(second.root->getChild(0)->getField("translation")->isSame(*field));
}

}  // namespace
}  // namespace haptiv
