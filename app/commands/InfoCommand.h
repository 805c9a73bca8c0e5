#pragma once

#include <string>

namespace haptiv {

struct InfoOptions {
  std::string log;
  bool json = false;
};

/// `haptiv info`: what a session log holds, complete or cut off.
int describeLog(const InfoOptions& options);

}  // namespace haptiv
