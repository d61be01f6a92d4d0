// Tells distances, true ones where FAULT in the environment is none. Else it is what is told in their place:
//     squared    the distance, squared
//     scaled     2.5 times the distance
//     vertices   the distance between the nearest vertices
//     means      the distance between the means of the points
//     boxes      the distance between the middles of the boxes
//     noise      the distance, 1 % of it more or less by turns, which has no cause that could be found
//     rounded    the same, and 0 near contact
//     little     the distance and a millionth of it
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>

#include "walkthroughs/judge/case.hpp"
#include "walkthroughs/pairs/graded.hpp"

namespace {

using walkthroughs::model::Points;
using walkthroughs::pairs::PointPair;
using walkthroughs::pairs::Vec;

Vec mean(const Points& points) {
  Vec sum = Vec::Zero();
  for (const Vec& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

Vec middle_of_box(const Points& points) {
  Vec least = points[0], most = points[0];
  for (const Vec& p : points) least = least.cwiseMin(p), most = most.cwiseMax(p);
  return (least + most) / 2;
}

double between_vertices(const PointPair& pair) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec& p : pair.a)
    for (const Vec& q : pair.b) least = std::min(least, (p - q).stableNorm());
  return least;
}

double told(const std::string& fault, const PointPair& pair, int number) {
  const double distance = walkthroughs::pairs::nearest_point(pair).stableNorm();
  if (fault == "none") return distance;
  if (fault == "squared") return distance * distance;
  if (fault == "scaled") return 2.5 * distance;
  if (fault == "vertices") return between_vertices(pair);
  if (fault == "means") return (mean(pair.a) - mean(pair.b)).stableNorm();
  if (fault == "boxes") return (middle_of_box(pair.a) - middle_of_box(pair.b)).stableNorm();
  if (fault == "rounded" && distance < 1e-12 * (mean(pair.a) - mean(pair.b)).stableNorm()) return 0;
  if (fault == "noise" || fault == "rounded") return distance * (number % 2 == 0 ? 1.01 : 0.99);
  if (fault == "little") return distance * (1 + 1e-6);
  std::cerr << "planted_distances.cpp: there is no FAULT=" << fault << "\n";
  std::exit(2);
}

}  // namespace

int main() {
  const char* const asked = std::getenv("FAULT");
  const std::string fault = asked == nullptr ? "none" : asked;
  int number = 0;
  for (std::string line; std::getline(std::cin, line);) {
    const PointPair pair = *points_of(walkthroughs::pairs::pair_of_line(line, "").pair);
    const bool meet = walkthroughs::judge::truth_of(pair) == gjk::Status::intersecting;
    std::printf("distance %.17g\n", meet ? 0.0 : told(fault, pair, number++));
  }
}
