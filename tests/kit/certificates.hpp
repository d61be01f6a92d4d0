/// Answers of gjkstep query --certified as their readers take them: do they prove what they say?
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/certified/check.hpp"

namespace kit {

/// Requires: an object of points, as a line gives it.
template <class S>
gjk::PointSet<S> set_in(const nlohmann::json& object) {
  std::vector<gjk::Vec3<S>> points;
  for (const auto& p : object["points"]) {
    const auto number = [&p](std::size_t i) {
      return i < p.size() ? static_cast<S>(p[i].template get<double>()) : S(0);
    };
    points.emplace_back(number(0), number(1), number(2));
  }
  return gjk::PointSet<S>(points);
}

inline gjk::IndexPairs index_pairs_in(const nlohmann::json& list) {
  gjk::IndexPairs pairs;
  for (const auto& pair : list) pairs.add({pair.at(0).get<int>(), pair.at(1).get<int>()});
  return pairs;
}

inline gjk::detail::Fractions fractions_in(const nlohmann::json& list) {
  gjk::detail::Fractions fractions;
  for (const auto& one : list) fractions.emplace_back(one.get<std::string>());
  return fractions;
}

/// Requires: a certificate as it is without --fractions.
inline gjk::Certificate certificate_in(const nlohmann::json& written) {
  if (written.contains("simplex")) return gjk::CommonSimplex{index_pairs_in(written["simplex"])};
  if (written.contains("nearest")) return gjk::SeparatingFeature{index_pairs_in(written["nearest"])};
  const auto d = written["direction"].get<std::array<double, 3>>();
  return gjk::SeparatingDirection{{d[0], d[1], d[2]}};
}

/// Returns: whether the points of these indices, weighted, make that point, as `index` takes them from one of the sets.
template <class S>
bool make(const gjk::detail::Fractions& point, const gjk::detail::Fractions& weights, const gjk::IndexPairs& pairs,
          const gjk::PointSet<S>& set, int gjk::IndexPair::*index) {
  gjk::detail::Fractions sum(3);
  for (int k = 0; k < pairs.size(); ++k) {
    const auto p = *gjk::detail::point_of(set, pairs[k].*index);
    for (std::size_t i = 0; i < 3; ++i) sum[i] += weights[static_cast<std::size_t>(k)] * p[i];
  }
  return sum == point;
}

/// Returns: whether the exact numbers of a certificate prove what it says.
template <class S>
bool exact_numbers_hold(const nlohmann::json& written, const gjk::PointSet<S>& a, const gjk::PointSet<S>& b) {
  if (written.contains("direction")) return gjk::detail::separates(fractions_in(written["direction"]), a, b);
  const auto pairs = index_pairs_in(written["simplex"]);
  const auto weights = fractions_in(written["weights"]), point = fractions_in(written["point"]);
  gjk::Fraction sum = 0;
  for (const auto& weight : weights) {
    if (weight < 0) return false;
    sum += weight;
  }
  return sum == 1 && static_cast<int>(weights.size()) == pairs.size() &&
         make(point, weights, pairs, a, &gjk::IndexPair::a) && make(point, weights, pairs, b, &gjk::IndexPair::b);
}

/// Returns: whether an answer, with --fractions or without, is proven by its certificate.
template <class S>
bool is_proven(const nlohmann::json& said, const gjk::PointSet<S>& a, const gjk::PointSet<S>& b) {
  const nlohmann::json& written = said.at("certificate");
  if (said.at("status") != (written.contains("simplex") ? "intersecting" : "separated")) return false;
  const bool is_in_fractions =
      written.contains("weights") || (written.contains("direction") && written["direction"].at(0).is_string());
  return is_in_fractions ? exact_numbers_hold(written, a, b) : gjk::holds(certificate_in(written), a, b);
}

}  // namespace kit
