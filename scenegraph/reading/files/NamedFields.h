#pragma once

#include <Inventor/fields/SoField.h>

#include <string>
#include <vector>

class SoNode;

namespace haptiv {

/// The fields of a node that name files, and what the files are for.
struct NamedFields {
  enum class Use {
    none,
    scene,    ///< File, Inline, WWWInline: nodes, put where the node stands
    picture,  ///< textures; Coin loads them when it learns of the name
    later,    ///< shaders, films, backgrounds: Coin opens them when it draws
    sound,    ///< never opened: nothing is played
    font,     ///< a name in which a path could stand
  };
  Use use = Use::none;
  std::vector<SoField*> fields;  ///< SoSFString, SoSFName or SoMFString
};
NamedFields namedFields(SoNode* node);

/// The strings that a field holds.
std::vector<std::string> stringsOf(SoField* field);

/// Makes them those; a field that holds one takes the first, or an empty one.
void setStrings(SoField* field, const std::vector<std::string>& strings);

}  // namespace haptiv
