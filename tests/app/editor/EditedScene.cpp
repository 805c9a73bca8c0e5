#include "tests/app/editor/EditedScene.h"

#include <Inventor/fields/SoSFFloat.h>
#include <QCoreApplication>
#include <QFile>
#include <stdexcept>

namespace haptiv {

const char kTwoWalls[] = R"(#Inventor V2.1 ascii
Separator {
  HapticDevice { fields [ SFVec3f position ] position -0.6 0 0 }
  HapticTool { fields [ SFFloat radius ] radius 0.01 }
  Separator {
    HapticSurface { fields [ SFFloat stiffness, SFString label ] stiffness 1500 label "left" }
    Transform { translation -0.1 0 0 }
    Cube { width 0.02 height 0.1 depth 0.04 }
  }
  Separator {
    HapticSurface { fields [ SFString label ] label "right" }
    Transform { translation 0.1 0 0 }
    Cube { width 0.02 height 0.1 depth 0.04 }
  }
}
)";

const char kSharedProperty[] = R"(#Inventor V2.1 ascii
Separator {
  HapticTool { }
  HapticSurface { fields [ SFFloat stiffness, SFString label ] stiffness 1200 label "maze" }
  Separator { Transform { translation 0.1 0 0 } Cube { width 0.02 height 0.1 depth 0.04 } }
  Separator { Translation { translation -0.1 0 0 } Cube { width 0.02 height 0.1 depth 0.04 }
              Translation { translation 0 0.2 0 } DEF Far Cube { width 0.04 height 0.1 depth 0.04 } }
}
)";

NewValue number(float value) {
  return [value](const SoField& field) { return FieldValue::of<SoSFFloat>(field, value); };
}

EditedScene::EditedScene(const std::string& text) {
  QFile file(pathOf("scene.iv"));
  if (!file.open(QIODevice::WriteOnly) || file.write(text.data(), static_cast<qint64>(text.size())) < 0) {
    throw std::runtime_error("cannot write the test's scene");
  }
  file.close();
  if (!document.open(pathOf("scene.iv"))) throw std::runtime_error(toText(document.diagnostics().front()));
  letEventsRun();
}

bool EditedScene::select(const QString& name) {
  document.releaseHandles();
  for (const SceneItem& item : items()) {
    if (item.name != name) continue;
    const NodeRef<SoPath> path = pathTo(document.root(), item.place);
    document.select(path.get());
    letEventsRun();
    return true;
  }
  return false;
}

QStringList EditedScene::names() const {
  QStringList names;
  for (const SceneItem& item : items()) names.append(item.name);
  return names;
}

void letEventsRun() {
  for (int turn = 0; turn < 4; ++turn) {
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
  }
}

}  // namespace haptiv
