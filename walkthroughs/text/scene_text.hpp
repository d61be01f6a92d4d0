/// Scenes that users write, as JSON: what a text holds, read into a walkthrough.
///
/// A scene declares what it needs; what it does not declare is not computed. example_scene() shows every key, and its default
/// or an alternative; scene_limits.hpp says how much each may hold. Beside that:
///
///     title            without it the file's name heads every frame
///     dimension        in the plane points are [x, y] or [x, y, 0], spheres are discs, and there are no cylinders
///     first_direction  of any length but zero
///     crossing_test    Section 3.1.3
///     rules            core/rule_sets.hpp. Eager rules, which test the first point, too, begin in the direction from the center
///                      of a to that of b: the mean of a point set's points, the sum of the centers of a sum
///     zero_test        core/zero_test.hpp
///     scalar           "float": numbers are rounded to the nearest float and computed with
///     truth            false: nothing beside what the search answers is computed or told
///     size             without it up to the reader; the text_scale up to the theme
///     points           their convex hull
///     box              along the axes; "half_extents" may stand in place of "size"
///     sum              each point of one plus each of the other (Section 2.3, Eq. 3); sums may be in one another
///     pose             either or both of its keys: the shape is first turned about the origin, counter-clockwise seen from the
///                      tip of the axis, then moved. In the plane the rotation is {"degrees": d}. It may also be a quaternion of any
///                      length, or a matrix, which is taken as it stands: its columns are perpendicular and of length 1 to 1e-5
///
/// All numbers are finite and at most 1e150 in magnitude, so that the squares of lengths are finite. Lengths may be 0.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "render/geometry.hpp"
#include "walkthroughs/model/walkthrough.hpp"
#include "walkthroughs/text/document.hpp"

namespace walkthroughs::text {

/// One scene as a walkthrough of Layout::search and Naming::roles. Its name is made from the file's (names.hpp).
struct SceneFile {
  Walkthrough walkthrough;
  std::optional<render::Size> size;
  std::optional<double> text_scale;
};

/// `file_name`: names the walkthrough; nothing is read from there.
Reading<SceneFile> scene_in(std::string_view text, const std::string& file_name);

/// Returns: a scene file with comments that shows every key.
std::string example_scene();

/// Returns: in one line what the scene declares.
std::string summary(const SceneFile& scene);

}  // namespace walkthroughs::text
