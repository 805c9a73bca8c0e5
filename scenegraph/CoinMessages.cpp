#include "scenegraph/CoinMessages.h"

#include <Inventor/errors/SoDebugError.h>
#include <Inventor/errors/SoReadError.h>

#include <cstdlib>

namespace haptiv {
namespace {

constexpr std::size_t kMaxMessages = 50;

/// "Coin read error: WHAT\n\tOccurred at line  N in FILE" -> WHAT, N.
Diagnostic parse(const SoError* error, const std::string& file) {
  std::string text = error->getDebugString().getString();
  Diagnostic diagnostic{Diagnostic::Severity::error, file, 0, {}, {}, nullptr};
  static const std::string kWhere = "Occurred at ";  // "line N", or "position N in binary file"
  if (const auto where = text.rfind(kWhere); where != std::string::npos) {
    static const std::string kLine = kWhere + "line ";
    if (text.compare(where, kLine.size(), kLine) == 0) diagnostic.line = std::atoi(text.c_str() + where + kLine.size());
    text.resize(where);
  }
  static const std::string kIntroduction = "Coin read error: ";
  if (text.starts_with(kIntroduction)) text.erase(0, kIntroduction.size());
  while (!text.empty() && (text.back() == '\n' || text.back() == '\t' || text.back() == ' ')) text.pop_back();
  for (char& c : text) {
    if (c == '\n' || c == '\t') c = ' ';
  }
  if (text.starts_with("Couldn't read value for field"))
    text += ": write a value of the field's type, and numbers as digits (nan and inf are none)";
  while (text.ends_with('.')) text.pop_back();
  if (text.find("not recognized") != std::string::npos)
    text += ": correct its spelling, or say its fields first, as in fields [ SFFloat size ], and it is kept";
  if (text.find("non-valid floating point number") != std::string::npos)
    text += ": write a number of no more than 3.4e38";
  if (text == "Error reading EXTERNPROTO definition")
    text += ": no file that it names is there and holds it: copy one into the scene's folder";
  diagnostic.message = text;
  return diagnostic;
}

}  // namespace

CoinMessages::CoinMessages(std::string file)
    : file_(std::move(file)),
      readHandler_(SoReadError::getHandlerCallback()),
      readData_(SoReadError::getHandlerData()),
      debugHandler_(SoDebugError::getHandlerCallback()),
      debugData_(SoDebugError::getHandlerData()) {
  SoReadError::setHandlerCallback(&onReadError, this);
  SoDebugError::setHandlerCallback(&onDebugError, this);
}

CoinMessages::~CoinMessages() {
  SoReadError::setHandlerCallback(readHandler_, readData_);
  SoDebugError::setHandlerCallback(debugHandler_, debugData_);
}

Diagnostics CoinMessages::ofReadScene() const {
  Diagnostics told;
  for (Diagnostic diagnostic : diagnostics_) {
    if (diagnostic.message.starts_with("Erroneous character(s) after end")) continue;  // said once a process: the scan
    const bool isReplaced = diagnostic.message.find("non-valid floating point number") != std::string::npos;
    if (!isReplaced) diagnostic.severity = Diagnostic::Severity::warning;
    if (diagnostic.message.find("No script language") != std::string::npos) {
      diagnostic.node = "Script";
      diagnostic.message = "is not run: what it would do is missing";
    } else if (diagnostic.message.find("SoVRMLSound") != std::string::npos) {
      diagnostic.node = "Sound";
      diagnostic.message = "is not played";
    }
    told.push_back(std::move(diagnostic));
  }
  return told;
}

void CoinMessages::onReadError(const SoError* error, void* self) {
  auto& messages = *static_cast<CoinMessages*>(self);
  if (messages.diagnostics_.size() >= kMaxMessages) return;
  messages.diagnostics_.push_back(parse(error, messages.file_));
}

// Remarks of Coin's own that do not keep it from reading.
void CoinMessages::onDebugError(const SoError* error, void* self) {
  auto& messages = *static_cast<CoinMessages*>(self);
  if (messages.diagnostics_.size() >= kMaxMessages) return;
  Diagnostic diagnostic = parse(error, messages.file_);
  diagnostic.severity = Diagnostic::Severity::warning;
  messages.diagnostics_.push_back(std::move(diagnostic));
}

}  // namespace haptiv
