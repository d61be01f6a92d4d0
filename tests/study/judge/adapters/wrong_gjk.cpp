// A short GJK with one mistake in it, to be found by tests/study/judge/README.md:
//
//     c++ wrong_gjk.cpp -o wrong_gjk && gjkstep-study judge -- ./wrong_gjk
#include <algorithm>

#include "judge_main.hpp"

using V = std::array<double, 3>;
static V operator-(V p, V q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }
static V operator-(V p) { return {-p[0], -p[1], -p[2]}; }
static double dot(V p, V q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
static V cross(V p, V q) { return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]}; }
static bool is_zero(V p) { return dot(p, p) == 0; }

static V support(const judge::Points& points, V d) {
  return *std::max_element(points.begin(), points.end(), [&](V p, V q) { return dot(p, d) < dot(q, d); });
}

using Simplex = std::vector<V>;  // the newest vertex, A, last

static bool keep(Simplex& s, Simplex kept, V& d, V direction) {
  s = std::move(kept);
  d = direction;
  return is_zero(d);  // the origin lies on what is kept
}

static bool from_edge(Simplex& s, V A, V X, V& d) {
  const V AX = X - A, AO = -A;
  if (dot(AX, AO) > 0) return keep(s, {X, A}, d, cross(cross(AX, AO), AX));
  return keep(s, {A}, d, AO);
}

static bool from_triangle(Simplex& s, V A, V B, V C, V& d) {
  const V AB = B - A, AC = C - A, AO = -A, n = cross(AB, AC);
  if (dot(cross(n, AC), AO) > 0) return dot(AC, AO) > 0 ? from_edge(s, A, C, d) : from_edge(s, A, B, d);
  if (dot(cross(AB, n), AO) > 0) return from_edge(s, A, B, d);
  if (dot(n, AO) >= 0) return keep(s, {C, B, A}, d, dot(n, AO) > 0 ? n : V{0, 0, 0});
  return keep(s, {C, B, A}, d, -n);
}

static bool contains_origin(Simplex& s, V& d) {
  const V A = s.back();
  if (s.size() == 1) return keep(s, {A}, d, -A);
  if (s.size() == 2) return from_edge(s, A, s[0], d);
  if (s.size() == 3) return from_triangle(s, A, s[1], s[0], d);
  const V B = s[2], C = s[1], D = s[0], AO = -A;
  if (dot(cross(B - A, C - A), AO) > 0) return from_triangle(s, A, B, C, d);
  if (dot(cross(C - A, D - A), AO) > 0) return from_triangle(s, A, C, D, d);
  if (dot(cross(D - A, B - A), AO) > 0) return from_triangle(s, A, D, B, d);
  return true;
}

bool collide(const judge::Points& a, const judge::Points& b) {
  V d = {1, 0, 0};
  Simplex s;
  for (int i = 0; i < 50; ++i) {
    const V searched = d, w = support(a, d) - support(b, -d);
    if (!s.empty() && dot(w, d) < 0) return false;
    s.push_back(w);
    const bool found = contains_origin(s, d);
    judge::step(searched, s);
    if (found) return true;
  }
  return false;
}
