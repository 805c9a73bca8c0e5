#pragma once

#include <cstdint>

namespace haptiv {

/// An OpenGL context without window and without X (EGL, Mesa's surfaceless platform), current on this thread while it
/// lives; a context of Qt that was current is let go of. Throws std::runtime_error naming what the machine lacks.
class SurfacelessContext {
 public:
  SurfacelessContext();
  ~SurfacelessContext();
  SurfacelessContext(const SurfacelessContext&) = delete;
  SurfacelessContext& operator=(const SurfacelessContext&) = delete;

  /// By which Coin tells the resources of this context from others'.
  std::uint32_t coinId() const { return coinId_; }

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
  std::uint32_t coinId_ = 0;
};

}  // namespace haptiv
