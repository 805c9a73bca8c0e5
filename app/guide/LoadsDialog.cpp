#include "app/guide/LoadsDialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSaveFile>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>
#include <exception>
#include <stdexcept>

#include "app/calibration/Calibration.h"
#include "app/calibration/LoadsFile.h"
#include "device/calibration/QuietCheck.h"

namespace haptiv {
namespace {

constexpr int kDigits = 6;  // of what is shown: a load that is known better is not

/// Throws std::runtime_error, which cell it is, where that is no number.
double numberAt(const QTableWidget& table, int row, int column) {
  const QTableWidgetItem* item = table.item(row, column);
  const QString text = item == nullptr ? QString() : item->text().trimmed();
  bool isNumber = false;
  const double number = text.toDouble(&isNumber);
  if (isNumber && std::isfinite(number)) return number;
  throw std::runtime_error("load " + std::to_string(row + 1) + ", " + nameOfAxis(column) + ": \"" +
                           text.left(40).toStdString() +
                           "\" is no number; correct it, with a point and without a unit");
}

}  // namespace

LoadsDialog::LoadsDialog(const HandleSensor& sensor, const std::vector<Vector6>& loads, QWidget* parent)
    : QDialog(parent), sensor_(sensor), table_(new QTableWidget(0, 6, this)), weight_(new WeightBox(this)) {
  setObjectName("loadsDialog");
  setWindowTitle(tr("Known loads"));
  resize(860, 560);
  table_->setObjectName("loadsTable");
  table_->setHorizontalHeaderLabels({tr("force x [N]"), tr("force y [N]"), tr("force z [N]"), tr("torque x [N m]"),
                                     tr("torque y [N m]"), tr("torque z [N m]")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  verdict_ = new QLabel(this);
  verdict_->setObjectName("loadsVerdict");
  verdict_->setWordWrap(true);
  verdict_->setMinimumHeight(2 * fontMetrics().lineSpacing() + 4);
  auto* words = new QLabel(tr("What is hung on the handle, one after the other: force and torque on it at the tool, in "
                              "the handle's axes. Seven or more, each axis both ways."),
                           this);
  words->setWordWrap(true);
  auto* middle = new QHBoxLayout;
  middle->addWidget(table_, 1);
  middle->addWidget(weight_);
  auto* all = new QVBoxLayout(this);
  all->addWidget(words);
  all->addLayout(middle, 1);
  all->addWidget(verdict_);
  all->addWidget(buildButtons());
  connect(table_, &QTableWidget::cellChanged, this, &LoadsDialog::judge);
  connect(weight_, &WeightBox::added, this, [this](const HungWeight& weight) { addLine(loadOf(weight)); });
  show(loads);
}

QWidget* LoadsDialog::buildButtons() {
  auto* box = new QDialogButtonBox(this);
  const auto add = [this, box](const char* name, const QString& words, QDialogButtonBox::ButtonRole role) {
    QPushButton* made = box->addButton(words, role);
    made->setObjectName(name);
    made->setAutoDefault(false);
    return made;
  };
  using Box = QDialogButtonBox;
  connect(add("loadsAdd", tr("Add line"), Box::ActionRole), &QPushButton::clicked, this,
          [this] { addLine(Vector6::Zero()); });
  connect(add("loadsRemove", tr("Remove line"), Box::ActionRole), &QPushButton::clicked, this, [this] {
    table_->removeRow(table_->currentRow());
    judge();
  });
  connect(add("loadsStandard", tr("Standard loads"), Box::ActionRole), &QPushButton::clicked, this,
          [this] { show(standardLoads()); });
  connect(add("loadsOpen", tr("Open..."), Box::ActionRole), &QPushButton::clicked, this, &LoadsDialog::openFile);
  connect(add("loadsSave", tr("Save..."), Box::ActionRole), &QPushButton::clicked, this, &LoadsDialog::saveFile);
  take_ = add("loadsTake", tr("Use these"), Box::AcceptRole);
  add("loadsCancel", tr("Cancel"), Box::RejectRole);
  connect(box, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(box, &QDialogButtonBox::rejected, this, &QDialog::reject);
  return box;
}

void LoadsDialog::show(const std::vector<Vector6>& loads) {
  table_->setRowCount(0);
  for (const Vector6& load : loads) append(load);
  judge();
}

void LoadsDialog::append(const Vector6& load) {
  const QSignalBlocker untilItIsWhole(table_);
  const int row = table_->rowCount();
  table_->insertRow(row);
  for (int axis = 0; axis < 6; ++axis) {
    auto* item = new QTableWidgetItem(QString::number(load[axis] + 0.0, 'g', kDigits));
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table_->setItem(row, axis, item);
  }
  table_->setCurrentCell(row, 0);
}

void LoadsDialog::addLine(const Vector6& load) {
  append(load);
  judge();
}

std::vector<Vector6> LoadsDialog::entered() const {
  std::vector<Vector6> loads(static_cast<std::size_t>(table_->rowCount()));
  for (int row = 0; row < table_->rowCount(); ++row)
    for (int axis = 0; axis < 6; ++axis) loads[static_cast<std::size_t>(row)][axis] = numberAt(*table_, row, axis);
  return loads;
}

void LoadsDialog::judge() {
  try {
    const std::vector<Vector6> loads = entered();
    const double condition = expectTelling(loads, sensor_);
    loads_ = loads;
    tell(tr("%1 loads, which tell the axes apart: condition %2, where 1 is best and 50 is refused.")
             .arg(loads.size())
             .arg(condition, 0, 'g', 3),
         false);
  } catch (const std::exception& error) {
    const QString words = QString::fromUtf8(error.what());
    tell(words.left(1).toUpper() + words.mid(1), true);
  }
}

void LoadsDialog::openFile() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Known loads"), QString(), tr("CSV (*.csv);;All (*)"));
  if (path.isEmpty()) return;
  try {
    std::vector<Vector6> loads;
    for (const KnownLoad& known : readLoadsFile(path.toStdString())) {
      if (known.counts)
        throw std::runtime_error(path.toStdString() +
                                 ": has the sensor's counts too, so nothing is to be hung on: use haptiv device "
                                 "calibrate --loads");
      loads.push_back(known.load);
    }
    show(loads);
  } catch (const std::exception& error) {  // what stands in the table stays
    verdict_->setText(QString::fromUtf8(error.what()));
  }
}

void LoadsDialog::saveFile() {
  const QString path = QFileDialog::getSaveFileName(this, tr("Known loads"), "loads.csv", tr("CSV (*.csv)"));
  if (path.isEmpty()) return;
  QSaveFile file(path);
  const QByteArray text = QByteArray::fromStdString(loadsText(loads_));
  const bool written = file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit();
  verdict_->setText(written ? tr("Saved: haptiv device calibrate --loads %1 takes them too").arg(path)
                            : tr("%1: cannot be written: %2").arg(path, file.errorString()));
}

void LoadsDialog::tell(const QString& what, bool wrong) {
  QPalette palette = this->palette();
  if (wrong) palette.setColor(QPalette::WindowText, QColor(190, 30, 30));
  verdict_->setPalette(palette);
  verdict_->setText(what);
  for (QPushButton* each : {take_, findChild<QPushButton*>("loadsSave")}) each->setEnabled(!wrong);
}

}  // namespace haptiv

#include "moc_LoadsDialog.cpp"
