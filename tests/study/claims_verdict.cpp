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

// -- Parts of a verdict -----------------------------------------------------------------------------------------------

double threshold(Strength strength) { return strength == Strength::usually ? 0.5 : 0.99; }

/// Without an exception only their small number can leave an *always* open.
std::string why_open(Strength strength, const Rate& rate) {
  if (rate.count == rate.trials) return "only " + grouped(rate.trials) + (rate.trials == 1 ? " case" : " cases");
  return printed("%.*g", 5, 100 * threshold(strength)) + " % lies within the interval";
}

std::string left_open(Strength strength, const std::vector<const Measured*>& open) {
  std::vector<std::string> places;
  for (const Measured* m : open) places.push_back(m->where + " (" + why_open(strength, m->holds) + ")");
  return places.empty() ? "" : "left open for " + joined(places);
}

/// What is said of the places that leave nothing open.
std::string answered(const std::vector<std::string>& yes, const std::vector<std::string>& no, bool all_but_some) {
  if (yes.empty() && no.empty()) return "";
  if (no.empty()) return "**holds**" + (all_but_some ? " for " + joined(yes) : "");
  if (yes.empty()) return "**does not hold**" + (all_but_some ? " for " + joined(no) : "");
  return "holds only for " + joined(yes) + "; not for " + joined(no);
}

}  // namespace

std::optional<bool> holds(Strength strength, const Rate& rate) {
  const Interval interval = rate.interval();
  const double least = threshold(strength);
  if (strength == Strength::always && rate.count < rate.trials) return false;
  if (interval.low >= least) return true;
  if (interval.high < least) return false;
  return std::nullopt;
}

std::string verdict(const Claim& claim) {
  std::vector<std::string> yes, no;
  std::vector<const Measured*> open;
  for (const Measured& m : claim.measured) {
    if (m.holds.trials == 0) continue;
    const auto answer = holds(claim.strength, m.holds);
    if (!answer)
      open.push_back(&m);
    else
      (*answer ? yes : no).push_back(m.where);
  }
  if (yes.empty() && no.empty() && open.empty()) return "nothing to look at";
  if (yes.empty() && no.empty() && open.size() == 1) return "left open: " + why_open(claim.strength, open[0]->holds);
  return answered(yes, no, !open.empty()) +
         (yes.empty() && no.empty() ? ""
          : open.empty()            ? ""
                                    : "; ") +
         left_open(claim.strength, open);
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
