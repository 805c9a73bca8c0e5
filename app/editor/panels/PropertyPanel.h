#pragma once

#include <QCheckBox>
#include <QGroupBox>
#include <QLabel>
#include <QScrollArea>

#include "app/editor/document/SceneDocument.h"
#include "app/editor/edits/Edits.h"
#include "app/editor/panels/FieldForm.h"
#include "app/editor/panels/PlaceForm.h"

namespace haptiv {

/// What is selected, how it feels and where it stands; every change is an undo step. Thread: GUI.
class PropertyPanel : public QScrollArea {
  Q_OBJECT
 public:
  explicit PropertyPanel(SceneDocument& document, QWidget* parent = nullptr);

 private:
  void build();
  void refresh();
  void showItem(const std::vector<SceneItem>& items, const SceneItem& item);
  void showSharing(const Sharing& sharing);
  void startGesture() { ++gesture_; }
  void editField(const QString& field, const NewValue& value);
  void editPlace(const std::function<void(ShapeFrame&)>& change, const QString& text);

  SceneDocument& document_;
  Gesture gesture_ = 1;
  QLabel* name_ = nullptr;
  QLabel* kind_ = nullptr;
  QLabel* hint_ = nullptr;
  QLabel* dynamics_ = nullptr;
  QCheckBox* onlyThis_ = nullptr;
  QGroupBox* feelSection_ = nullptr;
  QWidget* placeSection_ = nullptr;
  FieldForm* feel_ = nullptr;
  PlaceForm* place_ = nullptr;
};

}  // namespace haptiv
