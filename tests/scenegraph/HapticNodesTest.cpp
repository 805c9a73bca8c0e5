#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/fields/SoField.h>
#include <Inventor/lists/SoFieldList.h>
#include <gmock/gmock.h>

#include <map>

#include "scenegraph/nodes/SoHapticProperty.h"
#include "scenegraph/writing/SceneWriter.h"
#include "tests/scenegraph/SceneTesting.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

using Fields = std::map<std::string, std::string>;  // name to default value, as written

struct Specification {
  const char* keyword;
  Fields fields;
};

class HapticNode : public ::testing::TestWithParam<Specification> {};

Fields fieldsOf(const SoNode& node) {
  Fields fields;
  SoFieldList list;
  const int count = node.getFields(list);
  for (int i = 0; i < count; ++i) {
    SbName name;
    SbString value;
    node.getFieldName(list[i], name);
    list[i]->get(value);
    fields[name.getString()] = value.getString();
  }
  return fields;
}

TEST_P(HapticNode, HasTheFieldsAndDefaultsOfTheDesign) {
  const SoType type = SoType::fromName(GetParam().keyword);
  ASSERT_NE(type, SoType::badType());
  const NodeRef<SoNode> node(static_cast<SoNode*>(type.createInstance()));
  EXPECT_EQ(fieldsOf(*node.get()), GetParam().fields);
}

TEST_P(HapticNode, IsReadUnderBothNamesAndWrittenUnderTheShortOne) {
  const std::string keyword = GetParam().keyword;
  for (const std::string prefix : {"", "So"}) {
    const SceneFile scene = testing::read(prefix + keyword + " { }");
    ASSERT_TRUE(scene.root);
    ASSERT_EQ(scene.root->getNumChildren(), 1);
    const std::string text = writeSceneText(scene.root.get());
    EXPECT_THAT(text, HasSubstr("\n  " + keyword + " {"));
    EXPECT_THAT(text, Not(HasSubstr("So" + keyword)));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Design, HapticNode,
    ::testing::Values(
        Specification{"HapticSurface",
                      {{"stiffness", "2000"},
                       {"damping", "20"},
                       {"hysteresis", "0"},
                       {"staticFriction", "0"},
                       {"dynamicFriction", "0"},
                       {"enabled", "TRUE"},
                       {"label", "\"\""}}},
        Specification{"HapticViscousZone", {{"damping", "15"}, {"enabled", "TRUE"}, {"label", "\"\""}}},
        Specification{
            "HapticSpringZone",
            {{"stiffness", "150"}, {"anchor", "0 0 0"}, {"restLength", "0"}, {"enabled", "TRUE"}, {"label", "\"\""}}},
        Specification{
            "HapticRubberBand",
            {{"stiffness", "150"}, {"anchor", "0 0 0"}, {"restLength", "0"}, {"enabled", "TRUE"}, {"label", "\"\""}}},
        Specification{"HapticNone", {}},
        Specification{"HapticTool", {{"mass", "2"}, {"damping", "5"}, {"radius", "0.0099999998"}, {"home", "0 0 0"}}},
        Specification{
            "HapticDevice",
            {{"description", "\"vishard10\""}, {"position", "0 0 0"}, {"orientation", "0 0 1  0"}, {"scale", "1"}}}),
    [](const auto& one) { return std::string(one.param.keyword); });

}  // namespace
}  // namespace haptiv
