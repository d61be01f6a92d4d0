/// Does what a trace tells of proofs and of the second search agree with itself and with the points? Looked at in fractions; no
/// search is run.
///
///  C9.  A proof says what its numbers say, and these are those of what the first search has found.
///  C10. Every sign is that of the polynomial, which lies within its error; where 0 does, too, the fraction is told.
///  C11. The signs are those that the nearest feature is found by, in their order; what is kept and the direction follow.
///  C12. The next vertex reaches across the origin; the search ends where none does, or where the origin is in what is kept.
///  C13. The certificate holds, multiplied out.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "walkthroughs/model/event_fields.hpp"
#include "walkthroughs/model/scene.hpp"

namespace walkthroughs {

/// The events of one scene that follow those of its first search, given one by one.
class CertifiedCheck {
 public:
  /// `scene` must outlive the check. `found`: the places that its first search found. Requires: that it is certified.
  CertifiedCheck(const Scene& scene, const gjk::Result<double>& guess, std::vector<Point> found);
  ~CertifiedCheck();

  /// Errors: Contradiction, about the first thing that is wrong with this event. Requires: an expected kind.
  void operator()(const gjk::Event<double>& event);

  /// Returns: the kinds of event of which one must come next; none at the end.
  const std::vector<std::size_t>& expected() const;
  /// Returns: the iteration that the next event of that kind must have.
  int iteration_of_next(std::size_t kind) const;

 private:
  class Course;
  std::unique_ptr<Course> course_;
};

}  // namespace walkthroughs
