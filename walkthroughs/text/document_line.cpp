#include <simdjson.h>

#include "walkthroughs/text/document_builder.hpp"

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

}  // namespace

/// What simdjson turns away the other parser reads again, for it says why and at which key.
Document Document::of_line(std::string_view text) {
  simdjson::dom::parser parser;
  simdjson::dom::element root;
  Document document;
  if (is_blank(text)) {
    document.complain(1, "", "the line is empty");
    return document;
  }
  if (parser.parse(text.data(), text.size()).get(root)) return Document(text, Comments::refused);
  document.nodes_.reserve(64);  // of two tetrahedra: 41
  DocumentBuilder builder(document, first_line);
  if (!tell(builder, root)) document.nodes_.clear();
  return document;
}

}  // namespace walkthroughs::text
