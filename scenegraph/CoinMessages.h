#pragma once

#include <Inventor/errors/SoError.h>

#include <string>

#include "scenegraph/Diagnostic.h"

namespace haptiv {

/// While it lives, what Coin complains about becomes diagnostics instead of lines on stderr. Thread: GUI.
class CoinMessages {
 public:
  explicit CoinMessages(std::string file);
  ~CoinMessages();
  CoinMessages(const CoinMessages&) = delete;
  CoinMessages& operator=(const CoinMessages&) = delete;

  const Diagnostics& diagnostics() const { return diagnostics_; }

  /// The same, when Coin has read the scene all the same: what it complained about it shows, but for numbers that it
  /// has replaced by others.
  Diagnostics ofReadScene() const;

 private:
  static void onReadError(const SoError* error, void* self);
  static void onDebugError(const SoError* error, void* self);

  std::string file_;
  Diagnostics diagnostics_;
  SoErrorCB* readHandler_;
  void* readData_;
  SoErrorCB* debugHandler_;
  void* debugData_;
};

}  // namespace haptiv
