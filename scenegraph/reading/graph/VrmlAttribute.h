#pragma once

#include "scenegraph/reading/graph/AttributesInForce.h"

class SoMFInt32;
class SoSFBool;
class SoSFNode;

namespace haptiv {

/// How many values stand in the attribute node that a field of a VRML97 shape holds.
std::int64_t vrmlValues(const SoSFNode& node);

/// A shape's normals or colors. Without an index of its own, VRML's attribute of faces goes through them in order.
Attribute vrmlAttribute(const SoSFNode& node, const SoSFBool& perVertex, const SoMFInt32* index = nullptr);

/// A shape's texture coordinates.
Attribute vrmlTexture(const SoSFNode& node);

}  // namespace haptiv
