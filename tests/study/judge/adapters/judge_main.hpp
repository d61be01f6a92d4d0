// Makes a program that `gjkstep-study judge` can ask out of a function: write that function, include this file once, and build.
//
//     #include "judge_main.hpp"
//     bool collide(const judge::Points& a, const judge::Points& b) { return your_gjk(a, b); }
//
// Needs C++11 and nothing else.
#pragma once

#include <array>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace judge {

using Points = std::vector<std::array<double, 3>>;

/// Returns: the points between two places of a line such as {"a":{"points":[[0,0,0],[1,0,0]]},"b":{"points":[[0,0,1]]}}.
inline Points points_in(const std::string& line, std::size_t from, std::size_t to) {
  Points points;
  std::size_t coordinate = 0;
  for (const char* at = line.c_str() + from; at < line.c_str() + to;) {
    char* end = nullptr;
    const double number = std::strtod(at, &end);
    const bool is_number = end != at && (*at == '-' || (*at >= '0' && *at <= '9'));
    if (!is_number) {
      ++at;
      continue;
    }
    if (coordinate == 0) points.emplace_back();
    points.back()[coordinate] = number;
    coordinate = (coordinate + 1) % 3;
    at = end;
  }
  return points;
}

}  // namespace judge

/// Returns: whether the convex hulls of these points have a point in common.
bool collide(const judge::Points& a, const judge::Points& b);

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    const std::size_t b = line.find("\"b\"");
    const bool meet = collide(judge::points_in(line, line.find("\"a\""), b), judge::points_in(line, b, line.size()));
    std::cout << (meet ? "true" : "false") << std::endl;
  }
}
