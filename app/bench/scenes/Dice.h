#pragma once

#include <cstdint>
#include <random>

namespace haptiv {

/// Numbers evenly spread over [0, 1): the same ones in every run and with every library.
class Dice {
 public:
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_{20};
};

}  // namespace haptiv
