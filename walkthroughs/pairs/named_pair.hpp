/// Pairs as lines of JSON, which `gjkstep query` and every program that is judged read:
///
///     {"name":"triangles-3","family":"triangles","a":{"points":[[0,0,0],…]},"b":{"points":[…]}}
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "walkthroughs/pairs/pair.hpp"
#include "walkthroughs/text/document.hpp"

namespace walkthroughs::pairs {

struct NamedPair {
  std::string name, family;
  Pair pair;
  std::string source = "";  ///< who published it; else empty
};

/// Returns: "\"a\":…,\"b\":…", and as an object {"a":…,"b":…}. Neither tells a name or an answer, nor ends in a line feed.
std::string bodies_in_line(const Pair& pair);
std::string question_line(const Pair& pair);

/// Errors: std::invalid_argument where anybody has complained about it.
void require_good(const Document& document);

/// Returns: the pair of that line. `name`: where the line says none.
/// Errors: std::invalid_argument, also where it holds other shapes than points, spheres and cylinders, or a pose.
NamedPair pair_of_line(std::string_view line, const std::string& name);

/// Calls `use(line, number)` with each line, counted from 1. Errors: InputError, which names `file` and line, in place of a
/// std::invalid_argument of `use`.
void for_each_line(std::string_view text, const std::string& file,
                   const std::function<void(std::string_view, std::size_t)>& use);

/// Returns: the kept corpus, which the program has with it.
std::vector<NamedPair> kept_pairs();

}  // namespace walkthroughs::pairs
