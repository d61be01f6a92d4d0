#include <algorithm>
#include <boost/iterator/iterator_facade.hpp>
#include <cctype>
#include <nlohmann/json.hpp>

#include "walkthroughs/text/document_builder.hpp"
#include "walkthroughs/text/names.hpp"
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
  const std::string small = in_small_letters(word);
  return small.find("nan") != std::string::npos || small.find("inf") != std::string::npos;
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

/// Receives what nlohmann_json finds.
class Events : public DocumentBuilder {
 public:
  Events(Document& document, const Progress& progress)
      : DocumentBuilder(document, progress.line), progress_(progress) {}

  bool number_integer(Json::number_integer_t value) { return number(static_cast<double>(value)); }
  bool number_unsigned(Json::number_unsigned_t value) { return number(static_cast<double>(value)); }
  bool number_float(Json::number_float_t value, const std::string&) { return number(value); }
  bool binary(Json::binary_t&) { return false; }  // JSON has none
  bool start_object(std::size_t) { return DocumentBuilder::start_object(); }
  bool start_array(std::size_t) { return DocumentBuilder::start_array(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) {
    return fail(reason_of_syntax_error(progress_, error));
  }

 private:
  const Progress& progress_;
};

Complaint about_byte(std::string_view text, std::size_t at, const std::string& reason) {
  const auto lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  return {1 + static_cast<int>(lines), "", reason};
}

/// Returns: what the parser would take for the end of the text, or complain about less clearly.
std::optional<Complaint> objection_to_bytes(std::string_view text) {
  if (is_blank(text)) return Complaint{1, "", "the file is empty; 'gjkstep scene --example' prints one to begin with"};
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    return Complaint{1, "", "the text is UTF-16; save it as UTF-8"};
  if (const auto at = first_not_utf_8(text)) {
    const std::size_t line_begin = text.substr(0, *at).rfind('\n') + 1;  // 0 where there is no line break
    return about_byte(text, *at,
                      "is not UTF-8 at column " + std::to_string(*at - line_begin + 1) + ": the byte " +
                          printable(text.substr(*at, 1)) + " is no letter there; save the text as UTF-8");
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
  Events events(*this, progress);
  constexpr bool strict = true;
  Json::sax_parse(CountingIterator(progress), CountingIterator(), &events, Json::input_format_t::json, strict,
                  comments == Comments::allowed);
  if (complaint_) nodes_.clear();
}

}  // namespace walkthroughs::text
