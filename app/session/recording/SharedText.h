#pragma once

#include <memory>
#include <string>
#include <utility>

namespace haptiv {

/// A text that is handed on without being copied: that of a large scene has some 30 MB, and while a handle is dragged
/// many versions of the scene have the same.
class SharedText {
 public:
  SharedText() : SharedText(std::string()) {}
  SharedText(std::string text) : text_(std::make_shared<const std::string>(std::move(text))) {}
  SharedText(const char* text) : SharedText(std::string(text)) {}

  const std::string& get() const { return *text_; }

 private:
  std::shared_ptr<const std::string> text_;
};

}  // namespace haptiv
