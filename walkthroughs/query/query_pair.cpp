#include "walkthroughs/query/query_pair.hpp"

#include <algorithm>
#include <utility>

#include "walkthroughs/text/pair_line.hpp"

namespace walkthroughs::query {
namespace {

using namespace reading;

/// What is proven needs no room for squares.
Magnitudes magnitudes_of(QueryEvidence evidence) {
  return evidence == QueryEvidence::of_the_search ? Magnitudes::with_finite_squares : Magnitudes::all;
}

bool hold(const Space& space, const Points& points) {
  return std::ranges::all_of(
      points, [&](const Point& p) { return std::ranges::all_of(p, [&](double x) { return space.holds(x); }); });
}

/// Of most lines: two sets of points. Others are read with their complaints.
std::optional<PairAsWritten> read_points(std::string_view line, const Space& space) {
  std::optional<TwoPointSets> sets = two_point_sets(line);
  if (!sets || !hold(space, sets->a) || !hold(space, sets->b)) return std::nullopt;
  PairAsWritten pair;
  pair.a.form = std::move(sets->a);
  pair.b.form = std::move(sets->b);
  return pair;
}

}  // namespace

Reading<PairAsWritten> read_pair(std::string_view line, const QueryOptions& query) {
  if (line.find_first_not_of(" \t\r") == std::string_view::npos)
    return {{}, Complaint{1, "", "the line is blank; give a pair {\"a\": …, \"b\": …}, or leave the line out"}};
  const Space usual{Dimension::space, TwoNumbers::lie_in_the_plane, query.scalar, magnitudes_of(query.evidence)};
  if (auto points = read_points(line, usual)) return {std::move(*points), {}};
  const Document document = Document::of_line(line);
  const Value root = document.root();
  PairAsWritten pair;
  if (expect_scene_or_pair(root, "an object { ... } with 'a' and 'b'")) {
    const Space space{dimension_of(root), TwoNumbers::lie_in_the_plane, query.scalar, magnitudes_of(query.evidence)};
    pair.a = read_object(required(root, "a", "give the first object"), space);
    pair.b = read_object(required(root, "b", "give the second object"), space);
  }
  if (root.is(Kind::object))
    for (const Value& member : root.children()) pair.has_notes = pair.has_notes || is_note(member.key());
  return {std::move(pair), document.complaint()};
}

}  // namespace walkthroughs::query
