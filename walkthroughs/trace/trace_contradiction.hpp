/// What is said where a trace contradicts itself.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/events.hpp"
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

/// Whether a vertex is new is whether none of `known`, the places found so far, is its own; from then on it is one of them.
inline void require_new(const gjk::SupportFound<double>& event, std::vector<Point>& known) {
  const bool is_known = std::ranges::find(known, event.vertex.w) != known.end();
  require(event.is_new == !is_known, event.is_new ? "'new' is true, but an earlier w of this scene is the same"
                                                  : "'new' is false, but no earlier w of this scene is the same");
  if (event.is_new) known.push_back(event.vertex.w);
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
