/// Answers that are proven, each with its certificate: as JSON, and the exact numbers that follow from it.
#pragma once

#include <string>
#include <variant>

#include "core/certified/certified.hpp"
#include "core/certified/check.hpp"
#include "core/certified/grown.hpp"
#include "core/certified/shapes.hpp"
#include "walkthroughs/query/query_evidence.hpp"
#include "walkthroughs/query/query_pair.hpp"

namespace walkthroughs::query {

// A pair made ready to be proven, as often as one likes: by what it consists of.

template <class S>
struct ProvablePoints {
  gjk::Options<S> options;
  RuleSet rules;
  ZeroTest zero_test;
  gjk::PointSet<S> a, b;
};
struct ProvableGrown {
  gjk::Grown a, b;
};
/// Cylinders, and what is too large for gjk::Grown.
struct ProvableOthers {
  Object a, b;
};
template <class S>
using Provable = std::variant<ProvablePoints<S>, ProvableGrown, ProvableOthers>;

/// Requires: numbers that S holds; float or double.
template <class S>
Provable<S> provable(const PairAsWritten& pair, const QueryOptions& query);
template <class S>
gjk::CertifiedResult proven(const ProvablePoints<S>& pair);

/// Appends a direction that is proof enough by itself.
template <class S>
void write_direction(const gjk::Vec3<S>& d, QueryEvidence evidence, std::string& out) {
  out += "\"direction\":";
  if (evidence == QueryEvidence::fractions)
    write_numbers(gjk::detail::fractions(d), out);
  else
    write_numbers(d, out);
}

inline void write_indices(const gjk::IndexPairs& pairs, std::string& out) {
  write_list(pairs, out, [&out](gjk::IndexPair pair) {
    out.append("[").append(std::to_string(pair.a)).append(",").append(std::to_string(pair.b)).append("]");
  });
}

/// Writes a certificate about two sets of points; in fractions, if the evidence is: then with the numbers that would have to be
/// solved for to check it.
template <class S>
struct CertificateWriter {
  const gjk::PointSet<S>&a, &b;
  QueryEvidence evidence;
  std::string& out;

  void operator()(const gjk::SeparatingDirection& certificate) const { write_direction(certificate.d, evidence, out); }
  void operator()(const gjk::SeparatingFeature& certificate) const {
    out += "\"nearest\":";
    write_indices(certificate.of);
    if (!is_in_fractions()) return;
    out += ",\"direction\":";
    write_numbers(*gjk::direction_of(certificate, a, b), out);
  }
  void operator()(const gjk::CommonSimplex& certificate) const {
    out += "\"simplex\":";
    write_indices(certificate.of);
    if (!is_in_fractions()) return;
    const Fractions weights = *gjk::weights_of(certificate, a, b);
    out += ",\"weights\":";
    write_numbers(weights, out);
    out += ",\"point\":";
    write_numbers(weighted(certificate.of, weights), out);
  }

 private:
  using Fractions = gjk::detail::Fractions;

  bool is_in_fractions() const { return evidence == QueryEvidence::fractions; }

  void write_indices(const gjk::IndexPairs& pairs) const { query::write_indices(pairs, out); }

  /// Returns: the point of A that the weights make; that of B is the same.
  Fractions weighted(const gjk::IndexPairs& pairs, const Fractions& weights) const {
    Fractions sum(3);
    for (int k = 0; k < pairs.size(); ++k) {
      const Fractions p = *gjk::detail::point_of(a, pairs[k].a);
      for (std::size_t i = 0; i < 3; ++i) sum[i] += weights[static_cast<std::size_t>(k)] * p[i];
    }
    return sum;
  }
};

template <class S>
void write_answer(const gjk::CertifiedResult& result, const CertificateWriter<S>& writer) {
  std::string& out = writer.out;
  write_status(result, out);
  out.append(",\"second_iterations\":").append(std::to_string(result.fallback_iterations));
  out.append(",\"proof\":\"").append(to_string(result.proof)).append("\",\"certificate\":{");
  std::visit(writer, result.certificate);
  out += "}}\n";
}

/// What is decided exactly needs no more words.
inline void write_answer_of_cylinders(gjk::Status status, std::string& out) {
  out.append("{\"status\":\"").append(words_of::of(status)).append("\",\"proof\":\"discs\"}\n");
}

inline void write_answer(const gjk::ShapesResult& result, QueryEvidence evidence, std::string& out) {
  write_status(result, out);
  switch (result.status) {
    case gjk::Status::intersecting: out += ",\"proof\":\"surface\""; break;
    case gjk::Status::separated:
      write_direction(result.direction, evidence, out += ",\"proof\":\"direction\",\"certificate\":{");
      out += '}';
      break;
    case gjk::Status::undecided: write(result.gap, out += ",\"gap\":");
  }
  out += "}\n";
}

/// Appends the answer to a pair, which is used up. Of all that exact_shape.hpp decides it is exact; of other shapes it may be
/// undecided. Requires: a pair read for a query in float or double whose evidence is a certificate.
void answer_certified(PairAsWritten&& pair, const QueryOptions& query, std::string& out);

}  // namespace walkthroughs::query
