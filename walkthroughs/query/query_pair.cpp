#include "walkthroughs/query/query_pair.hpp"

#include <algorithm>
#include <utility>
#include <variant>

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

}  // namespace

Reading<PairAsWritten> read_pair(std::string_view line, const QueryOptions& query) {
  if (line.find_first_not_of(" \t\r") == std::string_view::npos)
    return {{}, Complaint{1, "", "the line is blank; give a pair {\"a\": …, \"b\": …}, or leave the line out"}};
  std::variant<TwoPointSets, Document> read = pair_of_line(line);
  PairAsWritten pair;
  if (auto* sets = std::get_if<TwoPointSets>(&read)) {
    const Space space{Dimension::space, TwoNumbers::lie_in_the_plane, query.scalar, magnitudes_of(query.evidence)};
    if (hold(space, sets->a) && hold(space, sets->b)) {
      pair.a.form = std::move(sets->a);
      pair.b.form = std::move(sets->b);
      return {std::move(pair), {}};
    }
    read = Document::of_line(line);  // which says where
  }
  const Document& document = std::get<Document>(read);
  const Value root = document.root();
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
