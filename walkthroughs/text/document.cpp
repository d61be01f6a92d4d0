#include "walkthroughs/text/document.hpp"

#include <simdjson.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <cctype>
#include <nlohmann/json.hpp>
#include <utility>

#include "walkthroughs/text/printable.hpp"

namespace walkthroughs::text {
namespace {

using Json = nlohmann::json;

/// How far the parser has read. The parser keeps a copy of its iterator; this is what all copies share.
struct Progress {
  const char* begin;
  const char* next;
  const char* end;
  int line = 1;  ///< of the last character read
  const char* line_begin;

  explicit Progress(std::string_view text)
      : begin(text.data()), next(begin), end(begin + text.size()), line_begin(begin) {}

  /// A number is known to be over only when the character behind it has been read. That may be the end of its line,
  /// which therefore still belongs to the line.
  void advance() {
    if (next != begin && next[-1] == '\n') {
      ++line;
      line_begin = next;
    }
    ++next;
  }

  /// Passes over blanks behind a line break or tab, but for the last. The parser keeps what it reads for its messages,
  /// eight letters for each such character. No string is changed: JSON allows no line breaks and tabs there.
  void skip_blanks() {
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
    if (next == begin || next[-1] == ' ' || !is_blank(next[-1])) return;
    while (next + 1 < end && is_blank(next[0]) && is_blank(next[1])) advance();
  }

  std::ptrdiff_t column() const { return std::max<std::ptrdiff_t>(next - line_begin, 1); }
};

/// Lets the parser read while lines are counted.
class CountingIterator : public boost::iterator_facade<CountingIterator, const char, boost::single_pass_traversal_tag> {
 public:
  CountingIterator() = default;  ///< the end
  explicit CountingIterator(Progress& progress) : progress_(&progress) {}

 private:
  friend class boost::iterator_core_access;

  const char& dereference() const {
    progress_->skip_blanks();
    return *progress_->next;
  }
  void increment() { progress_->advance(); }
  bool equal(const CountingIterator& other) const { return at_end() == other.at_end(); }
  bool at_end() const { return progress_ == nullptr || progress_->next == progress_->end; }

  Progress* progress_ = nullptr;
};

/// Returns: the letters and digits around `at`, for example "NaN".
std::string word_around(const char* at, const Progress& progress) {
  const auto belongs = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '+' || c == '-' || c == '.' || c == '_';
  };
  const char *first = at, *last = at;
  while (first != progress.begin && belongs(first[-1])) --first;
  while (last != progress.end && belongs(*last)) ++last;
  return {first, last};
}

bool looks_not_finite(const std::string& word) {
  return boost::algorithm::icontains(word, "nan") || boost::algorithm::icontains(word, "inf");
}

/// Returns: the parser's own words without its prefix and without the text read, which may be long.
std::string what_the_parser_says(const std::string& message) {
  const std::size_t begin = message.find(" - "), end = message.find("; last read: ");
  if (begin == std::string::npos) return message;
  return message.substr(begin + 3, end == std::string::npos ? end : end - begin - 3);
}

std::string reason_of_syntax_error(const Progress& progress, const nlohmann::detail::exception& error) {
  constexpr int number_overflow = 406;
  if (error.id == number_overflow) {
    const bool at_end = progress.next == progress.end && std::isdigit(static_cast<unsigned char>(progress.next[-1]));
    const std::string word = word_around(progress.next - (at_end ? 0 : 1), progress);
    return "the number " + in_quotes(word) +
           " is too large for floating point, which ends at 1.8e308; choose a larger unit of length";
  }
  const std::string word = word_around(progress.next, progress), said = what_the_parser_says(error.what());
  const std::string at_column = "is not JSON at column " + std::to_string(progress.column()) + ": ";
  if (looks_not_finite(word)) return at_column + in_quotes(word) + " is not a number; write a finite one";
  if (said == "invalid literal" && !word.empty())
    return at_column + in_quotes(word) + " is not a value; names and other texts need double quotes";
  if (said.find("surrogate") != std::string::npos)
    return at_column +
           "an escape is one half of a letter (a surrogate); write both halves, such as \\ud835\\udc65, or the letter";
  if (said.find("4 hex digits") != std::string::npos)
    return at_column + "after \\u come four hexadecimal digits, as in \\u00e4; write them, or the letter itself";
  if (said.find("after backslash") != std::string::npos)
    return at_column + "a backslash begins an escape such as \\n, and this is none; write \\\\ for a backslash";
  return at_column + said + ". Check brackets, commas and quotes there";
}

}  // namespace

/// Receives what the parser finds, in the order of the text.
class DocumentBuilder {
 public:
  DocumentBuilder(Document& document, const Progress& progress) : document_(document), progress_(progress) {}

  bool null() { return add(Document::Kind::null); }
  bool boolean(bool value) { return add(Document::Kind::boolean, value ? 1 : 0); }
  bool number_integer(Json::number_integer_t value) { return number_float(static_cast<double>(value), {}); }
  bool number_unsigned(Json::number_unsigned_t value) { return number_float(static_cast<double>(value), {}); }
  bool number_float(Json::number_float_t value, const std::string&) { return add(Document::Kind::number, value); }
  bool string(std::string& value) {
    if (!add(Document::Kind::string)) return false;
    document_.nodes_.back().text = keep(std::move(value));
    return true;
  }
  bool binary(Json::binary_t&) { return false; }  // JSON has none
  bool start_object(std::size_t) { return open(Document::Kind::object); }
  bool start_array(std::size_t) { return open(Document::Kind::list); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    const Open& object = open_.back();
    const bool is_second = object_has(object.index, name), is_too_many = object.children == document_limits::members;
    key_ = keep(std::move(name));
    if (is_second) return fail("this key appears twice in its object; remove one");
    if (is_too_many) return fail("too many keys; an object may have " + std::to_string(document_limits::members));
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) {
    return fail(reason_of_syntax_error(progress_, error));
  }

  static std::string shown(const std::string& key) {
    const std::string text = in_quotes(key);
    return text.substr(1, text.size() - 2);
  }

 private:
  struct Open {
    Document::Index index;
    std::size_t children = 0;
  };

  /// Complains about the value that would come next. Returns: that the parser is to stop.
  bool fail(const std::string& reason) const {
    document_.complain(progress_.line, place_of_next_value(), reason);
    return false;
  }

  bool object_has(Document::Index object, const std::string& name) const {
    const auto& nodes = document_.nodes_;
    for (std::size_t i = object + 1; i < nodes.size(); i = nodes[i].end)
      if (document_.strings_[nodes[i].key] == name) return true;
    return false;
  }

  Document::Index keep(std::string&& text) {
    document_.strings_.push_back(std::move(text));
    return static_cast<Document::Index>(document_.strings_.size() - 1);
  }

  std::string place() const { return open_.empty() ? "" : document_.path(open_.back().index); }

  /// Returns: the path that a value beginning here would have.
  std::string place_of_next_value() const {
    if (open_.empty()) return "";
    if (document_.nodes_[open_.back().index].kind == Document::Kind::list)
      return place() + "[" + std::to_string(open_.back().children) + "]";
    if (key_ == Document::none) return place();
    return place() + (place().empty() ? "" : ".") + shown(document_.strings_[key_]);
  }

  bool add(Document::Kind kind, double number = 0) {
    if (document_.nodes_.size() == document_limits::values)
      return fail("too many values; a file may have " + std::to_string(document_limits::values));
    const bool in_list = !open_.empty() && document_.nodes_[open_.back().index].kind == Document::Kind::list;
    if (in_list && open_.back().children == document_limits::elements) {
      document_.complain(progress_.line, place(),
                         "too many elements; a list may have " + std::to_string(document_limits::elements));
      return false;
    }
    Document::Node node{
        .number = number, .line = progress_.line, .key = std::exchange(key_, Document::none), .kind = kind};
    if (!open_.empty()) {
      node.parent = open_.back().index;
      ++open_.back().children;
    }
    node.end = static_cast<Document::Index>(document_.nodes_.size() + 1);
    document_.nodes_.push_back(node);
    return true;
  }

  bool open(Document::Kind kind) {
    if (open_.size() == document_limits::depth)
      return fail("too many brackets in one another; " + std::to_string(document_limits::depth) +
                  " levels are allowed");
    if (!add(kind)) return false;
    open_.push_back({static_cast<Document::Index>(document_.nodes_.size() - 1)});
    return true;
  }

  bool close() {
    document_.nodes_[open_.back().index].end = static_cast<Document::Index>(document_.nodes_.size());
    open_.pop_back();
    return true;
  }

  Document& document_;
  const Progress& progress_;
  std::vector<Open> open_;
  Document::Index key_ = Document::none;  // read, its value not yet
};

namespace {

Complaint about_byte(std::string_view text, std::size_t at, const std::string& reason) {
  const auto lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  return {1 + static_cast<int>(lines), "", reason};
}

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

/// Returns: what the parser would take for the end of the text, or complain about less clearly.
std::optional<Complaint> objection_to_bytes(std::string_view text) {
  if (is_blank(text)) return Complaint{1, "", "the file is empty; 'gjkstep scene --example' prints one to begin with"};
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    return Complaint{1, "", "the text is UTF-16; save it as UTF-8"};
  if (!simdjson::validate_utf8(text.data(), text.size())) {
    const std::size_t at = first_not_utf_8(text).value();
    const std::size_t line_begin = text.substr(0, at).rfind('\n') + 1;  // 0 where there is no line break
    return about_byte(text, at,
                      "is not UTF-8 at column " + std::to_string(at - line_begin + 1) + ": the byte " +
                          printable(text.substr(at, 1)) + " is no letter there; save the text as UTF-8");
  }
  const auto is_control = [](char c) { return '\0' <= c && c < ' ' && c != '\t' && c != '\n' && c != '\r'; };
  if (const auto at = std::ranges::find_if(text, is_control); at != text.end())
    return about_byte(text, static_cast<std::size_t>(at - text.begin()),
                      "there is a byte " + std::to_string(*at) + ", which no text has; save it as UTF-8");
  return std::nullopt;
}

}  // namespace

Document::Document(std::string_view text, Comments comments) {
  complaint_ = objection_to_bytes(text);
  if (complaint_) return;
  Progress progress(text);
  DocumentBuilder builder(*this, progress);
  constexpr bool strict = true;
  Json::sax_parse(CountingIterator(progress), CountingIterator(), &builder, Json::input_format_t::json, strict,
                  comments == Comments::allowed);
  if (complaint_) nodes_.clear();
}

namespace {

/// Tells the builder what simdjson has read, which knows neither lines nor limits. Returns: whether to go on.
bool tell(DocumentBuilder& builder, const simdjson::dom::element& value) {
  using Type = simdjson::dom::element_type;
  switch (value.type()) {
    case Type::ARRAY:
      if (!builder.start_array(0)) return false;
      for (const auto element : simdjson::dom::array(value))
        if (!tell(builder, element)) return false;
      return builder.end_array();
    case Type::OBJECT:
      if (!builder.start_object(0)) return false;
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
    default: return builder.number_float(double(value), {});
  }
}

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
  const Progress progress(text);
  DocumentBuilder builder(document, progress);
  if (!tell(builder, root)) document.nodes_.clear();
  return document;
}

Value Document::root() const { return {*this, nodes_.empty() ? none : 0}; }

std::string Document::path(Index index) const {
  if (index == none) return "";
  const Node& node = nodes_[index];
  if (node.parent == none) return "";
  const std::string front = path(node.parent);  // no deeper than document_limits::depth
  if (node.key != none) return front + (front.empty() ? "" : ".") + DocumentBuilder::shown(strings_[node.key]);
  std::size_t position = 0;
  for (Index i = node.parent + 1; i != index; i = nodes_[i].end) ++position;
  return front + "[" + std::to_string(position) + "]";
}

const Document::Node& Value::node() const {
  static const Document::Node nothing{.end = 0};
  return index_ == Document::none ? nothing : document_->nodes_[index_];
}

const std::string& Value::text() const {
  static const std::string nothing;
  return is(Document::Kind::string) ? document_->strings_[node().text] : nothing;
}

std::vector<Value> Value::children() const {
  std::size_t count = 0;
  for (Document::Index i = index_ + 1; i < node().end; i = document_->nodes_[i].end) ++count;
  std::vector<Value> children;
  children.reserve(count);
  for (Document::Index i = index_ + 1; i < node().end; i = document_->nodes_[i].end)
    children.push_back({*document_, i});
  return children;
}

std::optional<Value> Value::member(std::string_view key) const {
  if (!is(Document::Kind::object)) return std::nullopt;
  for (Document::Index i = index_ + 1; i < node().end; i = document_->nodes_[i].end)
    if (const Value child{*document_, i}; child.key() == key) return child;
  return std::nullopt;
}

std::string_view Value::description() const {
  switch (kind()) {
    case Document::Kind::null: return "null";
    case Document::Kind::boolean: return "true or false";
    case Document::Kind::number: return "a number";
    case Document::Kind::string: return "a string";
    case Document::Kind::list: return "a list";
    case Document::Kind::object: return "an object";
  }
  return "";
}

void Value::fail(const std::string& reason) const {
  if (is_good()) document_->complain(node().line, document_->path(index_), reason);
}

Value Value::fail_without(std::string_view key, const std::string& reason) const {
  const std::string path = is_good() ? document_->path(index_) : "";
  document_->complain(node().line, path + (path.empty() ? "" : ".") + std::string(key), reason);
  return {*document_, Document::none};
}

}  // namespace walkthroughs::text
