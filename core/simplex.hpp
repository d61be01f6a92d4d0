/// The simplex of GJK: one to four vertices of the Minkowski difference, in the report's order.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <initializer_list>

#include "shapes.hpp"

namespace gjk {

/// The report's letters. `A` is always the newest vertex, then `B`, `C` and `D` (Section 3.2).
enum class Role { A, B, C, D };

constexpr char letter(Role role) { return "ABCD"[static_cast<int>(role)]; }

/// Roles of one to four vertices, oldest first: {C, A, B}.
class Order {
 public:
  constexpr Order(std::initializer_list<Role> oldest_first) : size_(oldest_first.size()) {
    std::copy(oldest_first.begin(), oldest_first.end(), roles_.begin());
  }
  constexpr const Role* begin() const { return roles_.data(); }
  constexpr const Role* end() const { return begin() + size_; }

 private:
  std::array<Role, 4> roles_{};
  std::size_t size_;
};

/// Vertices in the report's order, oldest first: Simplex([C, B, A]) of the report is {C, B, A} here, A being newest.
///
/// Copies take what is there and no more. A search copies a few simplices in each iteration, most of them small, and in
/// floating point that is a good part of its time.
template <class S>
class Simplex {
 public:
  Simplex() {}
  Simplex(const Simplex& other) { *this = other; }
  Simplex& operator=(const Simplex& other) {
    if (this == &other) return *this;
    std::copy_n(other.vertices_.begin(), other.size_, vertices_.begin());
    size_ = other.size_;
    return *this;
  }

  int size() const { return size_; }

  /// Requires: 0 <= i < size(). Counted from the oldest.
  const Vertex<S>& operator[](int i) const {
    assert(0 <= i && i < size_);
    return vertices_[static_cast<std::size_t>(i)];
  }
  /// Requires: the simplex has a vertex of that role.
  const Vertex<S>& operator[](Role role) const { return (*this)[size_ - 1 - static_cast<int>(role)]; }
  /// Returns: the place of that vertex in the difference, the point that the report calls A, B, C or D.
  const Vec3<S>& point(Role role) const { return (*this)[role].w; }

  /// Returns: the vertices of these roles, in this order.
  Simplex only(const Order& order) const {
    Simplex kept;
    for (const Role role : order) kept.add((*this)[role]);
    return kept;
  }

  friend bool operator==(const Simplex& x, const Simplex& y) {
    return std::equal(x.vertices_.begin(), x.vertices_.begin() + x.size_, y.vertices_.begin(),
                      y.vertices_.begin() + y.size_);
  }

  /// Makes `vertex` the newest. Requires: size() < 4.
  void add(const Vertex<S>& vertex) {
    assert(size_ < 4);
    vertices_[static_cast<std::size_t>(size_++)] = vertex;
  }

 private:
  std::array<Vertex<S>, 4> vertices_;
  int size_ = 0;
};

}  // namespace gjk
