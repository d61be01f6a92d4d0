/// Random numbers that are the same with every standard library: its distributions are not.
#pragma once

#include <cstdint>
#include <random>

namespace kit {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : generator_(seed) {}

  /// Returns: one of low, low + 1, … high.
  int between(int low, int high) {
    return low + static_cast<int>(generator_() % static_cast<std::uint64_t>(high - low + 1));
  }
  /// Returns: a number in [low, high).
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(generator_() >> 11) * 0x1p-53);
  }
  bool coin() { return between(0, 1) == 1; }

 private:
  std::mt19937_64 generator_;
};

}  // namespace kit
