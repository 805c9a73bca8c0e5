#pragma once

#include <QWidget>
#include <memory>

#include "app/dexterity/EllipsoidBoxes.h"
#include "device/described/DeviceDescription.h"

namespace haptiv {

/// What an arm can do from where it is: indices, condition numbers and smallest singular values in translation and
/// rotation, and joint rates against their limits; and how its redundancy is resolved. Thread: GUI.
class DexterityPanel : public QWidget {
  Q_OBJECT
 public:
  explicit DexterityPanel(QWidget* parent = nullptr);
  ~DexterityPanel() override;

  /// The arm whose numbers follow; some milliseconds where it is another than before.
  void setArm(const DeviceDescription& description);
  /// What resolves its redundancy, and whether the user may choose.
  void showChoice(const ResolutionChoice& choice, bool mayChoose);
  /// What the numbers are of, such as "At home: no session runs".
  void showMoment(const QString& moment);
  /// @param q  joint angles [rad]   @param rates  sent to the joints [rad/s]
  void show(const JointVector& q, const JointVector& rates);

  EllipsoidBoxes& ellipsoids();

 signals:
  /// By the user.
  void chosen(const haptiv::ResolutionChoice& choice);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
