#include "tests/study/judge/pairs_file.hpp"

#include <stdexcept>

#include "tests/study/judge/kept_corpus_text.hpp"
#include "tests/study/truth/oracle.hpp"
#include "walkthroughs/query/query_pair.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace study {
namespace {

using walkthroughs::text::Document;

Body body_of(const walkthroughs::model::Object& object, const walkthroughs::text::Value& line, const std::string& key) {
  if (line.member(key)->member("pose"))
    throw std::invalid_argument(key + ".pose: is not judged, as it would round; give the object where it is");
  const auto body = [&](const auto& shape) -> Body {
    if constexpr (std::constructible_from<Body, decltype(shape)>)
      return shape;
    else
      throw std::invalid_argument(key +
                                  ": is a sum, which the oracle cannot judge; give points, a sphere or a cylinder");
  };
  return std::visit(body, object.form);
}

std::string text_of(const walkthroughs::text::Value& root, const char* key, const std::string& otherwise) {
  const auto value = root.member(key);
  return value && value->is(Document::Kind::string) && !value->text().empty() ? value->text() : otherwise;
}

}  // namespace

void require_good(const Document& document) {
  if (document.complaint()) throw std::invalid_argument(document.complaint()->text());
}

NamedPair pair_of_line(std::string_view line, const std::string& name) {
  const walkthroughs::query::QueryOptions any_magnitude{.evidence = walkthroughs::query::QueryEvidence::certificate};
  const auto [written, complaint] = walkthroughs::query::read_pair(line, any_magnitude);
  if (complaint) throw std::invalid_argument(complaint->text());
  const Document document = Document::of_line(line);
  NamedPair named{text_of(document.root(), "name", name),
                  text_of(document.root(), "family", "yours"),
                  {body_of(written.a, document.root(), "a"), body_of(written.b, document.root(), "b")}};
  truth(named.pair);
  return named;
}

void for_each_line(std::string_view text, const std::string& file,
                   const std::function<void(std::string_view, std::size_t)>& use) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const auto fail = [&](const std::string& reason) {
      throw walkthroughs::text::InputError(file + ":" + std::to_string(number) + ": " + reason);
    };
    try {
      use(line, number);
    } catch (const std::invalid_argument& error) {
      fail(error.what());
    }
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
}

std::vector<NamedPair> read_pairs(std::string_view text, const std::string& file) {
  std::vector<NamedPair> pairs;
  for_each_line(text, file, [&](std::string_view line, std::size_t number) {
    pairs.push_back(pair_of_line(line, "line-" + std::to_string(number)));
  });
  if (pairs.empty()) throw walkthroughs::text::InputError(file + ": holds no pair; 'gjkstep-study pairs' writes some");
  return pairs;
}

std::vector<NamedPair> kept_pairs() { return read_pairs(kept_corpus_text(), "corpus.jsonl"); }

}  // namespace study
