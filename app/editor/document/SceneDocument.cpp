#include "app/editor/document/SceneDocument.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoPath.h>
#include <Inventor/nodes/SoSeparator.h>

#include <QTimer>
#include <stdexcept>

#include "app/editor/document/LiveCompilation.h"
#include "app/editor/document/Selection.h"
#include "app/view/picture/PictureDecoder.h"
#include "scenegraph/writing/LastingText.h"
#include "scenegraph/writing/SceneSaver.h"
#include "scenegraph/writing/SceneWriter.h"

namespace haptiv {
namespace {

// The device stands so that the arm has room around the scene's origin and is far from singular there.
constexpr char kEmptyScene[] =
    "#Inventor V2.1 ascii\n\n"
    "Separator {\n"
    "  HapticDevice { fields [ SFVec3f position ] position -0.4 0 0 }\n"
    "  HapticTool { fields [ SFVec3f home ] home 0 0 0.02 }\n"
    "}\n";

}  // namespace

struct SceneDocument::Parts {
  SceneFile file;
  LiveCompilation compilation;
  Selection selection;
  QUndoStack undoStack;
  bool isChanged = false;  ///< sceneChanged is still to be emitted
  bool isFlushPending = false;
};

SceneDocument::SceneDocument(QObject* parent) : QObject(parent), parts_(std::make_unique<Parts>()) {
  parts_->compilation.setProgress([this](std::size_t shapes, std::size_t triangles) {
    emit compiling(static_cast<int>(shapes), static_cast<int>(triangles));
  });
  connect(&parts_->undoStack, &QUndoStack::cleanChanged, this, [this](bool clean) { emit modifiedChanged(!clean); });
  createNew();
}

SceneDocument::~SceneDocument() {
  releaseHandles();
  parts_->undoStack.disconnect(this);
}

bool SceneDocument::open(const QString& path) {
  SceneFile file = readScene(path.toStdString(), pictureDecoder());
  if (!file.root || hasErrors(file.diagnostics)) {
    parts_->compilation.setDiagnostics(std::move(file.diagnostics));
    emit diagnosticsChanged();
    return false;
  }
  if (const SoNode* prototype = findPrototype(file.root.get())) {
    Diagnostic saving{
        Diagnostic::Severity::warning, {}, 0, "PROTO", "saving writes out the nodes that it makes", prototype};
    locate(saving, file);
    file.diagnostics.push_back(std::move(saving));
  }
  replaceBy(std::move(file));
  return true;
}

void SceneDocument::createNew() {
  SceneFile file = readSceneText(kEmptyScene, "new scene");
  if (!file.root) throw std::logic_error("The empty scene cannot be read: call initSceneGraph() first.");
  file.path.clear();
  file.lineOf.clear();
  replaceBy(std::move(file));
}

void SceneDocument::replaceBy(SceneFile file) {
  releaseHandles();
  parts_->selection.set(nullptr);
  parts_->undoStack.clear();
  parts_->undoStack.setClean();
  parts_->file = std::move(file);
  parts_->compilation.replaceBy(parts_->file);
  emit sceneReplaced();
  emit selectionChanged();
  emit modifiedChanged(false);
  emit diagnosticsChanged();
  announceSoon();
}

void SceneDocument::save(const QString& path) {
  releaseHandles();
  const std::string text = saveScene(parts_->file.root.get(), path.toStdString());
  moveTo(path.toStdString(), text, parts_->file);
  parts_->compilation.forgetDevice();  // names of files are relative to the scene's folder
  parts_->compilation.locate(parts_->file);
  emit diagnosticsChanged();
  const bool wasClean = parts_->undoStack.isClean();
  parts_->undoStack.setClean();
  if (wasClean) emit modifiedChanged(false);  // the path may be another one
}

void SceneDocument::judgeAt(double rate) {
  parts_->compilation.setRate(rate);
  noteChange();
}

QString SceneDocument::path() const {
  return QString::fromStdString(parts_->file.path);
}

bool SceneDocument::isModified() const {
  return !parts_->undoStack.isClean();
}

SoSeparator* SceneDocument::root() const {
  return parts_->file.root.get();
}

std::string SceneDocument::text() const {
  const_cast<SceneDocument*>(this)->releaseHandles();
  try {
    return wholeText(parts_->file.root.get(), parts_->file.path);
  } catch (const std::runtime_error&) {
    return writeSceneText(parts_->file.root.get());
  }
}

QUndoStack& SceneDocument::undoStack() {
  return parts_->undoStack;
}

const CompiledScene& SceneDocument::compiled() const {
  return parts_->compilation.compiled();
}

const CompiledScene& SceneDocument::compileNow() {
  releaseHandles();
  parts_->compilation.compile(parts_->file);
  parts_->compilation.judge(parts_->file);
  return parts_->compilation.compiled();
}

const DeviceDescription& SceneDocument::device() const {
  return parts_->compilation.device();
}

const Diagnostics& SceneDocument::diagnostics() const {
  return parts_->compilation.diagnostics();
}

const SoPath* SceneDocument::selection() const {
  return parts_->selection.resolve(root());
}

void SceneDocument::select(const SoPath* path) {
  const SoPath* current = selection();
  if (path == current || (path && current && *path == *current)) return;
  releaseHandles();
  parts_->selection.set(path);
  emit selectionChanged();
}

void SceneDocument::releaseHandles() {
  emit handlesInTheWay();
}

void SceneDocument::noteChange() {
  parts_->compilation.outdate();
  announceSoon();
}

void SceneDocument::announceSoon() {
  parts_->isChanged = true;
  if (parts_->isFlushPending) return;
  parts_->isFlushPending = true;
  QTimer::singleShot(0, this, &SceneDocument::flush);
}

void SceneDocument::flush() {
  parts_->isFlushPending = false;
  if (!parts_->isChanged) return;
  parts_->isChanged = false;
  parts_->compilation.compile(parts_->file);
  emit sceneReady();
  parts_->compilation.judge(parts_->file);
  if (!parts_->selection.isEmpty() && !selection()) {
    parts_->selection.set(nullptr);
    emit selectionChanged();
  }
  emit sceneChanged();
  emit sceneCompiled();
  emit diagnosticsChanged();
}

}  // namespace haptiv

#include "moc_SceneDocument.cpp"
