/// Random numbers that are the same on every machine: no distribution of the standard library, whose results differ.
#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "walkthroughs/pairs/pair.hpp"

namespace walkthroughs::pairs {

/// Fowler, Noll and Vo's hash FNV-1a with 64 bits: of the same text always the same.
constexpr std::uint64_t hash(std::string_view text) {
  std::uint64_t h = 0xcbf29ce484222325;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return h;
}

/// A stream of its own for each seed, name and index (splitmix64, Steele et al. 2014).
class Dice {
 public:
  Dice(std::uint64_t seed, std::string_view name, std::uint64_t index)
      : state_(mixed(mixed(mixed(seed) ^ hash(name)) ^ mixed(~index))) {}

  std::uint64_t bits() { return mixed(state_ += 0x9e3779b97f4a7c15); }
  bool coin() { return bits() >> 63 != 0; }

  /// Each of the 2^53 multiples of 2^-53 in [0, 1) alike.
  double unit() { return std::ldexp(static_cast<double>(bits() >> 11), -53); }
  double between(double least, double most) { return least + (most - least) * unit(); }

  /// Returns: one of least, least + 1, … most, each alike.
  int whole(int least, int most) {
    const auto choices = static_cast<std::uint64_t>(static_cast<std::int64_t>(most) - least + 1);
    const std::uint64_t uneven = (0 - choices) % choices;  // 2^64 modulo choices: so many numbers are thrown away
    std::uint64_t number = bits();
    while (number < uneven) number = bits();
    return static_cast<int>(least + static_cast<std::int64_t>(number % choices));
  }

  /// 1 or -1.
  double sign() { return coin() ? 1 : -1; }

  /// In the cube of edge `2 reach` about the origin.
  Vec in_cube(double reach) {
    Vec v;
    for (double& coordinate : v) coordinate = between(-reach, reach);
    return v;
  }

  /// In the ball of radius 1, all volumes alike.
  Vec in_ball() {
    Vec v = in_cube(1);
    while (v.squaredNorm() > 1) v = in_cube(1);
    return v;
  }

  /// A unit vector, up to rounding; all directions alike.
  Vec direction() {
    Vec v = in_ball();
    while (v.squaredNorm() < 0.01) v = in_ball();
    return v / std::sqrt(v.squaredNorm());
  }

  template <class T>
  void shuffle(std::vector<T>& list) {
    for (std::size_t i = list.size(); i > 1; --i)
      std::swap(list[i - 1], list[static_cast<std::size_t>(whole(0, static_cast<int>(i) - 1))]);
  }

 private:
  static constexpr std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace walkthroughs::pairs
