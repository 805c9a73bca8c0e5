#include "app/editor/SceneDocument.h"
