#pragma once

#include <string>

namespace haptiv {

struct CheckOptions {
  std::string scene;
  bool json = false;
};

/// `haptiv check`: loads and judges a scene. kNotSo where it has errors.
int checkScene(const CheckOptions& options);

}  // namespace haptiv
