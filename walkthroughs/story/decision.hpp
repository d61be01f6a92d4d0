/// The plane pictures in which a decision in space is plain. A decision is the sign of one product; there is always a plane
/// in which that sign is seen, and the view in space shows it to nobody.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/model/plane.hpp"
#include "walkthroughs/story/story.hpp"

namespace walkthroughs::story {

struct DecisionView {
  enum class Kind {
    crossing,    ///< the plane of d and OP, d to the right: P short of the origin, at it, or past it
    segment,     ///< the plane of an edge at A and the origin, the origin above it
    true_shape,  ///< a triangle, straight down its normal, with the foot of the origin
    edge_on,     ///< a triangle as a line, its normal up the page: the origin above or below
  };
  Kind kind;
  gjk::Roles face;      ///< the triangle's roles, "ABC"; those of the others: "AB", ""
  Plane plane;          ///< that is the page
  double height = 0;    ///< of the origin above the triangle's plane, as the trace has it where it has; of P along d
  bool decides = true;  ///< whether this is the picture of what is asked now; others only help

  /// Whether it shows the face of a tetrahedron that the search comes from.
  bool is_left_behind() const { return face == "BCD"; }
};

/// Whether the frames of a story have such views: those of one search in space that has not switched them off.
bool shows_decision(const Story& story);

/// Returns: the views of a moment of a search in space, also of the one in which vertices are dropped, and of the gap with
/// which it ends. Two of one triangle have one direction to the right and stand below each other. Before a tetrahedron is
/// tested its three new faces stand side by side and last, below them, BCD, which the search has left behind. None where
/// nothing is decided, and where the vertices span no such plane.
std::vector<DecisionView> decision_views(const Moment& now, Focus focus);

/// Returns: what is seen there, a sentence: "Seen edge-on, the origin lies above triangle ABC."
std::string in_words(const DecisionView& view, const Moment& now, const Names& names);

/// Whether it is asked if an edge leads from A toward the origin, as the complete rules do.
bool asks_along_edge(const gjk::RegionTested<double>& region);

/// Returns: the roles of the triangle whose plane is asked about, "ABC", "ADB"; empty where none is.
gjk::Roles face_in_question(const Moment& now, Focus focus);

/// Returns: what was said of the face itself, above which the origin lies or not; nothing before it is tested.
const gjk::RegionTested<double>* test_of(const Moment& now, const gjk::Roles& face);

/// Returns: the height of the origin above the plane of a triangle APQ, by the product that decides where it is known: what
/// the search has computed is shown, not what it should have found. Requires: a triangle that is not flat.
double height_of_origin(const Moment& now, const gjk::Roles& face);

}  // namespace walkthroughs::story
