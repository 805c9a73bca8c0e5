#include "app/window/session/SessionStatus.h"

namespace haptiv {

namespace {

constexpr const char* kGood = "#006b2d";
constexpr const char* kCareful = "#8a5a00";
constexpr const char* kBad = "#b00020";

struct Hints {
  const char *ready, *running;
};

Hints hintsOf(SessionStatus::HandBy by) {
  switch (by) {
    case SessionStatus::HandBy::mouse:
      return {"the arm is braked: take the ball with the left mouse button, or hold Space",
              "pull the ball with the left mouse button, with Shift up and down; Esc stops at once"};
    case SessionStatus::HandBy::spaceMouse:
      return {"the arm is braked: hold button 1 of the SpaceMouse, and push its cap",
              "push the SpaceMouse's cap while you hold its button 1; Esc stops at once"};
    case SessionStatus::HandBy::device:
      return {"no force yet: hold the device's dead-man's button", "feel the scene with the device; Esc stops at once"};
  }
  return {};
}

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
  show(state, hint, {});
}

void SessionStatus::show(const QString& state, const QString& hint, const QString& colour) {
  const QString style = colour.isEmpty() ? QString() : "color: " + colour;
  if (state_->text() != state) state_->setText(state);
  if (state_->styleSheet() != style) state_->setStyleSheet(style);
  if (hint_->text() != hint) hint_->setText(hint);
}

void SessionStatus::showTrouble(const QString& trouble) {
  trouble_ = trouble;
}

void SessionStatus::showTick(const TickRecord& record, double rate) {
  force_->setText(tr("force %1 N").arg(record.environmentForce.norm(), 5, 'f', 1));
  rate_->setText(tr("%1 Hz").arg(rate, 0, 'f', 0));
  missed_->setText(tr("missed ticks: %1").arg(record.missedTicks));
  for (QLabel* label : {force_, rate_, missed_}) label->show();
  showSessionState(record);
}

void SessionStatus::showSessionState(const TickRecord& record) {
  const auto hint = [this](const QString& usual) { return trouble_.isEmpty() ? usual : trouble_; };
  switch (record.state) {
    case SessionState::idle:
      return show(tr("Starting"), hint(tr("the arm has not been read yet")), {});
    case SessionState::ready:
      return show(tr("Ready"), hint(tr(hintsOf(handBy_).ready)), kCareful);
    case SessionState::running:
      return show(tr("Running"), hint(tr(hintsOf(handBy_).running)), kGood);
    case SessionState::fault:
      return show(tr("Fault: %1").arg(QString::fromStdString(faultList(record.faults))),
                  tr("the arm is braked: let go, then Reset (F7)"), kBad);
  }
}

void SessionStatus::showScheduling(const Scheduling& scheduling) {
  scheduling_->setText(scheduling.realtime ? tr("real-time") : tr("not real-time"));
  scheduling_->setToolTip(QString::fromStdString(scheduling.explanation));
  scheduling_->show();
}

void SessionStatus::clearSession() {
  trouble_.clear();
  for (QLabel* label : {force_, rate_, missed_, scheduling_}) label->hide();
}

}  // namespace haptiv

#include "moc_SessionStatus.cpp"
