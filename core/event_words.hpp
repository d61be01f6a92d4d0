/// What the values of events are called: words for each enumerator, sentences for reasons.
#pragma once

#include <string>
#include <string_view>

#include "events.hpp"

namespace gjk {

constexpr std::string_view to_string(FirstDirection why) {
  switch (why) {
    case FirstDirection::usual: return "any first direction will do; +x is the usual one";
    case FirstDirection::asked_for: return "the caller asked for this first direction";
    case FirstDirection::from_inside:
      return "from a point inside A to one inside B; their difference is the first vertex";
    case FirstDirection::as_told: break;
  }
  return "the program began so";
}

constexpr std::string_view to_string(RegionLabel label) {
  constexpr std::string_view words[] = {"", "R1", "R2", "R3", "R4", "R5", "R6", "R7", "R3 or R4"};
  return words[static_cast<int>(label)];
}

constexpr std::string_view to_string(ReductionReason why) {
  switch (why) {
    case ReductionReason::beyond_edge: return "the origin lies beyond this edge; A stays the newest";
    case ReductionReason::turned_below_triangle:
      return "in the list A and B change places: the normal, read from it, turns to the origin, and the next faces "
             "get theirs outward";
    case ReductionReason::face_keeps_normal:
      return "read from the list in this order, the face keeps its normal, toward the origin, and the next faces get "
             "theirs outward";
    case ReductionReason::nearest_on_edge:
      return "the point nearest to the origin lies on this edge; A stays the newest";
    case ReductionReason::nearest_is_A: return "the point nearest to the origin is A";
    case ReductionReason::not_turned_below_triangle:
      return "A and B stay where they are, though the search turns to the other side";
    case ReductionReason::face_in_its_order: return "the vertices of the face stay in their order";
    case ReductionReason::as_told: break;
  }
  return "as told";
}

/// Returns: what a reason says of that test.
template <class S>
std::string in_words(RegionReason reason, const RegionTested<S>& test) {
  using enum RegionReason;
  switch (reason) {
    case left_behind: return "the search has just moved away from " + to_string(test.feature) + ", toward the origin";
    case ruled_out_before:
      return "ruled out when the search kept " + std::string(test.simplex_size == 3 ? "BC" : "BCD");
    case crossed_on_the_way: return "were the origin beyond A, the move to A would not have reached it";
    case only_by_crossing_test: return "only the crossing test rules this out, and this run does without it";
    case nearer_with_A: return "the move to A brought the simplex nearer to the origin";
    case A_is_origin: return "A is the origin";
    case origin_elsewhere: return "the origin lies elsewhere";
    case no_edge_leads_to_origin: return "no edge leads from A toward the origin";
    case on_segment: return "the origin lies on AB";
    case on_line: return "the origin lies on the line AB";
    case beside_segment: return "the origin lies to one side of AB";
    case on_edge: return "the origin lies on this edge";
    case nearest_on_edge: return "the point nearest to the origin lies on this edge";
    case nearer_along_edge: return "along this edge it is nearer to the origin than at A";
    case no_nearer_along_edge: return "along this edge it is no nearer to the origin than at A";
    case beyond_edge_in_plane: return "in this plane the origin lies beyond the edge";
    case within_edge_in_plane: return "in this plane the origin lies within the edge";
    case in_triangle: return "the origin lies in the triangle";
    case in_plane: return "the origin lies in its plane";
    case above_triangle: return "the origin lies above the triangle, on the side of ABCn";
    case below_triangle: return "the origin lies below the triangle, on the side of −ABCn";
    case above_face_within_edges: return "the origin lies above this face and within its edges";
    case not_above_face: return "the origin does not lie above this face";
    case normal_toward_origin: return to_string(test.expression.X) + " points toward the origin";
    case normal_not_toward_origin: return to_string(test.expression.X) + " does not point toward the origin";
    case no_face_sees_origin: break;
  }
  return "no face sees the origin: it lies in the tetrahedron";
}

/// Returns: why, in the letters of the simplex. Of a variant it says what the numbers say, and how the search goes on
/// all the same.
template <class S>
std::string reason_in_words(const RegionTested<S>& test) {
  std::string words = in_words(test.reason.is, test);
  if (test.reason.goes_on_as_if) words += ", but these rules go on as if " + in_words(*test.reason.goes_on_as_if, test);
  const bool is_segment_by_other_vector =  // only (AB×AO)×AB is zero exactly there
      test.simplex_size == 2 && test.feature == "AB" && test.expression.form != Expression::Form::dot &&
      test.expression != "AB×AO×AB";
  if (!is_segment_by_other_vector) return words;
  return to_string(test.expression) + (test.relation == Relation::zero ? " is zero" : " is not zero") +
         ", from which these rules conclude: " + words;
}

/// Returns: how the value of a sign was computed, "(AB·AO)(AB·AC) − (AC·AO)(AB·AB)"; empty where its expression says
/// that.
template <class S>
std::string formula_of(const SignTaken<S>& sign) {
  if (sign.face.empty()) return "";
  const Role X = sign.expression.X.of[1];
  std::string AX = {'A', letter(X)}, AY = "A";
  for (const Role each : sign.face)
    if (each != Role::A && each != X) AY += letter(each);
  return "(" + AX + "·AO)(" + AX + "·" + AY + ") − (" + AY + "·AO)(" + AX + "·" + AX + ")";
}

}  // namespace gjk
