#include "tests/study/sweep/plan.hpp"

#include <algorithm>

#include "tests/study/methods/all_methods.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/text/names.hpp"

namespace study {
namespace {

// -- How many pairs ---------------------------------------------------------------------------------------------------

/// About how many pairs of triangles take as long as a pair of this family. Round bodies that nearly touch take all the
/// iterations that there are.
std::uint64_t weight_of(const Family& family, std::uint64_t seed) {
  const Pair first = family.make(seed, 0);
  const auto *const a = std::get_if<Points>(&first.a), *const b = std::get_if<Points>(&first.b);
  if (!a || !b) return 5;
  const std::size_t most = std::max(a->size(), b->size());
  return most <= 8 ? 1 : most <= 32 ? 4 : 10;
}

constexpr std::uint64_t worth_exhausting = 600'000;  // a full run asks all pairs of a list up to this length

/// On two cores a full run takes some 25 minutes, and a quick one less than one.
Part part_of(const Family& family, const Request& request) {
  const std::uint64_t weight = weight_of(family, request.seed), usual_slow = (request.is_full ? 10000 : 60) / weight;
  std::uint64_t pairs = request.pairs.value_or((request.is_full ? 500000 : 3000) / weight);
  if (family.size) {
    const bool to_the_last = request.is_full && !request.pairs && *family.size <= worth_exhausting;
    pairs = to_the_last ? *family.size : std::min(pairs, *family.size);
  }
  const std::uint64_t slow = request.pairs ? std::max<std::uint64_t>(pairs / 50, 1) : usual_slow;
  return {&family, pairs, std::min(slow, pairs)};
}

// -- What is chosen ---------------------------------------------------------------------------------------------------

void expect_known(const std::vector<std::string>& chosen, const std::vector<std::string>& known,
                  const std::string& what) {
  for (const std::string& name : chosen)
    if (std::ranges::find(known, name) == known.end())
      throw UsageError("there is no " + what + " '" + name + "'; did you mean '" +
                       walkthroughs::text::nearest(name, known) + "'? 'gjkstep-study list' shows them");
}

bool is_chosen(const std::vector<std::string>& chosen, const std::string& name) {
  return chosen.empty() || std::ranges::find(chosen, name) != chosen.end();
}

std::vector<const Method*> chosen_methods(const Request& request) {
  std::vector<std::string> rules, zero_tests, scalars;
  std::vector<const Method*> chosen;
  for (const Method& method : all_methods()) {
    rules.push_back(method.rules);
    zero_tests.push_back(method.zero_test);
    scalars.push_back(method.scalar.name);
    if (is_chosen(request.rules, method.rules) && is_chosen(request.zero_tests, method.zero_test) &&
        is_chosen(request.scalars, method.scalar.name))
      chosen.push_back(&method);
  }
  expect_known(request.rules, rules, "set of rules");
  expect_known(request.zero_tests, zero_tests, "zero test");
  expect_known(request.scalars, scalars, "scalar");
  if (chosen.empty()) throw UsageError("no setting is left; 'gjkstep-study list' shows them");
  return chosen;
}

std::vector<int> limits_of(const Request& request) {
  std::vector<int> chosen = request.limits;
  if (chosen.empty()) chosen.assign(std::begin(limits), std::end(limits));
  std::ranges::sort(chosen);
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

// -- Words ------------------------------------------------------------------------------------------------------------

std::string option(const std::string& name, const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? " " + name + " " : ",") + value;
  return text;
}

}  // namespace

std::vector<const Family*> families_called(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const Family& family : families()) known.push_back(family.name);
  expect_known(names, known, "family");
  std::vector<const Family*> chosen;
  for (const Family& family : families())
    if (is_chosen(names, family.name)) chosen.push_back(&family);
  return chosen;
}

Plan plan_of(const Request& request) {
  Plan plan;
  plan.seed = request.seed;
  plan.methods = chosen_methods(request);
  for (const Family* const family : families_called(request.families)) plan.parts.push_back(part_of(*family, request));
  plan.limits = limits_of(request);
  return plan;
}

std::string command_of(const Request& request) {
  std::string text = "gjkstep-study run";
  if (request.pairs)
    text += " --pairs " + std::to_string(*request.pairs);
  else
    text += request.is_full ? " --full" : " --quick";
  std::vector<std::string> limits;
  for (const int limit : request.limits) limits.push_back(std::to_string(limit));
  return text + " --seed " + std::to_string(request.seed) + option("--families", request.families) +
         option("--rules", request.rules) + option("--scalar", request.scalars) +
         option("--zero-test", request.zero_tests) + option("--limit", limits);
}

Shard parse_shard(const std::string& text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto index = walkthroughs::text::decimal<std::uint64_t>(text.substr(0, slash)),
             count = walkthroughs::text::decimal<std::uint64_t>(text.substr(std::min(slash + 1, text.size())));
  if (!index || !count || *index >= *count)
    throw UsageError("--shard: expected I/N with I from 0 to N - 1, such as 0/8, found '" + text + "'");
  return {*index, *count};
}

}  // namespace study
