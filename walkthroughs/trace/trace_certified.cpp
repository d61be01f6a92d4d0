#include "walkthroughs/trace/trace_certified.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/certificate_check.hpp"
#include "core/certified.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/trace/farthest.hpp"
#include "walkthroughs/trace/trace_contradiction.hpp"
#include "walkthroughs/trace/trace_expression.hpp"

namespace walkthroughs {
namespace {

using Vertex = gjk::Vertex<double>;
using Simplex = gjk::Simplex<double>;
using gjk::Proof;
using gjk::Role;
using gjk::Status;
using gjk::detail::dot;
using gjk::detail::Fraction;
using gjk::detail::Fractions;
using gjk::detail::minus;

constexpr double enough = 1e-6;  // of a direction that was rounded, beside the exact one; a float has seven digits

Fractions cross(const Fractions& u, const Fractions& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
Fractions times(const Fraction& s, const Fractions& v) { return {s * v[0], s * v[1], s * v[2]}; }

Fractions place_of(const Vertex& vertex) {
  return minus(gjk::detail::fractions(vertex.a.point), gjk::detail::fractions(vertex.b.point));
}

bool is_same(const Vertex& p, const Vertex& q) { return p.a.index == q.a.index && p.b.index == q.b.index; }

/// A sign that is to be told.
struct Question {
  std::string expression, formula;
  Fraction value;
};

/// What is asked of one simplex, and what follows, all exactly.
class Step {
 public:
  explicit Step(const Simplex& simplex) : simplex_(simplex) {
    const Fractions A = place_of(simplex[Role::A]);
    AO_ = minus({0, 0, 0}, A);
    for (int i = 0; i < simplex.size(); ++i) to_.push_back(minus(place_of(simplex[static_cast<Role>(i)]), A));
    kept_ = gjk::detail::letters_of(gjk::detail::nearest_with_A(*this, simplex.size()));
    contains_origin_ = look_for_origin();
    if (!contains_origin_) choose_direction();
  }

  const std::vector<Question>& questions() const { return questions_; }
  const std::string& kept() const { return kept_; }
  bool contains_origin() const { return contains_origin_; }
  const std::string& expression() const { return expression_; }
  const Fractions& direction() const { return direction_; }

  Simplex after() const {
    Simplex kept;
    for (const char name : kept_) kept.add(simplex_[role(name)]);
    return kept;
  }
  std::string dropped() const { return gjk::detail::letters_beside(kept_, simplex_.size()); }

  // -- As nearest_with_A() asks

  bool is_toward(Role X) const { return ask(edge(X) + "·AO", "", dot(to(X), AO_)) > 0; }
  bool is_beyond(Role X, Role Y) const {
    const std::string AX = edge(X), AY = edge(Y);
    return ask(AX + "n·AO", "(" + AX + "·AO)(" + AX + "·" + AY + ") − (" + AY + "·AO)(" + AX + "·" + AX + ")",
               dot(to(X), AO_) * dot(to(X), to(Y)) - dot(to(Y), AO_) * dot(to(X), to(X))) >= 0;
  }
  bool is_above(Role X, Role Y, Role Z) const {
    const int of_origin = side_of_origin(X, Y);
    return of_origin * ask(normal(X, Y) + "·" + edge(Z), "", dot(cross(to(X), to(Y)), to(Z))) < 0;
  }

 private:
  static Role role(char name) { return static_cast<Role>(name - 'A'); }
  static std::string edge(Role X) { return {'A', gjk::letter(X)}; }
  static std::string normal(Role X, Role Y) { return edge(X) + gjk::letter(Y) + 'n'; }
  const Fractions& to(Role X) const { return to_[static_cast<std::size_t>(X)]; }

  /// Returns: the sign. Each is told once.
  int ask(const std::string& expression, const std::string& formula, const Fraction& value) const {
    const auto is_it = [&](const Question& q) { return q.expression == expression && q.formula == formula; };
    if (std::ranges::none_of(questions_, is_it)) questions_.push_back({expression, formula, value});
    return value.sign();
  }
  int side_of_origin(Role X, Role Y) const { return ask(normal(X, Y) + "·AO", "", dot(cross(to(X), to(Y)), AO_)); }
  bool is_zero(const std::string& name, const Fractions& v) const {
    return ask(name + ".x", "", v[0]) == 0 && ask(name + ".y", "", v[1]) == 0 && ask(name + ".z", "", v[2]) == 0;
  }

  /// Whether the origin lies in what is kept.
  bool look_for_origin() const {
    switch (kept_.size()) {
      case 1: return is_zero("AO", AO_);
      case 2: return is_zero("(" + edge(role(kept_[0])) + "×AO)", cross(to(role(kept_[0])), AO_));
      case 3: return side_of_origin(role(kept_[1]), role(kept_[0])) == 0;
      default: return true;
    }
  }
  void choose_direction() {
    expression_ = "AO";
    direction_ = AO_;
    if (kept_.size() == 2) {
      const Role X = role(kept_[0]);
      expression_ = edge(X) + "×AO×" + edge(X);
      direction_ = minus(times(dot(to(X), to(X)), AO_), times(dot(to(X), AO_), to(X)));
    } else if (kept_.size() == 3) {
      const Role X = role(kept_[1]), Y = role(kept_[0]);
      const int side = side_of_origin(X, Y);
      expression_ = (side > 0 ? "" : "−") + normal(X, Y);
      direction_ = times(side, cross(to(X), to(Y)));
    }
  }

  const Simplex simplex_;
  Fractions AO_;
  std::vector<Fractions> to_;  // by role
  mutable std::vector<Question> questions_;
  std::string kept_;  // oldest first
  bool contains_origin_ = false;
  std::string expression_;
  Fractions direction_;
};

void require_word(std::string_view found, std::string_view wanted, const char* key) {
  require(found == wanted, in_quotes(key) + " is " + in_quotes(found) + "; expected " + in_quotes(wanted));
}

Fraction power_of_two(int exponent) {
  const boost::multiprecision::cpp_int power = boost::multiprecision::cpp_int(1)
                                               << static_cast<unsigned>(std::abs(exponent));
  return exponent >= 0 ? Fraction(power) : Fraction(1) / Fraction(power);
}

/// `exactly`: the polynomial.
void check_value(const gjk::SignTaken<double>& event, const Fraction& exactly) {
  require(std::isfinite(event.value) && std::isfinite(event.error) && event.error >= 0,
          "'value' and 'error' are to be finite, and 'error' not negative");
  const Fraction distance = abs(Fraction(exactly * power_of_two(event.power.value_or(0)) - Fraction(event.value)));
  require(distance <= Fraction(event.error),
          in_quotes(event.expression) + " is farther from 'value' " + number_text(event.value) + " than 'error' says");
  const bool in_doubt = std::abs(event.value) <= event.error && event.error != 0;
  if (!in_doubt && event.expression != "max w·d")
    require(event.exact.empty(), "'exact' is given, but the sign of 'value' is in no doubt");
  if (in_doubt) require(!event.exact.empty(), "'exact' is missing: 0 lies within 'error' of 'value'");
  if (!event.exact.empty()) require_word(event.exact, exactly.str(), "exact");
  require(event.sign == exactly.sign(), "'sign' is " + std::to_string(event.sign) + ", but that of " +
                                            in_quotes(event.expression) + " is " + std::to_string(exactly.sign()));
}

}  // namespace

class CertifiedCheck::Course {
 public:
  Course(const Scene& scene, const gjk::Result<double>& guess, std::vector<Point> found)
      : scene_(scene),
        guess_(guess),
        found_(std::move(found)),
        a_(std::get<Points>(scene.a.form)),
        b_(std::get<Points>(scene.b.form)),
        expected_{event_index<gjk::ProofTried>} {
    next_proof_ = guess.separation ? Proof::direction : Proof::tetrahedron;
  }

  const std::vector<std::size_t>& expected() const { return expected_; }
  int iteration() const { return guess_.iterations + second_iterations_; }

  template <class E>
  void check(const E&) {
    throw Contradiction(in_quotes(FieldsOf<E>::event) + " cannot follow here");  // is never expected
  }

  void check(const gjk::ProofTried<double>& event) {
    require_word(words_of::of(event.proof), words_of::of(next_proof_), "proof");
    if (scene_.scalar == Scalar::binary32)
      check_proof<float>(event);
    else
      check_proof<double>(event);
    if (event.holds)
      return expect_end(next_proof_, next_proof_ == Proof::direction ? Status::separated : Status::intersecting);
    if (next_proof_ == Proof::direction && guess_.simplex.size() == 4)
      next_proof_ = Proof::tetrahedron;
    else
      expected_ = {event_index<gjk::VertexAdded>};
  }

  void check(const gjk::VertexAdded<double>& event) {
    ++second_iterations_;
    const int size = event.simplex.size();
    require(size == simplex_.size() + 1,
            "'simplex' has " + std::to_string(size) + " vertices; expected " + std::to_string(simplex_.size() + 1));
    for (int i = 0; i < size; ++i) {
      require_point(event.simplex[i]);
      if (i + 1 < size)
        require(is_same(event.simplex[i], simplex_[i]), "'simplex' is not that which was kept, with another vertex");
    }
    const Vertex& newest = event.simplex[size - 1];
    if (next_) require(is_same(newest, *next_), "the newest vertex is not the one that reaches across the origin");
    if (!next_) require(is_offered(newest), "the first vertex is not one of the first search");
    simplex_ = event.simplex;
    step_.emplace(simplex_);
    told_ = 0;
    expect_sign_or_kept();
  }

  void check(const gjk::SignTaken<double>& event) {
    if (event.vertex) return check_reach(event);
    require(told_ < step_->questions().size(), "this sign is not asked for");
    const Question& question = step_->questions()[told_++];
    require_word(event.expression, question.expression, "expression");
    require_word(event.formula, question.formula, "formula");
    check_value(event, question.value);
    expect_sign_or_kept();
  }

  void check(const gjk::FeatureKept<double>& event) {
    require(event.before == simplex_, "'before' is not the simplex as it was");
    require_word(event.kept, step_->kept(), "kept");
    require_word(event.dropped, step_->dropped(), "dropped");
    simplex_ = step_->after();
    require(event.after == simplex_, "'after' is not what 'kept' says");
    require(
        event.contains_origin == step_->contains_origin(),
        std::string("'contains_origin' is not true of what is kept: ") + (step_->contains_origin() ? "true" : "false"));
    if (event.contains_origin) return expect_end(Proof::second_search, Status::intersecting);
    expected_ = {event_index<gjk::DirectionChosen>};
  }

  void check(const gjk::DirectionChosen<double>& event) {
    require_word(event.expression, step_->expression(), "expression");
    require(points_along(event.direction, step_->direction()), "'direction' is not that of " + event.expression);
    direction_ = event.direction;
    has_looked_ = false;
    expected_ = {event_index<gjk::SignTaken>};
  }

  void check(const gjk::SupportFound<double>& event) {
    require(is_identical(event.direction, direction_), "'direction' is not the direction chosen last");
    require_point(event.vertex);
    for (const auto& [key, point, object, along] :
         {std::tuple("'a' ", &event.vertex.a, &scene_.a, direction_),
          std::tuple("'b' ", &event.vertex.b, &scene_.b, Point(-direction_))}) {
      const std::string against = objection_to(*point, *object, along, scene_.scalar);
      require(against.empty(), key + against);
    }
    require_new(event, found_);
    has_looked_ = true;
    expected_ = {event_index<gjk::SignTaken>};
  }

  void check(const gjk::Certified<double>& event) {
    const gjk::CertifiedResult& result = event.result;
    require_word(words_of::of(result.status), words_of::of(status_), "status");
    require_word(words_of::of(result.proof), words_of::of(proof_), "proof");
    require(result.iterations == guess_.iterations && result.second_iterations == second_iterations_,
            "'iterations' and 'second_iterations' are to be " + std::to_string(guess_.iterations) + " and " +
                std::to_string(second_iterations_));
    require(claim_of(result.certificate) == status_, "'certificate' is of another answer than 'status'");
    require(holds(result.certificate, a_, b_), "'certificate' does not hold");
    require(is_of_what_was_found(result.certificate),
            "'certificate' is not of the " + std::string(proof_ == Proof::direction ? "direction" : "simplex") +
                " that was found");
    expected_.clear();
  }

 private:
  bool is_of_what_was_found(const gjk::Certificate& certificate) const {
    if (const auto* direction = std::get_if<gjk::SeparatingDirection>(&certificate))
      return direction->d == guess_.separation->direction;
    const auto* feature = std::get_if<gjk::SeparatingFeature>(&certificate);
    const gjk::IndexPairs& pairs = feature ? feature->of : std::get<gjk::CommonSimplex>(certificate).of;
    const Simplex& simplex = proof_ == Proof::second_search ? simplex_ : guess_.simplex;
    if (pairs.size() != simplex.size()) return false;
    const auto point = [](const gjk::PointSet<double>& set, int index) -> const Point& {
      return set.points()[static_cast<std::size_t>(index)];
    };
    for (int i = 0; i < simplex.size(); ++i)
      if (point(a_, pairs[i].a) != simplex[i].a.point || point(b_, pairs[i].b) != simplex[i].b.point) return false;
    return true;
  }

  template <class S>
  void check_proof(const gjk::ProofTried<double>& event) const {
    const gjk::ProofTried<double> found = proof_of<S>();
    require(event.numbers.size() == found.numbers.size(), "'numbers' has " + std::to_string(event.numbers.size()) +
                                                              "; expected " + std::to_string(found.numbers.size()));
    require(std::abs(event.bound - found.bound) <= enough * found.bound,
            "'bound' is " + number_text(event.bound) + "; expected " + number_text(found.bound));
    for (std::size_t i = 0; i < found.numbers.size(); ++i) {
      require_word(event.numbers[i].expression, found.numbers[i].expression, "expression");
      require(std::abs(event.numbers[i].value - found.numbers[i].value) <= found.bound,
              in_quotes(found.numbers[i].expression) + " is " + number_text(event.numbers[i].value) + "; expected " +
                  number_text(found.numbers[i].value));
    }
    require(event.holds == found.holds,
            std::string("'holds' is ") + (event.holds ? "true" : "false") + ", but the numbers say otherwise");
  }

  template <class S>
  gjk::ProofTried<double> proof_of() const {
    const auto extent = [](const gjk::PointSet<double>& set) { return gjk::Vec3<S>(set.extent().template cast<S>()); };
    gjk::ProofTried<S> proof{.proof = next_proof_};
    if (next_proof_ == Proof::direction) {
      const gjk::Separation<double>& separation = *guess_.separation;
      proof = gjk::detail::DirectionProof<S>(separation.direction.template cast<S>(),
                                             static_cast<S>(separation.support_value), extent(a_), extent(b_))
                  .told();
    } else if (guess_.simplex.size() == 4) {
      const auto w = [this](int i) { return gjk::Vec3<S>(guess_.simplex[i].w.template cast<S>()); };
      proof = gjk::detail::TetrahedronProof<S>(w(0), w(1), w(2), w(3)).told();
    }
    return {.proof = proof.proof, .numbers = proof.numbers, .bound = proof.bound, .holds = proof.holds};
  }

  /// Of w·d.
  void check_reach(const gjk::SignTaken<double>& event) {
    require(told_ == step_->questions().size() && !direction_.isZero(0), "'vertex' is given, but no w·d is asked for");
    require_point(*event.vertex);
    if (!has_looked_) require(is_offered(*event.vertex), "'vertex' is not one of the first search");
    if (!has_looked_ || event.expression != "max w·d") require_word(event.expression, "w·d", "expression");
    check_value(event, dot(place_of(*event.vertex), step_->direction()));
    if (event.sign >= 0) {
      next_ = *event.vertex;
      expected_ = {event_index<gjk::VertexAdded>};
    } else if (!has_looked_) {
      expected_ = {event_index<gjk::SupportFound>};
    } else {
      require_word(event.expression, "max w·d", "expression");
      expect_end(Proof::second_search, Status::separated);
    }
  }

  void expect_sign_or_kept() {
    direction_ = Point::Zero();
    expected_ = {told_ < step_->questions().size() ? event_index<gjk::SignTaken> : event_index<gjk::FeatureKept>};
  }
  void expect_end(Proof proof, Status status) {
    proof_ = proof;
    status_ = status;
    expected_ = {event_index<gjk::Certified>};
  }

  /// That both of its points are those of their indices, and w is a − b, rounded.
  void require_point(const Vertex& vertex) const {
    const auto is_of = [](const gjk::SupportPoint<double>& point, const gjk::PointSet<double>& set) {
      return point.index && static_cast<std::size_t>(*point.index) < set.points().size() &&
             point.point == set.points()[static_cast<std::size_t>(*point.index)];
    };
    require(is_of(vertex.a, a_) && is_of(vertex.b, b_), "a vertex is not made of the points of its indices");
    const Point w = scene_.scalar == Scalar::binary32
                        ? Point((vertex.a.point.cast<float>() - vertex.b.point.cast<float>()).cast<double>())
                        : Point(vertex.a.point - vertex.b.point);
    require(vertex.w == w, "'w' of a vertex is not a - b");
  }
  /// Whether the first search has left that vertex to the second; where it left none, that of the first indices.
  bool is_offered(const Vertex& vertex) const {
    if (guess_.simplex.size() == 0) return vertex.a.index == 0 && vertex.b.index == 0;
    for (int i = 0; i < guess_.simplex.size(); ++i)
      if (is_same(vertex, guess_.simplex[i])) return true;
    return false;
  }

  /// Whether `d` is, to rounding, a positive multiple of the exact direction.
  static bool points_along(const Point& d, const Fractions& exactly) {
    if (!d.allFinite() || d.isZero(0)) return false;
    int largest = 0;
    d.cwiseAbs().maxCoeff(&largest);
    const Fraction& of_largest = exactly[static_cast<std::size_t>(largest)];
    if (of_largest == 0) return false;
    const Fraction scale = Fraction(d[largest]) / of_largest;
    if (scale < 0) return false;
    for (int i = 0; i < 3; ++i)
      if (abs(Fraction(exactly[static_cast<std::size_t>(i)] * scale - Fraction(d[i]))) >
          Fraction(enough * std::abs(d[largest])))
        return false;
    return true;
  }

  const Scene& scene_;
  const gjk::Result<double> guess_;
  std::vector<Point> found_;  // places, by both searches
  const gjk::PointSet<double> a_, b_;
  std::vector<std::size_t> expected_;
  Proof next_proof_;
  Simplex simplex_;  // of the second search
  int second_iterations_ = 0;
  std::optional<Step> step_;         // of simplex_ as of the last VertexAdded
  std::size_t told_ = 0;             // of its questions
  Point direction_ = Point::Zero();  // chosen last; zero before it is
  bool has_looked_ = false;          // for the farthest vertex along it
  std::optional<Vertex> next_;       // that reaches across
  Proof proof_ = Proof::second_search;
  Status status_ = Status::undecided;
};

CertifiedCheck::CertifiedCheck(const Scene& scene, const gjk::Result<double>& guess, std::vector<Point> found)
    : course_(std::make_unique<Course>(scene, guess, std::move(found))) {}
CertifiedCheck::~CertifiedCheck() = default;

void CertifiedCheck::operator()(const gjk::Event<double>& event) {
  std::visit([this](const auto& e) { course_->check(e); }, event);
}

const std::vector<std::size_t>& CertifiedCheck::expected() const { return course_->expected(); }

int CertifiedCheck::iteration_of_next(std::size_t kind) const {
  return course_->iteration() + (kind == event_index<gjk::VertexAdded> ? 1 : 0);
}

}  // namespace walkthroughs
