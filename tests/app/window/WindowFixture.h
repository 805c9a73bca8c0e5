#pragma once

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <memory>
#include <stdexcept>
#include <string>

#include "app/editor/document/SceneDocument.h"
#include "app/session/log/reading/SessionLog.h"
#include "app/view/SceneView.h"
#include "app/window/MainWindow.h"
#include "tests/app/window/Gestures.h"

namespace haptiv {

/// The real window and a user's means: its buttons, fields and the mouse. Each test has a home folder of its own.
class Window : public ::testing::Test {
 protected:
  void SetUp() override;

  void openScene(const std::string& text);

  template <typename T>
  T& find(const char* name = "") {
    T* found = window_->findChild<T*>(name);
    if (found == nullptr) throw std::runtime_error(std::string("the window has no ") + name);
    return *found;
  }
  SceneDocument& document() { return find<SceneDocument>(); }
  SceneView& view() { return find<SceneView>(); }

  /// Clicks the tool bar's button for this action, as a user does.
  void clickButton(const char* action);
  void type(const char* field, const QString& number);
  /// Starts a session, and waits until it runs.
  void startSession();
  /// Ends it, and waits for its replay.
  void stopSession();

  /// A session: takes hold of the ball where it is and pulls it to this place for a while; stops. Its log.
  SessionLog feel(const Vector3& target);
  /// However long that takes on a busy machine: there the simulated arm falls behind the clock.
  void waitUntilTheBallRests();
  QString onlyLog();
  /// Of the whole screen, for people to look at: HAPTIV_PICTURES names a folder.
  static void picture(const char* name);
  static std::uint64_t hardestTick(const SessionLog& log);

  QTemporaryDir home_;
  std::unique_ptr<MainWindow> window_;
  Vector3 reached_ = Vector3::Zero();  // by the ball, in `feel`
};

/// A wall whose face towards the ball is at y = 0.045; the ball rests at the origin's height 0.
inline constexpr const char* kWallAhead = R"(#Inventor V2.1 ascii
HapticDevice { position -0.3 0 0 }
HapticTool { home 0 0 0 radius 0.01 }
Separator {
  HapticSurface { stiffness 2000 label "ahead" }
  Transform { translation 0 0.05 0 }
  Material { diffuseColor 0.3 0.5 0.8 }
  Cube { width 0.3 height 0.01 depth 0.04 }
}
)";

/// Only the ball, at rest in the origin's height.
inline constexpr const char* kNoWalls = R"(#Inventor V2.1 ascii
HapticDevice { position -0.3 0 0 }
HapticTool { home 0 0 0.02 radius 0.01 }
)";

}  // namespace haptiv
