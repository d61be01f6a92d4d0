#include "walkthroughs/judge/judge.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/scene_limits.hpp"

namespace walkthroughs::judge {
namespace {

constexpr std::size_t block = 1024;               // cases in memory at once
constexpr std::size_t most_samples_of_kind = 30;  // of each family: right, wrong, or of a wrong distance

Verdict verdict_on(Reply::Kind kind) {
  switch (kind) {
    case Reply::ended: return Verdict::ended;
    case Reply::late: return Verdict::late;
    case Reply::flooding: return Verdict::no_answer;
    case Reply::line:
    case Reply::not_asked: break;
  }
  return Verdict::not_asked;
}

Verdict verdict_on(const Case& asked, Said said, const Standard& standard) {
  switch (said) {
    case Said::undecided: return Verdict::undecided;
    case Said::not_a_number: return Verdict::not_a_number;
    case Said::nothing: return Verdict::no_answer;
    case Said::intersecting:
    case Said::separated: break;
  }
  const bool says_yes = said == Said::intersecting;
  const Called right = right_answer(asked, standard);
  if (right == Called::either || says_yes == (right == Called::intersecting)) return Verdict::right;
  return says_yes ? Verdict::wrong_yes : Verdict::wrong_no;
}

Tally& tally_of(const std::string& family, std::vector<Tally>& all) {
  const auto found = std::ranges::find(all, family, &Tally::family);
  if (found != all.end()) return *found;
  all.push_back({.family = family});
  return all.back();
}

/// Whether floats, too, have room for the products of such numbers.
bool is_everyday(const Judged& each) {
  const double size = largest_number(each.asked.pair);
  return can_be_drawn(each.asked.pair) && size < 1e8 && size > 1e-8;
}

/// Of two powers of ten one class.
int class_of(double wrong) { return wrong > 0 ? static_cast<int>(std::floor(std::log10(wrong) / 2)) : -1000; }

/// Everyday numbers first, and of these the worst; of some as bad, that of fewest points, which is easiest to follow.
bool is_worse(const Judged& one, const Judged& other) {
  if (is_everyday(one) != is_everyday(other)) return is_everyday(one);
  const auto size = [](const Judged& each) { return each.asked.pair.a.size() + each.asked.pair.b.size(); };
  const double wrong_one = how_wrong(one), wrong_other = how_wrong(other);
  if (class_of(wrong_one) != class_of(wrong_other)) return class_of(wrong_one) > class_of(wrong_other);
  if (size(one) != size(other)) return size(one) < size(other);
  return wrong_one > wrong_other;
}

/// What happened in one block beside what happened before.
void add(Replies& all, const Replies& more) {
  if (all.first_crash.empty()) {
    all.first_crash = more.first_crash;
    all.answers_before_first_crash = more.answers_before_first_crash;
  }
  if (all.late_in_company == 0) all.answers_before_first_late = more.answers_before_first_late;
  if (all.said.empty()) all.said = more.said;
  if (all.others == 0) all.first_other = more.first_other;
  all.crashes_in_company += more.crashes_in_company;
  all.late_in_company += more.late_in_company;
  all.early_ends += more.early_ends;
  all.floods += more.floods;
  all.long_lines += more.long_lines;
  all.others += more.others;
  all.closes_its_input = all.closes_its_input || more.closes_its_input;
  all.outlives_its_input = all.outlives_its_input || more.outlives_its_input;
  all.was_given_up = all.was_given_up || more.was_given_up;
}

std::string fault_line(const Judged& each) {
  const std::string what(each.false_evidence ? "false evidence"
                                             : verdict_words[static_cast<std::size_t>(each.verdict)]);
  return what + " " + printable(each.asked.name);
}

class Hearing {
 public:
  Hearing(const Standard& standard, std::size_t worst) : standard_(standard), most_worst_(worst) {
    judgement_.all.family = "all";
  }

  void hear(const std::vector<Case>& cases, const Replies& replies) {
    for (std::size_t i = 0; i < cases.size(); ++i) take(judged(cases[i], replies.all[i], standard_));
    add(judgement_.replies, replies);
  }
  bool is_over() const { return judgement_.replies.was_given_up; }
  Judgement& judgement() { return judgement_; }

 private:
  void take(Judged each) {
    judgement_.all.add(each);
    tally_of(each.asked.family, judgement_.families).add(each);
    const bool is_answer =
        each.verdict == Verdict::right || is_wrong(each.verdict) || each.verdict == Verdict::within_tolerance;
    if (is_wrong(each.verdict)) keep_if_worst(each);
    if (is_fault(each.verdict) || each.false_evidence) judgement_.faults.push_back(fault_line(each));
    auto& list = each.verdict == Verdict::undecided ? judgement_.open : judgement_.failed;
    if (is_fault(each.verdict) && !is_answer && list.size() < most_failed) list.push_back(each);
    const int kind = each.verdict == Verdict::wrong_distance ? 2 : is_wrong(each.verdict) ? 1 : 0;
    if (is_answer && samples_[{each.asked.family, kind}]++ < most_samples_of_kind)
      judgement_.samples.push_back(std::move(each));
  }

  void keep_if_worst(const Judged& each) {
    auto& worst = judgement_.worst;
    worst.insert(std::ranges::upper_bound(worst, each, is_worse), each);
    if (worst.size() > most_worst_) worst.pop_back();
  }

  Standard standard_;
  std::size_t most_worst_;
  std::map<std::pair<std::string, int>, std::size_t> samples_;
  Judgement judgement_;
};

}  // namespace

double how_wrong(const Judged& judged) {
  const double right = judged.how_far.relative;
  return judged.distance ? std::abs(relative_to_size(*judged.distance, judged.asked.pair) - right) : right;
}

std::uint64_t Tally::faults() const {
  std::uint64_t sum = false_evidence;
  for (std::size_t i = 0; i < counts.size(); ++i) sum += is_fault(static_cast<Verdict>(i)) ? counts[i] : 0;
  return sum;
}

void Tally::add(const Judged& judged) {
  ++pairs;
  ++counts[static_cast<std::size_t>(judged.verdict)];
  false_evidence += judged.false_evidence;
  if (is_wrong(judged.verdict)) worst = std::max(worst, how_wrong(judged));
}

bool Judgement::is_good() const { return all.faults() == 0 && behaves(); }

bool Judgement::behaves() const {
  constexpr std::uint64_t hiccups = 1;  // of a machine with other work
  return all.of(Verdict::not_asked) == 0 && replies.crashes_in_company == 0 && replies.late_in_company <= hiccups &&
         replies.floods == 0 && replies.long_lines == 0;
}

Called right_answer(const Case& asked, const Standard& standard) {
  const bool in_plane = standard.expected.in_plane;
  if (!asked.meet()) return Called::separated;
  if (standard.touching != Called::intersecting && only_touch(asked.pair, in_plane)) return standard.touching;
  if (standard.inside != Called::intersecting && one_is_inside(asked.pair, in_plane)) return standard.inside;
  return Called::intersecting;
}

bool can_be_drawn(const PointPair& pair) {
  return std::max(pair.a.size(), pair.b.size()) <= scene_limits::points &&
         largest_number(pair) <= scene_limits::magnitude;
}

Judged judged(const Case& asked, const Reply& reply, const Standard& standard) {
  Judged judged{.asked = asked};
  if (reply.kind != Reply::line) {
    judged.verdict = verdict_on(reply.kind);
    judged.detail = reply.text;
    return judged;
  }
  const ProgramAnswer answer = read_answer(reply.text, {asked.pair.a, asked.pair.b});
  judged.said = answer.said;
  judged.verdict = verdict_on(asked, answer.said, standard);
  judged.detail = answer.why;
  judged.false_evidence = judged.verdict == Verdict::right && answer.evidence == Evidence::proves_nothing;
  if (judged.verdict == Verdict::right && answer.said == Said::separated && !asked.meet() &&
      answer.distance.value_or(0) > 0)
    judged.distance = answer.distance;
  if (!is_wrong(judged.verdict) && !judged.distance) return judged;
  judged.how_far = how_far(asked, standard.expected.in_plane);
  // Of surfaces alone, a move into the other set may be shorter than the one out of it that is measured.
  if (asked.meet() && standard.inside != Called::intersecting) judged.how_far.is_bound = judged.how_far.length > 0;
  const double wrong = how_wrong(judged);
  if (judged.distance && wrong <= good_distance(standard.expected.numbers)) return judged;
  if (judged.distance) judged.verdict = Verdict::wrong_distance;
  if (wrong <= standard.tolerance && standard.tolerance > 0) judged.verdict = Verdict::within_tolerance;
  return judged;
}

Judgement judge(const AskedProgram& program, Cases cases, const Standard& standard, std::size_t worst,
                const std::function<void(std::uint64_t done, std::uint64_t most)>& progress) {
  Hearing hearing(standard, worst);
  for (std::uint64_t done = 0; !hearing.is_over();) {
    const std::vector<Case> some = cases.next(block);
    if (some.empty() && cases.most() == 0) progress(done, done);  // now it is known
    if (some.empty()) break;
    std::vector<std::string> questions;
    for (const Case& each : some) questions.push_back(question_line({each.pair.a, each.pair.b}));
    hearing.hear(some, ask_all(program, questions));
    progress(done += some.size(), cases.most());
  }
  hearing.judgement().passed_over = cases.passed_over();
  return std::move(hearing.judgement());
}

}  // namespace walkthroughs::judge
