#include "walkthroughs/steps/right_outcomes.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <string_view>
#include <utility>

#include "core/certified/fraction.hpp"
#include "core/complete.hpp"
#include "core/gjk.hpp"
#include "walkthroughs/model/number_text.hpp"

namespace walkthroughs::steps {
namespace {

constexpr double flat = 1e-12;  // BC×BD·BA, of edges whose largest coordinate is 1

template <class S>
gjk::Simplex<S> simplex_in(const Vertices& vertices, const Indices& order) {
  gjk::Simplex<S> simplex;
  for (const int i : order) {
    const Vec& w = vertices[static_cast<std::size_t>(i)];
    gjk::Vertex<S> vertex;
    vertex.w = gjk::Vec3<S>(S(w[0]), S(w[1]), S(w[2]));
    vertex.a = {vertex.w, i};
    vertex.b.point = gjk::Vec3<S>(S(0), S(0), S(0));
    simplex.add(vertex);
  }
  return simplex;
}

template <class S>
Indices indices_in(const gjk::Simplex<S>& simplex) {
  Indices indices;
  for (int i = 0; i < simplex.size(); ++i) indices.push_back(*simplex[i].a.index);
  return indices;
}

/// Returns: the expression about vertices in that order, in the letters that they have as they were told.
std::string in_told_letters(std::string text, const Indices& order) {
  const std::size_t size = order.size();
  for (char& c : text)
    if (const std::size_t role = std::string_view("ABCD").find(c); role < size)
      c = "ABCD"[size - 1 - static_cast<std::size_t>(order[size - 1 - role])];
  return text;
}

/// Collects "ABCn·AO = 3 > 0" of what decided.
template <class S>
struct Reasons {
  const Indices& order;                     ///< of the vertices, as they were told
  std::string chosen = {}, not_above = {};  ///< the region; the faces of a tetrahedron that the origin is not above

  void operator()(const gjk::RegionTested<S>& event) {
    const S* const value = std::get_if<S>(&event.value);
    if (!value) return;
    if (event.verdict == gjk::Verdict::chosen) add(chosen, to_string(event.expression), *value);
    if (event.verdict == gjk::Verdict::rejected && event.simplex_size == 4 && event.face.empty())
      add(not_above, to_string(event.expression), *value);
  }
  template <class E>
  void operator()(const E&) {}

 private:
  void add(std::string& text, const std::string& in_order, S number) const {
    std::string expression = in_told_letters(in_order, order);
    // The report names a normal in one order of its face: in the other it is the opposite.
    for (const auto& [turned, named] : {std::pair{"ACBn", "ABCn"}, {"ADCn", "ACDn"}, {"ABDn", "ADBn"}})
      if (const std::size_t at = expression.find(turned); at != std::string::npos) {
        expression.replace(at, 4, named);
        number = -number;
      }
    text += (text.empty() ? "" : ", ") + expression + " = " + shown(static_cast<double>(number)) +
            (number > 0   ? " > 0"
             : number < 0 ? " < 0"
                          : "");
  }
};

/// As fractions, so that a long one does not become infinite: only the ratios count.
template <class S>
Vec as_doubles(const gjk::Vec3<S>& direction) {
  const S most = direction.cwiseAbs().maxCoeff();
  if (most == S(0)) return Vec::Zero();
  return {static_cast<double>(S(direction[0] / most)), static_cast<double>(S(direction[1] / most)),
          static_cast<double>(S(direction[2] / most))};
}

template <class S, class Rules = gjk::AsIntended>
Outcome processed(const Vertices& vertices, const Indices& order) {
  gjk::Simplex<S> simplex = simplex_in<S>(vertices, order);
  Reasons<S> reasons{order};
  gjk::detail::Teller<Reasons<S>> tell(reasons, gjk::CrossingTest::on);
  const gjk::Next<S> next = gjk::detail::process<Rules>(simplex, tell);
  if (next.contains_origin())
    return {true, order, Vec::Zero(), reasons.chosen.empty() ? reasons.not_above : reasons.chosen};
  return {false, indices_in(simplex), as_doubles<S>(next.direction()), reasons.chosen};
}

/// Whether A lies in the direction BC×BD (Section 3.2.4), as far as rounding leaves that open: of a flat one any order is as good.
bool points_outward(const Vertices& vertices, const Indices& order) {
  if (order.size() < 4) return true;
  const Vec B = vertices[static_cast<std::size_t>(order[2])];
  std::array<Vec, 3> edges;
  for (std::size_t i = 0; i < 3; ++i) {
    edges[i] = vertices[static_cast<std::size_t>(order[i == 2 ? 3 : 1 - i])] - B;  // BC, BD, BA
    if (const double most = edges[i].cwiseAbs().maxCoeff(); most > 0) edges[i] /= most;
  }
  return !(edges[0].cross(edges[1]).dot(edges[2]) < -flat);
}

}  // namespace

std::string shown(double number) {
  constexpr std::size_t longest = 10;
  const std::string exact = number_text(number + 0.0);
  if (exact.size() <= longest) return exact;
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.6g", number);
  return text.data();
}

Indices as_told(const Vertices& vertices) {
  Indices order(vertices.size());
  std::iota(order.begin(), order.end(), 0);
  return order;
}

std::vector<Indices> outward_orders(const Vertices& vertices) {
  std::vector<Indices> all;
  Indices order = as_told(vertices);
  do {
    if (points_outward(vertices, order)) all.push_back(order);
  } while (std::next_permutation(order.begin(), order.end() - 1));
  return all;
}

Outcome outcome_of(const Vertices& vertices, const Indices& order) { return processed<double>(vertices, order); }

std::vector<Outcome> right_outcomes(const Vertices& vertices) {
  std::vector<Outcome> all;
  for (const Indices& order : outward_orders(vertices)) {
    all.push_back(processed<double>(vertices, order));
    all.push_back(processed<gjk::Fraction>(vertices, order));
    all.push_back(processed<gjk::Fraction, gjk::Complete<>>(vertices, order));
  }
  return all;
}

gjk::Simplex<double> simplex_of(const Vertices& vertices, const Indices& order) {
  return simplex_in<double>(vertices, order);
}

Indices indices_of(const gjk::Simplex<double>& simplex) { return indices_in(simplex); }

}  // namespace walkthroughs::steps
