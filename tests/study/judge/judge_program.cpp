#include "tests/study/judge/judge_program.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "tests/study/judge/answer.hpp"
#include "tests/study/judge/resemblance.hpp"
#include "tests/study/judge/rounding.hpp"
#include "tests/study/judge/symmetries.hpp"
#include "tests/study/pairs/dice.hpp"
#include "tests/study/truth/oracle.hpp"

namespace study {
namespace {

// -- Single pairs -----------------------------------------------------------------------------------------------------

Verdict verdict_on(Said said, Truth truth) {
  switch (said) {
    case Said::intersecting: return truth == Truth::intersecting ? Verdict::right : Verdict::wrong_yes;
    case Said::separated: return truth == Truth::separated ? Verdict::right : Verdict::wrong_no;
    case Said::undecided: return Verdict::undecided;
    case Said::nothing: break;
  }
  return Verdict::unreadable;
}

Verdict verdict_on(Reply::Kind kind) {
  switch (kind) {
    case Reply::ended: return Verdict::ended;
    case Reply::late: return Verdict::late;
    case Reply::flooding: return Verdict::unreadable;
    case Reply::line:
    case Reply::not_asked: break;
  }
  return Verdict::not_asked;
}

/// What a reply says, and whether it says it with evidence.
struct Reading {
  Judged judged;
  ProgramAnswer answer;
};

Reading read(const NamedPair& named, const Reply& reply) {
  Reading reading{{.named = named, .truth = truth(named.pair)}, {}};
  Judged& judged = reading.judged;
  if (reply.kind != Reply::line) {
    judged.verdict = verdict_on(reply.kind);
    judged.detail = reply.text;
    return reading;
  }
  reading.answer = read_answer(reply.text, named.pair);
  judged.verdict = verdict_on(reading.answer.said, judged.truth);
  judged.detail = reading.answer.why;
  judged.false_evidence = judged.verdict == Verdict::right && reading.answer.evidence == Evidence::proves_nothing;
  return reading;
}

void count(const Reading& reading, FamilyTally& tally) {
  const Judged& judged = reading.judged;
  ++tally.pairs;
  ++tally.counts[static_cast<std::size_t>(judged.verdict)];
  tally.evidence += judged.verdict == Verdict::right && reading.answer.evidence != Evidence::none;
  tally.false_evidence += judged.false_evidence;
  if (judged.verdict != Verdict::not_asked) tally.wrong.add(judged.is_wrong());
}

FamilyTally& tally_of(const std::string& family, std::vector<FamilyTally>& all) {
  const auto found = std::ranges::find(all, family, &FamilyTally::family);
  if (found != all.end()) return *found;
  all.push_back({.family = family});
  return all.back();
}

// -- Changes that must not matter -------------------------------------------------------------------------------------

Points times(Points points, double factor) {
  for (Vec& p : points) p *= factor;
  return points;
}

/// By no more than 2^8, so that floats have room, too. Nothing where doubles have none.
std::optional<PairOfSets<double>> scaled_a_little(const PairOfSets<double>& pair, Dice& dice) {
  const double factor = std::ldexp(1.0, dice.coin() ? dice.whole(1, 8) : -dice.whole(1, 8));
  PairOfSets<double> scaled{times(pair.a, factor), times(pair.b, factor)};
  if (times(scaled.a, 1 / factor) != pair.a || times(scaled.b, 1 / factor) != pair.b) return std::nullopt;
  return scaled;
}

std::optional<Pair> changed(Symmetry symmetry, const Pair& pair, Dice& dice) {
  if (symmetry == Symmetry::exchanged) return Pair{pair.b, pair.a};
  const auto *a = std::get_if<Points>(&pair.a), *b = std::get_if<Points>(&pair.b);
  if (!a || !b) return std::nullopt;
  const PairOfSets<double> sets{*a, *b};
  const auto after_it = symmetry == Symmetry::scaled ? scaled_a_little(sets, dice) : after(symmetry, sets, dice);
  if (!after_it) return std::nullopt;
  return Pair{after_it->a, after_it->b};
}

struct ChangedPair {
  std::size_t change, original;
  Pair pair;
  Said expected;
};

bool is_with_itself(const ChangedPair& pair) { return pair.change + 1 == symmetry_names.size(); }

/// `said`: what the program says of each pair.
std::vector<ChangedPair> changed_pairs(const std::vector<NamedPair>& pairs, const std::vector<Said>& said) {
  std::vector<ChangedPair> all;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (said[i] != Said::intersecting && said[i] != Said::separated) continue;
    Dice dice(1, "changes of " + pairs[i].name, i);
    for (std::size_t s = 1; s < symmetry_names.size(); ++s)
      if (const auto pair = changed(static_cast<Symmetry>(s), pairs[i].pair, dice))
        all.push_back({s - 1, i, *pair, said[i]});
    all.push_back({symmetry_names.size() - 1, i, {pairs[i].pair.a, pairs[i].pair.a}, Said::intersecting});
  }
  return all;
}

std::vector<Change> ask_changed(const AskedProgram& program, const std::vector<NamedPair>& pairs,
                                const std::vector<Said>& said) {
  std::vector<Change> changes;
  for (const std::string_view name : symmetry_names)
    if (name != symmetry_names.front()) changes.push_back({name});
  changes.push_back({"A with itself"});
  const std::vector<ChangedPair> all = changed_pairs(pairs, said);
  std::vector<std::string> questions;
  for (const ChangedPair& each : all) questions.push_back(question_line(each.pair));
  const Replies replies = ask_all(program, questions);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (replies.all[k].kind == Reply::not_asked) continue;
    const Pair& original = pairs[all[k].original].pair;  // whose indices are others: evidence is not looked at
    const bool is_line = replies.all[k].kind == Reply::line;
    const Said now = is_line ? read_answer(replies.all[k].text, original).said : Said::nothing;
    Change& change = changes[all[k].change];
    ++change.asked;
    if (now == all[k].expected) continue;
    change.wrong_no += is_with_itself(all[k]) && now == Said::separated;
    if (change.other_answers++ > 0) continue;
    change.first = pairs[all[k].original].name;
    change.first_pair = all[k].pair;
  }
  return changes;
}

}  // namespace

bool Judged::has_search() const {
  const bool is_answered =
      verdict == Verdict::wrong_yes || verdict == Verdict::wrong_no || verdict == Verdict::undecided;
  return is_answered && std::holds_alternative<Points>(named.pair.a) && std::holds_alternative<Points>(named.pair.b);
}

bool Judged::is_wrong() const {
  return verdict != Verdict::right && verdict != Verdict::undecided && verdict != Verdict::not_asked;
}

bool ProgramJudged::is_good() const {
  constexpr std::uint64_t hiccups = 1;  // of a machine with other work
  return all.wrong.count == 0 && all.false_evidence == 0 && all.of(Verdict::not_asked) == 0 && !crashes &&
         replies.late_in_company <= hiccups && replies.floods == 0 && replies.long_lines == 0 &&
         std::ranges::all_of(changes, [](const Change& change) { return change.other_answers == 0; });
}

ProgramJudged judge_program(const AskedProgram& program, const std::vector<NamedPair>& pairs) {
  std::vector<std::string> questions;
  for (const NamedPair& each : pairs) questions.push_back(question_line(each.pair));
  ProgramJudged judged;
  judged.replies = ask_all(program, questions);
  judged.all.family = "all";
  std::vector<Said> said;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Reading reading = read(pairs[i], judged.replies.all[i]);
    count(reading, tally_of(pairs[i].family, judged.families));
    count(reading, judged.all);
    said.push_back(reading.answer.said);
    judged.pairs.push_back(std::move(reading.judged));
  }
  judged.crashes = judged.replies.crashes_in_company > 0;
  judged.resemblances = resemblances(judged.pairs);
  judged.rounding = laid_to_rounding(judged.pairs);
  if (!judged.replies.was_given_up) judged.changes = ask_changed(program, pairs, said);
  return judged;
}

}  // namespace study
