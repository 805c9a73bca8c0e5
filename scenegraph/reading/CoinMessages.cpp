#include "scenegraph/reading/CoinMessages.h"

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
  static const std::string kWhere = "Occurred at line ";
  if (const auto where = text.rfind(kWhere); where != std::string::npos) {
    diagnostic.line = std::atoi(text.c_str() + where + kWhere.size());
    text.resize(where);
  }
  static const std::string kIntroduction = "Coin read error: ";
  if (text.starts_with(kIntroduction)) text.erase(0, kIntroduction.size());
  while (!text.empty() && (text.back() == '\n' || text.back() == '\t' || text.back() == ' ')) text.pop_back();
  for (char& c : text) {
    if (c == '\n' || c == '\t') c = ' ';
  }
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

void CoinMessages::onReadError(const SoError* error, void* self) {
  auto& messages = *static_cast<CoinMessages*>(self);
  if (messages.diagnostics_.size() >= kMaxMessages) return;
  Diagnostic diagnostic = parse(error, messages.file_);
  if (diagnostic.message.starts_with("Could not read texture file")) {
    diagnostic.severity = Diagnostic::Severity::warning;  // Coin draws the shape without it
    diagnostic.message += ": put the file into the scene's folder";
  }
  messages.diagnostics_.push_back(std::move(diagnostic));
}

// Remarks of Coin's own that do not keep it from reading. Of a missing texture there is a read error too, with its
// line.
void CoinMessages::onDebugError(const SoError* error, void* self) {
  auto& messages = *static_cast<CoinMessages*>(self);
  if (messages.diagnostics_.size() >= kMaxMessages) return;
  Diagnostic diagnostic = parse(error, messages.file_);
  if (diagnostic.message.find("SbImage::readFile") != std::string::npos) return;
  diagnostic.severity = Diagnostic::Severity::warning;
  messages.diagnostics_.push_back(std::move(diagnostic));
}

}  // namespace haptiv
