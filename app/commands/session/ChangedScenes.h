#pragma once

#include <string>
#include <vector>

#include "app/session/log/reading/SessionLog.h"

namespace haptiv {

/// A property of a scene's node that is to have another value.
struct PropertyChange {
  std::string node;  ///< DEF name, or label
  std::string field;
  std::string value;  ///< as Inventor writes it
};

/// Reads NODE.FIELD=VALUE. Throws CommandFailure (kWrongUsage) where it is none.
PropertyChange parseChange(const std::string& text);

/// The scenes of a log as they would have been with these changes; versions, shape ids and texts stay. What the changes leave
/// alone stays bit for bit. Needs initSceneGraph. Throws CommandFailure: kWrongUsage where no scene has such a node or
/// field, kNotSo where a changed scene has errors, kCouldNot where what it includes is not there.
std::vector<LoggedScene> withChanges(const std::vector<LoggedScene>& scenes,
                                     const std::vector<PropertyChange>& changes);

}  // namespace haptiv
