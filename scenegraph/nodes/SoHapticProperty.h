#pragma once

#include <Inventor/nodes/SoSubNode.h>

namespace haptiv {

/// What the property nodes have in common: each says how the shapes after it feel, to the right and downwards,
/// until another one or the end of the Separator.
class SoHapticProperty : public SoNode {
  typedef SoNode inherited;
  SO_NODE_ABSTRACT_HEADER(SoHapticProperty);

 public:
  static void initClass();

  /// Whether the shapes under it are felt at all.
  virtual bool isFelt() const = 0;

  void doAction(SoAction* action) override;
  void callback(SoCallbackAction* action) override;
  void pick(SoPickAction* action) override;

 protected:
  SoHapticProperty();
  ~SoHapticProperty() override;
};

}  // namespace haptiv
