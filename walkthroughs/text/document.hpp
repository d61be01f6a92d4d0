/// JSON that knows its lines: the text of a scene file, or one line of a trace, as a tree, within limits that keep it small.
///
/// Comments, // to the end of the line and /* */, count as blanks where they are allowed. The parser does not recurse, and it stops at the first
/// thing that it objects to. Nothing here knows of scenes.
///
/// Errors are values: the first complaint about a text is kept in its document, whoever makes it, and those after it are not. So a
/// reader reads on, with something in place of what it did not find, and its caller looks once, at the end.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "walkthroughs/rooms.hpp"

namespace walkthroughs::text {

/// Something is wrong with a text.
struct Complaint {
  int line;            ///< counted from 1
  std::string key;     ///< the path to the value, such as "a.points[2]"; empty for the text as a whole
  std::string reason;  ///< a sentence without place

  /// Returns: "a.points[2]: expected …".
  std::string text() const { return key + (key.empty() ? "" : ": ") + reason; }
};

/// What was read from a text, and what is wrong with it: then the value is of no use.
template <class T>
struct Reading {
  T value;
  std::optional<Complaint> complaint;
};

namespace document_limits {
inline constexpr std::size_t depth = 16;         ///< lists and objects in one another
inline constexpr std::size_t members = 100;      ///< of one object
inline constexpr std::size_t elements = 100000;  ///< of one list
inline constexpr std::size_t values = 1000000;   ///< in all
}  // namespace document_limits

class Value;

class Document {
 public:
  enum class Kind : std::uint8_t { null, boolean, number, string, list, object };

  enum class Comments { allowed, refused };

  /// Complains where `text` is not JSON, goes beyond the limits, or names a key twice in one object; its root is then null.
  explicit Document(std::string_view text, Comments comments = Comments::allowed);

  /// One line of JSON Lines, without comments: the same as the constructor, several times as fast where it is JSON.
  static Document of_line(std::string_view text);

  Value root() const;
  /// Returns: the first complaint about this text, of the parser or of a Value.
  const std::optional<Complaint>& complaint() const { return complaint_; }

 private:
  friend class Value;
  friend class DocumentBuilder;
  using Index = std::uint32_t;
  static constexpr Index none = ~Index{0};

  /// Values lie in the order of the text: the first child of a value is the next one, its sibling lies at `end`.
  struct Node {
    double number = 0;
    int line = 1;
    Index parent = none, end = none;
    Index key = none, text = none;  // in strings_
    Kind kind = Kind::null;
  };

  Document() = default;
  std::string path(Index index) const;
  static std::string shown(const std::string& key);
  /// The first one counts.
  void complain(int line, std::string key, std::string reason) const {
    if (!complaint_) complaint_ = {line, std::move(key), std::move(reason)};
  }

  std::vector<Node> nodes_;
  std::vector<std::string> strings_;
  mutable std::optional<Complaint> complaint_;  // what is read stays as it is
};

/// One value of a document, which must outlive it.
class Value {
 public:
  Document::Kind kind() const { return node().kind; }
  bool is(Document::Kind kind) const { return node().kind == kind; }
  double number() const { return is(Document::Kind::number) ? node().number : 0; }  ///< 0 where it is no number
  bool is_true() const { return node().number != 0; }                               ///< Requires: a boolean.
  /// Returns: valid UTF-8; empty where it is no string.
  const std::string& text() const;
  /// Requires: the value of a member of an object.
  const std::string& key() const { return document_->strings_[node().key]; }
  /// Returns: the elements of a list or the members of an object, in their order; none of other values.
  std::vector<Value> children() const;
  std::optional<Value> member(std::string_view key) const;

  /// Returns: what kind of value it is, with an article: "a string".
  std::string_view description() const;
  /// Complains about this value.
  void fail(const std::string& reason) const;
  /// As fail(), for what an object lacks. Returns: null in its place.
  Value fail_without(std::string_view key, const std::string& reason) const;
  /// Returns: whether nobody has complained about this document so far.
  bool is_good() const { return !document_->complaint_; }

 private:
  friend class Document;
  Value(const Document& document, Document::Index index) : document_(&document), index_(index) {}
  /// Of what is not there: null, without children.
  const Document::Node& node() const;

  const Document* document_;
  Document::Index index_;
};

}  // namespace walkthroughs::text
