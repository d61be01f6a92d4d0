/// All regions of a simplex at once, each drawn as what the algorithm has made of it so far.
#pragma once

#include <array>

#include "walkthroughs/picture/panels.hpp"
#include "walkthroughs/picture/pencil.hpp"

namespace walkthroughs::picture {

/// What the algorithm has said of a region up to one moment. Nothing may be told by colour alone: skipped regions are
/// hatched, rejected ones named with ✗, the chosen one with ✓, and the one just tested has a strong border and its
/// normal.
enum class RegionState { pending, skipped, rejected, just_rejected, just_possible, chosen };

/// Returns: that of a region of `now.regions`; pending where there is none.
RegionState state_of(const gjk::RegionTested<double>* region, const Moment& now);

/// Fills or hatches an area as its state wants it; nothing while it is pending.
void fill_region(render::Panel& panel, const std::vector<render::Vec2>& corners, RegionState state, const Style& style);

/// Returns: "AB_n·AO = −0.42 ≤ 0"; nothing where the value is no number.
std::string inequality_of(const gjk::RegionTested<double>& region, const Names& names);

/// Draws the regions of the simplex that is being processed (of one face and its edges, where Algorithm 5 has come to
/// them). Nothing where no region has been tested in this iteration.
void draw_regions(Pencil& pencil, const Shown& shown);

/// Draws those of one segment or triangle, tested or not yet, or those beside a face APQ of a tetrahedron, in the plane
/// of that feature; or on which side of A an edge AX leads. Nothing beside one edge of several.
void draw_regions_in_plane(Pencil& pencil, const Shown& shown, const gjk::Roles& feature);

/// Writes at each face of a tetrahedron that was rejected before which one it is; nothing while the edges of a face are
/// shown. To be asked for after the vertices have their names, which are more important.
void name_rejected_faces(Pencil& pencil, const Shown& shown);

/// A point of each line, best that which is nearest to the origin: its digits tell best on which side of it the line runs.
using Feet = std::array<render::Vec2, 3>;

/// The regions of a triangle ABC as Fig. 7 numbers them: R1 inside, R2 beyond A, R3 beyond AB, R4 beyond B, R5 beyond
/// BC, R6 beyond C, R7 beyond AC; each the part of the convex polygon `clip` that lies in it.
/// `feet`: those of AB, BC and CA. Requires: A, B, C not on one line.
std::vector<std::vector<render::Vec2>> regions_of_triangle(const render::Vec2& A, const render::Vec2& B,
                                                           const render::Vec2& C, const Feet& feet,
                                                           const std::vector<render::Vec2>& clip);

/// The regions of a segment AB as Fig. 6 numbers them: R1 beyond B, R2 beyond A, R3 to the left and R4 to the right of
/// the way from B to A. `foot`: of AB.
std::vector<std::vector<render::Vec2>> regions_of_segment(const render::Vec2& A, const render::Vec2& B,
                                                          const render::Vec2& foot,
                                                          const std::vector<render::Vec2>& clip);

}  // namespace walkthroughs::picture
