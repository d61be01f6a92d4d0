#include "walkthroughs/judge/asking.hpp"

#include <algorithm>
#include <optional>
#include <span>

#include "walkthroughs/model/number_text.hpp"

namespace walkthroughs::judge {
namespace {

Reply::Kind kind_of(End end) {
  switch (end) {
    case End::ended: return Reply::ended;
    case End::late: return Reply::late;
    case End::flooding:
    case End::long_line: return Reply::flooding;
    case End::answered: break;
  }
  return Reply::line;
}

bool is_flood(End end) { return end == End::flooding || end == End::long_line; }

std::string in_seconds(std::chrono::milliseconds time) {
  return number_text(static_cast<double>(time.count()) / 1000) + " s";
}

/// Returns: why a run that was asked one question has no answer to it.
std::string why_not_answered(const RunOfProgram& run, std::chrono::milliseconds limit) {
  switch (run.end) {
    case End::ended: return run.how;
    case End::late:
      return "no answer within " + in_seconds(limit) +
             (run.closed_output  ? "; it had closed its output"
              : run.closed_input ? "; it had closed its input"
                                 : "");
    case End::flooding: return "more lines than pairs";
    case End::long_line: return "a line longer than 1 MB";
    case End::answered: break;
  }
  return "";
}

constexpr int most_floods = 3;       // in a row, each at one pair alone
constexpr int most_ended_runs = 20;  // each with few answers, none between with more
constexpr std::size_t few = 16;

class Interview {
 public:
  Interview(const AskedProgram& program, const std::vector<std::string>& questions)
      : program_(program), questions_(questions) {
    replies_.all.resize(questions.size());
  }

  Replies go() {
    while (at_ < questions_.size() && !replies_.was_given_up) ask_some();
    forgive_or_count();
    return std::move(replies_);
  }

 private:
  /// Asks the next few in one run of the program.
  void ask_some() {
    const std::size_t count = std::min(size_, questions_.size() - at_);
    RunOfProgram run =
        run_program(program_.words, std::span(questions_).subspan(at_, count), program_.limit, program_.is_answer);
    note(run);
    // Where some are missing though nothing happened, nobody knows which.
    const bool is_shifted = run.end == End::ended && !run.failed && !run.lines.empty();
    const std::size_t answered = (is_flood(run.end) || is_shifted) && count > 1 ? 0 : run.lines.size();
    for (std::size_t i = 0; i < answered; ++i) replies_.all[at_ + i] = {Reply::line, std::move(run.lines[i])};
    if (answered > 0) in_a_row_ = 0;
    const bool crashed =
        (run.failed && run.end == End::ended) || (run.was_killed_by_signal && run.end == End::answered);
    replies_.early_ends += is_shifted;
    give_up_who_never_ends(run);
    const bool was_late = run.end == End::late && answered > 0;  // before the first it may only keep its output back
    if ((crashed || was_late) && (count > 1 || run.end == End::answered)) {
      if (!unexplained_) unexplained_ = {at_ + count, was_late, run.how, answered, 0};
      ++unexplained_->times;
    }
    at_ += answered;
    if (count == 1) give_up_who_floods(run);
    if (answered == count)
      size_ *= 2;
    else if (count == 1)
      blame(run);
    else
      size_ = answered > 0 ? 1 : count / 2;
    forgive_or_count();
  }

  /// Whose answers to single pairs are several lines has no answers, only lines.
  void give_up_who_floods(const RunOfProgram& run) {
    floods_alone_ = is_flood(run.end) ? floods_alone_ + 1 : 0;
    if (floods_alone_ == most_floods && at_ < questions_.size()) replies_.was_given_up = true;
  }

  /// Who answers a few and then hangs would take the time limit once for each pair.
  void give_up_who_never_ends(const RunOfProgram& run) {
    const bool was_ended = run.end == End::late || run.outlives_its_input;
    if (run.lines.size() >= few)
      ended_runs_ = 0;
    else if (was_ended)
      ++ended_runs_;
    if (ended_runs_ >= most_ended_runs && at_ + run.lines.size() < questions_.size()) replies_.was_given_up = true;
  }

  void note(const RunOfProgram& run) {
    if (replies_.others == 0) replies_.first_other = run.first_other;
    replies_.others += run.others;
    replies_.floods += run.end == End::flooding;
    replies_.long_lines += run.end == End::long_line;
    replies_.closes_its_input = replies_.closes_its_input || (run.closed_input && run.end != End::answered);
    replies_.outlives_its_input = replies_.outlives_its_input || run.outlives_its_input;
    if (run.end != End::answered && replies_.said.empty()) replies_.said = run.said;
  }

  /// Asked alone, the pair had no answer.
  void blame(const RunOfProgram& run) {
    replies_.all[at_++] = {kind_of(run.end), why_not_answered(run, program_.limit)};
    unexplained_.reset();
    in_a_row_ += run.end == End::late ? 10 : 1;
    if (in_a_row_ >= 50 && at_ < questions_.size()) replies_.was_given_up = true;
  }

  /// What no pair is to blame for.
  void forgive_or_count() {
    if (!unexplained_ || at_ < unexplained_->end) return;
    const auto& [end, is_late, how, answered, times] = *unexplained_;
    std::uint64_t& so_far = is_late ? replies_.late_in_company : replies_.crashes_in_company;
    if (so_far == 0) (is_late ? replies_.answers_before_first_late : replies_.answers_before_first_crash) = answered;
    if (so_far == 0 && !is_late) replies_.first_crash = how;
    so_far += times;
    unexplained_.reset();
  }

  const AskedProgram& program_;
  const std::vector<std::string>& questions_;
  Replies replies_;
  std::size_t at_ = 0, size_ = 16;
  /// A run that crashed or was too late, and was to end with that question.
  struct Unexplained {
    std::size_t end;
    bool is_late;
    std::string how;
    std::size_t answered;
    std::uint64_t times;  ///< with those that followed until then
  };
  std::optional<Unexplained> unexplained_;
  int in_a_row_ = 0, floods_alone_ = 0, ended_runs_ = 0;
};

}  // namespace

Replies ask_all(const AskedProgram& program, const std::vector<std::string>& questions) {
  return Interview(program, questions).go();
}

}  // namespace walkthroughs::judge
