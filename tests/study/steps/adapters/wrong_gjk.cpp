// A short GJK with one mistake in it, to be found by tests/study/steps/README.md: c++ wrong_gjk.cpp -o wrong_gjk
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
static V from_edge(Simplex& s, V A, V X) { return s = {X, A}, cross(cross(X - A, -A), X - A); }
static V from_triangle(Simplex& s, V A, V B, V C) {
  const V AB = B - A, AC = C - A, AO = -A, n = cross(AB, AC);
  if (dot(cross(n, AC), AO) > 0) return from_edge(s, A, C);
  if (dot(cross(AB, n), AO) > 0) return from_edge(s, A, B);
  if (dot(n, AO) < 0) return s = {C, B, A}, -n;
  return s = {C, B, A}, dot(n, AO) > 0 ? n : V{0, 0, 0};
}
static V toward_origin(Simplex& s) {  // zero where it is found
  const V A = s.back();
  if (s.size() < 3) return s.size() == 1 ? -A : from_edge(s, A, s[0]);
  if (s.size() == 3) return from_triangle(s, A, s[1], s[0]);
  for (const Simplex& face : {Simplex{s[2], s[1]}, Simplex{s[1], s[0]}, Simplex{s[0], s[2]}})
    if (dot(cross(face[0] - A, face[1] - A), -A) > 0) return from_triangle(s, A, face[0], face[1]);
  return {0, 0, 0};
}
bool collide(const judge::Points& a, const judge::Points& b) {
  Simplex s;
  V d = {1, 0, 0};
  for (int i = 0; i < 50 && dot(d, d) > 0; ++i) {
    const V searched = d, w = support(a, d) - support(b, -d);
    if (!s.empty() && dot(w, d) < 0) return false;
    s.push_back(w), d = toward_origin(s), judge::step(searched, s);
  }
  return dot(d, d) == 0;
}
