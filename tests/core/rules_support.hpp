/// Asks one of Algorithms 2-5 about one simplex, and puts what it told into words that a test can compare.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "tests/core/oracle.hpp"
#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {

template <class S>
struct Told {
  std::string skipped;     ///< "B R4, BC R5, C R6, A R2"
  std::string decided;     ///< "AB R3: no, AC R7: yes"
  std::string next;        ///< the next simplex, oldest first, in the roles of the one given: "CAB"; empty at the end
  std::string expression;  ///< of the next direction
  std::optional<Vec3<S>> direction;  ///< empty where the simplex contains the origin
  std::vector<RegionTested<S>> regions;

  const RegionTested<S>& region(const std::string& feature, const std::string& face = "") const {
    for (const auto& r : regions)
      if (r.feature == feature && r.face == face) return r;
    throw std::logic_error("no word of " + feature);
  }
};

/// Vertices of the difference that remember their place in `oldest_first` through their index.
template <class S>
Simplex<S> simplex_of(const std::vector<Vec3<S>>& oldest_first) {
  Simplex<S> simplex;
  int i = 0;
  for (const Vec3<S>& w : oldest_first) simplex.add({SupportPoint<S>(w, i++), SupportPoint<S>(Vec3<S>::Zero()), w});
  return simplex;
}

template <class S>
std::string roles(const Simplex<S>& simplex, int size_before) {
  std::string letters;
  for (int i = 0; i < simplex.size(); ++i) letters += "ABCD"[size_before - 1 - *simplex[i].a.index];
  return letters;
}

inline void append(std::string& list, const std::string& item) { list += (list.empty() ? "" : ", ") + item; }

template <class S>
bool value_stands_in_relation(const RegionTested<S>& region) {
  const auto holds = [&](bool negative, bool zero) {
    switch (region.relation) {
      case Relation::positive: return !negative && !zero;
      case Relation::negative: return negative;
      case Relation::zero: return zero;
      case Relation::not_zero: return !zero;
      case Relation::not_negative: return !negative;
    }
    return false;
  };
  if (const S* s = std::get_if<S>(&region.value)) return holds(*s < S(0), *s == S(0));
  return holds(false, std::get<Vec3<S>>(region.value) == Vec3<S>(Vec3<S>::Zero()));
}

/// A verdict must follow from the value told; the value from the normal told.
template <class S>
void require_consistent(const RegionTested<S>& region, const Simplex<S>& simplex) {
  INFO("region " << region.feature << " " << region.label << " " << region.face);
  REQUIRE(region.simplex_size == simplex.size());
  REQUIRE_FALSE(region.reason.empty());
  const bool has_value = region.value.index() != 0;
  REQUIRE(has_value == !region.expression.empty());
  REQUIRE(region.normal.has_value() == !region.formula.empty());
  if (region.verdict == Verdict::skipped) REQUIRE_FALSE(has_value);
  if (has_value) REQUIRE(value_stands_in_relation(region) == (region.verdict == Verdict::chosen));
  if (region.normal) REQUIRE(std::get<S>(region.value) == -region.normal->dot(simplex.point(Role::A)));
}

/// Returns: empty where the simplex contains the origin.
template <class S>
std::optional<Vec3<S>> direction_of(const Next<S>& next) {
  return next.contains_origin() ? std::nullopt : std::optional(next.direction());
}

/// What holds for every simplex: nothing is told twice, the step is what was told, and telling does not change it.
template <class S>
void require_consistent(const std::vector<Event<S>>& events, const Simplex<S>& simplex, const Simplex<S>& kept,
                        const std::optional<Vec3<S>>& next) {
  std::set<std::tuple<std::string, std::string, std::string>> told;
  std::string order;
  for (const Event<S>& event : events) {
    if (const auto* region = std::get_if<RegionTested<S>>(&event)) {
      order += 'r';
      REQUIRE(told.insert({region->feature, region->label, region->face}).second);
      require_consistent(*region, simplex);
    } else if (const auto* reduced = std::get_if<SimplexReduced<S>>(&event)) {
      order += 's';
      REQUIRE(same_simplex(reduced->before, simplex));
      REQUIRE(same_simplex(reduced->after, kept));
      REQUIRE(reduced->kept == roles(kept, simplex.size()));
      REQUIRE_FALSE(reduced->why.empty());
      std::string all = reduced->kept + reduced->dropped;
      std::sort(all.begin(), all.end());
      REQUIRE(all == std::string("ABCD").substr(0, static_cast<std::size_t>(simplex.size())));
    } else {
      order += 'd';
      REQUIRE(std::get<DirectionChosen<S>>(event).direction == next);
    }
  }
  const bool changed = !same_simplex(simplex, kept);
  REQUIRE(order.substr(order.find_last_of('r') + 1) == (!next ? "" : changed ? "sd" : "d"));
  REQUIRE(order.find_first_not_of('r') == (next ? order.find_last_of('r') + 1 : std::string::npos));

  Simplex<S> plain = simplex;
  REQUIRE(direction_of(process<AsIntended>(plain)) == next);
  REQUIRE(same_simplex(plain, kept));
}

/// Runs the algorithm for this size of simplex, the last point being A.
template <class S>
Told<S> ask_rules(const std::vector<Vec3<S>>& oldest_first) {
  const Simplex<S> simplex = simplex_of(oldest_first);
  Trace<S> trace;
  Simplex<S> kept = simplex;
  const std::optional<Vec3<S>> next = direction_of(process<AsIntended>(kept, CrossingTest::on, trace));
  require_consistent(trace.events, simplex, kept, next);

  Told<S> told;
  told.direction = next;
  if (next) told.next = roles(kept, simplex.size());
  told.regions = events_of_kind<RegionTested<S>>(trace.events);
  for (const auto& r : told.regions) {
    const std::string name =
        r.feature + (r.label.empty() ? "" : " " + r.label) + (r.face.empty() ? "" : " of " + r.face);
    if (r.verdict == Verdict::skipped) append(told.skipped, name);
    if (r.verdict == Verdict::chosen) append(told.decided, name + ": yes");
    if (r.verdict == Verdict::rejected) append(told.decided, name + ": no");
  }
  for (const auto& d : events_of_kind<DirectionChosen<S>>(trace.events)) told.expression = d.expression;
  return told;
}

/// The vertices of `oldest_first` that play the roles in `letters`.
template <class S>
ExactVecs vertices_in_roles(const std::vector<Vec3<S>>& oldest_first, const std::string& letters) {
  ExactVecs vertices;
  for (const char c : letters) vertices.push_back(exact(oldest_first[oldest_first.size() - 1 - std::size_t(c - 'A')]));
  return vertices;
}

/// The search goes on straight from the feature that is kept toward the origin, whatever formula the report has for it.
template <class S>
void require_search_from_kept_feature_to_origin(const Told<S>& told, const std::vector<Vec3<S>>& oldest_first) {
  REQUIRE(told.direction.has_value());
  const ExactVec expected = toward_origin(vertices_in_roles(oldest_first, told.next));
  REQUIRE(same_direction(exact(*told.direction), expected, allowed_sine<S>()));
}

/// Points relative to an origin, as they look in a frame.
template <class S>
std::vector<Vec3<S>> seen_from(const Point& origin, const Points& points, const Frame<S>& frame) {
  return seen(moved(points, {-origin[0], -origin[1], -origin[2]}), frame);
}

/// What a rule must tell and do where the origin lies in a region.
struct Outcome {
  std::string decided, next, expression;
};

template <class S>
Told<S> require_outcome(const Outcome& expected, const std::string& skipped, const std::vector<Vec3<S>>& simplex) {
  const auto told = ask_rules(simplex);
  REQUIRE(told.skipped == skipped);
  REQUIRE(told.decided == expected.decided);
  REQUIRE(told.next == expected.next);
  REQUIRE(told.expression == expected.expression);
  REQUIRE(told.direction.has_value() == !expected.next.empty());
  if (told.direction) require_search_from_kept_feature_to_origin(told, simplex);
  return told;
}

/// `points`: the simplex, oldest first.
template <class S>
void require_outcome_at(const Point& origin, const Points& points, const std::string& skipped, const Outcome& expected,
                        const std::vector<Frame<S>>& frames) {
  for (const auto& frame : frames) {
    INFO(frame.name << ", origin at " << origin[0] << " " << origin[1] << " " << origin[2]);
    require_outcome(expected, skipped, seen_from(origin, points, frame));
  }
}

}  // namespace gjk::test
