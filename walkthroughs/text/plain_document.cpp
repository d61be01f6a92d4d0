// Lines of numbers, read without the ceremony that the first thing wrong in a file deserves.
#include <algorithm>
#include <charconv>
#include <cstring>
#include <utility>

#include "walkthroughs/text/document.hpp"

namespace walkthroughs {

/// Reads a text that is right and plain: objects, lists, numbers, and strings of printable ASCII without escapes, within
/// document_limits. At anything else, right or wrong, it gives up; then the other reader reads the text from its
/// beginning. Where it does not give up, the other one finds the same tree.
class PlainReader {
 public:
  PlainReader(Document& document, std::string_view text)
      : document_(document), next_(text.data()), end_(text.data() + text.size()) {
    document_.nodes_.reserve(64);  // of two tetrahedra: 41
  }

  /// Returns: whether it got through; else the document is of no use.
  bool read() {
    if (!value(0)) return false;
    skip_blanks();
    return next_ == end_;
  }

 private:
  using Kind = Document::Kind;
  using Index = Document::Index;

  void skip_blanks() {
    while (next_ != end_ && (*next_ == ' ' || *next_ == '\t' || *next_ == '\r' || *next_ == '\n')) ++next_;
  }

  /// Passes over blanks and, where it comes next, `c`.
  bool accept(char c) {
    skip_blanks();
    if (next_ == end_ || *next_ != c) return false;
    ++next_;
    return true;
  }

  Index add(Kind kind) {
    const auto index = static_cast<Index>(document_.nodes_.size());
    document_.nodes_.push_back(
        {.parent = parent_, .end = index + 1, .key = std::exchange(key_, Document::none), .kind = kind});
    return index;
  }

  bool value(std::size_t depth) {
    if (document_.nodes_.size() == document_limits::values) return false;
    if (accept('[')) return depth != document_limits::depth && list(depth + 1);
    if (accept('{')) return depth != document_limits::depth && object(depth + 1);
    if (accept('"')) return string();
    return number();
  }

  bool list(std::size_t depth) {
    const Index index = add(Kind::list), outer = std::exchange(parent_, index);
    if (!accept(']')) {
      std::size_t count = 0;
      do {
        if (++count > document_limits::elements || !value(depth)) return false;
      } while (accept(','));
      if (!accept(']')) return false;
    }
    return close(index, outer);
  }

  bool object(std::size_t depth) {
    const Index index = add(Kind::object), outer = std::exchange(parent_, index);
    if (!accept('}')) {
      do {
        if (!key(index) || !accept(':') || !value(depth)) return false;
      } while (accept(','));
      if (!accept('}')) return false;
    }
    return close(index, outer);
  }

  bool close(Index index, Index outer) {
    document_.nodes_[index].end = static_cast<Index>(document_.nodes_.size());
    parent_ = outer;
    return true;
  }

  /// Returns: whether a key follows that the object of that index does not have yet, nor too many others.
  bool key(Index object) {
    if (!accept('"')) return false;
    const std::optional<std::string_view> name = plain_text();
    if (!name) return false;
    std::size_t count = 0;
    for (Index i = object + 1; i != document_.nodes_.size(); i = document_.nodes_[i].end)
      if (document_.strings_[document_.nodes_[i].key] == *name || ++count == document_limits::members) return false;
    key_ = keep(*name);
    return true;
  }

  bool string() {
    const std::optional<std::string_view> text = plain_text();
    if (!text) return false;
    const Index index = add(Kind::string);
    document_.nodes_[index].text = keep(*text);
    return true;
  }

  Index keep(std::string_view text) {
    document_.strings_.emplace_back(text);
    return static_cast<Index>(document_.strings_.size() - 1);
  }

  /// Requires: the quote before it has been passed over.
  std::optional<std::string_view> plain_text() {
    const char* const begin = next_;
    while (next_ != end_ && ' ' <= *next_ && *next_ <= '~' && *next_ != '"' && *next_ != '\\') ++next_;
    if (next_ == end_ || *next_ != '"') return std::nullopt;
    return std::string_view(begin, next_++);
  }

  bool number() {
    const char* const begin = next_;
    const bool is_whole = !pass_number();
    if (next_ == begin) return false;
    double found = 0;
    const auto [last, error] = std::from_chars(begin, next_, found);
    if (error != std::errc() || last != next_) return false;  // beyond all doubles, or between 0 and the least of them
    // A whole number has no sign where it is 0.
    document_.nodes_[add(Kind::number)].number = is_whole ? found + 0.0 : found;
    return true;
  }

  /// Passes over a number as JSON spells it, which is less than from_chars() would read; over nothing where there is none.
  /// Returns: whether it has a fraction or an exponent.
  bool pass_number() {
    const char* const begin = next_;
    const auto fail = [&] {
      next_ = begin;
      return false;
    };
    if (next_ != end_ && *next_ == '-') ++next_;
    if (next_ != end_ && *next_ == '0')
      ++next_;
    else if (!pass_digits())
      return fail();
    const char* const after_digits = next_;
    if (next_ != end_ && *next_ == '.') {
      ++next_;
      if (!pass_digits()) return fail();
    }
    if (next_ != end_ && (*next_ == 'e' || *next_ == 'E')) {
      ++next_;
      if (next_ != end_ && (*next_ == '+' || *next_ == '-')) ++next_;
      if (!pass_digits()) return fail();
    }
    return next_ != after_digits;
  }

  bool pass_digits() {
    const char* const begin = next_;
    while (next_ != end_ && '0' <= *next_ && *next_ <= '9') ++next_;
    return next_ != begin;
  }

  Document& document_;
  const char *next_, *end_;
  Index parent_ = Document::none, key_ = Document::none;
};

Document Document::of_line(std::string_view text) {
  Document document;
  if (PlainReader(document, text).read()) return document;
  return Document(text, Comments::refused);
}

}  // namespace walkthroughs
