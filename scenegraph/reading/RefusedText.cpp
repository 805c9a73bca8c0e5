#include "scenegraph/reading/RefusedText.h"

namespace haptiv {

std::string refusedNode(std::string_view keyword) {
  for (const std::string_view prefix : {"So", "VRML"}) {
    if (keyword.starts_with(prefix)) keyword.remove_prefix(prefix.size());
  }
  if (keyword == "File" || keyword == "Inline" || keyword == "WWWInline") {
    return "other files are not read from within a scene: paste their contents here";
  }
  if (keyword == "Path") return "paths are not read: Coin crashes on broken ones; remove the field that holds it";
  if (keyword.find("Nurbs") != std::string_view::npos) return "NURBS are not read: convert them to triangles";
  return {};
}

std::string headerFault(std::string_view text) {
  if (text.empty()) return "the file is empty: a scene begins with \"#Inventor V2.1 ascii\"";
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  for (const std::string_view header :
       {"#Inventor V2.1 ascii", "#Inventor V2.0 ascii", "#VRML V1.0 ascii", "#VRML V2.0 utf8"}) {
    if (line.starts_with(header)) return {};
  }
  if (line.starts_with("#Inventor") && line.find("binary") != std::string_view::npos) {
    return "the file is binary: convert it to text first (ivcat does it)";
  }
  return "the first line is not \"#Inventor V2.1 ascii\" (or V2.0, or VRML): is this an Open Inventor file?";
}

}  // namespace haptiv
