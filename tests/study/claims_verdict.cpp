#include "tests/study/claims_verdict.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace study {
namespace {

std::string printed(const char* format, int digits, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, digits, value);
  return text;
}

/// Two or three digits of what differs from nothing or from everything: 12.3, 0.012, 99.983.
std::string percent(double share) {
  const double rare = 100 * std::min(share, 1 - share);
  const int digits = rare <= 0    ? 0
                     : rare >= 10 ? 1
                     : rare >= 1  ? 2
                                  : 1 - static_cast<int>(std::floor(std::log10(rare)));
  return printed("%.*f", std::min(digits, 7), 100 * share);
}

bool is_per_million(double share) { return share > 0 && share < 1e-4; }

std::string per_million(double share) { return printed("%.*g", 3, 1e6 * share); }

}  // namespace

std::optional<bool> holds(Strength strength, const Rate& rate) {
  if (strength == Strength::always) return rate.count == rate.trials;
  const double threshold = strength == Strength::usually ? 0.5 : 0.99;
  const Interval interval = rate.interval();
  if (interval.low >= threshold) return true;
  if (interval.high < threshold) return false;
  return std::nullopt;
}

std::string verdict(const Claim& claim) {
  std::vector<std::string> yes, open;
  std::size_t looked_at = 0;
  for (const Measured& m : claim.measured) {
    if (m.holds.trials == 0) continue;
    ++looked_at;
    const auto answer = holds(claim.strength, m.holds);
    if (!answer) open.push_back(m.where);
    if (answer.value_or(false)) yes.push_back(m.where);
  }
  if (looked_at == 0) return "nothing to look at";
  const std::string rest = open.empty() ? "" : "; left open for " + joined(open);
  if (yes.size() == looked_at) return "**holds**";
  if (open.size() == looked_at) return "left open";
  if (yes.empty()) return "**does not hold**" + rest;
  return "holds only for " + joined(yes) + rest;
}

const Measured& worst(const Claim& claim) {
  return *std::ranges::min_element(claim.measured, {}, [](const Measured& m) {
    return m.holds.trials == 0 ? 2 : m.holds.share();  // what was not looked at comes last
  });
}

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return digits;
}

std::string share_text(double share) {
  return is_per_million(share) ? per_million(share) + " per million" : percent(share) + " %";
}

std::string rate_text(const Rate& rate) {
  if (rate.trials == 0) return "–";
  const Interval i = rate.interval();
  if (rate.count == 0) return "0 (at most " + share_text(i.high) + ")";
  if (rate.count == rate.trials) return "100 % (at least " + percent(i.low) + " %)";
  if (is_per_million(rate.share()))
    return per_million(rate.share()) + " (" + per_million(i.low) + "–" + per_million(i.high) + ") per million";
  return percent(rate.share()) + " % (" + percent(i.low) + "–" + percent(i.high) + ")";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

}  // namespace study
