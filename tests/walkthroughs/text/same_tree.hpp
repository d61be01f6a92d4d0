/// Are two documents the same, to the sign of zero?
#pragma once

#include <cmath>

#include "walkthroughs/text/document.hpp"

namespace walkthroughs::test {

using namespace program;

inline bool same_tree(const Value& one, const Value& other) {
  using Kind = Document::Kind;
  if (one.kind() != other.kind()) return false;
  if (one.is(Kind::number))
    return one.number() == other.number() && std::signbit(one.number()) == std::signbit(other.number());
  if (one.is(Kind::boolean)) return one.is_true() == other.is_true();
  if (one.is(Kind::string)) return one.text() == other.text();
  const auto children = one.children(), others = other.children();
  if (children.size() != others.size()) return false;
  for (std::size_t i = 0; i < children.size(); ++i) {
    if (one.is(Kind::object) && children[i].key() != others[i].key()) return false;
    if (!same_tree(children[i], others[i])) return false;
  }
  return true;
}

}  // namespace walkthroughs::test
