#include "tests/study/methods/mistakes.hpp"

#include <optional>
#include <set>

#include "tests/core/replay.hpp"
#include "tests/kit/catch.hpp"
#include "tests/study/claims/claims_measured.hpp"
#include "tests/study/pairs/families.hpp"
#include "tests/study/pairs/random_triangles.hpp"
#include "walkthroughs/wrong_on_purpose/rules.hpp"

namespace study {
namespace {

using V = gjk::Vec3<double>;
using gjk::Verdict;

bool stands(double value, gjk::Relation relation) {
  switch (relation) {
    case gjk::Relation::positive: return value > 0;
    case gjk::Relation::negative: return value < 0;
    case gjk::Relation::zero: return value == 0;
    case gjk::Relation::not_zero: return value != 0;
    case gjk::Relation::not_negative: return value >= 0;
  }
  return false;
}

/// Follows the events of a run with a mistake in it, and asks whether they say what was done.
class Witness {
 public:
  void operator()(const gjk::SupportFound<double>& e) {
    if (direction_) REQUIRE(e.direction == *direction_);
    vertex_ = e.vertex;
  }
  void operator()(const gjk::VertexAdded<double>& e) {
    gjk::Simplex<double> expected = simplex_;
    expected.add(vertex_);
    REQUIRE(e.simplex == expected);
    simplex_ = e.simplex;
    letters_.emplace(simplex_);
    edges_.clear();
  }
  void operator()(const gjk::RegionTested<double>& e) {
    if (e.normal) {
      const std::string name = e.expression.substr(0, e.expression.find("·"));
      letters_->name(name, *e.normal);
      REQUIRE(std::get<double>(e.value) == letters_->number(e.expression));
      edges_.push_back(e);
      if (e.simplex_size == 4 || name == "ABCn") require_formulas();
    }
    if (const double* value = std::get_if<double>(&e.value))
      REQUIRE(stands(*value, e.relation) == (e.verdict == Verdict::chosen));
    if (const V* value = std::get_if<V>(&e.value)) {
      REQUIRE(*value == letters_->vector(e.expression));
      REQUIRE((e.relation == gjk::Relation::zero) == (*value == V(0, 0, 0)));
    }
    told_.insert(e.face + " " + e.feature + " " + e.formula);
    told_.insert(e.reason);
  }
  void operator()(const gjk::SimplexReduced<double>& e) {
    REQUIRE(e.before == simplex_);
    REQUIRE(e.kept.size() == static_cast<std::size_t>(e.after.size()));
    for (int i = 0; i < e.after.size(); ++i)
      REQUIRE(e.after[i] == e.before[static_cast<gjk::Role>(e.kept[static_cast<std::size_t>(i)] - 'A')]);
    told_.insert(std::to_string(e.before.size()) + " keeps " + e.kept);
    simplex_ = e.after;
  }
  void operator()(const gjk::DirectionChosen<double>& e) {
    REQUIRE(e.direction == letters_->vector(e.expression));
    told_.insert("along " + e.expression);
    direction_ = e.direction;
  }
  template <class E>
  void operator()(const E&) {}

  /// Everything that has been told, in words.
  const std::set<std::string>& told() const { return told_; }
  /// The next run.
  void start_again() {
    direction_.reset();
    simplex_ = {};
  }

 private:
  /// A triangle's ABn and ACn are told before the ABCn that is in their formulas.
  void require_formulas() {
    for (const auto& e : edges_) REQUIRE(*e.normal == letters_->vector(e.formula));
    edges_.clear();
  }

  gjk::Simplex<double> simplex_;
  gjk::Vertex<double> vertex_;
  std::optional<V> direction_;
  std::optional<gjk::test::Letters<double>> letters_;
  std::vector<gjk::RegionTested<double>> edges_;
  std::set<std::string> told_;
};

/// Returns: what a run of such rules tells of many pairs, in words; each event has been looked at.
template <class Rules>
std::set<std::string> told_by() {
  Witness witness;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    INFO("pair " << i);
    Dice dice(5, "mistakes", i);
    for (const Pair& pair :
         {coarse_triangles(dice, 4, 1), coarse_triangles(dice, 2, 1), family_named("tetrahedra").make(5, i)}) {
      const gjk::PointSet<double> a(std::get<Points>(pair.a)), b(std::get<Points>(pair.b));
      witness.start_again();
      gjk::collision<double, Rules>(a, b, gjk::Options<double>{}, witness);
    }
  }
  return witness.told();
}

/// Asks for words that rules with this mistake tell and the right ones do not.
template <class Rules>
void require_telling(const std::string& words) {
  static const std::set<std::string> right = told_by<gjk::AsIntended>();
  const std::set<std::string> wrong = told_by<Rules>();
  INFO(words);
  REQUIRE(wrong.count(words) == 1);
  REQUIRE(right.count(words) == 0);
}

TEST_CASE("Events of a mistake tell what it does: its formulas, what it keeps, where it searches", "[mistakes]") {
  using namespace walkthroughs::wrong_on_purpose;
  require_telling<TriangleNormalReversed>(" ABC AC×AB");
  require_telling<TriangleABnInward>(" AB ABCn×AB");
  require_telling<TriangleACnInward>(" AC AC×ABCn");
  require_telling<ABCnInward>(" ABC AC×AB");
  require_telling<ACDnInward>(" ACD AD×AC");
  require_telling<ADBnInward>(" ADB AB×AD");
  require_telling<EdgeNormalReused>("ACD AC ABCn×AC");
  require_telling<EdgeNormalReused>("ADB AD ACDn×AD");
  require_telling<ABnReusedForADB>("ADB AB AB×ABCn");
  require_telling<OrderKeptBelowTriangle>("3 keeps CBA");
  require_telling<OrderOfADB>("4 keeps DBA");
  require_telling<EdgeNormalAsDirection>("along ABn");
  require_telling<EdgeNormalAsDirection>("along ACn");
  REQUIRE(told_by<DirectionFromVertex>().count("along AB×AO×AB") == 0);
}

TEST_CASE("Where a mistake decides otherwise than its numbers say, the reason tells both", "[mistakes]") {
  using namespace walkthroughs::wrong_on_purpose;
  const std::string as_if = ", but these rules go on as if ";
  require_telling<OriginAtVertexMissed>("A is the origin" + as_if + "the origin lies elsewhere");
  require_telling<OriginOnSegmentMissed>("the origin lies on AB" + as_if + "the origin lies to one side of AB");
  require_telling<DirectionFromVertex>(
      "AO is not zero, from which these rules conclude: the origin lies to one side of AB");
  require_telling<OriginInTriangleMissed>("the origin lies in the triangle" + as_if +
                                          "the origin lies below the triangle, on the side of −ABCn");
  require_telling<TwoDimensionsOnly>("the origin lies above the triangle, on the side of ABCn" + as_if +
                                     "the origin lies in the triangle");
  require_telling<OriginInFaceSeenOutside>("ABCn does not point toward the origin" + as_if +
                                           "ABCn points toward the origin");
}

TEST_CASE("Every mistake changes some runs, and all have names of their own", "[mistakes]") {
  const ClaimsOptions options{.pairs = 3000, .seed = 1, .threads = 2};
  MistakeTable all = measure_mistakes(TestPairs::grid_triangles, options);
  all += measure_mistakes(TestPairs::tetrahedra, options);
  std::set<std::string> names;
  for (std::size_t i = 0; i < mistakes().size(); ++i) {
    INFO(mistakes()[i].name);
    REQUIRE(all.counts[i].changed.count > 0);
    REQUIRE(names.insert(mistakes()[i].name).second);
  }
}

TEST_CASE("A mistake that is asked about a pair by hand: the zero direction, the first point, the wrong side",
          "[mistakes]") {
  const auto ask = [](const std::string& part, const Points& a, const Points& b) {
    for (const Mistake& mistake : mistakes())
      if (mistake.name.find(part) != std::string::npos)
        return mistake.ask(gjk::PointSet<double>(a), gjk::PointSet<double>(b)).status;
    throw std::invalid_argument("no mistake is called " + part);
  };
  const Points origin{{0, 0, 0}};
  using gjk::Status;
  REQUIRE(ask("first vertex", origin, origin) == Status::undecided);
  REQUIRE(ask("the segment is not", {{1, 0, 0}, {-1, 0, 0}}, origin) == Status::undecided);
  REQUIRE(ask("first point", {{-1, 0, 0}, {-2, 0, 0}}, origin) == Status::separated);
  REQUIRE(ask("first point", {{1, 0, 0}, {-2, 0, 0}}, origin) == Status::intersecting);
  REQUIRE(ask("<=", {{1, 0, 0}, {0, 0, 0}}, origin) == Status::separated);
  REQUIRE(ask("as printed", {{5, 0, 0}}, origin) == Status::intersecting);
  REQUIRE(ask("support(B, d)", {{3, 0, 0}, {2, 0, 0}}, {{0, 0, 0}, {2.5, 0, 0}}) == Status::separated);
}

}  // namespace
}  // namespace study
