#pragma once

#include <string>

#include "scenegraph/reading/graph/AttributesInForce.h"

class SoNode;

namespace haptiv {

bool isNurbs(const SoNode* node);
/// One as it comes without fields: of no control points.
bool isEmptyNurbs(const SoNode* node);

/// What is wrong with the numbers of a NURBS shape, on which GLU would crash, or not end; empty where nothing is, and
/// of empty ones and other nodes. A spline of order k with n points has n + k knots, which rise, and of which no more
/// than k are equal.
std::string nurbsFault(const SoNode* node, const AttributesInForce& state);

}  // namespace haptiv
