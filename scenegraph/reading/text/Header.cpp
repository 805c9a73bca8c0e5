#include "scenegraph/reading/text/Header.h"

#include <Inventor/SoDB.h>

namespace haptiv {
namespace {

std::string firstLine(std::string_view text) {
  return std::string(text.substr(0, std::min<std::size_t>(text.find_first_of("\r\n"), 200)));
}

}  // namespace

std::string headerFault(std::string_view text) {
  if (text.empty()) return "the file is empty: a scene begins with \"#Inventor V2.1 ascii\"";
  if (SoDB::isValidHeader(firstLine(text).c_str())) return {};
  return "the first line is not \"#Inventor V2.1 ascii\" (or another version, or VRML): is this an Open Inventor file?";
}

bool isBinaryHeader(std::string_view text) {
  const std::string line = firstLine(text);
  return line.starts_with("#Inventor") && line.find("binary") != std::string::npos;
}

}  // namespace haptiv
