#include "app/window/session/ScenePublisher.h"

#include <QApplication>
#include <QElapsedTimer>

namespace haptiv {
namespace {

constexpr int kSlowText = 8;        // [ms], half a graphics frame
constexpr int kPauseForText = 300;  // [ms] without an edit
/// So many shapes may wait to be logged, or one scene: of a scene of a hundred thousand walls the log takes a second.
constexpr std::size_t kMostToLog = 100000;
constexpr int kPauseForLog = 20;  // [ms] until the log is asked again

}  // namespace

ScenePublisher::ScenePublisher(SceneDocument& document, QObject* parent) : QObject(parent), document_(document) {
  textPause_.setSingleShot(true);
  textPause_.setInterval(kPauseForText);
  logPause_.setSingleShot(true);
  logPause_.setInterval(kPauseForLog);
  connect(&document.undoStack(), &QUndoStack::indexChanged, this, &ScenePublisher::keepText);
  connect(&textPause_, &QTimer::timeout, this, [this] {
    if (QApplication::mouseButtons() != Qt::NoButton) return textPause_.start();  // a handle may be held
    if (session_) takeLateText();
  });
  connect(&logPause_, &QTimer::timeout, this, &ScenePublisher::publish);
  connect(&document, &SceneDocument::sceneReady, this, &ScenePublisher::publish);
}

const SharedText& ScenePublisher::takeText() {
  QElapsedTimer timer;
  timer.start();
  text_ = document_.text();
  isTextSlow_ = timer.elapsed() > kSlowText;
  textPause_.stop();
  return text_;
}

void ScenePublisher::follow(Session& session) {
  session_ = &session;
}

void ScenePublisher::finish() {
  if (textPause_.isActive()) {
    takeLateText();
    document_.compileNow();
    publishAtOnce();
  }
  logPause_.stop();
  session_ = nullptr;
}

/// The text is taken only where a command is complete: while a handle is dragged, many scenes share one. That of a
/// scene with large meshes takes its time; it is taken when the user pauses.
void ScenePublisher::keepText() {
  if (!session_) return;
  if (isTextSlow_) {
    textPause_.start();
  } else {
    takeText();
  }
}

/// Gives the log the text of the scene that is felt already, as that of a new version.
void ScenePublisher::takeLateText() {
  takeText();
  document_.noteChange();
}

/// While a large scene is dragged, more versions are made than the log can take: the servo gets the newest as soon as
/// there is room for it. An edit by itself is felt at once.
void ScenePublisher::publish() {
  if (session_ && session_->shapesToLog() > kMostToLog) return logPause_.start();
  publishAtOnce();
}

void ScenePublisher::publishAtOnce() {
  logPause_.stop();
  if (session_ && !hasErrors(document_.compiled().diagnostics)) session_->publish(document_.compiled().scene, text_);
}

}  // namespace haptiv

#include "moc_ScenePublisher.cpp"
