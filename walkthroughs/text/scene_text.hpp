/// Scenes that users write, as JSON: what a text holds, read into a walkthrough.
///
/// A scene declares what it needs; what it does not declare is not computed. example_scene() shows every key.
///
///     key              value                                                                           without it
///     title            heads every frame; 1 to 120 characters                                          the file's name
///     dimension        2 (points are [x, y] or [x, y, 0]) or 3                                          3
///     a, b             the two objects                                                                 an error
///     first_direction  where the search begins; any length but zero                                    [1, 0, 0], or below
///     iteration_limit  1 to 1000                                                                       20
///     crossing_test    "on", "off" (Section 3.1.3)                                                     "on"
///     rules            "as-intended", "as-printed", "eager", "complete" (core/rule_sets.hpp)           "as-intended"
///     zero_test        "exact", "relative" (core/zero_test.hpp)                                        "exact"
///     scalar           "double", "float"; numbers are rounded to the nearest float and computed with    "double"
///     panels           those of "objects", "hull", "algorithm", "decision" to show beside the search,   these four
///                      and "close-up", which magnifies what is around the origin
///     letters          "roles" (A is always the newest vertex), "fixed" (each keeps its own)           "roles"
///     size             "1280x720" or [1280, 720], in pixels                                            up to the reader
///     text_scale       0.75 to 1.5: all text so many times as large                                    up to the theme
///
/// Eager rules, which test the first point, too, begin in the direction from the center of a to that of b: the mean of a
/// point set's points, the sum of the centers of a sum.
///
/// An object has one shape, and may have a name (1 to 40 characters) and a pose:
///
///     points           [[x, y, z], ...], 1 to 100,000: their convex hull
///     sphere           {"center": [x, y, z], "radius": r}; in the plane a disc
///     cylinder         {"center": [x, y, z], "axis": [x, y, z], "radius": r, "height": h}; in space only
///     box              {"center": [x, y, z], "size": [x, y, z]}, along the axes; or "half_extents" in place of "size"
///     capsule          {"from": [x, y, z], "to": [x, y, z], "radius": r}
///     sum              [{shape}, {shape}]: each point of one plus each of the other (Section 2.3, Eq. 3). Up to 4 sums may be
///                      in one another.
///     pose             {"rotation": {"axis": [x, y, z], "degrees": d}, "translation": [x, y, z]}, either or both: the
///                      shape is first turned about the origin, counter-clockwise seen from the tip of the axis, then
///                      moved. In the plane the rotation is {"degrees": d}.
///
/// All numbers are finite and at most 1e150 in magnitude, so that the squares of lengths are finite. Lengths may be 0.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "render/geometry.hpp"
#include "walkthroughs/model/walkthrough.hpp"
#include "walkthroughs/text/document.hpp"

namespace walkthroughs {

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

}  // namespace walkthroughs
