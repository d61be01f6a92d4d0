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

/// Returns: the points of "a" or "b" in a line such as {"a":{"points":[[0,0,0],[1,0,0]]},"b":{"points":[[0,0,1]]}}.
inline Points points_of(const char* key, const std::string& line) {
  Points points;
  const std::size_t from = line.find("[[", line.find(key)), to = line.find("]]", from);
  if (to == std::string::npos) return points;
  std::size_t coordinate = 0;
  for (const char* at = line.c_str() + from; at < line.c_str() + to; ++at) {
    if (*at != '-' && (*at < '0' || *at > '9')) continue;
    char* end = nullptr;
    if (coordinate == 0) points.emplace_back();
    points.back()[coordinate] = std::strtod(at, &end);
    coordinate = (coordinate + 1) % 3;
    at = end - 1;
  }
  return points;
}

/// Call it at the end of each iteration, if you like: where JUDGE_STEPS is set, it tells `gjkstep-study check-steps` of it.
inline void step(const std::array<double, 3>& searched_along, const Points& reduced_simplex) {
  if (std::getenv("JUDGE_STEPS") == nullptr) return;
  const auto write = [](const char* before, const std::array<double, 3>& p) {
    std::cout << before << '[' << p[0] << ',' << p[1] << ',' << p[2] << ']';
  };
  std::cout.precision(17);
  write("{\"direction\":", searched_along);
  for (std::size_t i = 0; i < reduced_simplex.size(); ++i) write(i == 0 ? ",\"simplex\":[" : ",", reduced_simplex[i]);
  std::cout << "]}\n";
}

}  // namespace judge

/// Returns: whether the convex hulls of these points have a point in common.
bool collide(const judge::Points& a, const judge::Points& b);

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    if (line.find("\"center\"") != std::string::npos)
      return std::cerr << "judge_main.hpp asks about points, and this pair has a round shape\n", 2;
    const bool meet = collide(judge::points_of("\"a\"", line), judge::points_of("\"b\"", line));
    std::cout << (meet ? "true" : "false") << std::endl;
  }
}
