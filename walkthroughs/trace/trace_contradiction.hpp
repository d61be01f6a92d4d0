/// What is said where a trace contradicts itself.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/text/printable.hpp"

namespace walkthroughs {

/// what(): what contradicts what, without place.
struct Contradiction : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline void require(bool holds, const std::string& reason) {
  if (!holds) throw Contradiction(reason);
}

inline std::string written(const Point& p) {
  return "[" + number_text(p.x()) + ", " + number_text(p.y()) + ", " + number_text(p.z()) + "]";
}

inline std::string written(const std::variant<std::monostate, double, Point>& value) {
  if (const double* number = std::get_if<double>(&value)) return number_text(*number);
  const Point* vector = std::get_if<Point>(&value);
  return vector ? written(*vector) : "missing";
}

}  // namespace walkthroughs
