#include "walkthroughs/text/document.hpp"

#include "walkthroughs/text/printable.hpp"

namespace walkthroughs::text {

Value Document::root() const { return {*this, nodes_.empty() ? none : 0}; }

std::string Document::shown(const std::string& key) {
  const std::string text = in_quotes(key);
  return text.substr(1, text.size() - 2);
}

std::string Document::path(Index index) const {
  if (index == none) return "";
  const Node& node = nodes_[index];
  if (node.parent == none) return "";
  const std::string front = path(node.parent);  // no deeper than document_limits::depth
  if (node.key != none) return front + (front.empty() ? "" : ".") + shown(strings_[node.key]);
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
