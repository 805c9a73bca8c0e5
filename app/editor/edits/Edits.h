#pragma once

#include <functional>

#include "app/editor/commands/FieldValue.h"
#include "app/editor/commands/SceneCommand.h"
#include "app/editor/document/SceneDocument.h"
#include "app/editor/edits/ShapeFrame.h"
#include "app/editor/items/SceneItems.h"

namespace haptiv {

// What a user does to the scene, each as one undo step. All act on the document's selection.

/// Makes the new value from the field as it is.
using NewValue = std::function<FieldValue(const SoField&)>;

/// Changes a field of the selected node itself (the tool, the device).
void editSelectedNode(SceneDocument& document, const char* field, const NewValue& value, Gesture gesture = 0);

enum class Reach { onlyThis, allThatShare };
/// Changes a field of the haptic property that is in force at the selected shape. With `onlyThis`, a property that
/// other shapes share stays as it is, and the shape gets a copy of its own.
void editProperty(SceneDocument& document, const char* field, const NewValue& value, Reach reach, Gesture gesture = 0);
/// How many shapes have the property that is in force at this one, and for how many of them it could not differ
/// (they are one and the same shape, used several times).
struct Sharing {
  int shapes = 1;
  int inseparable = 1;
};
Sharing sharingOf(const std::vector<SceneItem>& items, const SceneItem& item, SoSeparator* root);

/// Moves, turns or resizes the selected shape; wraps it where it has no transform of its own.
void moveShape(SceneDocument& document, const std::function<void(ShapeFrame&)>& change, const QString& text,
               Gesture gesture = 0);

/// Removes the selected shape, with the Separator that holds nothing else.
void removeShape(SceneDocument& document);

/// Whether the selected shape can be moved aside, as its copy is.
bool canDuplicate(const SceneDocument& document);
/// Puts a copy of the selected shape, with what belongs to it alone, beside it, under a label of its own; selects it.
void duplicateShape(SceneDocument& document);

/// Whether the scene is only seen: shapes, and none that is felt or said not to be.
bool isScenery(const std::vector<SceneItem>& items);
/// Puts a surface before everything, and a tool and a device of the model's size where they lack.
void makeSolid(SceneDocument& document);

/// Adds a wall or zone beside the tool and selects it.
void addShape(SceneDocument& document, SceneItem::Kind kind);

}  // namespace haptiv
