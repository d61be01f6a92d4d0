#include "tests/study/claims/claims_verdict.hpp"

#include <algorithm>
#include <array>
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

using Places = std::vector<const Measured*>;

double threshold(Strength strength) {
  if (strength == Strength::usually) return 0.5;
  return strength == Strength::all_but_few ? 1 - 10e-6 : 0.99;
}

/// Without an exception only their small number can leave an *always* open.
std::string why_open(Strength strength, const Rate& rate) {
  if (rate.count == rate.trials) return "only " + grouped(rate.trials) + (rate.trials == 1 ? " case" : " cases");
  return printed("%.*g", 5, 100 * threshold(strength)) + " % lies within the interval";
}

/// A group is named in place of its members where none of those that were looked at is missing.
std::vector<std::string> names(const Places& places, const Claim& claim) {
  std::vector<std::string> terms;
  for (const Measured* const m : places) {
    const auto in_group = [&](const Measured& other) {
      return !m->group.empty() && other.group == m->group && other.holds.trials > 0;
    };
    const auto all = std::ranges::count_if(claim.measured, in_group);
    const auto here = std::ranges::count_if(places, [&](const Measured* other) { return in_group(*other); });
    const std::string& term = all > 1 && all == here ? m->group : m->where;
    if (std::ranges::find(terms, term) == terms.end()) terms.push_back(term);
  }
  return terms;
}

struct Standings {
  explicit Standings(const Claim& claim) {
    for (const Measured& m : claim.measured)
      if (m.holds.trials > 0) at(standing(claim.strength, m)).push_back(&m);
  }

  Places& at(Standing s) { return places[static_cast<std::size_t>(s)]; }
  const Places& at(Standing s) const { return places[static_cast<std::size_t>(s)]; }

  std::array<Places, 4> places;
};

/// The shorter list says where a claim breaks. An answer for few places, where more are left open, names them.
std::string answered(const Standings& found, const Claim& claim) {
  const Places &nearly = found.at(Standing::nearly_holds), &no = found.at(Standing::fails);
  Places yes = found.at(Standing::holds);
  yes.insert(yes.end(), nearly.begin(), nearly.end());
  const auto holding = names(yes, claim), breaking = names(no, claim);
  const std::size_t left_open = found.at(Standing::open).size();
  if (yes.empty()) return breaking.size() <= left_open ? "does not hold for " + joined(breaking) : "**does not hold**";
  if (no.empty() && !nearly.empty()) return "**mostly holds**";
  if (no.empty()) return holding.size() <= left_open ? "holds for " + joined(holding) : "**holds**";
  if (holding.size() > breaking.size()) return "**mostly holds**, but not for " + joined(breaking);
  if (holding.size() < breaking.size()) return "**mostly fails**, but holds for " + joined(holding);
  return "holds for " + joined(holding) + ", not for " + joined(breaking);
}

/// Returns: empty where there are none. Of two lists the shorter one is told.
std::string rare_exceptions(const Standings& found, const Claim& claim) {
  const auto with = names(found.at(Standing::nearly_holds), claim), without = names(found.at(Standing::holds), claim);
  if (with.empty()) return "";
  const std::string rare = "rare exceptions (under 1 %)";
  if (with.size() <= without.size()) return rare + " for " + joined(with);
  const std::string where = found.at(Standing::fails).empty() ? "everywhere" : "elsewhere";
  return rare + " " + where + (without.empty() ? "" : ", but none for " + joined(without));
}

std::string left_open(const Standings& found, const Claim& claim) {
  std::vector<std::string> terms;
  for (const Measured* const m : found.at(Standing::open))
    terms.push_back(m->where + " (" + why_open(claim.strength, m->holds) + ")");
  return terms.empty() ? "" : "left open for " + joined(terms);
}

}  // namespace

Interval Measured::interval() const {
  return cases == Cases::all && holds.trials > 0 ? Interval{holds.share(), holds.share()} : holds.interval();
}

Standing standing(Strength strength, const Measured& measured) {
  const Interval interval = measured.interval();
  const bool is_above = interval.low >= threshold(strength);
  if (strength == Strength::always && measured.holds.count < measured.holds.trials)
    return is_above ? Standing::nearly_holds : Standing::fails;
  if (is_above) return Standing::holds;
  return interval.high < threshold(strength) ? Standing::fails : Standing::open;
}

std::string verdict(const Claim& claim) {
  const Standings found(claim);
  const Places& open = found.at(Standing::open);
  const auto looked_at = std::ranges::count_if(claim.measured, [](const Measured& m) { return m.holds.trials > 0; });
  if (looked_at == 0) return "nothing to look at";
  if (looked_at == 1 && !open.empty()) return "left open: " + why_open(claim.strength, open[0]->holds);
  if (open.size() == static_cast<std::size_t>(looked_at)) return left_open(found, claim);
  std::string words = answered(found, claim);
  for (const std::string& more : {rare_exceptions(found, claim), left_open(found, claim)})
    if (!more.empty()) words += "; " + more;
  return words;
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

std::string text_of(const Measured& m) {
  if (m.cases == Cases::thrown) return m.where + ": " + rate_text(m.holds);
  return m.where + ": " + share_text(m.holds.share()) + " of all " + grouped(m.holds.trials);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

}  // namespace study
