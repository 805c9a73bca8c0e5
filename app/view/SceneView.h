#pragma once

#include <Inventor/SoPath.h>

#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>

#include "app/view/drawn/HapticOverlay.h"

namespace haptiv {

/// The 3-D view: the scene, the overlay, lights, ground grid and the cameras; turns the mouse into what is meant by it.
///
/// Mouse, whatever the mode: right drag orbits, middle drag pans, wheel zooms (the user can always look around).
/// Left button: in `hand` mode it takes hold of the ball; in `select` mode it clicks on shapes and drags the handles
/// of the editor.
class SceneView : public QWidget {
  Q_OBJECT
 public:
  enum class LeftButton { select, hand };

  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  /// Shows this graph (kept by reference); null: nothing but the grid. The camera stays, unless `viewAll`.
  void setScene(SoNode* root, bool viewAll);
  HapticOverlay& overlay();
  /// Under this separator the editor hangs what it draws over the scene (handles stay in the scene itself).
  SoSeparator* decorations();
  void setLeftButton(LeftButton meaning);

  /// Straight down, orthographic, as a plan with x to the right and y up; otherwise perspective from the side. Both
  /// look at the same place.
  void viewFromAbove();
  void viewFreely();
  bool isFromAbove() const;
  /// Of the look, about z: 0 looks along y [rad].
  double heading() const;
  void viewAll();
  /// As the scene's own first camera looks; all of the scene where it has none.
  void viewAsMeant();
  /// Draws again soon; cheap to call often.
  void redraw();
  /// What the view shows now.
  QImage grabImage();
  /// Where a point of the world is in the widget [pixels]; for tests and labels.
  QPointF toWidget(const Vector3& p_W) const;

 signals:
  /// A click (not a drag) in select mode on a shape of the scene; null: on nothing. The path starts at the scene's
  /// root.
  void shapeClicked(const SoPath* path);
  /// hand mode: where the hand wants the ball, in W; nothing: it lets go.
  void handMoved(const std::optional<haptiv::Vector3>& p_WH);
  /// The plan came or went: also by orbiting out of it with the mouse.
  void fromAboveChanged(bool fromAbove);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
