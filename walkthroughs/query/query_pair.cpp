#include "walkthroughs/query/query_pair.hpp"

#include <utility>

namespace walkthroughs::query {
namespace {

using namespace reading;

/// What is proven needs no room for squares.
Magnitudes magnitudes_of(QueryEvidence evidence) {
  return evidence == QueryEvidence::of_the_search ? Magnitudes::with_finite_squares : Magnitudes::all;
}

}  // namespace

Reading<PairAsWritten> read_pair(std::string_view line, const QueryOptions& query) {
  if (line.find_first_not_of(" \t\r") == std::string_view::npos)
    return {{}, Complaint{1, "", "the line is blank; give a pair {\"a\": …, \"b\": …}, or leave the line out"}};
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
