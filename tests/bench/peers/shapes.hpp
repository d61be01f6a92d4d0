/// The bodies of the study as this project's shapes.
#pragma once

#include <variant>

#include "core/shapes.hpp"
#include "tests/study/pairs/pairs.hpp"

namespace peers {

using PointSet = gjk::PointSet<double>;
using AnyShape = walkthroughs::model::AskedForms<study::Body>;

inline AnyShape any_shape(const study::Body& body) { return walkthroughs::model::asked(study::Body(body)); }

/// Some point well inside, from which some searches start.
inline study::Vec center(const study::Body& body) {
  return std::visit([](const auto& one) { return walkthroughs::model::RowOf<decltype(one)>::middle(one); }, body);
}

}  // namespace peers
