#include "app/window/SessionStatus.h"

namespace haptiv {

namespace {

QLabel* label(QStatusBar* bar, const char* name, bool permanent) {
  auto* label = new QLabel(bar);
  label->setObjectName(name);
  label->setMargin(3);
  if (permanent) {
    bar->addPermanentWidget(label);
  } else {
    bar->addWidget(label);
  }
  return label;
}

}  // namespace

SessionStatus::SessionStatus(QWidget* parent) : QStatusBar(parent) {
  state_ = label(this, "modeLabel", false);
  hint_ = label(this, "hintLabel", false);
  force_ = label(this, "forceLabel", true);
  rate_ = label(this, "rateLabel", true);
  missed_ = label(this, "missedLabel", true);
  scheduling_ = label(this, "schedulingLabel", true);
  QFont bold = font();
  bold.setBold(true);
  state_->setFont(bold);
  clearSession();
}

void SessionStatus::showState(const QString& state, const QString& hint) {
  state_->setText(state);
  state_->setStyleSheet({});
  hint_->setText(hint);
}

void SessionStatus::showTick(const TickRecord& record, double rate) {
  force_->setText(tr("force %1 N").arg(record.environmentForce.norm(), 5, 'f', 1));
  rate_->setText(tr("%1 Hz").arg(rate, 0, 'f', 0));
  missed_->setText(tr("missed ticks: %1").arg(record.missedTicks));
  for (QLabel* label : {force_, rate_, missed_}) label->show();
  if (record.faults != kNoFault) {
    showState(tr("Fault: %1").arg(faultName(static_cast<Fault>(record.faults))),
              tr("the arm is braked; stop the session to go on"));
    state_->setStyleSheet("color: #b00020");
  }
}

void SessionStatus::showScheduling(const Scheduling& scheduling) {
  scheduling_->setText(scheduling.realtime ? tr("real-time") : tr("not real-time"));
  scheduling_->setToolTip(QString::fromStdString(scheduling.explanation));
  scheduling_->show();
}

void SessionStatus::clearSession() {
  for (QLabel* label : {force_, rate_, missed_, scheduling_}) label->hide();
}

}  // namespace haptiv
