#pragma once

#include <QObject>
#include <QTimer>

#include "app/editor/document/SceneDocument.h"
#include "app/session/Session.h"

namespace haptiv {

/// Hands what is edited to the running session: every valid compilation of the document goes to the servo, with the
/// text that the log gets. Both take their time where a scene is large, and wait until there is some. Thread: GUI.
class ScenePublisher : public QObject {
  Q_OBJECT
 public:
  explicit ScenePublisher(SceneDocument& document, QObject* parent = nullptr);

  /// The document as it is now, as text: what a session starts with.
  const SharedText& takeText();
  /// From now on; until `finish`, `session` must live.
  void follow(Session& session);
  /// What still waits is handed over before the session stops.
  void finish();

 private:
  void keepText();
  void takeLateText();
  void publish();
  void publishAtOnce();

  SceneDocument& document_;
  Session* session_ = nullptr;
  SharedText text_;          // of the scene as it was when the last command had been done
  bool isTextSlow_ = false;  // to be written: what is edited is felt before it is
  QTimer textPause_;
  QTimer logPause_;
};

}  // namespace haptiv
