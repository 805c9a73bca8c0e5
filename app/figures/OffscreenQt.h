#pragma once

#include <memory>

class QApplication;

namespace haptiv {

/// Makes Qt able to draw without a display while this lives: for commands that write pictures. Where there is a
/// QApplication already, that one serves.
class OffscreenQt {
 public:
  OffscreenQt();
  ~OffscreenQt();
  OffscreenQt(const OffscreenQt&) = delete;
  OffscreenQt& operator=(const OffscreenQt&) = delete;

 private:
  struct Arguments;
  std::unique_ptr<Arguments> arguments_;
  std::unique_ptr<QApplication> application_;
};

}  // namespace haptiv
