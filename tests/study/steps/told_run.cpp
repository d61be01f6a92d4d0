#include "tests/study/steps/told_run.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "walkthroughs/pairs/named_pair.hpp"
#include "walkthroughs/text/document.hpp"
#include "walkthroughs/text/scene_limits.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace study {
namespace {

using walkthroughs::judge::ProgramAnswer;
using walkthroughs::judge::read_answer;
using walkthroughs::pairs::for_each_line;
using walkthroughs::pairs::pair_of_line;
using walkthroughs::pairs::require_good;
using walkthroughs::text::Document;
using walkthroughs::text::Value;
using Kind = Document::Kind;

Vec vec_in(const Value& value) {
  const std::vector<Value> numbers = value.children();
  if (!value.is(Kind::list) || numbers.size() != 3) value.fail("must be [x, y, z]");
  Vec v = Vec::Zero();
  for (std::size_t i = 0; i < 3 && value.is_good(); ++i) {
    if (!numbers[i].is(Kind::number)) numbers[i].fail("must be a number");
    v[static_cast<Eigen::Index>(i)] = numbers[i].number();
  }
  return v;
}

Vec point_in(const Value& value) {
  const Vec p = vec_in(value);
  if (!(p.cwiseAbs().maxCoeff() <= walkthroughs::text::scene_limits::magnitude)) value.fail("is too far away");
  return p;
}

/// Returns: the direction in numbers whose products with points no double is too small for: only their ratios count.
Vec direction_in(const Value& value) {
  const Vec d = vec_in(value);
  const double most = d.cwiseAbs().maxCoeff();
  return most > walkthroughs::text::scene_limits::magnitude ? Vec(d * std::ldexp(1.0, -std::ilogb(most))) : d;
}

ToldStep step_in(const Value& root) {
  const auto direction = root.member("direction"), simplex = root.member("simplex");
  if (!direction || !simplex) throw std::invalid_argument("a step has a \"direction\" and a \"simplex\"");
  ToldStep step{direction_in(*direction), {}};
  const std::vector<Value> points = simplex->children();
  if (!simplex->is(Kind::list) || points.empty() || points.size() > 4)
    simplex->fail("must be a list of one to four points [x, y, z]");
  for (const Value& point : points) step.simplex.push_back(point_in(point));
  return step;
}

bool is_of_points(const NamedPair& named) {
  return std::holds_alternative<Points>(named.pair.a) && std::holds_alternative<Points>(named.pair.b);
}

/// What one line adds.
void add_line(std::string_view line, std::size_t number, std::vector<ToldRun>& runs) {
  const Document document = Document::of_line(line);
  require_good(document);
  const Value root = document.root();
  if (root.member("a")) {
    runs.push_back({pair_of_line(line, "line-" + std::to_string(number)), {}, {}});
    if (!is_of_points(runs.back().named))
      throw std::invalid_argument("only searches in sets of points can be followed");
    return;
  }
  if (runs.empty()) throw std::invalid_argument("the first line must be a pair {\"a\": …, \"b\": …}");
  ToldRun& run = runs.back();
  if (run.said) throw std::invalid_argument("comes after the answer; the next search begins with its pair");
  if (const ProgramAnswer answer = read_answer(line, run.named.pair); answer.said != Said::nothing)
    run.said = answer.said;
  else
    run.steps.push_back(step_in(root));
  require_good(document);
}

/// Whether each step that adds a vertex to others has it first, and two steps at least do so.
bool is_newest_first(const std::vector<ToldStep>& steps) {
  int seen = 0;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const std::vector<Vec>&before = steps[i - 1].simplex, &now = steps[i].simplex;
    const auto is_new = [&](const Vec& v) { return std::ranges::find(before, v) == before.end(); };
    if (now.size() < 2 || std::ranges::count_if(now, is_new) != 1) continue;
    if (!is_new(now.front())) return false;
    ++seen;
  }
  return seen >= 2;
}

}  // namespace

std::vector<ToldRun> read_told_runs(std::string_view text, const std::string& file) {
  std::vector<ToldRun> runs;
  for_each_line(text, file, [&](std::string_view line, std::size_t number) { add_line(line, number, runs); });
  if (runs.empty()) throw walkthroughs::text::InputError(file + ": is empty; the first line must be a pair");
  for (ToldRun& run : runs)
    if (is_newest_first(run.steps))
      for (ToldStep& step : run.steps) std::ranges::reverse(step.simplex);
  return runs;
}

}  // namespace study
