/// Follows a run from its events alone, without shapes and without the algorithm, and examines whether they fit together.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/core/support.hpp"

namespace gjk::test {

/// Works out the texts of events, such as "AB×AO×AB", "−ABCn" and "ABn·AO", by the rules at the top of events.hpp.
template <class S>
class Letters {
 public:
  explicit Letters(const Simplex<S>& simplex) : simplex_(simplex) {}

  /// A normal of an edge means something only beside its formula.
  void name(const std::string& normal, const Vec3<S>& value) { normals_[normal] = value; }

  S number(const std::string& text) const {
    const std::size_t dot = text.find("·");
    return vector(text.substr(0, dot)).dot(vector(text.substr(dot + std::string("·").size())));
  }

  Vec3<S> vector(const std::string& text) const {
    const std::string minus = "−", cross = "×";
    if (text.starts_with(minus)) return -vector(text.substr(minus.size()));
    const std::size_t last = text.rfind(cross);
    if (last == std::string::npos) return factor(text);
    return vector(text.substr(0, last)).cross(factor(text.substr(last + cross.size())));
  }

 private:
  Vec3<S> point(char c) const {
    return c == 'O' ? Vec3<S>(Vec3<S>::Zero()) : simplex_.point(static_cast<Role>(c - 'A'));
  }
  Vec3<S> edge(char from, char to) const { return point(to) - point(from); }

  Vec3<S> factor(const std::string& text) const {
    if (const auto normal = normals_.find(text); normal != normals_.end()) return normal->second;
    if (text.size() == 4 && text[3] == 'n') return edge(text[0], text[1]).cross(edge(text[0], text[2]));  // Eqs. 10, 14
    if (text.size() == 2) return edge(text[0], text[1]);
    throw std::logic_error("no vector is called " + text);
  }

  Simplex<S> simplex_;
  std::map<std::string, Vec3<S>> normals_;
};

/// One event after the other. Knows nothing but the events; keeps what a reader would have to keep. Throws where an
/// event does not fit, so that a test can also ask for that.
template <class S>
class Replay {
 public:
  void operator()(const SearchStarted<S>& e) {
    follows(e, "", 'S');
    direction_ = e.direction;
  }

  void operator()(const SupportFound<S>& e) {
    ++iteration_;
    states_.emplace_back(direction_, simplex_);
    follows(e, "SD", 'V');
    must(e.direction == direction_, "the support function is asked in the direction chosen");
    must(e.vertex.w == Vec3<S>(e.vertex.a.point - e.vertex.b.point), "w = a - b");
    must(e.is_new == (std::find(seen_.begin(), seen_.end(), e.vertex.w) == seen_.end()),
         "is_new tells of earlier places");
    seen_.push_back(e.vertex.w);
    vertex_ = e.vertex;
  }

  void operator()(const CrossingTested<S>& e) {
    follows(e, "V", 'C');
    const bool applied = e.verdict == Crossing::crossed || e.verdict == Crossing::not_crossed;
    must(e.value.has_value() == applied, "a value exactly where the test was applied");
    must(!applied || *e.value == vertex_.w.dot(direction_), "the value is w·d");
    must(!applied || (*e.value < S(0)) == (e.verdict == Crossing::not_crossed), "not crossed exactly where w·d < 0");
    must((e.verdict == Crossing::first_point) == (iteration_ == 1 && e.verdict != Crossing::switched_off),
         "the first point, and only it, is not tested");
    verdict_ = e.verdict;
  }

  void operator()(const VertexAdded<S>& e) {
    follows(e, "C", 'A');
    must(verdict_ != Crossing::not_crossed, "the search ends where the origin was not crossed");
    simplex_.add(vertex_);
    must(e.simplex == simplex_, "the vertex found is added as the newest");
    regions_.clear();
  }

  void operator()(const RegionTested<S>& e) {
    follows(e, "AR", 'R');
    must(e.simplex_size == simplex_.size(), "the region belongs to this simplex");
    must(regions_.insert({to_string(e.feature), label_of(e), to_string(e.face)}).second, "a region is told once");
    must((e.value.index() != 0) == !e.expression.empty() && e.normal.has_value() == !e.formula.empty(),
         "what is computed has its text");
    must((e.value.index() == 0) == (e.verdict == Verdict::skipped) || e.feature == "ABCD",
         "what is skipped has no value");
    if (e.value.index() != 0)
      must(stands_in_relation(e) == (e.verdict == Verdict::chosen), "the value fits the verdict");
    Letters<S> letters(simplex_);
    if (e.normal) {
      must(*e.normal == letters.vector(to_string(e.formula)), "the normal is its formula's value");
      letters.name(to_string(e.expression.X), *e.normal);
    }
    if (const S* value = std::get_if<S>(&e.value))
      must(*value == letters.number(to_string(e.expression)), "the value is its expression's");
    if (const auto* value = std::get_if<Vec3<S>>(&e.value))
      must(*value == letters.vector(to_string(e.expression)), "the value is its expression's");
    contains_origin_ = e.verdict == Verdict::chosen && (e.relation == Relation::zero || e.feature == "ABCD");
  }

  void operator()(const SimplexReduced<S>& e) {
    follows(e, "R", 'X');
    must(e.before == simplex_, "the simplex before is the one of the last event");
    kept_from_ = simplex_;
    simplex_ = {};
    for (const Role role : e.kept) simplex_.add(kept_from_[role]);
    must(e.after == simplex_, "the simplex after has the vertices kept, in their order");
    must(!(e.after == e.before), "a reduction changes something");
  }

  void operator()(const DirectionChosen<S>& e) {
    const Simplex<S>& tested = last() == 'X' ? kept_from_ : simplex_;
    follows(e, "RX", 'D');
    must(!contains_origin_, "no direction is chosen where the origin was found");
    must(e.direction == Letters<S>(tested).vector(to_string(e.expression)), "the direction is its expression's value");
    direction_ = e.direction;
  }

  void operator()(const auto&) {}  // of certified_collision()
  void operator()(const Finished<S>& e) {
    // Without the crossing test the rules may take a simplex on the near side for one that contains the origin; the run
    // ends there all the same, but separated.
    const bool near_side = contains_origin_ && verdict_ == Crossing::switched_off && vertex_.w.dot(direction_) < S(0);
    const bool not_crossed = near_side || (last() == 'C' && verdict_ == Crossing::not_crossed);
    follows(e, "SCDR", 'F');
    must(e.result.iterations == iteration_, "the iterations are counted");
    must(e.result.simplex == simplex_, "the last simplex is the result's");
    must((e.result.status == Status::intersecting) == (contains_origin_ && !near_side),
         "intersecting exactly where the origin was found");
    must((e.result.reason == Reason::origin_not_crossed) == not_crossed, "Eq. 9 is the reason exactly where it failed");
    must(e.result.separation.has_value() == (e.result.status == Status::separated), "separated with proof");
    must(e.result.cycle_start.has_value() == (e.result.reason == Reason::cycle), "a cycle begins somewhere");
    if (e.result.cycle_start) {
      const auto& [direction, simplex] = states_.at(static_cast<std::size_t>(*e.result.cycle_start) - 1);
      must(direction == direction_ && simplex == simplex_, "the next iteration would begin as the one told did");
    }
    must(!e.result.separation || (e.result.separation->direction == direction_ &&
                                  e.result.separation->support_value == vertex_.w.dot(direction_)),
         "the proof is the last direction and its w·d");
  }

  /// Returns: the kinds of events so far, one letter each.
  const std::string& kinds() const { return kinds_; }

 private:
  static bool stands_in_relation(const RegionTested<S>& e) {
    const S* const number = std::get_if<S>(&e.value);
    const bool negative = number && *number < S(0);
    const bool zero = number ? *number == S(0) : is_zero(std::get<Vec3<S>>(e.value));
    switch (e.relation) {
      case Relation::positive: return !negative && !zero;
      case Relation::negative: return negative;
      case Relation::zero: return zero;
      case Relation::not_zero: return !zero;
      case Relation::not_negative: return !negative;
    }
    return false;
  }
  char last() const { return kinds_.empty() ? ' ' : kinds_.back(); }
  void must(bool holds, const std::string& what) const {
    if (!holds) throw std::logic_error("after the events " + kinds_ + ": " + what);
  }
  template <class E>
  void follows(const E& e, const std::string& predecessors, char kind) {
    must(predecessors.empty() ? kinds_.empty() : predecessors.find(last()) != std::string::npos,
         std::string("an event ") + kind + " comes at the wrong place");
    must(e.iteration == iteration_, "the iteration is counted");
    kinds_ += kind;
  }

  std::string kinds_;
  int iteration_ = 0;
  Vec3<S> direction_ = Vec3<S>::Zero();
  Vertex<S> vertex_;
  Simplex<S> simplex_, kept_from_;
  std::vector<Vec3<S>> seen_;
  std::set<std::tuple<std::string, RegionLabel, std::string>> regions_;  // of the simplex that is processed
  std::vector<std::pair<Vec3<S>, Simplex<S>>> states_;                   // with which each iteration began
  Crossing verdict_ = Crossing::crossed;
  bool contains_origin_ = false;
};

/// Throws where the events of a run are incomplete or do not fit together. Returns: their kinds, one letter each.
template <class S>
std::string replayed(const std::vector<Event<S>>& events) {
  Replay<S> replay;
  for (const Event<S>& event : events) std::visit(replay, event);
  if (!replay.kinds().ends_with('F')) throw std::logic_error("the end is not told: " + replay.kinds());
  return replay.kinds();
}

}  // namespace gjk::test
