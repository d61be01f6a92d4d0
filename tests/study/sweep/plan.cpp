#include "tests/study/sweep/plan.hpp"

#include <algorithm>
#include <charconv>

#include "tests/study/methods/all_methods.hpp"
#include "walkthroughs/text/nearest.hpp"

namespace study {
namespace {

// -- How many pairs ---------------------------------------------------------------------------------------------------

/// Returns: 0 for a body that has no corners.
std::size_t points_in(const Body& body) {
  const Points* const points = std::get_if<Points>(&body);
  return points ? points->size() : 0;
}

/// About how many pairs of triangles take as long as a pair of this family. Round bodies that nearly touch take all the
/// iterations that there are.
std::uint64_t weight_of(const Family& family, std::uint64_t seed) {
  const Pair first = family.make(seed, 0);
  const std::size_t least = std::min(points_in(first.a), points_in(first.b));
  const std::size_t most = std::max(points_in(first.a), points_in(first.b));
  return least == 0 ? 5 : most <= 8 ? 1 : most <= 32 ? 4 : 10;
}

struct Amount {
  std::uint64_t pairs, slow_pairs;
};

/// On two cores: some 25 minutes, and less than one.
Amount amount_of(Scope scope) { return scope == Scope::full ? Amount{500000, 10000} : Amount{3000, 60}; }

constexpr std::uint64_t worth_exhausting = 600'000;  // a full run asks all pairs of a list up to this length

Part part_of(const Family& family, const Request& request) {
  const Amount amount = amount_of(request.scope);
  const std::uint64_t weight = weight_of(family, request.seed);
  std::uint64_t pairs = request.pairs.value_or(amount.pairs / weight);
  if (family.size) {
    const bool to_the_last = request.scope == Scope::full && !request.pairs && *family.size <= worth_exhausting;
    pairs = to_the_last ? *family.size : std::min(pairs, *family.size);
  }
  const std::uint64_t slow = request.pairs ? std::max<std::uint64_t>(pairs / 50, 1) : amount.slow_pairs / weight;
  return {&family, pairs, std::min(slow, pairs)};
}

// -- What is chosen ---------------------------------------------------------------------------------------------------

std::vector<std::string> names_of(std::string Method::*name) {
  std::vector<std::string> names;
  for (const Method& method : all_methods()) names.push_back(method.*name);
  return names;
}

std::vector<std::string> scalar_names() {
  std::vector<std::string> names;
  for (const Method& method : all_methods()) names.push_back(method.scalar.name);
  return names;
}

void expect_known(const std::vector<std::string>& chosen, const std::vector<std::string>& known,
                  const std::string& what) {
  for (const std::string& name : chosen)
    if (std::ranges::find(known, name) == known.end())
      throw UsageError("there is no " + what + " '" + name + "'; did you mean '" + walkthroughs::nearest(name, known) +
                       "'? 'gjkstep-study list' shows them");
}

bool is_chosen(const std::vector<std::string>& chosen, const std::string& name) {
  return chosen.empty() || std::ranges::find(chosen, name) != chosen.end();
}

std::vector<const Method*> chosen_methods(const Request& request) {
  expect_known(request.rules, names_of(&Method::rules), "set of rules");
  expect_known(request.zero_tests, names_of(&Method::zero_test), "zero test");
  expect_known(request.scalars, scalar_names(), "scalar");
  std::vector<const Method*> chosen;
  for (const Method& method : all_methods())
    if (is_chosen(request.rules, method.rules) && is_chosen(request.zero_tests, method.zero_test) &&
        is_chosen(request.scalars, method.scalar.name))
      chosen.push_back(&method);
  if (chosen.empty()) throw UsageError("no setting is left; 'gjkstep-study list' shows them");
  return chosen;
}

/// Whether one of the methods can be asked about such shapes: about round bodies exact numbers cannot.
bool can_be_asked(const Family& family, const std::vector<const Method*>& methods, std::uint64_t seed) {
  const Pair first = family.make(seed, 0);
  return std::ranges::any_of(methods, [&](const Method* method) {
    const std::optional<RoundedPair> rounded = method->scalar.rounded(first);
    if (!rounded) return true;
    return method->scalar.question(rounded->pair) != nullptr;
  });
}

/// Families that nobody asked for are left out where there is nobody to ask.
std::vector<Part> parts_of(const Request& request, const std::vector<const Method*>& methods) {
  std::vector<Part> parts;
  for (const Family* const family : families_called(request.families))
    if (!request.families.empty() || can_be_asked(*family, methods, request.seed))
      parts.push_back(part_of(*family, request));
  return parts;
}

std::vector<int> limits_of(const Request& request) {
  std::vector<int> chosen = request.limits;
  if (chosen.empty()) chosen.assign(std::begin(limits), std::end(limits));
  std::ranges::sort(chosen);
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  if (chosen.front() < 1 || chosen.back() > largest_limit)
    throw UsageError(std::string("--limit: expected ") + limits_in_words);
  return chosen;
}

// -- Words ------------------------------------------------------------------------------------------------------------

std::string option(const std::string& name, const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? " " + name + " " : ",") + value;
  return text;
}

std::vector<std::string> words_of(const std::vector<int>& numbers) {
  std::vector<std::string> words;
  for (const int number : numbers) words.push_back(std::to_string(number));
  return words;
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
  plan.parts = parts_of(request, plan.methods);
  plan.limits = limits_of(request);
  plan.failure_limit = std::min(report_limit, plan.limits.back());
  return plan;
}

std::string command_of(const Request& request) {
  std::string text = "gjkstep-study run";
  if (request.pairs)
    text += " --pairs " + std::to_string(*request.pairs);
  else
    text += request.scope == Scope::full ? " --full" : " --quick";
  return text + " --seed " + std::to_string(request.seed) + option("--families", request.families) +
         option("--rules", request.rules) + option("--scalar", request.scalars) +
         option("--zero-test", request.zero_tests) + option("--limit", words_of(request.limits));
}

Shard parse_shard(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  const bool has_index = index.ec == std::errc() && index.ptr != end && *index.ptr == '/';
  const auto count = has_index ? std::from_chars(index.ptr + 1, end, shard.count) : index;
  if (!has_index || count.ec != std::errc() || count.ptr != end || shard.index >= shard.count)
    throw UsageError("--shard: expected I/N with I from 0 to N - 1, such as 0/8, found '" + text + "'");
  return shard;
}

}  // namespace study
