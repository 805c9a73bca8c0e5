#include "app/dexterity/StrategySelector.h"

#include <QFormLayout>
#include <QStandardItemModel>

#include "app/dexterity/DexterityColours.h"
#include "device/control/ResolutionNames.h"

namespace haptiv {
namespace {

QString meaningOf(Strategy strategy) {
  switch (strategy) {
    case Strategy::nonopt:
      return StrategySelector::tr("least joint rates, no side criterion");
    case Strategy::man:
      return StrategySelector::tr("volume V of the manipulability ellipsoids, eq. (10)");
    case Strategy::dir:
      return StrategySelector::tr("volume over condition number, eq. (14)");
    case Strategy::cond:
      return StrategySelector::tr("condition number, eq. (11)");
  }
  return {};
}

QString shortMeaningOf(Strategy strategy) {
  switch (strategy) {
    case Strategy::nonopt:
      return StrategySelector::tr("least rates");
    case Strategy::man:
      return StrategySelector::tr("volume V");
    case Strategy::dir:
      return QString::fromUtf8("V/\u03ba");
    case Strategy::cond:
      return StrategySelector::tr("condition \u03ba");
  }
  return {};
}

}  // namespace

StrategySelector::StrategySelector(QWidget* parent)
    : QWidget(parent), strategy_(new QComboBox), solution_(new QComboBox) {
  strategy_->setObjectName("strategyBox");
  solution_->setObjectName("solutionBox");
  for (const Strategy each : kStrategies) {
    strategy_->addItem(QString("%1: %2").arg(QString::fromStdString(nameOf(each)), shortMeaningOf(each)),
                       static_cast<int>(each));
    strategy_->setItemData(strategy_->count() - 1, meaningOf(each), Qt::ToolTipRole);
  }
  for (const Solution each : kSolutions)
    solution_->addItem(QString::fromStdString(nameOf(each)), static_cast<int>(each));
  strategy_->setToolTip(tr("What the arm's self-motion is used for"));
  solution_->setToolTip(tr("All joints at once, or position and orientation apart, eqs. (24), (25)"));

  QPalette readable = palette();  // also where nothing can be chosen
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    readable.setColor(QPalette::Disabled, role, DexterityColours::faint());
  setPalette(readable);

  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(tr("Strategy"), strategy_);
  form->addRow(tr("Solution"), solution_);
  for (QComboBox* box : {strategy_, solution_})
    connect(box, qOverload<int>(&QComboBox::activated), this, [this] { announce(); });
}

void StrategySelector::show(const ResolutionChoice& choice) {
  strategy_->setCurrentIndex(strategy_->findData(static_cast<int>(choice.strategy)));
  solution_->setCurrentIndex(solution_->findData(static_cast<int>(choice.solution)));
}

void StrategySelector::setPartitionedPossible(bool possible) {
  const int row = solution_->findData(static_cast<int>(Solution::partitioned));
  auto* items = qobject_cast<QStandardItemModel*>(solution_->model());
  items->item(row)->setEnabled(possible);
  items->item(row)->setToolTip(possible ? QString() : tr("Only VISHARD10's position and orientation come apart"));
}

void StrategySelector::announce() {
  emit chosen({static_cast<Strategy>(strategy_->currentData().toInt()),
               static_cast<Solution>(solution_->currentData().toInt())});
}

}  // namespace haptiv

#include "moc_StrategySelector.cpp"
