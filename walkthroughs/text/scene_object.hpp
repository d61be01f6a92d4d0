/// Objects as scene files and queries write them: a shape, and perhaps a name and a pose. scene_text.hpp says what each may
/// hold.
#pragma once

#include <optional>

#include "walkthroughs/text/scene_values.hpp"

namespace walkthroughs::reading {

struct ObjectAsWritten {
  std::string name;  ///< empty where none is given
  AnyShape form;     ///< its numbers those of the text
  std::optional<Pose> pose;
};

/// Where it is none it complains (document.hpp).
ObjectAsWritten read_object(const Value& value, const Space& space);

}  // namespace walkthroughs::reading
