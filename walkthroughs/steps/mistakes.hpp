/// Every mistake with its name, and how to ask it about a pair.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/gjk.hpp"
#include "walkthroughs/rooms.hpp"

namespace walkthroughs::steps {

/// How one run ended, and what is needed to see whether two runs went the same way.
struct Run {
  gjk::Status status = gjk::Status::undecided;
  int iterations = 0;
  int vertices = 0;       ///< of its last simplex
  std::uint64_t way = 0;  ///< a hash of all directions in which the first set was asked, in their order
};

/// What Algorithms 2-5 make of a simplex.
struct Processed {
  bool contains_origin = false;
  gjk::Simplex<double> kept;
  gjk::Vec3<double> direction = {0, 0, 0};  ///< of the next search
};

/// One line of the table: an implementation of the report with one mistake in it.
struct Mistake {
  std::string name;     ///< "the order is not changed when moving below the triangle"
  std::string section;  ///< of the report, where it says how it is done
  Run (*ask_from)(const gjk::Vec3<double>& first_direction, const gjk::PointSet<double>& a,
                  const gjk::PointSet<double>& b);
  Processed (*process)(gjk::Simplex<double> simplex);

  Run ask(const gjk::PointSet<double>& a, const gjk::PointSet<double>& b) const;
};

/// Where searches begin unless somebody says otherwise.
inline const gjk::Vec3<double> usual_first_direction = gjk::Options<double>{}.first_direction;

/// Returns: the report's algorithm, without a mistake.
Run ask_faithfully(const gjk::PointSet<double>& a, const gjk::PointSet<double>& b,
                   const gjk::Vec3<double>& first_direction = usual_first_direction);

/// Returns: all of them, in the report's order.
const std::vector<Mistake>& mistakes();

}  // namespace walkthroughs::steps
