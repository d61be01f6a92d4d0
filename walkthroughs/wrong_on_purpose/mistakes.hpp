/// The mistakes by name: what is wrong, where the report says how it is done, which line of its pseudo-code it is, and how long it stays
/// unnoticed.
///
/// WRONG ON PURPOSE: whoever looks for rules to use finds them in core/.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "core/rule_sets.hpp"
#include "walkthroughs/rooms.hpp"

namespace walkthroughs::wrong_on_purpose {

/// M1 to M21, in the report's order.
enum class Mistake {
  wrong_side_of_b,
  first_point_tested,
  touching_is_apart,
  as_printed,
  origin_at_vertex_missed,
  origin_on_segment_missed,
  direction_from_vertex,
  triangle_normal_reversed,
  triangle_abn_inward,
  triangle_acn_inward,
  edge_normal_as_direction,
  two_dimensions_only,
  origin_in_triangle_missed,
  order_kept_below_triangle,
  abcn_inward,
  acdn_inward,
  adbn_inward,
  edge_normals_reused,
  abn_reused_for_adb,
  order_of_adb,
  origin_in_face_seen_outside,
};

/// What a mistaken program has in place of a line of the report's pseudo-code.
struct WrongLine {
  int algorithm;               ///< 1 to 5
  std::string_view right;      ///< as story/pseudocode.cpp writes it
  std::string_view wrong;      ///< or what is not done
  std::string_view sets = {};  ///< the variable that the line sets to something else
};

enum class TestPairs { triangles, tetrahedra, grid_triangles };

/// How many random pairs show a mistake in 95 of 100 tests.
struct PairsToNotice {
  double count;
  bool is_more;  ///< none of those that were tried has shown it

  constexpr PairsToNotice(double count_, bool is_more_ = false) : count(count_), is_more(is_more_) {}

  /// Returns: "about 190,000" or "more than 780,000".
  std::string text() const;
};

struct Description {
  Mistake value;
  std::string_view word;     ///< in traces and in names of walkthroughs: "m14-order-below-triangle"
  std::string_view meaning;  ///< "the order is not changed when moving below the triangle"
  std::string_view section;  ///< of the report, where it says how it is done
  std::string_view
      practice;  ///< the case that it gets wrong, a walkthrough of regions; of a mistake in the crossing test what that rules out
  std::span<const WrongLine> lines;
  std::array<PairsToNotice, 3> to_notice;  ///< by TestPairs
  /// What Algorithm 1 does with the first point and after Eq. 9 has said no is what these do; all else is the mistake's.
  gjk::RuleSet rules = gjk::RuleSet::as_intended;
};

/// Returns: all, in the order of the enumerators.
std::span<const Description> all();

const Description& description_of(Mistake mistake);
/// Returns: null where no mistake has that word.
const Description* named(std::string_view word);

const PairsToNotice& pairs_to_notice(Mistake mistake, TestPairs pairs);

/// Returns: whether a search that is begun along an axis is wrong with it nowhere, however many pairs are tried. That is proven: P·d of
/// the first point is then a single difference, whose sign no rounding changes, and P·d < 0 proves separation wherever it is found.
bool is_none_along_axes(Mistake mistake);

/// Returns: "M14".
std::string number_of(Mistake mistake);

}  // namespace walkthroughs::wrong_on_purpose
