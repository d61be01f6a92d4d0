// A GJK with one fault, which FAULT in the environment chooses: what a judge of collision tests must find.
//
//     c++ -O2 judge.cpp planted.cpp -o planted && FAULT=m14 gjkstep judge -- ./planted
//
// FAULT=none (also without FAULT) has none: the search begins along +x, and answers no after 50 iterations.
// m1 ... m21 are the mistakes that the report names, each alone. The other faults are common causes of wrong answers:
//     tolerance      what is below 1e-4 counts as zero, whatever the size of the shapes
//     contact        shapes that only touch are a miss
//     planar         z is ignored
//     limit          4 iterations, then no
//     nan            directions are normalized without a look for zero
//     translation    an early-out forgets the centre of b: right only near the world's origin
//     order_ab       only the first 4 points of b are looked at
//     order_points   the last point of each shape is never looked at
//     floats         all arithmetic is in float
//     depth          only bounding boxes are compared
//     stale          beyond an edge the direction is not changed
//     untold         none, but the first point is not told
//     hollow         a set inside the other is a miss; "hollow,m14" is m14 of such a program
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Points = std::vector<std::array<double, 3>>;

void judge_step(const std::array<double, 3>& searched_along, const Points& simplex);

static bool is_hollow = false, is_faithful_for_now = false;

static std::string fault_asked_for() {
  static const char* const others[] = {"none",     "tolerance",    "contact", "planar", "limit", "nan",   "translation",
                                       "order_ab", "order_points", "floats",  "depth",  "stale", "untold"};
  const char* const asked = std::getenv("FAULT");
  std::string fault = asked == nullptr ? "none" : asked;
  is_hollow = fault.rfind("hollow", 0) == 0;
  if (is_hollow) fault = fault == "hollow" ? "none" : fault.substr(7);
  for (const char* other : others)
    if (fault == other) return fault;
  for (int i = 1; i <= 21; ++i)
    if (fault == "m" + std::to_string(i)) return fault;
  std::cerr << "planted.cpp: there is no FAULT=" << fault << "\n";
  std::exit(2);
}

static bool has(const char* fault) {
  static const std::string planted = fault_asked_for();
  return planted == fault && !is_faithful_for_now;
}

template <class T>
struct Vec3 {
  T x, y, z;
  Vec3 operator-() const { return {-x, -y, -z}; }
  Vec3 operator-(const Vec3& v) const { return {x - v.x, y - v.y, z - v.z}; }
};
template <class T>
T dot(const Vec3<T>& u, const Vec3<T>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}
template <class T>
Vec3<T> cross(const Vec3<T>& u, const Vec3<T>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

template <class T>
bool is_positive(T x) {
  return x > (has("tolerance") ? T(1e-4) : T(0));
}
template <class T>
bool is_zero(T x) {
  return has("tolerance") ? std::abs(x) <= T(1e-4) : x == 0;
}
template <class T>
bool is_zero(const Vec3<T>& v) {
  return is_zero(v.x) && is_zero(v.y) && is_zero(v.z);
}

template <class T>
struct Simplex {
  Vec3<T> p[4];  // the newest first
  int n;
  void push_front(const Vec3<T>& v) {
    for (int i = n++; i > 0; --i) p[i] = p[i - 1];
    p[0] = v;
  }
  void set(const Vec3<T>& u, const Vec3<T>& v) { p[0] = u, p[1] = v, n = 2; }
  void set(const Vec3<T>& u, const Vec3<T>& v, const Vec3<T>& w) { p[0] = u, p[1] = v, p[2] = w, n = 3; }
};

template <class T>
class Gjk {
 public:
  Gjk(const Points& a, const Points& b) : a_(a), b_(b), s_(), d_{1, 0, 0} {}

  bool intersect() {
    for (int left = has("limit") ? 4 : 50; left > 0; --left) {
      if (d_.x == 0 && d_.y == 0 && d_.z == 0) return false;
      const Vec3<T> searched_along = d_, w = support(d_);
      const bool missed = (s_.n > 0 || has("m2")) && is_before_origin(dot(w, d_));
      if (missed && !has("m4")) return false;
      s_.push_front(w);
      const bool contains = contains_origin();
      if (s_.n > 1 || !has("untold")) tell_step(searched_along);
      if (contains) return !has("contact") || overlap();
      if (missed) return false;
    }
    return false;
  }

 private:
  void tell_step(const Vec3<T>& searched_along) const {
    const auto as_doubles = [](const Vec3<T>& v) {
      return std::array<double, 3>{double(v.x), double(v.y), double(v.z)};
    };
    Points simplex;
    for (int i = s_.n; i-- > 0;) simplex.push_back(as_doubles(s_.p[i]));
    judge_step(as_doubles(searched_along), simplex);
  }

  static Vec3<T> farthest(const Points& points, std::size_t n, const Vec3<T>& d) {
    if (has("order_points") && n > 1) --n;
    Vec3<T> best{};
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3<T> p{T(points[i][0]), T(points[i][1]), has("planar") ? T(0) : T(points[i][2])};
      if (i == 0 || dot(p, d) > dot(best, d)) best = p;
    }
    return best;
  }

  Vec3<T> support(const Vec3<T>& d) const {
    const std::size_t nb = has("order_ab") ? std::min<std::size_t>(b_.size(), 4) : b_.size();
    return farthest(a_, a_.size(), d) - farthest(b_, nb, has("m1") ? d : -d);
  }

  static bool is_before_origin(T w_d) {
    if (has("m3") || has("contact")) return w_d <= 0;
    if (has("tolerance")) return w_d < T(-1e-4);
    return has("nan") ? !(w_d >= 0) : w_d < 0;
  }

  void search_along(const Vec3<T>& d) {
    const T length = has("nan") ? std::sqrt(dot(d, d)) : T(1);
    d_ = {d.x / length, d.y / length, d.z / length};
  }

  void search_from_edge(const Vec3<T>& A, const Vec3<T>& X, const Vec3<T>& AXn) {
    s_.set(A, X);
    if (has("stale")) return;
    search_along(has("m7") ? -A : has("m11") ? AXn : cross(cross(X - A, -A), X - A));
  }

  /// Says whether the simplex holds the origin. Else reduces it, and chooses where to search next.
  bool contains_origin() {
    const Vec3<T> A = s_.p[0], B = s_.p[1], C = s_.p[2], D = s_.p[3], AO = -A, AB = B - A, AC = C - A, AD = D - A;
    switch (s_.n) {
      case 1: search_along(AO); return !has("m5") && is_zero(d_);
      case 2: search_along(has("m7") ? AO : cross(cross(AB, AO), AB)); return !has("m6") && is_zero(d_);
      case 3: {
        const Vec3<T> n = has("m8") ? cross(AC, AB) : cross(AB, AC);
        const Vec3<T> ABn = has("m9") ? cross(n, AB) : cross(AB, n);
        const Vec3<T> ACn = has("m10") ? cross(AC, n) : cross(n, AC);
        const T height = dot(n, AO);
        if (is_positive(dot(ABn, AO))) {
          search_from_edge(A, B, ABn);
        } else if (is_positive(dot(ACn, AO))) {
          search_from_edge(A, C, ACn);
        } else if (has("m12") || (is_zero(height) && !has("m13"))) {
          return true;
        } else if (height > 0) {
          search_along(n);
        } else {
          if (!has("m14")) s_.set(B, A, C);
          search_along(-n);
        }
        return false;
      }
      default: {
        const Vec3<T> P[3] = {B, C, D}, Q[3] = {C, D, B};
        const Vec3<T> n[3] = {has("m15") ? cross(AC, AB) : cross(AB, AC), has("m16") ? cross(AD, AC) : cross(AC, AD),
                              has("m17") ? cross(AB, AD) : cross(AD, AB)};
        for (int i = 0; i < 3; ++i) {
          const T height = dot(n[i], AO);
          if (!is_positive(height) && !(has("m21") && height == 0)) continue;
          const Vec3<T> AP = P[i] - A, AQ = Q[i] - A;
          const Vec3<T> APn = has("m18") && i > 0 ? cross(n[i - 1], AP) : cross(AP, n[i]);
          const Vec3<T> AQn = has("m19") && i == 2 ? cross(AQ, n[0]) : cross(n[i], AQ);
          if (is_positive(dot(AQn, AO))) {
            search_from_edge(A, Q[i], AQn);
          } else if (is_positive(dot(APn, AO))) {
            search_from_edge(A, P[i], APn);
          } else {
            has("m20") && i == 2 ? s_.set(A, Q[i], P[i]) : s_.set(A, P[i], Q[i]);
            search_along(n[i]);
          }
          return false;
        }
        return true;
      }
    }
  }

  /// For FAULT=contact: no plane through the origin that is looked at has all of the difference on one side.
  bool overlap() const {
    for (int i = 0; i < s_.n; ++i)
      for (int j = 0; j < s_.n; ++j)
        for (int k = 0; k < s_.n; ++k)
          if (is_touched(cross(s_.p[j] - s_.p[i], s_.p[k] - s_.p[i]))) return false;
    for (int i = 0; i < 27; ++i)
      if (is_touched({T(i % 3 - 1), T(i / 3 % 3 - 1), T(i / 9 - 1)})) return false;
    return true;
  }
  bool is_touched(const Vec3<T>& d) const { return !(d.x == 0 && d.y == 0 && d.z == 0) && dot(support(d), d) <= 0; }

  const Points& a_;
  const Points& b_;
  Simplex<T> s_;
  Vec3<T> d_;
};

static double lowest(const Points& points, int axis) {
  double least = points[0][axis];
  for (const auto& p : points) least = std::min(least, p[axis]);
  return least;
}
static double highest(const Points& points, int axis) {
  double most = points[0][axis];
  for (const auto& p : points) most = std::max(most, p[axis]);
  return most;
}

static bool boxes_overlap(const Points& a, const Points& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (lowest(a, axis) > highest(b, axis) || lowest(b, axis) > highest(a, axis)) return false;
  return true;
}

/// For FAULT=translation: how far apart the boxes are along an axis is taken from a's centre, and b's is forgotten.
static bool is_far_away(const Points& a, const Points& b) {
  for (int axis = 0; axis < 3; ++axis) {
    const double sizes = highest(a, axis) - lowest(a, axis) + highest(b, axis) - lowest(b, axis);
    if (std::abs(highest(a, axis) + lowest(a, axis)) > 8 * sizes + 8) return true;
  }
  return false;
}

/// For FAULT=hollow: all points of a, and some to each side of these, are in b.
static bool lies_inside(const Points& a, const Points& b) {
  for (const auto& p : a)
    for (int axis = 0; axis < 3; ++axis)
      for (const double by : {1e-9, -1e-9}) {
        Points beside{p};
        beside[0][axis] += by * (1 + std::abs(p[axis]));
        if (!Gjk<double>(beside, b).intersect()) return false;
      }
  return true;
}

static bool one_is_inside(const Points& a, const Points& b) {
  is_faithful_for_now = true;
  const bool found = lies_inside(a, b) || lies_inside(b, a);
  is_faithful_for_now = false;
  return found;
}

bool collide(const Points& a, const Points& b) {
  if (has("depth")) return boxes_overlap(a, b);
  if (has("translation") && is_far_away(a, b)) return false;
  const bool meet = has("floats") ? Gjk<float>(a, b).intersect() : Gjk<double>(a, b).intersect();
  return meet && !(is_hollow && one_is_inside(a, b));
}
