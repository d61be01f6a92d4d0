#include "walkthroughs/judge/judged_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "walkthroughs/steps/mistakes.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/scene_limits.hpp"

namespace walkthroughs::judge {
namespace {

constexpr std::size_t longest_scene = 500;  // on the first screen

/// "1,204".
std::string count(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

std::string count(std::uint64_t number, const std::string& one, const std::string& many) {
  return count(number) + " " + (number == 1 ? one : many);
}

/// Three digits are enough.
std::string size_text(double x, int digits = 3) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return text;
}

std::string word(Verdict verdict) { return std::string(verdict_words[static_cast<std::size_t>(verdict)]); }

// -- The first screen -------------------------------------------------------------------------------------------------

std::string verdict(const Report& report) {
  const Judgement& found = report.judgement;
  const Tally& all = found.all;
  const std::string pairs = count(all.pairs, "pair", "pairs");
  std::string line = printable(report.program) + ": ";
  line += all.faults() == 0 ? "right on all " + pairs + (found.behaves() ? "" : ", but see the notes")
                            : "not right on " + count(all.faults()) + " of " + pairs;
  std::string between = ": ";
  const auto add = [&](std::uint64_t number, const std::string& what) {
    if (number == 0) return;
    line += between + count(number) + " " + what;
    between = ", ";
  };
  for (std::size_t i = 0; i < verdict_words.size(); ++i)
    if (is_fault(static_cast<Verdict>(i))) add(all.counts[i], word(static_cast<Verdict>(i)));
  add(all.false_evidence, "right with evidence that proves nothing");
  if (all.of(Verdict::within_tolerance) > 0)
    line += (all.faults() == 0 ? "; of these " : "; besides ") + count(all.of(Verdict::within_tolerance)) +
            (all.of(Verdict::within_tolerance) == 1 ? " is" : " are") + " within the tolerance";
  if (found.passed_over > 0)
    line += "; " + count(found.passed_over) + " were not asked, as floats have no room for them";
  return line;
}

std::string how_far_in_words(const Judged& each) {
  const bool meet = each.asked.meet();
  if (each.how_far.length == 0) return meet ? "they touch" : "they are apart by less than a double can say";
  const std::string most = each.how_far.is_bound ? "at most " : "";
  return (meet ? "they are " : "they are apart by ") + most + size_text(each.how_far.relative) +
         (meet ? " of their size deep in each other" : " of their size");
}

/// Of a distance as many digits as show that it is wrong, of which three are enough otherwise.
std::string said_in_words(const Judged& each) {
  if (!each.distance) return each.said == Said::intersecting ? "yes" : "no";
  const double said = relative_to_size(*each.distance, each.asked.pair);
  int digits = 3;
  while (digits < 17 && size_text(said, digits) == size_text(each.how_far.relative, digits)) ++digits;
  return size_text(said, digits);
}

/// What came of a pair that is wrong, or has no answer.
std::string what_came_of(const Judged& each) {
  if (!is_wrong(each.verdict)) return each.detail.empty() ? word(each.verdict) : message_line(each.detail);
  return how_far_in_words(each) + ", and it says " + said_in_words(each);
}

/// A pair without an answer says more than a wrong one, and that more than one left open.
std::array<const std::vector<Judged>*, 3> lists_of(const Judgement& found) {
  return {&found.failed, &found.worst, &found.open};
}

const Judged* shown_pair(const Judgement& found) {
  for (const std::vector<Judged>* const list : lists_of(found))
    if (!list->empty()) return &list->front();
  return nullptr;
}

std::string worst_line(const Report& report) {
  const Judged* const shown = shown_pair(report.judgement);
  if (!shown) return "";
  return (is_wrong(shown->verdict) ? "worst: " : "first without an answer: ") + message_line(shown->asked.name) + ": " +
         what_came_of(*shown) + "\n";
}

std::string command(const Report& report, const std::string& more) {
  return "gjkstep judge " + report.options + more + " -- " + report.program;
}

std::string scene_line(const Report& report) {
  const Judged* const shown = shown_pair(report.judgement);
  if (!shown) return "";
  const std::string scene = question_line({shown->asked.pair.a, shown->asked.pair.b});
  return "its scene: " +
         (scene.size() <= longest_scene ? scene
          : can_be_drawn(shown->asked.pair)
              ? report.saved.empty() ? "--save wrong writes it to wrong/1.json" : printable(report.saved) + "/1.json"
              : not_drawn) +
         "\n";
}

std::string cause_line(const Report& report) {
  if (report.judgement.all.wrong() == 0) return "";
  if (report.causes.empty()) return "probable cause: " + std::string(no_cause) + "\n";
  const Cause& cause = report.causes.front();
  return "probable cause: " + cause.name + " (" + cause.evidence + ")\n";
}

/// Returns: nothing where nothing follows from the cause.
std::string what_to_do(const Report& report, const Cause& cause) {
  if (!cause.mistake.empty()) return "gjkstep render mistakes/" + cause.mistake;
  const std::string word = cause.option.substr(0, cause.option.find(' '));
  const bool is_given = report.options.find(word) != std::string::npos;
  return cause.option.empty() || is_given ? "" : command(report, cause.option);
}

std::string next_line(const Report& report) {
  const Judgement& found = report.judgement;
  if (found.is_good()) return report.options.empty() ? "next: " + command(report, "--count 1000") + "\n" : "";
  const Cause cause = report.causes.empty() ? Cause{} : report.causes.front();
  if (const std::string told = what_to_do(report, cause); !told.empty()) return "next: " + told + "\n";
  if (!report.shown.empty()) return "";  // but to open it
  if (report.causes.empty() && report.steps.searches == 0 && found.all.wrong() > 0)
    return "next: call judge_step, which 'gjkstep judge --adapter c' has (or cpp, mjs, py): the first wrong step is "
           "named\n";
  const Judged* const shown = shown_pair(found);
  if (!shown || !can_be_drawn(shown->asked.pair)) return "next: " + command(report, "--table") + "\n";
  if (!report.saved.empty()) return "next: gjkstep render " + shell_word(report.saved + "/1.json") + "\n";
  return "next: " + command(report, "--save wrong") + "; gjkstep render wrong/1.json\n";
}

std::string last_line(const std::string& text) {
  const std::size_t last = text.find_last_not_of(" \r\n");
  if (last == std::string::npos) return "";
  const std::string said = text.substr(0, last + 1);
  const std::size_t feed = said.rfind('\n');
  return said.substr(feed == std::string::npos ? 0 : feed + 1);
}

/// What its steps are like; nothing where it tells none.
std::string note_on_steps(const StepsLooked& steps) {
  const std::string complaint = message_line(steps.complaint);
  if (steps.searches == 0) return complaint;
  std::string text =
      "it tells its steps, " + count(steps.steps) + " in " + count(steps.searches, "search", "searches") + ": " +
      (steps.wrong == 0 ? "none is wrong" : count(steps.wrong, "search has a wrong one", "searches have wrong ones"));
  if (steps.repaired > 0) text += ", of which " + count(steps.repaired, "is", "are") + " answered rightly all the same";
  if (steps.rounding > 0) text += "; in " + count(steps.rounding) + " rounding may be why the report makes another";
  if (steps.otherwise > 0) text += "; " + count(steps.otherwise) + " others are as right as the report's";
  if (steps.without_steps > 0)
    text += "; for " + count(steps.without_steps, "wrong answer", "wrong answers") + " it tells none";
  if (!complaint.empty()) text += "; " + complaint;
  return text;
}

/// Of those that it tells.
std::string first_wrong_step_line(const StepsLooked& steps) {
  const LookedSearch* const shown = steps.shown();
  return shown ? "first wrong step: " + words_of_first_wrong(*shown) + "\n" : "";
}

/// What is odd, whether answers are right or not.
std::vector<std::string> behaviour(const Report& report) {
  const Judgement& found = report.judgement;
  const Replies& replies = found.replies;
  std::vector<std::string> notes;
  const auto say = [&](bool is_so, const std::string& what) {
    if (is_so) notes.push_back(what);
  };
  say(replies.crashes_in_company > 0, "it crashed " + count(replies.crashes_in_company, "time", "times") + " (" +
                                          message_line(replies.first_crash) + ") after " +
                                          count(replies.answers_before_first_crash, "answer", "answers") +
                                          ", though each pair has its answer in another run");
  say(replies.late_in_company > 0,
      "it was too late " + count(replies.late_in_company, "time", "times") +
          ", though each pair has its answer in another run; let it flush after each answer");
  say(replies.early_ends > 0, "it ended " + count(replies.early_ends, "time", "times") +
                                  " before all pairs of a run were answered, and was started again");
  say(replies.closes_its_input && found.all.of(Verdict::ended) == 0,
      "it closes its standard input before it has answered all");
  say(replies.outlives_its_input, "it does not end when its input ends");
  say(replies.others > 0,
      "it also prints " + count(replies.others, "line that is no answer", "lines that are no answers") +
          ", the first " + in_quotes(replies.first_other) + "; an answer is yes, no, undecided or distance 0.25");
  const std::string said = last_line(replies.said);
  say(!said.empty(), "it wrote to standard error: " + message_line(said));
  const std::string of_steps = note_on_steps(report.steps);
  say(!of_steps.empty(), of_steps);
  return notes;
}

std::string note_lines(const Report& report) {
  std::string text;
  for (const std::string& note : behaviour(report)) text += "note: " + note + "\n";
  return text;
}

/// What is known of it already.
std::string accepted_line(const Report& report) {
  if (!report.accepted) return "";
  const auto& [file, faults, is_written] = *report.accepted;
  if (is_written)
    return "accepted: " + count(faults.size(), "fault", "faults") + ", written to " + printable(file) + "\n";
  const std::vector<std::string> news = report.accepted->news(report.judgement);
  const std::size_t known = report.judgement.faults.size() - news.size();
  std::string line = "accepted: " + count(known, "fault is", "faults are") + " in " + printable(file) + ", " +
                     count(news.size()) + " new";
  if (!news.empty()) line += ", the first " + message_line(news.front());
  if (known < faults.size())
    line += "; " + count(faults.size() - known) + " of the file are mended: remove it to accept anew";
  return line + "\n";
}

// -- The pairs --------------------------------------------------------------------------------------------------------

/// Without the rest of a letter that was cut.
std::string whole_letters(std::string text) {
  if (const auto cut = first_not_utf_8(text)) text.resize(*cut);
  return text;
}

/// `number`: of the next file.
ToldPair told_pair(const Judged& each, std::size_t number) {
  ToldPair pair{message_line(each.asked.name), what_came_of(each)};
  if (!can_be_drawn(each.asked.pair)) return pair;
  const std::string what =
      is_wrong(each.verdict) ? word(each.verdict) + ", " + how_far_in_words(each) : word(each.verdict);
  const nlohmann::json title = whole_letters((pair.name + ": " + what).substr(0, scene_limits::title));
  pair.file = std::to_string(number) + ".json";
  pair.scene = "{\"title\":" + title.dump() + "," + bodies_in_line({each.asked.pair.a, each.asked.pair.b}) + "}\n";
  return pair;
}

std::vector<ToldPair> told_pairs(const Judgement& judgement) {
  std::vector<ToldPair> pairs;
  std::size_t files = 0;
  for (const std::vector<Judged>* const list : lists_of(judgement))
    for (const Judged& each : *list) {
      pairs.push_back(told_pair(each, files + 1));
      files += !pairs.back().file.empty();
    }
  return pairs;
}

// -- The table --------------------------------------------------------------------------------------------------------

const Row columns{"family",         "pairs",     "wrong yes", "wrong no",
                  "wrong distance", "undecided", "no answer", "how far at most"};
constexpr std::ptrdiff_t of_distances = 4;

Row row_of(const Tally& tally) {
  const std::uint64_t open = tally.of(Verdict::undecided),
                      none = tally.faults() - tally.wrong() - open - tally.false_evidence;
  return {message_line(tally.family),
          count(tally.pairs),
          count(tally.of(Verdict::wrong_yes)),
          count(tally.of(Verdict::wrong_no)),
          count(tally.of(Verdict::wrong_distance)),
          count(open),
          count(none),
          tally.wrong() > 0 ? size_text(tally.worst) : ""};
}

// -- JSON -------------------------------------------------------------------------------------------------------------

using Json = nlohmann::ordered_json;

Json json_of(const Tally& tally) {
  Json all = {{"pairs", tally.pairs}};
  for (std::size_t i = 0; i < verdict_words.size(); ++i)
    if (tally.counts[i] > 0) all[word(static_cast<Verdict>(i))] = tally.counts[i];
  if (tally.false_evidence > 0) all["false evidence"] = tally.false_evidence;
  if (tally.wrong() > 0) all["worst"] = tally.worst;
  return all;
}

Json json_of(const Judged& each) {
  Json pair = {{"name", each.asked.name}, {"family", each.asked.family}, {"verdict", word(each.verdict)}};
  if (is_wrong(each.verdict)) {
    pair["relative"] = how_wrong(each);
    pair["length"] = each.how_far.length;
    pair["at_most"] = each.how_far.is_bound;
    if (each.distance) pair["distance"] = *each.distance;
  }
  if (!each.detail.empty()) pair["detail"] = printable(each.detail);
  pair.update(Json::parse(question_line({each.asked.pair.a, each.asked.pair.b})));
  return pair;
}

constexpr std::array kinds_of_findings{"wrong", "rounding", "otherwise"};

Json json_of(const StepsLooked& steps) {
  Json all = {{"searches", steps.searches}, {"steps", steps.steps},       {"wrong", steps.wrong},
              {"repaired", steps.repaired}, {"rounding", steps.rounding}, {"otherwise", steps.otherwise}};
  if (!steps.complaint.empty()) all["complaint"] = printable(steps.complaint);
  if (const LookedSearch* const shown = steps.shown()) {
    Json findings = Json::array();
    for (const StepFinding& each : shown->findings)
      findings.push_back({{"iteration", each.iteration}, {"is", kinds_of_findings[each.kind]}, {"words", each.words}});
    all["first"] = {{"name", printable(shown->run.name)}, {"findings", findings}};
  }
  return all;
}

Json list_of(const std::vector<Judged>& all) {
  Json list = Json::array();
  for (const Judged& each : all) list.push_back(json_of(each));
  return list;
}

}  // namespace

std::vector<std::string> Accepted::news(const Judgement& judgement) const {
  std::vector<std::string> news;
  for (const std::string& fault : judgement.faults)
    if (!faults.contains(fault)) news.push_back(fault);
  return news;
}

std::optional<std::string> why_not_judged(const Judgement& judgement) {
  const Replies& replies = judgement.replies;
  const auto of = [&](Verdict verdict) { return judgement.all.of(verdict); };
  const std::uint64_t answered = of(Verdict::right) + of(Verdict::within_tolerance) + judgement.all.wrong() +
                                 of(Verdict::undecided) + of(Verdict::not_a_number);
  const std::string first = judgement.failed.empty() ? ""
                                                     : " (" + judgement.failed.front().asked.name + ": " +
                                                           judgement.failed.front().detail + ")";
  const std::string last = last_line(replies.said);
  const std::string said = last.empty() ? "" : "; it wrote to standard error: " + message_line(last);
  const std::string others =
      said + (replies.others == 0 ? ""
                                  : "; what it prints, such as " + in_quotes(replies.first_other) +
                                        ", is no answer: yes, no, undecided or distance 0.25");
  if (replies.floods > 0 || replies.long_lines > 0)
    return "writes too much: more answers than it reads pairs, or too many or too long other lines" + others;
  if (answered == 0)
    return "answered none of " + std::to_string(judgement.all.pairs - of(Verdict::not_asked)) + " pairs" + first +
           others;
  if (replies.was_given_up)
    return "was given up after " + std::to_string(answered) + " answers: too many pairs in a row had none" + first +
           others;
  return std::nullopt;
}

std::string first_screen(const Report& report) {
  return verdict(report) + "\n" + worst_line(report) + scene_line(report) + cause_line(report) + next_line(report) +
         accepted_line(report) + first_wrong_step_line(report.steps) + note_lines(report);
}

std::string table(const Report& report) {
  std::vector<Row> rows{columns};
  for (const Tally& each : report.judgement.families) rows.push_back(row_of(each));
  rows.push_back(row_of(report.judgement.all));
  std::string text;
  for (Row& row : rows) {
    if (report.judgement.all.of(Verdict::wrong_distance) == 0) row.erase(row.begin() + of_distances);
    std::ranges::replace(row[0], '|', '/');
    for (const std::string& cell : row) text += "| " + cell + " ";
    text += "|\n";
    if (&row != &rows.front()) continue;
    for (std::size_t i = 0; i < row.size(); ++i) text += "|---";
    text += "|\n";
  }
  return text;
}

std::string steps_text(const Report& report) {
  const StepsLooked& steps = report.steps;
  std::string text;
  for (const LookedSearch& search : steps.found)
    for (std::set<std::string> told; const StepFinding& each : search.findings) {
      if (!told.insert(each.words).second) continue;  // a search that goes round
      text += message_line(search.run.name) + ", iteration " + std::to_string(each.iteration) +
              (each.kind == StepFinding::otherwise ? ", as right: " : ": ") + message_line(each.words) + "\n";
      for (const std::size_t m : each.mistakes)
        text += "  that is what follows from M" + std::to_string(m + 1) + ": " + mistakes()[m].name + "\n";
    }
  const std::string note = note_on_steps(steps);
  return text + (note.empty() ? "it tells no steps; 'gjkstep judge --help' says how" : note) + "\n";
}

std::string json(const Report& report) {
  const Judgement& found = report.judgement;
  Json causes = Json::array(), families = Json::object();
  for (const Cause& each : report.causes) {
    causes.push_back({{"cause", each.name}, {"agreement", each.agreement}, {"evidence", each.evidence}});
    if (!each.mistake.empty()) causes.back()["mistake"] = each.mistake;
  }
  for (const Tally& each : found.families) families[printable(each.family)] = json_of(each);
  Json all = {{"schema", "gjkstep-judged"},    {"program", printable(report.program)},
              {"right", found.is_good()},      {"all", json_of(found.all)},
              {"families", families},          {"causes", causes},
              {"worst", list_of(found.worst)}, {"failed", list_of(found.failed)},
              {"open", list_of(found.open)},   {"notes", note_lines(report)}};
  if (report.steps.searches > 0 || !report.steps.complaint.empty()) all["steps"] = json_of(report.steps);
  if (report.accepted) all["new"] = report.accepted->news(found);
  return all.dump(1) + "\n";
}

std::vector<SavedScene> scenes_of_worst(const Judgement& judgement) {
  std::vector<SavedScene> files;
  for (const ToldPair& each : told_pairs(judgement))
    if (!each.file.empty()) files.push_back({each.file, each.scene});
  return files;
}

Told told(const Report& report) {
  Told all{.verdict = verdict(report), .accepted = accepted_line(report), .columns = columns};
  for (const Cause& each : report.causes)
    all.causes.push_back({each.name, each.evidence, std::lround(100 * each.agreement), what_to_do(report, each)});
  if (const LookedSearch* const shown = report.steps.shown()) all.first_wrong_step = words_of_first_wrong(*shown);
  all.pairs = told_pairs(report.judgement);
  for (const Tally& each : report.judgement.families)
    (each.faults() > 0 ? all.with_faults : all.without_faults).push_back(row_of(each));
  all.all = row_of(report.judgement.all);
  all.notes = behaviour(report);
  all.command = command(report, "--report " + shell_word(report.shown));
  return all;
}

}  // namespace walkthroughs::judge
