#include "app/dexterity/DexterityPanel.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QStandardItemModel>
#include <QTest>

#include "app/dexterity/RateBars.h"

namespace haptiv {
namespace {

/// A chain of two joints, of no use but to be no VISHARD10.
DeviceDescription twoJoints() {
  DeviceDescription description;
  description.chain.joints = {ChainJoint{}, ChainJoint{}};
  description.chain.joints[1].mount.position = Vector3(0.3, 0, 0);
  description.chain.end.position = Vector3(0.3, 0, 0);
  return description;
}

class DexterityPanelTest : public ::testing::Test {
 protected:
  DexterityPanelTest() { panel_.setArm(vishard10_); }

  QStringList texts(const char* label) {
    QStringList found;
    for (const QLabel* each : panel_.findChildren<QLabel*>(label)) found << each->text();
    return found;
  }
  QComboBox& box(const char* name) { return *panel_.findChild<QComboBox*>(name); }

  DeviceDescription vishard10_ = loadDeviceDescription("vishard10");
  DexterityPanel panel_;
  std::vector<ResolutionChoice> chosen_;
};

TEST_F(DexterityPanelTest, CallsOnlyASingularPoseSingular) {
  panel_.show(vishard10_.homeAngles, JointVector::Zero());
  EXPECT_EQ(texts("singularityLabel"), QStringList({"", ""})) << "translation, rotation";
  panel_.show(JointVector::Zero(), JointVector::Zero());  // stretched: the tool cannot move along x
  EXPECT_EQ(texts("singularityLabel").first(), "singular");
}

TEST_F(DexterityPanelTest, ShowsANormalisedIndexThatIsZeroInASingularPose) {
  panel_.show(vishard10_.homeAngles, JointVector::Zero());
  for (const QString& index : texts("indexLabel")) EXPECT_GT(index.toDouble(), 0.05) << index.toStdString();
  panel_.show(JointVector::Zero(), JointVector::Zero());
  EXPECT_EQ(texts("indexLabel").first(), "0.00");
}

TEST_F(DexterityPanelTest, AnnouncesWhatTheUserChoosesAndNothingElse) {
  QObject::connect(&panel_, &DexterityPanel::chosen,
                   [this](const ResolutionChoice& choice) { chosen_.push_back(choice); });
  panel_.showChoice({Strategy::man, Solution::full}, true);
  EXPECT_TRUE(chosen_.empty());
  EXPECT_TRUE(box("strategyBox").currentText().startsWith("man"));
  QTest::keyClick(&box("strategyBox"), Qt::Key_Down);
  QTest::keyClick(&box("solutionBox"), Qt::Key_Down);
  ASSERT_EQ(chosen_.size(), 2u);
  EXPECT_EQ(chosen_.front(), (ResolutionChoice{Strategy::dir, Solution::full}));
  EXPECT_EQ(chosen_.back(), (ResolutionChoice{Strategy::dir, Solution::partitioned}));
}

TEST_F(DexterityPanelTest, OffersAnotherArmWhatThatCan) {
  const auto possible = [this] {
    return qobject_cast<QStandardItemModel*>(box("solutionBox").model())->item(1)->isEnabled();
  };
  const auto& bars = *panel_.findChild<RateBars*>("rateBars");
  EXPECT_TRUE(possible());
  EXPECT_EQ(bars.jointCount(), 10);
  panel_.setArm(twoJoints());
  EXPECT_FALSE(possible()) << "only VISHARD10 has a partitioned solution";
  EXPECT_EQ(bars.jointCount(), 2);
}

TEST_F(DexterityPanelTest, EllipsoidsAreSwitchedByBoxAndByMenuAlike) {
  std::vector<std::pair<Manipulability, bool>> switched;
  QObject::connect(&panel_.ellipsoids(), &EllipsoidBoxes::switched,
                   [&](Manipulability which, bool visible) { switched.emplace_back(which, visible); });
  panel_.findChild<QAbstractButton*>("rotationalEllipsoidBox")->click();
  EXPECT_TRUE(panel_.ellipsoids().action(Manipulability::rotational)->isChecked());
  panel_.ellipsoids().action(Manipulability::rotational)->trigger();
  EXPECT_FALSE(panel_.findChild<QAbstractButton*>("rotationalEllipsoidBox")->isChecked());
  const std::vector<std::pair<Manipulability, bool>> expected = {{Manipulability::rotational, true},
                                                                 {Manipulability::rotational, false}};
  EXPECT_EQ(switched, expected);
}

}  // namespace
}  // namespace haptiv
