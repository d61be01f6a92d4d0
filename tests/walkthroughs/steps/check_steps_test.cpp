#include "walkthroughs/steps/check_steps.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "core/complete.hpp"
#include "tests/kit/catch.hpp"
#include "walkthroughs/judge/case.hpp"
#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/pairs/named_pair.hpp"
#include "walkthroughs/steps/differences.hpp"
#include "walkthroughs/steps/mistakes.hpp"

namespace walkthroughs::steps {
namespace check_steps_test {

/// The steps that a trace tells, as a program would write them: direction, and the simplex at the end of each iteration.
ToldRun told(const NamedPair& named, const gjk::Trace<double>& trace) {
  ToldRun run{named.name, points_of(named.pair).value()};
  const auto take = [&](const gjk::Simplex<double>& simplex) {
    run.steps.back().simplex.clear();
    for (int i = 0; i < simplex.size(); ++i) run.steps.back().simplex.push_back(simplex[i].w);
  };
  for (const auto& event : trace.events) {
    if (const auto* e = std::get_if<gjk::SupportFound<double>>(&event)) {
      Points kept = run.steps.empty() ? Points{e->vertex.w} : run.steps.back().simplex;
      run.steps.push_back({e->direction, std::move(kept)});
    }
    if (const auto* e = std::get_if<gjk::VertexAdded<double>>(&event)) take(e->simplex);
    if (const auto* e = std::get_if<gjk::SimplexReduced<double>>(&event)) take(e->after);
    if (const auto* e = std::get_if<gjk::Finished<double>>(&event)) run.said = e->result.status;
  }
  return run;
}

/// The same as adapters tell it: the step that ends the search with "no" has no simplex, and is not told.
ToldRun told_at_ends(ToldRun run) {
  if (run.said == gjk::Status::separated && run.steps.size() > 1) run.steps.pop_back();
  return run;
}

/// What is found about a search: the first that is wrong, or may be.
struct Looked {
  int iteration = 0;
  std::string words = {};
  std::vector<std::size_t> mistakes = {};
  bool may_be_rounding = false;
  std::size_t other_choices = 0;
};
Looked look_at(const ToldRun& run) {
  const StepFindings found = check_steps(run).findings;
  Looked looked;
  if (const StepFinding* const wrong = first_wrong(found))
    looked = {wrong->iteration, wrong->words, wrong->mistakes, wrong->kind == StepFinding::rounding};
  looked.other_choices =
      static_cast<std::size_t>(std::ranges::count(found, StepFinding::otherwise, &StepFinding::kind));
  return looked;
}

bool answers_rightly(const Run& run, const PointPair& pair) {
  return (run.status == gjk::Status::intersecting) == (judge::truth_of(pair) == gjk::Status::intersecting);
}
bool misleads_the_report(const NamedPair& named) {
  const PointPair pair = points_of(named.pair).value();
  return !answers_rightly(ask_faithfully(gjk::PointSet<double>(pair.a), gjk::PointSet<double>(pair.b)), pair);
}
/// Whether that mistake answers wrongly, and the report's algorithm rightly.
bool shows(const NamedPair& named, std::size_t mistake) {
  const PointPair pair = points_of(named.pair).value();
  const gjk::PointSet<double> a(pair.a), b(pair.b);
  const Run with = mistakes()[mistake].ask(a, b), without = ask_faithfully(a, b);
  if ((with.status == gjk::Status::intersecting) == (without.status == gjk::Status::intersecting)) return false;
  return answers_rightly(without, pair);
}

std::vector<NamedPair> smallest() {
  std::vector<NamedPair> all = kept_pairs();
  std::erase_if(all,
                [](const NamedPair& each) { return each.family != "smallest" && each.family != "grid-tetrahedra"; });
  return all;
}

model::Scene scene_of(const NamedPair& named) {
  return {.name = named.name,
          .a = {"a", std::get<Points>(named.pair.a)},
          .b = {"b", std::get<Points>(named.pair.b)},
          .dimension = model::Dimension::space};
}

gjk::PointSet<double> set(const Body& body) { return gjk::PointSet<double>(std::get<Points>(body)); }

TEST_CASE(
    "Steps: of every mistake, wherever it shows, the first wrong step is told, and the mistake is among those that "
    "make it",
    "[steps]") {
  int all = 0;
  for (std::size_t m = 0; m < mistakes().size(); ++m)
    for (const NamedPair& named : smallest()) {
      if (!shows(named, m)) continue;
      const ToldRun run = told(named, model::run(model::mistaken(scene_of(named), wrong_on_purpose::Mistake(m))));
      const Looked found = look_at(run);
      INFO("M" << m + 1 << ", " << named.name << ", iteration " << found.iteration << ": " << found.words);
      CHECK((found.iteration > 0 && found.iteration <= static_cast<int>(run.steps.size())));
      CHECK(std::ranges::count(found.mistakes, m) == 1);
      ++all;
    }
  CHECK(all > 1000);
}

TEST_CASE("Steps: of a mistake that ends with no, and does not tell that step, a wrong step is told all the same",
          "[steps]") {
  int all = 0, told_wrong = 0, named = 0;
  for (std::size_t m = 0; m < mistakes().size(); ++m)
    for (const NamedPair& pair : smallest()) {
      const ToldRun run =
          told_at_ends(told(pair, model::run(model::mistaken(scene_of(pair), wrong_on_purpose::Mistake(m)))));
      if (!shows(pair, m) || run.said != gjk::Status::separated ||
          judge::truth_of(points_of(pair.pair).value()) != gjk::Status::intersecting)
        continue;
      const Looked found = look_at(run);
      told_wrong += found.iteration > 0;
      named += std::ranges::count(found.mistakes, m) == 1;
      ++all;
    }
  CHECK(all > 250);
  CHECK(told_wrong >=
        all - 1);  // of one the step that was not told has P·d = 0 but for rounding: either sign may be found
  CHECK(named == told_wrong);
}

TEST_CASE(
    "Steps: who takes touching for apart is told that first, and a wrong side of B only where every vertex is of it",
    "[steps]") {
  constexpr std::size_t wrong_side = 0, touching = 2;
  int all = 0;
  for (const NamedPair& pair : smallest()) {
    if (!shows(pair, touching)) continue;
    const ToldRun run = told(pair, model::run(model::mistaken(scene_of(pair), wrong_on_purpose::Mistake(touching))));
    for (const ToldRun& each : {run, told_at_ends(run)}) {
      const Looked found = look_at(each);
      if (found.iteration == 0) continue;
      INFO(pair.name << ", iteration " << found.iteration << ": " << found.words);
      REQUIRE_FALSE(found.mistakes.empty());
      CHECK(found.mistakes.front() == touching);
      if (each.steps.size() > 2) CHECK(std::ranges::count(found.mistakes, wrong_side) == 0);
      ++all;
    }
  }
  CHECK(all > 20);
}

TEST_CASE("Steps: normals have the report's names, zero has no sign, and numbers are short", "[steps]") {
  for (std::size_t m = 0; m < mistakes().size(); ++m)
    for (const NamedPair& pair : kept_pairs()) {
      if (!std::holds_alternative<Points>(pair.pair.a) || !shows(pair, m)) continue;
      const Looked found =
          look_at(told(pair, model::run(model::mistaken(scene_of(pair), wrong_on_purpose::Mistake(m)))));
      INFO(found.words);
      for (const char* const none : {"ACBn", "ADCn", "ABDn", "= -0 ", "= -0:", "-0,", "-0)"})
        CHECK(found.words.find(none) == std::string::npos);
      std::size_t digits = 0, most = 0;
      for (const char c : found.words) most = std::max(most, digits = c >= '0' && c <= '9' ? digits + 1 : 0);
      CHECK(most <= 10);
    }
}

TEST_CASE("Steps: by hand, each kind of wrong step and its words", "[steps]") {
  const NamedPair far{"far", "f", {Points{{0, 0, 0}, {1, 0, 0}}, Points{{5, 1, 0}, {5, -1, 0}}}};
  const auto words = [&](const std::vector<ToldStep>& steps, gjk::Status said) {
    const Looked found = look_at({far.name, points_of(far.pair).value(), steps, said});
    return std::to_string(found.iteration) + ": " + found.words;
  };
  const ToldStep first{{1, 0, 0}, {{-4, -1, 0}}};
  CHECK(words({first, {{4, 1, 0}, {{-4, -1, 0}}}}, gjk::Status::separated) == "0: ");
  CHECK_THAT(words({{{1, 0, 0}, {{-5, 1, 0}}}}, gjk::Status::undecided),
             kit::contains("1: (-5, 1, 0) is no point of a − b farthest"));
  CHECK_THAT(words({{{1, 0, 0}, {{9, 9, 0}}}}, gjk::Status::undecided),
             kit::contains("1: (9, 9, 0) is no difference a − b of a point of each set"));
  CHECK_THAT(words({first, {{0, 1, 0}, {{-4, -1, 0}}}}, gjk::Status::separated),
             kit::contains("1: from [A], rightly kept, the report searches along (1, 0.25, 0)"));
  CHECK_THAT(words({first, {{0, 0, 0}, {{-4, -1, 0}}}}, gjk::Status::separated),
             kit::contains("yours along (0, 0, 0)"));
  const std::vector<ToldStep> going_on{first, {{4, 1, 0}, {{-4, -1, 0}, {-4, 1, 0}}}, {{1, 0, 0}, {{-4, 1, 0}}}};
  CHECK_THAT(words(going_on, gjk::Status::intersecting), kit::contains("2: P·d = -15 < 0: the origin was not crossed"));
  CHECK_THAT(words(going_on, gjk::Status::separated), !kit::contains("P·d = -15 < 0"));
  CHECK_THAT(words({first, {{4, 1, 0}, {{-4, 1, 0}, {-5, 1, 0}}}}, gjk::Status::separated),
             kit::contains("2: its simplex has 2 vertices"));
  CHECK(words({}, gjk::Status::separated) == "0: ");
  CHECK(words({first}, gjk::Status::separated) == "0: ");
  CHECK_THAT(words({{{0, 0, 0}, {{-4, -1, 0}}}}, gjk::Status::separated),
             kit::contains("1: a search along (0, 0, 0) goes nowhere"));
}

TEST_CASE(
    "Steps: a wrong step on sets so small or large that doubles lose its products is told with that, and no mistake is "
    "named",
    "[steps]") {
  const auto found = [](double size) {
    const NamedPair apart{
        "p", "f", {Points{{0, 0, 0}, {size, 0, 0}}, Points{{5 * size, size, 0}, {5 * size, -size, 0}}}};
    // M4: P·d < 0 is not looked at
    return look_at({apart.name,
                    points_of(apart.pair).value(),
                    {{{size, 0, 0}, {{-4 * size, -size, 0}}},
                     {{4 * size, size, 0}, {{-4 * size, -size, 0}, {-4 * size, size, 0}}},
                     {{size, 0, 0}, {{-4 * size, size, 0}}}},
                    gjk::Status::intersecting});
  };
  for (const double size : {0x1p-260, 0x1p-250, 0x1p-173, 0x1p-172, 1.0, 0x1p+167, 0x1p+168, 0x1p+250, 0x1p+260}) {
    INFO(size);
    const bool is_lost = 5 * size < 0x1p-170 || 5 * size > 0x1p+170;
    CHECK(found(size).iteration == 2);
    CHECK(found(size).mistakes.empty() == is_lost);
    CHECK((found(size).words.find("no line wrong") != std::string::npos) == is_lost);
    if (!is_lost) continue;
    CHECK_THAT(found(size).words, kit::contains(size < 1 ? "lengths vanish" : "lengths overflow"));
    CHECK_THAT(found(size).words, kit::contains(size < 0x1p-255 || size > 0x1p+255 ? " of four" : " of six"));
  }
}

/// Algorithm 5 with its faces looked at in another order: as right as the report's.
struct FacesFromTheLast : gjk::AsIntended {
  template <class Rules, class S, class Obs>
  static gjk::Next<S> process_3simplex(gjk::detail::Step<Rules, S, Obs> step) {
    const auto AO = step.AO();
    const auto AB = step.AB(), AC = step.AC(), AD = step.AD();
    const auto ABCn = Rules::ABCn(AB, AC).named(gjk::NamedVector::normal("ABC"));
    const auto ACDn = Rules::ACDn(AC, AD).named(gjk::NamedVector::normal("ACD"));
    const auto ADBn = Rules::ADBn(AD, AB).named(gjk::NamedVector::normal("ADB"));
    if (step.is_above_face({.feature = "ADB"}, ADBn.dot(AO)))
      return Rules::process_face(step, gjk::Face::ADB, ADBn, AD, AB, ABCn, ABCn);
    if (step.is_above_face({.feature = "ACD"}, ACDn.dot(AO)))
      return Rules::process_face(step, gjk::Face::ACD, ACDn, AC, AD, ABCn, ABCn);
    if (step.is_above_face({.feature = "ABC"}, ABCn.dot(AO)))
      return Rules::process_face(step, gjk::Face::ABC, ABCn, AB, AC, ABCn, ABCn);
    return step.contains_origin();
  }
};

/// The same, with the normal of ADB turned inward: M17 in another order.
struct FacesFromTheLastInward : FacesFromTheLast {
  static auto ADBn(const auto& AD, const auto& AB) { return AB.cross(AD); }
};

template <class Rules>
ToldRun told_by(const NamedPair& named) {
  gjk::Trace<double> trace;
  const gjk::PointSet<double> a = set(named.pair.a), b = set(named.pair.b);
  gjk::collision<double, Rules>(a, b, gjk::Options<double>{}, trace);
  return told(named, trace);
}

/// The steps of a search whose x, y and z are another's y, z and x, or z, x and y: sums of products are rounded in another order.
ToldRun told_with_turned_axes(const NamedPair& named, int turns) {
  const auto turned = [](const Vec& v, int by) { return Vec(v[by % 3], v[(by + 1) % 3], v[(by + 2) % 3]); };
  NamedPair other = named;
  for (Body* const body : {&other.pair.a, &other.pair.b})
    for (Vec& p : std::get<Points>(*body)) p = turned(p, turns);
  ToldRun run = told_by<gjk::AsIntended>(other);
  run.pair = points_of(named.pair).value();
  for (ToldStep& step : run.steps) {
    step.direction = turned(step.direction, 3 - turns);
    for (Vec& v : step.simplex) v = turned(v, 3 - turns);
  }
  return run;
}

/// Pairs of points whose answer is not lost in rounding, nor any product beyond all doubles.
std::vector<NamedPair> plain_pairs() {
  std::vector<NamedPair> all = kept_pairs();
  std::erase_if(all, [](const NamedPair& each) {
    return !std::holds_alternative<Points>(each.pair.a) || each.family.ends_with("100") || misleads_the_report(each);
  });
  return all;
}

TEST_CASE(
    "Steps: the report's algorithm is not blamed, whatever the length of its directions and the order of its vertices",
    "[steps]") {
  for (const NamedPair& named : plain_pairs()) {
    ToldRun run = told_by<gjk::AsIntended>(named);
    Looked found = look_at(run);
    INFO(named.name << ": " << found.words);
    CHECK(found.iteration == 0);
    CHECK(found.other_choices == 0);
    CHECK(look_at(told_at_ends(run)).words.empty());
    if (named.family != "smallest") continue;
    for (ToldStep& step : run.steps) {
      step.direction /= step.direction.stableNorm();
      std::ranges::reverse(step.simplex);
    }
    found = look_at(run);
    INFO(found.words);
    CHECK(found.iteration == 0);
  }
}

TEST_CASE("Steps: who takes the first point before the loop is not blamed, and a wrong step is told as if it were told",
          "[steps]") {
  int all = 0;
  for (const bool is_newest_first : {false, true})
    for (const std::optional<std::size_t> m : {std::optional<std::size_t>(), std::optional<std::size_t>(8)})
      for (const NamedPair& named : smallest()) {
        const model::Scene scene = scene_of(named);
        ToldRun run = told(named, model::run(m ? model::mistaken(scene, wrong_on_purpose::Mistake(*m)) : scene));
        if (run.steps.size() < 2 || run.steps[1].simplex.size() != 2) continue;
        const Looked whole = look_at(run);
        run.steps.erase(run.steps.begin());
        if (is_newest_first)
          for (ToldStep& step : run.steps) std::ranges::reverse(step.simplex);
        bring_to_differences(run);
        const Looked found = look_at(run);
        INFO(named.name << ": " << found.words);
        CHECK(found.iteration == whole.iteration);
        if (!is_newest_first) {  // of a short search the order may not be seen
          CHECK(found.words == whole.words);
          CHECK(found.mistakes == whole.mistakes);
        }
        ++all;
      }
  CHECK(all > 1000);
}

TEST_CASE("Steps: who begins with more is told to tell more, and a direction that does not change is told as that",
          "[steps]") {
  const NamedPair far{"far", "f", {Points{{0, 0, 0}, {1, 0, 0}}, Points{{5, 1, 0}, {5, -1, 0}}}};
  const auto found = [&](const std::vector<ToldStep>& steps) {
    return check_steps({far.name, points_of(far.pair).value(), steps, gjk::Status::separated}).findings;
  };
  const StepFindings begins = found({{{0, 1, 0}, {{-4, -1, 0}, {-5, -1, 0}, {-4, 1, 0}}}});
  REQUIRE(begins.size() == 1);
  CHECK(begins.front().kind == StepFinding::otherwise);
  CHECK_THAT(begins.front().words, kit::contains("it begins with 3 vertices"));
  const StepFindings goes_on = found({{{1, 0, 0}, {{-4, -1, 0}}}, {{1, 0, 0}, {{-4, -1, 0}, {-4, 1, 0}}}});
  REQUIRE(first_wrong(goes_on));
  CHECK(first_wrong(goes_on)->keeps_direction);
  CHECK_THAT(first_wrong(goes_on)->words, kit::contains("yours as before, along (1, 0, 0)"));
}

namespace {

/// A search that keeps a triangle in an order from which the next faces point inward, and then `kept`.
Looked checked_behind_an_order(const Points& kept) {
  const std::vector<NamedPair> all = kept_pairs();
  const auto pair = std::ranges::find(all, std::string("one-ulp-885"), &NamedPair::name);
  REQUIRE(pair != all.end());
  const Vec D(4, 4, 0x1p-48), C(-13, -11, -7), B(-1, -14, -2);
  return look_at({pair->name,
                  points_of(pair->pair).value(),
                  {{Vec(1, 0, 0), {Vec(7, -11, -8)}},
                   {Vec(-7, 11, 8), {Vec(7, -11, -8), D}},
                   {Vec(-1336.0000000000005, -471.99999999999977, 383.99999999999932), {D, C}},
                   {Vec(-75.999999999999801, -331.99999999999977, 895.99999999999864), {D, C, B}},
                   {Vec(-96.000000000000014, 0.99999999999995737, 231), kept},
                   {Vec(7, 6, -0x1p-48), {kept.back()}}},
                  {}});
}

const Vec newest(-7, -6, 0x1p-48);

}  // namespace

TEST_CASE("Steps: an order is to blame also where the program tests more than the report", "[steps]") {
  const Looked found = checked_behind_an_order({newest});
  INFO(found.words);
  CHECK(found.iteration == 4);
  CHECK(found.mistakes == std::vector<std::size_t>{13});
}

TEST_CASE("Steps: what decides is told in the letters of the simplex that was told", "[steps]") {
  const Looked found = checked_behind_an_order({Vec(4, 4, 0x1p-48), Vec(-13, -11, -7), newest});
  INFO(found.words);
  CHECK(found.iteration == 5);
  // AB×AD·AO of the places told, not that of vertices in the order in which the report would have them.
  CHECK(found.words.starts_with("from [D, C, B, A] the report finds ADBn·AO = -8 < 0: keep [D, B, A];"));
}

TEST_CASE("Steps: with its faces tested in another order it is not blamed, and told where it chose otherwise",
          "[steps]") {
  std::size_t other_choices = 0;
  for (const NamedPair& named : plain_pairs()) {
    const ToldRun run = told_by<FacesFromTheLast>(named);
    if (run.said == gjk::Status::undecided) continue;
    const Looked found = look_at(run);
    INFO(named.name << ": " << found.words);
    CHECK(found.iteration == 0);
    other_choices += found.other_choices;
  }
  CHECK(other_choices >= 5);
}

TEST_CASE("Steps: who keeps the feature nearest to the origin is not blamed, on the border of a region either",
          "[steps]") {
  int otherwise = 0;
  for (const NamedPair& named : plain_pairs()) {
    const ToldRun run = told_by<gjk::Complete<>>(named);
    for (const ToldRun& each : {run, told_at_ends(run)}) {
      const Looked found = look_at(each);
      INFO(named.name << ": " << found.words);
      CHECK(found.iteration == 0);
      otherwise += found.other_choices > 0;
    }
  }
  CHECK(otherwise > 10);
}

TEST_CASE("Steps: of a search that rounds otherwise, as with its axes in another order, no mistake is named",
          "[steps]") {
  int blamed = 0;
  for (const NamedPair& named : kept_pairs()) {
    if (!std::holds_alternative<Points>(named.pair.a) || named.family.ends_with("100")) continue;
    for (const ToldRun& run : {told_with_turned_axes(named, 1), told_with_turned_axes(named, 2)}) {
      const Looked found = look_at(run);
      INFO(named.name << ", iteration " << found.iteration << ": " << found.words);
      CHECK(found.mistakes.empty());
      if (found.iteration == 0) continue;
      CHECK(found.may_be_rounding);
      CHECK_THAT(found.words, kit::contains("of vertices moved by a few roundings the report does the same"));
      ++blamed;
    }
  }
  CHECK(blamed == 2);
}

TEST_CASE("Steps: rounding excuses no mistake that shows where numbers vanish, or where nothing rounds", "[steps]") {
  const Points triangle{{-.3, -.7, 0}, {.9, -.2, 0}, {-.1, .8, 0}}, tenths{{.1, .7, -.3}, {.2, .7, -.3}, {.1, .8, -.2}};
  const Points tetrahedron{{-.3, -.7, 0}, {.9, -.2, 0}, {-.1, .8, 0}, {.2, .1, -.9}}, origin{{0, 0, 0}};
  const NamedPair pairs[] = {{"triangle", "f", {triangle, origin}},
                             {"tetrahedron", "f", {tetrahedron, origin}},
                             {"segment", "f", {Points{{-.3, 0, 0}, {.7, 0, 0}}, origin}},
                             {"vertex", "f", {tenths, Points{tenths[1]}}},
                             {"halves", "f", {Points{{-1.5, -.5, 0}, {2.5, -.5, 0}, {-1, 1.5, 0}}, origin}}};
  std::set<std::size_t> all;
  for (std::size_t m = 0; m < mistakes().size(); ++m)
    for (const NamedPair& pair : pairs) {
      const Looked found =
          look_at(told(pair, model::run(model::mistaken(scene_of(pair), wrong_on_purpose::Mistake(m)))));
      if (found.iteration == 0) continue;
      INFO("M" << m + 1 << ", " << pair.name << ", iteration " << found.iteration << ": " << found.words);
      CHECK_FALSE(found.may_be_rounding);
      CHECK(std::ranges::count(found.mistakes, m) == 1);
      all.insert(m);
    }
  CAPTURE(all);
  for (const std::size_t origin_missed : {4, 5}) CHECK(all.contains(origin_missed));
}

TEST_CASE("Steps: ways of telling them that are often mixed up are told as that", "[steps]") {
  const std::vector<NamedPair> all = kept_pairs();
  const ToldRun sound =
      told_at_ends(told_by<gjk::AsIntended>(*std::ranges::find(all, std::string("m18-1"), &NamedPair::name)));
  REQUIRE(sound.steps.size() >= 2);
  REQUIRE(look_at(sound).iteration == 0);
  ToldRun run = sound;
  for (ToldStep& step : run.steps)
    for (Vec& v : step.simplex) v = -v;
  CHECK_THAT(look_at(run).words, kit::contains("but one b − a: steps are told with a − b"));
  run = sound;
  for (ToldStep& step : run.steps) step.direction = -step.direction;
  CHECK_THAT(look_at(run).words, kit::contains("every vertex is farthest the opposite way"));
  run = sound;
  run.steps[1].direction = -run.steps[1].direction;
  CHECK_THAT(look_at(run).words, kit::contains("yours the opposite way, along"));
  run = sound;
  for (std::size_t i = 0; i + 1 < run.steps.size(); ++i) run.steps[i].direction = run.steps[i + 1].direction;
  CHECK_THAT(look_at(run).words,
             kit::contains("told is the direction that was searched along, not the one that follows"));
}

TEST_CASE("Steps: a simplex that was not reduced, and a search that goes round, are told as that", "[steps]") {
  const std::vector<NamedPair> all = kept_pairs();
  const auto named = [&](const std::string& name) { return *std::ranges::find(all, name, &NamedPair::name); };
  ToldRun run = told_by<gjk::AsIntended>(named("cycles-1"));
  REQUIRE(run.said == gjk::Status::undecided);
  run.said = gjk::Status::separated;
  CHECK_THAT(look_at(run).words,
             kit::contains("; it goes round: step ") && kit::contains("a limit of iterations may have"));
  run = told_by<gjk::AsIntended>(named("m18-1"));
  const auto smaller = std::ranges::adjacent_find(
      run.steps, [](const ToldStep& x, const ToldStep& y) { return x.simplex.size() >= y.simplex.size(); });
  REQUIRE(smaller != run.steps.end());
  Points unreduced = smaller->simplex;
  for (const Vec& v : (smaller + 1)->simplex)
    if (std::ranges::find(unreduced, v) == unreduced.end()) unreduced.push_back(v);
  (smaller + 1)->simplex = unreduced;
  CHECK_THAT(look_at(run).words, kit::contains("all of them (told is the simplex after it was reduced)"));
}

TEST_CASE("Steps: a mistake is named whatever the order of the faces, and why the origin lies inside is told",
          "[steps]") {
  constexpr std::size_t abc_inward = 14, adb_inward = 16;
  int all = 0, named = 0, inside = 0;
  for (const NamedPair& pair : smallest()) {
    if (!std::holds_alternative<Points>(pair.pair.a)) continue;
    const Looked found = look_at(told_by<FacesFromTheLastInward>(pair));
    if (found.iteration == 0) continue;
    ++all;
    // In another order of B, C and D the face may be another.
    named += std::ranges::any_of(found.mistakes, [](auto m) { return m >= abc_inward && m <= adb_inward; });
    if (found.words.find("the origin lies in it") == std::string::npos) continue;
    ++inside;
    CHECK(found.words.find("the report finds ABCn·AO = ") != std::string::npos);
    CHECK(found.words.find("ADBn·AO = ") != std::string::npos);
  }
  CAPTURE(all, named, inside);
  CHECK(all > 20);
  CHECK(inside > 5);
  CHECK(named == all);
}

TEST_CASE("Steps: a wrong vertex is that of B's wrong side only where all that are told are", "[steps]") {
  const NamedPair pair{"p", "f", {Points{{-1, 0, 0}, {-2, 0, 0}}, Points{{3, 0, 0}, {4, 1, 0}}}};
  const auto found = [&](const Vec& later) {
    return look_at({pair.name,
                    points_of(pair.pair).value(),
                    {{{1, 0, 0}, {{-5, -1, 0}}}, {{0, -1, 0}, {{-5, -1, 0}, later}}},
                    gjk::Status::separated});
  };
  for (const Vec& later : {Vec(-4, 0, 0), Vec(-6, -1, 0)}) CHECK(found(later).iteration == 1);
  CHECK(found({-4, 0, 0}).mistakes == std::vector<std::size_t>{0});  // along (0, -1, 0) of A and B
  CHECK(found({-6, -1, 0}).mistakes.empty());                        // along (0, -1, 0) of A, and (0, 1, 0) of B
}

}  // namespace check_steps_test
}  // namespace walkthroughs::steps
