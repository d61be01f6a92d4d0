#include "tests/study/judge/judged_text.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/study/judge/markdown.hpp"
#include "tests/study/methods/mistakes.hpp"
#include "walkthroughs/text/printable.hpp"

namespace study {
namespace {

using walkthroughs::text::message_line;
using walkthroughs::text::printable;

constexpr double alike_enough = 0.5;
constexpr std::size_t most_resemblances = 3;

std::string count_of(std::uint64_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

// -- Sentences --------------------------------------------------------------------------------------------------------

std::string pairs_in_common(const Resemblance& best) {
  std::string words = count_of(best.both, "pair", "pairs") + " in common, of " + std::to_string(best.either) +
                      " that the one or the other answers wrongly";
  if (best.first_direction.starts_with("from"))
    words += ", begun " + best.first_direction;
  else if (!best.first_direction.empty())
    words += ", begun along " + best.first_direction;
  if (best.mistake) words += "; what misleads the report's algorithm, too, is not counted";
  return words;
}

/// Returns: in which numbers rounding explains all that is wrong. That it may be in floats says little of who is not like them:
/// many pairs differ by less.
std::optional<Numbers> numbers_that_explain(const ProgramJudged& judged) {
  const LaidToRounding& rounding = judged.rounding;
  if (rounding.in_doubles == rounding.wrong) return Numbers::doubles;
  const bool is_like_floats = !judged.resemblances.empty() && judged.resemblances.front().sound_in == Numbers::floats;
  return is_like_floats && rounding.in_floats == rounding.wrong ? std::optional(Numbers::floats) : std::nullopt;
}

/// What no mistake of the study explains, rounding may.
void add_rounding(const ProgramJudged& judged, std::vector<std::string>& sentences) {
  const LaidToRounding& rounding = judged.rounding;
  if (rounding.wrong == 0) return;
  const std::string others = "a limit of iterations, or a tolerance, is not among the mistakes";
  const std::string wrong = count_of(rounding.wrong, "wrong answer", "wrong answers") + " about sets of points";
  if (const auto numbers = numbers_that_explain(judged))
    sentences.push_back("Nothing but rounding and cycles need be wrong with it: in " +
                        std::string(numbers_words[static_cast<std::size_t>(*numbers)]) + " they explain all of its " +
                        wrong + "; " + others + ", and may show on no other pairs.");
  else
    sentences.push_back("Rounding and cycles do not explain all of it: in doubles " +
                        std::to_string(rounding.in_doubles) + " of its " + wrong + ", in floats " +
                        std::to_string(rounding.in_floats) + "; " + others + ", and may be the reason.");
}

/// Returns: how the sentence begins that names the most alike.
std::string likeness(const ProgramJudged& judged) {
  const Resemblance& best = judged.resemblances.front();
  if (!best.has_evidence()) return "Too few pairs to name a mistake; the nearest is ";
  if (best.sound_in) return "It answers most like ";
  return best.share() >= alike_enough ? "It behaves like "
                                      : "No single mistake of the study explains it; the nearest is ";
}

void add_resemblance(const ProgramJudged& judged, std::vector<std::string>& sentences) {
  if (judged.all.of(Verdict::wrong_yes) + judged.all.of(Verdict::wrong_no) == 0) return;
  if (judged.resemblances.empty()) {
    sentences.emplace_back("No mistake of the study is wrong on any of the same pairs.");
    return add_rounding(judged, sentences);
  }
  const Resemblance& best = judged.resemblances.front();
  sentences.push_back(likeness(judged) + best.name + ": " + pairs_in_common(best) + ".");
  const bool is_explained = !best.sound_in && best.has_evidence() && best.share() >= alike_enough;
  if (!is_explained) add_rounding(judged, sentences);
}

void add_end(const ProgramJudged& judged, std::vector<std::string>& sentences) {
  const Replies& replies = judged.replies;
  if (replies.was_given_up)
    sentences.push_back(
        "It was given up after several pairs in a row without an answer or with more lines than one, or many runs that "
        "answered a few pairs and then had to be ended; " +
        count_of(judged.all.of(Verdict::not_asked), "pair was", "pairs were") + " not asked.");
  if (replies.crashes_in_company > 0)
    sentences.push_back("It crashed " + count_of(replies.crashes_in_company, "time", "times") +
                        ", though each of the pairs has its answer in another run: " + replies.first_crash +
                        ", the first time after " + count_of(replies.answers_before_first_crash, "answer", "answers") +
                        " of a run.");
  if (replies.late_in_company > 0)
    sentences.push_back("It was too late " + count_of(replies.late_in_company, "time", "times") +
                        ", though each of the pairs has its answer in another run: the first time after " +
                        count_of(replies.answers_before_first_late, "answer", "answers") +
                        " of a run. If it keeps answers back, let it flush after each.");
  if (replies.early_ends > 0)
    sentences.push_back("It ended " + count_of(replies.early_ends, "time", "times") +
                        " (exit code 0) before it had answered all of its pairs, and was started again.");
  if (replies.floods > 0)
    sentences.push_back("It writes more lines than it reads: one answer a line, and nothing else on standard output.");
  if (replies.long_lines > 0)
    sentences.push_back("It writes a line longer than 1 MB: one short line an answer, with a line feed at its end.");
  if (replies.closes_its_input)
    sentences.push_back("It closes its standard input before it has answered all of its pairs.");
  if (replies.outlives_its_input) sentences.push_back("It does not end when its input ends, and was ended.");
  for (const Judged& each : judged.pairs)
    if (!each.detail.empty()) {
      sentences.push_back("First pair without an answer: " + message_line(each.named.name) + ": " +
                          message_line(each.detail) + ".");
      break;
    }
  const std::size_t last = replies.said.find_last_not_of(" \r\n");
  if (last != std::string::npos) {
    const std::string said = replies.said.substr(0, last + 1);
    const std::size_t feed = said.rfind('\n');
    sentences.push_back(
        "It wrote to standard error: " + message_line(said.substr(feed == std::string::npos ? 0 : feed + 1)) + ".");
  }
}

// -- Tables -----------------------------------------------------------------------------------------------------------

constexpr std::array<Verdict, 7> columns{Verdict::wrong_yes, Verdict::wrong_no, Verdict::undecided, Verdict::unreadable,
                                         Verdict::ended,     Verdict::late,     Verdict::not_asked};

Cells cells_of(const FamilyTally& tally, bool is_sample) {
  Cells cells{tally.family, std::to_string(tally.pairs)};
  for (const Verdict verdict : columns) cells.push_back(std::to_string(tally.of(verdict)));
  cells.push_back(tally.evidence == 0 ? "–"
                                      : std::to_string(tally.false_evidence) + " of " + std::to_string(tally.evidence));
  if (is_sample) cells.push_back(in_words(tally.wrong));
  return cells;
}

Table family_table(const ProgramJudged& judged, bool is_sample) {
  Table table{"By family", {"Family", "Pairs"}, 1};
  for (const Verdict verdict : columns) table.titles.emplace_back(verdict_words[static_cast<std::size_t>(verdict)]);
  table.titles.emplace_back("evidence that proves nothing");
  if (is_sample) table.titles.emplace_back("wrong, with the 95 % interval");
  std::size_t all_right = 0;
  for (const FamilyTally& family : judged.families)
    if (family.of(Verdict::right) == family.pairs && family.false_evidence == 0)
      ++all_right;
    else
      table.rows.push_back(cells_of(family, is_sample));
  table.rows.push_back(cells_of(judged.all, is_sample));
  if (all_right > 0)
    table.sentences.push_back(count_of(all_right, "family", "families") + " of which every pair is answered rightly " +
                              (all_right == 1 ? "has" : "have") + " no line.");
  if (!is_sample)
    table.sentences.emplace_back("These pairs are chosen, not thrown: their rates say nothing of other pairs.");
  if (judged.all.evidence == 0) table.sentences.emplace_back("No answer came with evidence.");
  return table;
}

Table mistake_table(const ProgramJudged& judged) {
  Table table{"Which mistake answers most alike",
              {"Mistake", "Section of the report", "Both wrong", "One or both wrong", "In common", "Begun"},
              2};
  for (std::size_t i = 0; i < std::min(most_resemblances, judged.resemblances.size()); ++i) {
    const Resemblance& each = judged.resemblances[i];
    table.rows.push_back({each.name, each.mistake ? mistakes()[*each.mistake].section : "–", std::to_string(each.both),
                          std::to_string(each.either), percent(each.share()),
                          each.first_direction.empty() ? "–" : each.first_direction});
  }
  return table;
}

Table change_table(const ProgramJudged& judged) {
  Table table{
      "Asked again after what must not change the answer", {"What was done", "Asked", "Other answers", "First"}, 1};
  for (const Change& change : judged.changes) {
    if (change.wrong_no > 0)
      table.sentences.push_back("A set has its own points in common with itself: of the last line " +
                                count_of(change.wrong_no, "answer is a wrong no.", "answers are wrong no's."));
    table.rows.push_back({std::string(change.what), std::to_string(change.asked), std::to_string(change.other_answers),
                          change.first.empty() ? "–" : printable(change.first)});
  }
  return table;
}

/// One mistake makes wrong steps of many kinds, many mistakes may make one: what counts is which makes most.
void add_what_makes_most(const std::vector<JudgedSteps>& steps, Table& table) {
  std::vector<std::uint64_t> made(mistakes().size());
  std::uint64_t wrong = 0;
  for (const JudgedSteps& each : steps) {
    wrong += each.iteration > 0 && !each.may_be_rounding;
    for (const std::size_t m : each.mistakes) ++made[m];
  }
  const auto most = std::ranges::max_element(made);
  if (wrong < 2 || *most == 0) return;
  std::string names;
  for (std::size_t m = 0; m < made.size(); ++m)
    if (made[m] == *most) names += (names.empty() ? "M" : ", M") + std::to_string(m + 1);
  table.sentences.push_back("Of these " + std::to_string(wrong) + " wrong steps " + std::to_string(*most) +
                            (*most == 1 ? " follows" : " follow") + " from " + names +
                            (*most == wrong ? "." : ": no mistake of the study makes them all."));
}

Table step_table(const ProgramJudged& judged) {
  Table table{"The first wrong step", {"Pair", "Iteration", "What is wrong", "That is what follows from"}, 4};
  if (!judged.steps) return table;
  for (const JudgedSteps& each : *judged.steps) {
    std::string follows;
    for (const std::size_t m : each.mistakes)
      follows += (follows.empty() ? "M" : "; M") + std::to_string(m + 1) + ": " + mistakes()[m].name;
    table.rows.push_back({printable(each.pair), each.iteration == 0 ? "–" : std::to_string(each.iteration),
                          printable(each.words), follows.empty() ? "–" : follows});
  }
  add_what_makes_most(*judged.steps, table);
  std::set<std::string> families;
  for (const Judged& each : judged.pairs)
    if (each.has_search()) families.insert(each.named.family);
  if (families.size() > table.rows.size())
    table.sentences.push_back("Of " + std::to_string(families.size()) + " families with failures " +
                              (table.rows.size() == 1
                                   ? "that of the smallest pair is told."
                                   : "the " + std::to_string(table.rows.size()) + " of the smallest pairs are told."));
  return table;
}

/// Names of others may hold anything.
std::string markdown_cell(const std::string& text) {
  std::string cell;
  for (const char c : printable(text)) cell += c == '|' ? "\\|" : c == '<' ? "\\<" : std::string(1, c);
  return cell;
}

void write(std::ostream& out, const Table& table) {
  out << "## " << table.heading << "\n\n";
  heading(out, table.titles, table.words);
  for (Cells cells : table.rows) {
    std::ranges::transform(cells, cells.begin(), markdown_cell);
    row(out, cells);
  }
  out << '\n';
  for (const std::string& sentence : table.sentences) paragraph(out, sentence);
}

// -- JSON -------------------------------------------------------------------------------------------------------------

using Json = nlohmann::ordered_json;

std::string key_of(Verdict verdict) {
  std::string key(verdict_words[static_cast<std::size_t>(verdict)]);
  std::ranges::replace(key, ' ', '_');
  return key;
}

Json json_of(const FamilyTally& tally, bool is_sample) {
  Json object{{"family", tally.family}, {"pairs", tally.pairs}, {"right", tally.of(Verdict::right)}};
  for (const Verdict verdict : columns) object[key_of(verdict)] = tally.of(verdict);
  object["evidence"] = tally.evidence;
  object["false_evidence"] = tally.false_evidence;
  if (is_sample) object["wrong_interval"] = {tally.wrong.interval().low, tally.wrong.interval().high};
  return object;
}

Json json_of(const Judged& judged) {
  Json object{{"name", judged.named.name},
              {"family", judged.named.family},
              {"truth", judged.truth == Truth::intersecting ? "intersecting" : "separated"},
              {"verdict", key_of(judged.verdict)}};
  if (judged.false_evidence) object["false_evidence"] = true;
  if (!judged.detail.empty()) object["detail"] = judged.detail;
  return object;
}

Json json_of(const JudgedSteps& steps) {
  Json object{{"name", steps.pair}, {"iteration", steps.iteration == 0 ? Json() : Json(steps.iteration)}};
  object["words"] = steps.words;
  if (steps.may_be_rounding) object["may_be_rounding"] = true;
  object["mistakes"] = Json::array();
  for (const std::size_t m : steps.mistakes) object["mistakes"].push_back(m + 1);
  return object;
}

}  // namespace

std::string verdict_line(const ProgramJudged& judged) {
  const std::string pairs = count_of(judged.all.pairs, "pair", "pairs");
  const std::uint64_t undecided = judged.all.of(Verdict::undecided);
  const std::string left = undecided == 0 ? "" : ", " + std::to_string(undecided) + " undecided";
  if (judged.is_good() && undecided == judged.all.pairs)
    return "nothing is wrong, and nothing decided: " + pairs + left;
  if (judged.is_good()) return "nothing is wrong: " + pairs + left;
  const std::uint64_t wrong = judged.all.wrong.count, not_asked = judged.all.of(Verdict::not_asked);
  const std::uint64_t unanswered =
      judged.all.of(Verdict::unreadable) + judged.all.of(Verdict::ended) + judged.all.of(Verdict::late);
  std::string line = wrong == 0 ? "something is wrong: " + pairs : "wrong: " + std::to_string(wrong) + " of " + pairs;
  if (unanswered > 0) line += ", " + std::to_string(unanswered) + " of these without an answer";
  if (not_asked > 0) line += ", " + std::to_string(not_asked) + " not asked";
  line += left;
  if (const std::uint64_t unproved = judged.all.false_evidence; unproved > 0)
    line += "; " + count_of(unproved, "right answer has", "right answers have") + " evidence that proves nothing";
  std::uint64_t changed = 0, wrong_no = 0;
  for (const Change& change : judged.changes) {
    changed += change.other_answers - change.wrong_no;
    wrong_no += change.wrong_no;
  }
  if (changed > 0) line += "; " + count_of(changed, "answer", "answers") + " changed where nothing may";
  if (wrong_no > 0) line += "; " + count_of(wrong_no, "wrong no", "wrong no's") + " of a set with itself";
  return line;
}

std::vector<std::string> remarks(const ProgramJudged& judged) {
  std::vector<std::string> sentences;
  add_resemblance(judged, sentences);
  add_end(judged, sentences);
  return sentences;
}

std::vector<Table> tables_of(const ProgramJudged& judged, bool is_sample) {
  std::vector<Table> all{family_table(judged, is_sample), mistake_table(judged), change_table(judged),
                         step_table(judged)};
  std::erase_if(all, [](const Table& table) { return table.rows.empty(); });
  return all;
}

std::string judged_markdown(const ProgramJudged& judged, const JudgedHead& head) {
  std::ostringstream out;
  out << "# " << message_line(head.program) << ": " << verdict_line(judged) << "\n\n";
  for (const std::string& sentence : remarks(judged)) out << "* " << sentence << '\n';
  out << "* made by: `" << message_line(head.command) << "`\n\n";
  for (const Table& table : tables_of(judged, head.is_sample)) write(out, table);
  return out.str();
}

std::string judged_json(const ProgramJudged& judged, const JudgedHead& head) {
  Json all{{"program", head.program}, {"command", head.command}, {"good", judged.is_good()}};
  all["remarks"] = remarks(judged);
  all["all"] = json_of(judged.all, head.is_sample);
  for (const FamilyTally& family : judged.families) all["families"].push_back(json_of(family, head.is_sample));
  all["laid_to_rounding"] = {{"wrong", judged.rounding.wrong},
                             {"in_doubles", judged.rounding.in_doubles},
                             {"in_floats", judged.rounding.in_floats}};
  all["mistakes"] = Json::array();
  for (const Resemblance& each : judged.resemblances)
    all["mistakes"].push_back({{"number", each.mistake ? Json(*each.mistake + 1) : Json()},
                               {"name", each.name},
                               {"both_wrong", each.both},
                               {"either_wrong", each.either},
                               {"first_direction", each.first_direction}});
  all["changes"] = Json::array();
  for (const Change& change : judged.changes)
    all["changes"].push_back({{"what", change.what},
                              {"asked", change.asked},
                              {"other_answers", change.other_answers},
                              {"wrong_no", change.wrong_no},
                              {"first", change.first}});
  if (judged.steps) {
    all["steps"] = Json::array();
    for (const JudgedSteps& each : *judged.steps) all["steps"].push_back(json_of(each));
  }
  all["not_right"] = Json::array();
  for (const Judged& each : judged.pairs)
    if (each.verdict != Verdict::right || each.false_evidence) all["not_right"].push_back(json_of(each));
  return all.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace study
