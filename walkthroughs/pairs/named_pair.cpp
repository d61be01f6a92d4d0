#include "walkthroughs/pairs/named_pair.hpp"

#include <stdexcept>

#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/pairs/kept_corpus_text.hpp"
#include "walkthroughs/query/query_pair.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace walkthroughs::pairs {
namespace {

// -- Bodies as JSON ---------------------------------------------------------------------------------------------------

void append(std::string& text, double x) { append_number(x == 0 ? 0.0 : x, text); }  // 0 has no sign here

void append(std::string& text, const Vec& v) {
  for (int i = 0; i < 3; ++i) append(text += i == 0 ? '[' : ',', v[i]);
  text += ']';
}

/// Writes one field after the other.
struct FieldText {
  std::string& text;

  void operator()(field::Places, const Points& points) const {
    for (const Vec& p : points) append(text += text.empty() ? '[' : ',', p);
    text += ']';
  }
  void operator()(auto field, const auto& value) const {
    append(text.append(text.empty() ? "{\"" : ",\"").append(field.name).append("\":"), value);
  }
};

std::string text_of(const Body& body) {
  const auto text = [](const auto& shape) {
    using Row = RowOf<decltype(shape)>;
    std::string fields;
    Row::fields(FieldText{fields}, shape);
    return "{\"" + std::string(Row::key) + "\":" + fields + (fields.front() == '{' ? "}}" : "}");
  };
  return std::visit(text, body);
}

// -- And read ---------------------------------------------------------------------------------------------------------

Body body_of(const Object& object, const Value& line, const std::string& key) {
  if (line.member(key)->member("pose"))
    throw std::invalid_argument(key + ".pose: is not judged, as it would round; give the object where it is");
  const auto body = [&](const auto& shape) -> Body {
    if constexpr (std::constructible_from<Body, decltype(shape)>)
      return shape;
    else
      throw std::invalid_argument(key + ": is a sum, which is not judged; give points, a sphere or a cylinder");
  };
  return std::visit(body, object.form);
}

std::string word_of(const Value& root, const char* key, const std::string& otherwise) {
  const auto value = root.member(key);
  return value && value->is(Document::Kind::string) && !value->text().empty() ? value->text() : otherwise;
}

}  // namespace

std::string bodies_in_line(const Pair& pair) { return "\"a\":" + text_of(pair.a) + ",\"b\":" + text_of(pair.b); }

std::string question_line(const Pair& pair) { return "{" + bodies_in_line(pair) + "}"; }

void require_good(const Document& document) {
  if (document.complaint()) throw std::invalid_argument(document.complaint()->text());
}

NamedPair pair_of_line(std::string_view line, const std::string& name) {
  const query::QueryOptions any_magnitude{.evidence = query::QueryEvidence::certificate};
  const auto [written, complaint] = query::read_pair(line, any_magnitude);
  if (complaint) throw std::invalid_argument(complaint->text());
  const Document document = Document::of_line(line);
  const Value root = document.root();
  return {word_of(root, "name", name),
          word_of(root, "family", "yours"),
          {body_of(written.a, root, "a"), body_of(written.b, root, "b")},
          word_of(root, "source", "")};
}

void for_each_line(std::string_view text, const std::string& file,
                   const std::function<void(std::string_view, std::size_t)>& use) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    try {
      use(line, number);
    } catch (const std::invalid_argument& error) {
      throw InputError(file + ":" + std::to_string(number) + ": " + error.what());
    }
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
}

std::vector<NamedPair> kept_pairs() {
  std::vector<NamedPair> pairs;
  for_each_line(kept_corpus_text(), "corpus.jsonl",
                [&](std::string_view line, std::size_t /*number*/) { pairs.push_back(pair_of_line(line, "")); });
  return pairs;
}

}  // namespace walkthroughs::pairs
