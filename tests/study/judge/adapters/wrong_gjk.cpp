// A short GJK with one mistake in it, to be found by tests/study/judge/README.md:
//
//     c++ wrong_gjk.cpp -o wrong_gjk && gjkstep-study judge -- ./wrong_gjk
#include <algorithm>

#include "judge_main.hpp"

using V = std::array<double, 3>;
using Simplex = std::vector<V>;  // the newest vertex, A, last
static V operator-(V p, V q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }
static V operator-(V p) { return V{0, 0, 0} - p; }
static double dot(V p, V q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
static V cross(V p, V q) { return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]}; }

static V support(const judge::Points& points, V d) {
  return *std::max_element(points.begin(), points.end(), [&](V p, V q) { return dot(p, d) < dot(q, d); });
}
static V from_edge(Simplex& s, V A, V X) {
  const V AX = X - A, AO = -A;
  if (dot(AX, AO) <= 0) return s = {A}, AO;
  return s = {X, A}, cross(cross(AX, AO), AX);
}
static V from_triangle(Simplex& s, V A, V B, V C) {
  const V AB = B - A, AC = C - A, AO = -A, n = cross(AB, AC);
  if (dot(cross(n, AC), AO) > 0) return from_edge(s, A, dot(AC, AO) > 0 ? C : B);
  if (dot(cross(AB, n), AO) > 0) return from_edge(s, A, B);
  if (dot(n, AO) < 0) return s = {C, B, A}, -n;
  return s = {C, B, A}, dot(n, AO) > 0 ? n : V{0, 0, 0};
}
static V toward_origin(Simplex& s) {  // zero where it is found
  const V A = s.back(), AO = -A;
  if (s.size() == 1) return AO;
  if (s.size() == 2) return from_edge(s, A, s[0]);
  if (s.size() == 3) return from_triangle(s, A, s[1], s[0]);
  const V B = s[2], C = s[1], D = s[0];
  if (dot(cross(B - A, C - A), AO) > 0) return from_triangle(s, A, B, C);
  if (dot(cross(C - A, D - A), AO) > 0) return from_triangle(s, A, C, D);
  if (dot(cross(D - A, B - A), AO) > 0) return from_triangle(s, A, D, B);
  return {0, 0, 0};
}
bool collide(const judge::Points& a, const judge::Points& b) {
  Simplex s;
  V d = {1, 0, 0};
  for (int i = 0; i < 50; ++i) {
    const V searched = d, w = support(a, d) - support(b, -d);
    if (!s.empty() && dot(w, d) < 0) return false;
    s.push_back(w);
    d = toward_origin(s);
    judge::step(searched, s);
    if (dot(d, d) == 0) return true;
  }
  return false;
}
