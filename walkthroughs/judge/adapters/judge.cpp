// Lets `gjkstep judge` ask a collision test that is written in C++11 or newer. Write this function in a file of yours:
//
//     bool collide(const std::vector<std::array<double, 3>>& a, const std::vector<std::array<double, 3>>& b);
//
// It gets the points of two convex hulls, and returns whether the hulls have a point in common. Touching counts. Then:
//
//     c++ -O2 judge.cpp mine.cpp -o mine && gjkstep judge -- ./mine
//
// If your search calls this at the end of each iteration, its steps are judged, too:
//
//     void judge_step(const std::array<double, 3>& searched_along, const std::vector<std::array<double, 3>>& simplex);
//
// The simplex is the reduced one, points a - b, the newest last (or always first).
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Points = std::vector<std::array<double, 3>>;

bool collide(const Points& a, const Points& b);

void judge_step(const std::array<double, 3>& searched_along, const Points& simplex) {
  if (std::getenv("JUDGE_STEPS") == nullptr) return;
  const auto write = [](const char* before, const std::array<double, 3>& p) {
    std::cout << before << '[' << p[0] << ',' << p[1] << ',' << p[2] << ']';
  };
  std::cout.precision(17);
  write("{\"direction\":", searched_along);
  for (std::size_t i = 0; i < simplex.size(); ++i) write(i == 0 ? ",\"simplex\":[" : ",", simplex[i]);
  std::cout << "]}\n";
}

/// Returns: the points [[x,y,z],...] that follow `key` in a line without blanks.
static Points points_after(const std::string& key, const std::string& line) {
  const std::size_t found = line.find(key);
  if (found == std::string::npos) {
    std::cerr << "judge.cpp: a line is no pair of sets of points\n";
    std::exit(2);
  }
  Points points;
  const char* at = line.c_str() + found + key.size();
  while (*at == '[') {
    points.push_back({});
    for (double& coordinate : points.back()) {
      if (*at != '[' && *at != ',') break;
      char* end = nullptr;
      coordinate = std::strtod(at + 1, &end);
      at = end;
    }
    if (*at == ']') ++at;
    if (*at == ',') ++at;
  }
  return points;
}

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    line.erase(std::remove_if(line.begin(), line.end(), [](unsigned char c) { return std::isspace(c); }), line.end());
    const Points a = points_after("\"a\":{\"points\":[", line), b = points_after("\"b\":{\"points\":[", line);
    std::cout << (collide(a, b) ? "yes" : "no") << std::endl;
  }
}
