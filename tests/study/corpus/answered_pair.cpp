#include "tests/study/corpus/answered_pair.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/certified/certified.hpp"
#include "core/certified/check.hpp"
#include "tests/study/methods/question.hpp"
#include "tests/study/truth/oracle.hpp"
#include "tests/study/truth/proofs.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/query/query_certified.hpp"

namespace study {
namespace {

std::string status_of(Truth truth) { return truth == Truth::intersecting ? "intersecting" : "separated"; }

// -- Proofs -----------------------------------------------------------------------------------------------------------

std::string list_of(const char* key, const RationalVec& v) {
  return std::string("{\"") + key + "\":[\"" + v[0].str() + "\",\"" + v[1].str() + "\",\"" + v[2].str() + "\"]}";
}

/// Returns: the direction of whole numbers nearest to it, its largest 2^digits.
RationalVec rounded(const RationalVec& d, unsigned digits) {
  Rational largest = 0;
  for (const Rational& x : d) largest = std::max(largest, Rational(abs(x)));
  const Rational unit = largest / Rational(boost::multiprecision::mpz_int(1) << digits);
  RationalVec whole;
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational x = d[i] / unit + Rational(1, 2);
    boost::multiprecision::mpz_int floor = numerator(x) / denominator(x);
    if (x < 0 && Rational(floor) != x) --floor;
    whole[i] = Rational(floor);
  }
  return whole;
}

/// Returns: a direction that is as short to write as may be and separates as well.
RationalVec shortened(const RationalVec& d, const Pair& pair) {
  for (const unsigned digits : {0U, 1U, 2U, 3U, 5U, 8U, 12U, 16U, 24U, 32U, 53U, 80U, 128U, 256U, 512U})
    if (const RationalVec whole = rounded(d, digits); separates(whole, pair)) return whole;
  return d;
}

RationalVec rational(const gjk::detail::Fractions& fractions) {
  return {Rational(fractions[0].str()), Rational(fractions[1].str()), Rational(fractions[2].str())};
}

/// Found by the certified search; so that nothing rests on that, the proof is multiplied out here.
std::string certificate_of_points(const Pair& pair, Truth truth) {
  const gjk::PointSet<double> a(std::get<Points>(pair.a)), b(std::get<Points>(pair.b));
  const gjk::Certificate found = gjk::certified_collision(a, b).certificate;
  if (!gjk::holds(found, a, b) || (gjk::claim_of(found) == gjk::Status::intersecting) != (truth == Truth::intersecting))
    throw std::logic_error("a certificate and the oracle do not agree");
  if (const auto* const d = std::get_if<gjk::SeparatingDirection>(&found))
    return list_of("direction", shortened(rational(gjk::detail::fractions(d->d)), pair));
  if (const auto* const feature = std::get_if<gjk::SeparatingFeature>(&found))
    return list_of("direction", shortened(rational(*gjk::direction_of(*feature, a, b)), pair));
  std::string text;
  walkthroughs::query::CertificateWriter<double>{a, b, walkthroughs::query::QueryEvidence::fractions,
                                                 text}(std::get<gjk::CommonSimplex>(found));
  return "{" + text + "}";
}

std::string certificate_of(const Pair& pair, Truth truth) {
  if (std::holds_alternative<Points>(pair.a)) return certificate_of_points(pair, truth);
  if (truth == Truth::intersecting) return list_of("point", common_point(pair));
  return list_of("direction", shortened(direction_between(pair), pair));
}

// -- Notes ------------------------------------------------------------------------------------------------------------

std::vector<std::string> notes_on(const Pair& pair, Truth truth) {
  std::vector<std::string> notes;
  if (truth == Truth::intersecting && only_touch(pair)) notes.emplace_back("touching");
  const auto in_floats = study::rounded<float>(pair);
  if (!in_floats)
    notes.emplace_back("floats have no room");
  else if (in_floats->differs && study::truth(in_floats->pair) != truth)
    notes.push_back("rounded to floats: " + status_of(study::truth(in_floats->pair)));
  return notes;
}

}  // namespace

AnsweredPair answered(NamedPair named) {
  const Truth found = truth(named.pair);
  std::string certificate = certificate_of(named.pair, found);
  std::vector<std::string> notes = notes_on(named.pair, found);
  return {std::move(named), found, std::move(certificate), std::move(notes)};
}

std::string answered_line(const AnsweredPair& answered) {
  using Json = nlohmann::json;
  const NamedPair& named = answered.named;
  std::string line = "{\"name\":" + Json(named.name).dump() + ",\"family\":" + Json(named.family).dump() + "," +
                     walkthroughs::pairs::bodies_in_line(named.pair) + ",\"answer\":{\"status\":\"" +
                     status_of(answered.truth) + "\",\"certificate\":" + answered.certificate + "}";
  if (!answered.notes.empty()) line += ",\"notes\":" + Json(answered.notes).dump();
  if (!named.source.empty()) line += ",\"source\":" + Json(named.source).dump();
  return line + "}";
}

}  // namespace study
