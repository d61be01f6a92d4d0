/// The simplex of GJK: one to four vertices of the Minkowski difference, in the report's order.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "shapes.hpp"

namespace gjk {

/// The report's letters. `A` is always the newest vertex, then `B`, `C` and `D` (Section 3.2).
enum class Role { A, B, C, D };

constexpr char letter(Role role) { return "ABCD"[static_cast<int>(role)]; }

constexpr std::optional<Role> role_named(char letter) {
  return letter < 'A' || letter > 'D' ? std::nullopt : std::optional(static_cast<Role>(letter - 'A'));
}

/// Up to four of something: a simplex has no more vertices.
template <class T>
class UpToFour {
 public:
  constexpr const T* begin() const { return all_.data(); }
  constexpr const T* end() const { return begin() + size_; }
  constexpr int size() const { return size_; }
  constexpr bool empty() const { return size_ == 0; }
  /// Requires: 0 <= i < size().
  constexpr const T& operator[](int i) const { return all_[static_cast<std::size_t>(i)]; }
  /// Requires: size() < 4.
  constexpr void add(const T& one) { all_[static_cast<std::size_t>(size_++)] = one; }
  constexpr bool operator==(const UpToFour& other) const {
    return std::equal(begin(), end(), other.begin(), other.end());
  }

 private:
  std::array<T, 4> all_{};
  int size_ = 0;
};

/// Roles of up to four vertices, each once. It is a feature as the report writes it, "ADB", or what is kept of a simplex,
/// oldest first, "CA". Written as that in code, too: event.feature == "ADB".
class Roles {
 public:
  constexpr Roles() = default;
  constexpr Roles(std::initializer_list<Role> roles) {
    for (const Role role : roles) add(role);
  }
  /// What names no roles does not compile.
  template <std::size_t length>
  consteval Roles(const char (&letters)[length]) : Roles(named(std::string_view(letters, length - 1)).value()) {}

  /// Returns: nothing where these are no roles.
  static constexpr std::optional<Roles> named(std::string_view letters) {
    Roles roles;
    for (const char each : letters) {
      const std::optional<Role> role = role_named(each);
      if (!role || roles.has(*role)) return std::nullopt;
      roles.add(*role);
    }
    return roles;
  }

  constexpr const Role* begin() const { return all_.begin(); }
  constexpr const Role* end() const { return all_.end(); }
  constexpr int size() const { return all_.size(); }
  constexpr bool empty() const { return all_.empty(); }
  constexpr const Role& operator[](int i) const { return all_[i]; }
  constexpr void add(Role role) { all_.add(role); }
  constexpr bool has(Role role) const { return std::find(begin(), end(), role) != end(); }
  constexpr bool operator==(const Roles&) const = default;

 private:
  UpToFour<Role> all_;  // no base class: with one, and a consteval constructor, Clang 16 fails
};

/// Returns: "ADB".
inline std::string to_string(const Roles& roles) {
  std::string letters;
  for (const Role role : roles) letters += letter(role);
  return letters;
}

/// Returns: the roles of a simplex of that size that are not among `kept`, oldest first.
constexpr Roles beside(const Roles& kept, int size) {
  Roles others;
  for (int i = size; i-- > 0;)
    if (const Role role = static_cast<Role>(i); !kept.has(role)) others.add(role);
  return others;
}

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
  /// From the oldest to the newest.
  const Vertex<S>* begin() const { return vertices_.data(); }
  const Vertex<S>* end() const { return begin() + size_; }

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
  Simplex only(const Roles& roles) const {
    Simplex kept;
    for (const Role role : roles) kept.add((*this)[role]);
    return kept;
  }

  friend bool operator==(const Simplex& x, const Simplex& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end());
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
