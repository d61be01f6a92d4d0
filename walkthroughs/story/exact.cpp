#include "walkthroughs/story/exact.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "core/certified/check.hpp"
#include "core/gjk.hpp"
#include "core/rule_sets.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::story {
namespace {

using Vec = gjk::Vec3<gjk::Fraction>;
using ExactTrace = gjk::Trace<gjk::Fraction>;

constexpr std::size_t longest_fraction = 24;

// -- The search -------------------------------------------------------------------------------------------------------

Vec exact(const Point& p) { return {gjk::Fraction(p.x()), gjk::Fraction(p.y()), gjk::Fraction(p.z())}; }

gjk::PointSet<gjk::Fraction> exact(const Object& object) {
  std::vector<Vec> vertices;
  for (const Point& p : vertices_of(object)) vertices.push_back(exact(p));
  return gjk::PointSet<gjk::Fraction>(std::move(vertices));
}

ExactTrace run_exactly(const Scene& scene) {
  const gjk::Options<gjk::Fraction> options{.first_direction = exact(scene.options.first_direction),
                                            .iteration_limit = scene.options.iteration_limit,
                                            .crossing_test = scene.options.crossing_test};
  ExactTrace trace;
  gjk::with_rules<gjk::ExactZeroTest>(scene.rules, [&]<class Rules>() {
    gjk::collision<gjk::Fraction, Rules>(exact(scene.a), exact(scene.b), options, trace);
  });
  return trace;
}

// -- Decisions --------------------------------------------------------------------------------------------------------

/// What an event decides, apart from its numbers: searches that agree in it do the same next.
struct DecisionOf {
  template <class S>
  std::string operator()(const gjk::SupportFound<S>& e) const {
    return std::to_string(e.vertex.a.index.value()) + ", " + std::to_string(e.vertex.b.index.value());
  }
  template <class S>
  std::string operator()(const gjk::CrossingTested<S>& e) const {
    return std::string(words_of::of(e.verdict));
  }
  template <class S>
  std::string operator()(const gjk::RegionTested<S>& e) const {
    return to_string(e.face) + " " + to_string(e.feature) + " " + std::string(words_of::of(e.relation)) + " " +
           std::string(words_of::of(e.verdict));
  }
  template <class S>
  std::string operator()(const gjk::DirectionChosen<S>& e) const {
    return with_brackets(e.expression) + (gjk::is_usable_direction(e.direction) ? "" : ", of no use");
  }
  template <class S>
  std::string operator()(const gjk::Finished<S>& e) const {
    return std::string(words_of::of(e.result.reason));
  }
  template <class E>
  std::string operator()(const E&) const {  // follows from the events before
    return "";
  }
};

/// Returns: the place of the first event of both that decides differently.
std::size_t first_other_decision(const Trace& trace, const ExactTrace& exactly) {
  const std::size_t shorter = std::min(trace.events.size(), exactly.events.size());
  for (std::size_t i = 0; i < shorter; ++i)
    if (std::visit(DecisionOf{}, trace.events[i]) != std::visit(DecisionOf{}, exactly.events[i])) return i;
  throw std::logic_error("exact arithmetic decides as this search does");
}

// -- Numbers ----------------------------------------------------------------------------------------------------------

using Decimal = boost::multiprecision::cpp_dec_float_50;

Decimal decimal(const gjk::Fraction& x) { return Decimal(numerator(x).str()) / Decimal(denominator(x).str()); }

/// As number() of words.hpp, for numbers that no double holds too.
std::string written(const gjk::Fraction& x) {
  const double near = x.convert_to<double>();
  return x == 0 || std::isnormal(near) ? number(near) : with_true_minus(decimal(x).str(6));
}

/// Returns: with two digits behind the point.
std::string fixed(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%s%.2f", x < 0 ? "−" : "", std::abs(x));
  return text;
}

/// To six digits and in any case to a hundredth.
std::string rounded(const gjk::Fraction& x) {
  const double near = x.convert_to<double>();
  return std::abs(near) < 1e4 || std::abs(near) >= 1e12 ? written(x) : fixed(near);
}

std::string written(const Vec& v, Dimension dimension, std::string (*number)(const gjk::Fraction&) = written) {
  return "(" + number(v.x()) + ", " + number(v.y()) +
         (dimension == Dimension::plane ? ")" : ", " + number(v.z()) + ")");
}

gjk::Fraction largest(const Vec& v) {
  gjk::Fraction most = 0;
  for (const gjk::Fraction& x : v) most = std::max(most, gjk::Fraction(abs(x)));
  return most;
}

/// Returns: n/|d|.
std::string quotient_with_length(const gjk::Fraction& n, const Vec& d) {
  const gjk::Fraction scale = largest(d);  // so that no square of a double over- or underflows
  Point scaled;
  for (int i = 0; i < 3; ++i) scaled[i] = gjk::Fraction(d[i] / scale).convert_to<double>();
  return written(gjk::Fraction(n / scale / gjk::Fraction(scaled.norm())));
}

// -- The first wrong decision -----------------------------------------------------------------------------------------

/// Says what exact arithmetic finds where the search of rounded numbers went wrong.
struct ExactFinding {
  Dimension dimension;
  const gjk::Event<double>& rounded;

  Remark operator()(const gjk::SupportFound<gjk::Fraction>& e) const {
    const auto& found = std::get<gjk::SupportFound<double>>(rounded).vertex;
    const Vec taken = exact(found.a.point) - exact(found.b.point);
    return remark(Remark::At::support_found, e,
                  "P·d = " + written(gjk::Fraction(taken.dot(e.direction))) + ", but " +
                      written(e.vertex.w, dimension) + "·d = " + written(gjk::Fraction(e.vertex.w.dot(e.direction))));
  }
  Remark operator()(const gjk::CrossingTested<gjk::Fraction>& e) const {
    return remark(Remark::At::crossing_tested, e, "P·d = " + written(e.value.value()));
  }
  Remark operator()(const gjk::RegionTested<gjk::Fraction>& e) const {
    const gjk::Fraction* value = std::get_if<gjk::Fraction>(&e.value);
    return remark(
        Remark::At::region_tested, e,
        with_brackets(e.expression) + " = " + (value ? written(*value) : written(std::get<Vec>(e.value), dimension)),
        (e.face.empty() ? "" : to_string(e.face) + " ") + to_string(e.feature));
  }
  Remark operator()(const gjk::DirectionChosen<gjk::Fraction>& e) const {
    return remark(Remark::At::direction_chosen, e,
                  with_brackets(e.expression) + " = " + written(e.direction, dimension));
  }
  Remark operator()(const auto&) const { throw std::logic_error("this event has no number that could be wrong"); }

 private:
  static Remark remark(Remark::At at, const auto& event, const std::string& fact, const std::string& only_for = {}) {
    return {.at = at,
            .iteration = event.iteration,
            .text = {},
            .only_for = only_for,
            .fact = "in exact arithmetic: " + fact};
  }
};

// -- The truth --------------------------------------------------------------------------------------------------------

constexpr const char* words_for_answer(gjk::Status answer) {
  return answer == gjk::Status::intersecting ? "together" : answer == gjk::Status::separated ? "apart" : "no answer";
}

/// What is searched otherwise than the truth is found.
std::string searched(const Scene& scene) {
  if (scene.rules == RuleSet::as_printed) return "as printed";
  return scene.scalar == Scalar::binary32 ? "in floats" : "in doubles";
}

/// Returns: point `i` of a set of points, exactly where the matrix of its pose puts it.
Vec exact_point(const Object& object, int i) {
  const Vec p = exact(std::get<Points>(object.form)[static_cast<std::size_t>(i)]), t = exact(object.pose.translation);
  Vec moved;
  for (int row = 0; row < 3; ++row) moved[row] = exact(Point(object.pose.rotation.row(row))).dot(p) + t[row];
  return moved;
}

/// The points that a certificate names, numbered anew in its order.
struct NamedPoints {
  std::vector<Vec> a, b;
  gjk::IndexPairs of;

  NamedPoints(const gjk::IndexPairs& pairs, const Scene& scene) {
    for (const gjk::IndexPair pair : pairs) {
      of.add({static_cast<int>(a.size()), static_cast<int>(a.size())});
      a.push_back(exact_point(a_as_read(scene), pair.a));
      b.push_back(exact_point(b_as_read(scene), pair.b));
    }
  }
};

/// Requires: a certificate of this scene.
std::string certificate_told(const ExactAnswer& answer, const Scene& scene) {
  const NamedPoints named(answer.nearest, scene);
  const gjk::PointSet<gjk::Fraction> a(named.a), b(named.b);
  if (answer.status == gjk::Status::separated) {
    const gjk::detail::Fractions d = gjk::direction_of(gjk::SeparatingFeature{named.of}, a, b).value();
    const Vec v(-d[0], -d[1], -d[2]);
    return "in truth a − b is nearest to the origin at v = " + written(v, scene.dimension) + ", " +
           quotient_with_length(v.dot(v), v) + " away";
  }
  const gjk::detail::Fractions weights = gjk::weights_of(gjk::CommonSimplex{named.of}, a, b).value();
  Vec point = Vec::Zero();
  for (std::size_t i = 0; i < weights.size(); ++i) point += named.a[i] * weights[i];
  return "in truth both objects hold the point " + written(point, scene.dimension, rounded);
}

/// "a[0] − b[2], a[1] − b[2]", by the places of the points in their sets.
std::string differences_told(const gjk::IndexPairs& pairs) {
  return joined(pairs, ", ", [](const gjk::IndexPair& pair) {
    return "a[" + std::to_string(pair.a) + "] − b[" + std::to_string(pair.b) + "]";
  });
}

bool have_points(const Scene& scene) {
  return std::holds_alternative<Points>(scene.a.form) && std::holds_alternative<Points>(scene.b.form);
}

}  // namespace

double nearest_double(const std::string& fraction) { return decimal(gjk::Fraction(fraction)).convert_to<double>(); }

std::string short_fraction(const std::string& fraction) {
  if (fraction.size() <= longest_fraction) return with_true_minus(fraction);
  const Decimal x = decimal(gjk::Fraction(fraction));
  int exponent = static_cast<int>(x.backend().order());
  double mantissa = Decimal(x * pow(Decimal(10), -exponent)).convert_to<double>();
  if (std::abs(mantissa) >= 9.9995) {  // which would be rounded to 10
    mantissa /= 10;
    ++exponent;
  }
  char digits[64];
  std::snprintf(digits, sizeof digits, "≈ %.4ge%d", mantissa, exponent);
  return with_true_minus(digits);
}

std::string in_truth(gjk::Status answer) {
  return answer == gjk::Status::intersecting ? "they intersect" : "they are apart";
}

TruthTold truth_told(const Truth& truth, const Scene& scene, gjk::Status shown) {
  TruthTold told;
  const auto add = [&](const std::string& sentence) { told.sentence += (told.sentence.empty() ? "" : " ") + sentence; };
  const auto tell = [&](const std::string& fact) { told.facts.push_back({Fact::Mark::truth, fact}); };
  if (is_otherwise(truth, shown)) {
    add(as_sentence(searched(scene)) + ": " + words_for_answer(shown) + ". In truth: " + in_truth(truth.answer.status) +
        ".");
    if (truth.answer.nearest.size() > 0 && have_points(scene)) {
      tell(certificate_told(truth.answer, scene));
      tell("the certificate is " + differences_told(truth.answer.nearest));
    }
    if ((scene.a_as_read || scene.b_as_read) && exact_answer(scene.a, scene.b).status != truth.answer.status)
      tell("this is the truth about the numbers as read: rounding them to floats has moved the objects");
  }
  if (truth.of_decimals) add("The decimals as typed say otherwise: " + in_truth(*truth.of_decimals) + ".");
  if (truth.exchanged)
    add("With a and b exchanged the search answers: " + std::string(words_for_answer(*truth.exchanged)) + ".");
  return told;
}

std::vector<Remark> remarks_on(const WrongTurn& turn, const Scene& scene, const Trace& trace) {
  const ExactTrace exact_trace = run_exactly(scene);
  const std::size_t i = first_other_decision(trace, exact_trace);
  Remark wrong = std::visit(ExactFinding{scene.dimension, trace.events[i]}, exact_trace.events[i]);
  wrong.text = turn.cause;
  wrong.contradicts = true;
  if (turn.ending.empty()) return {wrong};
  const int last = std::get<gjk::Finished<double>>(trace.events.back()).iteration;
  return {wrong, {.at = Remark::At::end, .iteration = last, .text = turn.ending}};
}

}  // namespace walkthroughs::story
