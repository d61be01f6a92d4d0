/// How a document comes from what a parser of JSON finds. Parsers: document_text.cpp, document_line.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "walkthroughs/text/document.hpp"

namespace walkthroughs::text {

inline bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

/// Receives what a parser finds, in the order of the text, and holds it to the limits. All but the constructor return whether to go on.
class DocumentBuilder {
 public:
  /// `line`: where the reader is.
  DocumentBuilder(Document& document, const int& line) : document_(document), line_(line) {}

  bool null() { return add(Document::Kind::null); }
  bool boolean(bool value) { return add(Document::Kind::boolean, value ? 1 : 0); }
  bool number(double value) { return add(Document::Kind::number, value); }
  bool string(std::string& value) {
    if (!add(Document::Kind::string)) return false;
    document_.nodes_.back().text = keep(std::move(value));
    return true;
  }
  bool start_object() { return open(Document::Kind::object); }
  bool start_array() { return open(Document::Kind::list); }
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

  /// Returns: a document of which nothing has been found.
  static Document empty_document() { return {}; }
  /// Drops what was found.
  void forget() { document_.nodes_.clear(); }

  /// Complains about the value that would come next. Returns: that the parser is to stop.
  bool fail(const std::string& reason) const {
    document_.complain(line_, place_of_next_value(), reason);
    return false;
  }

 private:
  struct Open {
    Document::Index index;
    std::size_t children = 0;
  };

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
    return place() + (place().empty() ? "" : ".") + Document::shown(document_.strings_[key_]);
  }

  bool add(Document::Kind kind, double number = 0) {
    if (document_.nodes_.size() == document_limits::values)
      return fail("too many values; a file may have " + std::to_string(document_limits::values));
    const bool in_list = !open_.empty() && document_.nodes_[open_.back().index].kind == Document::Kind::list;
    if (in_list && open_.back().children == document_limits::elements) {
      document_.complain(line_, place(),
                         "too many elements; a list may have " + std::to_string(document_limits::elements));
      return false;
    }
    Document::Node node{.number = number, .line = line_, .key = std::exchange(key_, Document::none), .kind = kind};
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
  const int& line_;
  std::vector<Open> open_;
  Document::Index key_ = Document::none;  // read, its value not yet
};

}  // namespace walkthroughs::text
