/// A pair that a program is asked about, with the truth; and all of them, one after the other.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "walkthroughs/pairs/family.hpp"
#include "walkthroughs/pairs/named_pair.hpp"

namespace walkthroughs::judge {

struct Case {
  std::string name, family;
  PointPair pair;
  gjk::Status truth = gjk::Status::undecided;  ///< separated or intersecting

  bool meet() const { return truth == gjk::Status::intersecting; }
};

/// Returns: the certified answer. Its certificate is multiplied out in fractions. Errors: std::logic_error where it does not hold.
gjk::Status truth_of(const PointPair& pair);

enum class Numbers { doubles, floats };

/// What a program is expected to be able to do.
struct Expected {
  Numbers numbers = Numbers::doubles;  ///< floats: every pair is rounded to floats first
  bool in_plane = false;               ///< every z becomes 0
};

/// Returns: the pair as that program gets it; nothing where a number leaves the range of floats, or where it is not of points.
std::optional<PointPair> as_expected(const Pair& pair, const Expected& expected);

/// Cases one after the other, each made when it is asked for.
class Cases {
 public:
  using Next = std::function<std::optional<NamedPair>()>;

  Cases(Next next, std::uint64_t most, const Expected& expected)
      : next_(std::move(next)), most_(most), expected_(expected) {}

  /// At most so many; at the end none. Errors: those of truth_of().
  std::vector<Case> next(std::size_t count);
  std::uint64_t most() const { return most_; }                ///< that may come; 0 where nobody knows
  std::uint64_t passed_over() const { return passed_over_; }  ///< of which floats have no room for

 private:
  Next next_;
  std::uint64_t most_, passed_over_ = 0;
  Expected expected_;
};

/// Those listed, then of each family so many; none that was listed comes again.
Cases cases_of(std::vector<NamedPair> listed, std::vector<const Family*> families, std::uint64_t of_each,
               std::uint64_t seed, const Expected& expected);

}  // namespace walkthroughs::judge
