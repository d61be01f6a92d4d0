#include "tests/core/rules_support.hpp"

#include "core/event_words.hpp"
#include "tests/core/oracle.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace {

template <class S>
std::string roles(const Simplex<S>& simplex, int size_before) {
  std::string letters;
  for (int i = 0; i < simplex.size(); ++i) letters += "ABCD"[size_before - 1 - *simplex[i].a.index];
  return letters;
}

}  // namespace

template <class S>
Told<S> ask_rules(const std::vector<Vec3<S>>& oldest_first) {
  const Simplex<S> simplex = simplex_of(oldest_first);
  Simplex<S> kept = simplex;
  const auto [next, events] = step(kept);
  Told<S> told;
  told.direction = next;
  if (next) told.next = roles(kept, simplex.size());
  told.regions = events_of_kind<RegionTested<S>>(events);
  for (const auto& r : told.regions) {
    const std::string_view label = to_string(label_of(r));
    const std::string name = to_string(r.feature) + (label.empty() ? "" : " " + std::string(label)) +
                             (r.face.empty() ? "" : " of " + to_string(r.face));
    if (r.verdict == Verdict::skipped) append(told.skipped, name);
    if (r.verdict == Verdict::chosen) append(told.decided, name + ": yes");
    if (r.verdict == Verdict::rejected) append(told.decided, name + ": no");
  }
  for (const auto& d : events_of_kind<DirectionChosen<S>>(events)) told.expression = to_string(d.expression);
  return told;
}

namespace {

/// The vertices of `oldest_first` that play the roles in `letters`.
ExactVecs vertices_in_roles(const ExactVecs& oldest_first, const std::string& letters) {
  ExactVecs vertices;
  for (const char c : letters) vertices.push_back(oldest_first[oldest_first.size() - 1 - std::size_t(c - 'A')]);
  return vertices;
}

/// Of all scalars alike. `sine`: see same_direction().
void require_said(const Outcome& expected, const Outcome& said, const std::optional<ExactVec>& direction,
                  const ExactVecs& simplex, const Rational& sine) {
  REQUIRE(said.decided == expected.decided);
  REQUIRE(said.next == expected.next);
  REQUIRE(said.expression == expected.expression);
  REQUIRE(direction.has_value() == !expected.next.empty());
  if (direction) REQUIRE(same_direction(*direction, toward_origin(vertices_in_roles(simplex, said.next)), sine));
}

}  // namespace

template <class S>
Told<S> require_outcome(const Outcome& expected, const std::string& skipped, const std::vector<Vec3<S>>& simplex) {
  const auto told = ask_rules(simplex);
  REQUIRE(told.skipped == skipped);
  require_said(expected, {told.decided, told.next, told.expression},
               told.direction ? std::optional(exact(*told.direction)) : std::nullopt, exact(simplex),
               allowed_sine<S>());
  return told;
}

namespace {

template <class S>
void require_outcomes(const std::vector<OutcomeAt>& expected, const Points& points, const std::string& skipped,
                      In places) {
  for (const auto& frame : places == In::all_frames ? frames<S>() : frames_without_rounding<S>())
    for (const auto& [origin, outcome] : expected) {
      INFO(frame.name << ", " << sizeof(S) << " bytes, origin at " << origin[0] << " " << origin[1] << " "
                      << origin[2]);
      require_outcome(outcome, skipped, seen_from(origin, points, frame));
    }
}

}  // namespace

void require_outcomes(In places, const Points& points, const std::string& skipped,
                      const std::vector<OutcomeAt>& expected) {
  require_outcomes<float>(expected, points, skipped, places);
  require_outcomes<double>(expected, points, skipped, places);
  require_outcomes<long double>(expected, points, skipped, places);
  require_outcomes<Rational>(expected, points, skipped, places);
}

template Told<double> ask_rules(const std::vector<Vec3<double>>&);
template Told<Rational> ask_rules(const std::vector<Vec3<Rational>>&);
template Told<Rational> require_outcome(const Outcome&, const std::string&, const std::vector<Vec3<Rational>>&);

}  // namespace gjk::test
