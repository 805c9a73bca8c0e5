#include "app/editor/panels/PropertyPanel.h"

#include <QVBoxLayout>

#include "app/editor/edits/Edits.h"
#include "app/editor/panels/KindNames.h"
#include "app/editor/panels/WallDynamics.h"

namespace haptiv {
namespace {

bool isShape(const SceneItem& item) {
  return item.kind != SceneItem::Kind::tool && item.kind != SceneItem::Kind::device;
}

QGroupBox* section(const QString& title, QWidget* form) {
  auto* box = new QGroupBox(title);
  auto* layout = new QVBoxLayout(box);
  layout->addWidget(form);
  return box;
}

QLabel* wrapped(const QString& name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  return label;
}

}  // namespace

PropertyPanel::PropertyPanel(SceneDocument& document, QWidget* parent) : QScrollArea(parent), document_(document) {
  setObjectName("propertyPanel");
  build();
  connect(&document, &SceneDocument::selectionChanged, this, [this] {
    startGesture();
    onlyThis_->setChecked(true);
    refresh();
  });
  connect(&document, &SceneDocument::sceneChanged, this, &PropertyPanel::refresh);
  connect(feel_, &FieldForm::edited, this, &PropertyPanel::editField);
  connect(feel_, &FieldForm::gestureEnded, this, &PropertyPanel::startGesture);
  connect(place_, &PlaceForm::edited, this, &PropertyPanel::editPlace);
  connect(place_, &PlaceForm::gestureEnded, this, &PropertyPanel::startGesture);
  refresh();
}

void PropertyPanel::build() {
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  name_ = wrapped("selectionName");
  QFont bold = name_->font();
  bold.setBold(true);
  bold.setPointSizeF(bold.pointSizeF() * 1.2);
  name_->setFont(bold);
  kind_ = wrapped("selectionKind");
  hint_ = wrapped("selectionHint");
  dynamics_ = wrapped("wallDynamics");
  onlyThis_ = new QCheckBox("Change only this one");
  onlyThis_->setObjectName("onlyThisBox");
  onlyThis_->setChecked(true);
  feel_ = new FieldForm;
  feelSection_ = section("Feel", feel_);
  place_ = new PlaceForm;
  placeSection_ = section("Place and size", place_);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{name_, kind_, feelSection_, dynamics_, hint_, onlyThis_, placeSection_}) {
    layout->addWidget(widget);
  }
  layout->addStretch();
  setWidget(content);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setMinimumWidth(270);
}

void PropertyPanel::refresh() {
  const std::vector<SceneItem> items = listScene(document_.root());
  const SceneItem* item = findItem(items, document_.selection());
  for (QWidget* widget : std::initializer_list<QWidget*>{kind_, onlyThis_, feelSection_, dynamics_, placeSection_}) {
    widget->setVisible(false);
  }
  if (item) return showItem(items, *item);
  name_->setText("Nothing selected");
  hint_->setText("Click a wall or a zone in the view, or choose anything in the scene tree.");
  hint_->setVisible(true);
}

void PropertyPanel::showItem(const std::vector<SceneItem>& items, const SceneItem& item) {
  name_->setText(item.name);
  kind_->setText(kindName(item.kind));
  kind_->setVisible(item.name != kindName(item.kind));
  hint_->setVisible(false);
  feelSection_->setTitle(isShape(item) ? "Feel" : "Settings");
  if (!isShape(item)) {
    feel_->show(item.node);
    feelSection_->setVisible(true);
    return;
  }
  const bool hasFeel = item.property && !rowsFor(keyword(*item.property)).isEmpty();
  feel_->show(hasFeel ? item.property : nullptr);
  feelSection_->setVisible(hasFeel);
  dynamics_->setText(wallDynamicsText(document_, item.property));
  dynamics_->setVisible(!dynamics_->text().isEmpty());
  if (hasFeel) showSharing(sharingOf(items, item, document_.root()));
  if (!hasFeel) {
    hint_->setText("It is drawn, but the hand goes through it.");
    hint_->setVisible(true);
  }
  const auto frame = ShapeFrame::of(*document_.selection());
  placeSection_->setVisible(frame.has_value());
  if (frame) place_->show(*frame, keyword(*item.node));
}

void PropertyPanel::showSharing(const Sharing& sharing) {
  if (sharing.shapes == 1) return;
  hint_->setVisible(true);
  if (sharing.shapes == sharing.inseparable) {
    hint_->setText(QString("It is used %1 times: changes apply to all of them.").arg(sharing.shapes));
    return;
  }
  onlyThis_->setVisible(true);
  hint_->setText(
      onlyThis_->isChecked()
          ? QString("%1 shapes share these values; a change gives this one values of its own.").arg(sharing.shapes)
          : QString("A change applies to all %1 shapes that share these values.").arg(sharing.shapes));
}

void PropertyPanel::editField(const QString& field, const NewValue& value) {
  const SoPath* selection = document_.selection();
  if (!selection) return;
  const QString word = keyword(*selection->getTail());
  const QByteArray name = field.toUtf8();
  if (word == "HapticTool" || word == "HapticDevice")
    return editSelectedNode(document_, name.constData(), value, gesture_);
  editProperty(document_, name.constData(), value, onlyThis_->isChecked() ? Reach::onlyThis : Reach::allThatShare,
               gesture_);
}

void PropertyPanel::editPlace(const std::function<void(ShapeFrame&)>& change, const QString& text) {
  moveShape(document_, change, text, gesture_);
}

}  // namespace haptiv

#include "moc_PropertyPanel.cpp"
