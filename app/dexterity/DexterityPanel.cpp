#include "app/dexterity/DexterityPanel.h"

#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/dexterity/DexterityColours.h"
#include "app/dexterity/IndexGauge.h"
#include "app/dexterity/RateBars.h"
#include "app/dexterity/StrategySelector.h"
#include "device/kinematics/ArmKinematics.h"
#include "device/redundancy/Normalisation.h"

namespace haptiv {
namespace {

QLabel* heading(const QString& text) {
  auto* label = new QLabel(text);
  label->setStyleSheet("color: " + DexterityColours::faint().name());
  label->setContentsMargins(0, 6, 0, 0);
  return label;
}

}  // namespace

struct DexterityPanel::Parts {
  StrategySelector* selector = new StrategySelector;
  QLabel* moment = new QLabel;
  IndexGauge* translation = new IndexGauge(tr("Translation"), "m/s");
  IndexGauge* rotation = new IndexGauge(tr("Rotation"), "rad/s");
  RateBars* rates = new RateBars;
  EllipsoidBoxes* ellipsoids = new EllipsoidBoxes;

  ArmKinematics arm{DeviceDescription{}};
  std::string armText;  // of its description
  CriterionPair best;   // the normalisation of the index
};

DexterityPanel::DexterityPanel(QWidget* parent) : QWidget(parent), parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  p.moment->setObjectName("momentLabel");
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(6, 4, 6, 4);
  column->setSpacing(4);
  for (QWidget* each :
       std::initializer_list<QWidget*>{p.selector, p.moment, heading(tr("Index V/\u03ba, normalised: 1 is the best")),
                                       p.translation, p.rotation, heading(tr("Joint rates [rad/s]")), p.rates,
                                       heading(tr("Manipulability ellipsoids at the wrist")), p.ellipsoids}) {
    column->addWidget(each);
  }
  column->addStretch(1);
  auto* scroll = new QScrollArea;
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(content);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll);
  connect(p.selector, &StrategySelector::chosen, this, &DexterityPanel::chosen);
}

DexterityPanel::~DexterityPanel() = default;

void DexterityPanel::setArm(const DeviceDescription& description) {
  Parts& p = *parts_;
  if (!description.text.empty() && description.text == p.armText) return;
  p.armText = description.text;
  p.arm = ArmKinematics(description);
  // Of V/kappa of all joints alike, whatever is chosen: numbers can be compared between strategies.
  p.best = normalisation(description, {Strategy::dir, Solution::full}, JointVector::Ones());
  p.rates->setJoints(p.arm.jointCount(), description.drives.rateLimit);
  p.selector->setPartitionedPossible(p.arm.vishard10() != nullptr);
}

void DexterityPanel::showChoice(const ResolutionChoice& choice, bool mayChoose) {
  parts_->selector->show(choice);
  parts_->selector->setEnabled(mayChoose);
}

void DexterityPanel::showMoment(const QString& moment) {
  if (parts_->moment->text() != moment) parts_->moment->setText(moment);
}

void DexterityPanel::show(const JointVector& q, const JointVector& rates) {
  Parts& p = *parts_;
  p.rates->show(rates);
  if (!q.allFinite()) return;
  const Jacobian J = p.arm.jacobian(q);
  p.translation->show(translationalDexterity(J), p.best.translation);
  p.rotation->show(rotationalDexterity(J), p.best.rotation);
}

EllipsoidBoxes& DexterityPanel::ellipsoids() {
  return *parts_->ellipsoids;
}

}  // namespace haptiv

#include "moc_DexterityPanel.cpp"
