#include <simdjson.h>

#include "walkthroughs/text/document_builder.hpp"
#include "walkthroughs/text/pair_line.hpp"

namespace walkthroughs::text {
namespace {

/// Tells the builder what simdjson has read, which knows neither lines nor limits. Returns: whether to go on.
bool tell(DocumentBuilder& builder, const simdjson::dom::element& value) {
  using Type = simdjson::dom::element_type;
  switch (value.type()) {
    case Type::ARRAY:
      if (!builder.start_array()) return false;
      for (const auto element : simdjson::dom::array(value))
        if (!tell(builder, element)) return false;
      return builder.end_array();
    case Type::OBJECT:
      if (!builder.start_object()) return false;
      for (const auto [key, member] : simdjson::dom::object(value)) {
        std::string name(key);
        if (!builder.key(name) || !tell(builder, member)) return false;
      }
      return builder.end_object();
    case Type::STRING: {
      std::string text(std::string_view{value});
      return builder.string(text);
    }
    case Type::BOOL: return builder.boolean(bool(value));
    case Type::NULL_VALUE: return builder.null();
    default: return builder.number(double(value));
  }
}

constexpr int first_line = 1;

/// Keeps its memory from line to line.
simdjson::simdjson_result<simdjson::dom::element> parsed(std::string_view text) {
  static thread_local simdjson::dom::parser parser;
  return parser.parse(text.data(), text.size());
}

/// Returns: whether it is a list of numbers, three to a point.
bool read_points(const simdjson::dom::element& value, Points& points) {
  simdjson::dom::array list;
  if (value.get(list) || list.size() == 0 || list.size() > document_limits::elements) return false;
  points.reserve(list.size());
  for (const simdjson::dom::element each : list) {
    simdjson::dom::array coordinates;
    if (each.get(coordinates) || coordinates.size() != 3) return false;
    Point& point = points.emplace_back();
    int axis = 0;
    for (const simdjson::dom::element coordinate : coordinates)
      if (!coordinate.is_number() || coordinate.get(point[axis++])) return false;
  }
  return true;
}

bool read_only_member(const simdjson::dom::element& value, std::string_view key, Points& points) {
  simdjson::dom::object object;
  return !value.get(object) && object.size() == 1 && object.begin().key() == key &&
         read_points(object.begin().value(), points);
}

std::optional<TwoPointSets> two_point_sets(const simdjson::simdjson_result<simdjson::dom::element>& line) {
  simdjson::dom::object pair;
  if (line.get(pair) || pair.size() != 2) return std::nullopt;
  TwoPointSets sets;
  auto member = pair.begin();
  if (member.key() != "a" || !read_only_member(member.value(), "points", sets.a)) return std::nullopt;
  ++member;
  if (member.key() != "b" || !read_only_member(member.value(), "points", sets.b)) return std::nullopt;
  return sets;
}

/// What simdjson turns away the other parser reads again, for it says why and at which key.
Document document_of(std::string_view text, const simdjson::simdjson_result<simdjson::dom::element>& line) {
  simdjson::dom::element root;
  if (line.get(root)) return Document(text, Document::Comments::refused);
  Document document = DocumentBuilder::empty_document();
  DocumentBuilder builder(document, first_line);
  if (!tell(builder, root)) builder.forget();
  return document;
}

}  // namespace

std::variant<TwoPointSets, Document> pair_of_line(std::string_view text) {
  const auto line = parsed(text);
  if (std::optional<TwoPointSets> sets = two_point_sets(line)) return std::move(*sets);
  return is_blank(text) ? Document::of_line(text) : document_of(text, line);
}

Document Document::of_line(std::string_view text) {
  if (!is_blank(text)) return document_of(text, parsed(text));
  Document document;
  document.complain(1, "", "the line is empty");
  return document;
}

}  // namespace walkthroughs::text
