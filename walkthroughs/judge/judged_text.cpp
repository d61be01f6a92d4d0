#include "walkthroughs/judge/judged_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "walkthroughs/text/printable.hpp"

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
std::string size_text(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

std::string word(Verdict verdict) { return std::string(verdict_words[static_cast<std::size_t>(verdict)]); }

// -- The first screen -------------------------------------------------------------------------------------------------

std::string verdict_line(const Report& report) {
  const Tally& all = report.judgement.all;
  std::string line = printable(report.program) + ": ";
  const std::string pairs = count(all.pairs, "pair", "pairs");
  if (report.judgement.is_good())
    line += "right on all " + pairs;
  else
    line += "wrong on " + count(all.faults()) + " of " + pairs;
  std::string parts;
  for (std::size_t i = 1; i < verdict_words.size(); ++i)
    if (all.counts[i] > 0)
      parts += (parts.empty() ? ": " : ", ") + count(all.counts[i]) + " " + word(static_cast<Verdict>(i));
  if (all.false_evidence > 0)
    parts += (parts.empty() ? ": " : ", ") + count(all.false_evidence) + " right with evidence that proves nothing";
  if (report.judgement.passed_over > 0)
    parts += "; " + count(report.judgement.passed_over) + " not asked, as floats have no room for them";
  return line + parts + "\n";
}

std::string how_far_in_words(const Judged& each) {
  const bool meet = each.asked.meet();
  if (each.how_far.length == 0) return meet ? "they touch" : "they are apart by less than a double can say";
  const std::string most = each.how_far.is_bound ? "at most " : "";
  return (meet ? "they are " : "they are apart by ") + most + size_text(each.how_far.relative) +
         (meet ? " of their size deep in each other" : " of their size");
}

std::string worst_line(const Report& report) {
  const Judgement& found = report.judgement;
  if (!found.worst.empty()) {
    const Judged& worst = found.worst.front();
    return "worst: " + message_line(worst.asked.name) + ": " + how_far_in_words(worst) + ", and it says " +
           (worst.asked.meet() ? "no" : "yes") + "\n";
  }
  if (found.failed.empty()) return "";
  const Judged& first = found.failed.front();
  return "first without an answer: " + message_line(first.asked.name) + ": " +
         (first.detail.empty() ? word(first.verdict) : message_line(first.detail)) + "\n";
}

const Judged* shown_pair(const Judgement& found) {
  return !found.worst.empty() ? &found.worst.front() : !found.failed.empty() ? &found.failed.front() : nullptr;
}

std::string command(const Report& report, const std::string& more) {
  return "gjkstep judge " + report.options + more + " -- " + report.program;
}

std::string scene_line(const Report& report) {
  const Judged* const shown = shown_pair(report.judgement);
  if (!shown) return "";
  const std::string scene = question_line({shown->asked.pair.a, shown->asked.pair.b});
  return "its scene: " +
         (scene.size() <= longest_scene     ? scene
          : can_be_drawn(shown->asked.pair) ? "of many points; --save wrong writes it to wrong/1-….json"
                                            : "beyond what is drawn: its numbers are too large") +
         "\n";
}

std::string cause_line(const Report& report) {
  if (report.judgement.all.wrong() == 0) return "";
  if (report.causes.empty()) return "probable cause: no cause found\n";
  const Cause& cause = report.causes.front();
  return "probable cause: " + cause.name + " (" + cause.evidence + ")\n";
}

std::string next_line(const Report& report) {
  const Judgement& found = report.judgement;
  if (found.is_good())
    return "next: gjkstep judge " + std::string(report.options.empty() ? "--count 1000 " : "") + "-- " +
           report.program + "\n";
  if (!report.causes.empty() && !report.causes.front().mistake.empty())
    return "next: gjkstep render mistakes/" + report.causes.front().mistake + "\n";
  if (found.all.wrong() == 0) return "next: " + command(report, "--table") + "\n";
  return "next: " + command(report, "--save wrong") + "; gjkstep render wrong/1-*.json\n";
}

/// What is odd, whether answers are right or not.
std::string behaviour(const Judgement& found) {
  const Replies& replies = found.replies;
  std::string text;
  const auto say = [&](bool is_so, const std::string& what) {
    if (is_so) text += "note: " + what + "\n";
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
  say(replies.closes_its_input, "it closes its standard input before it has answered all");
  say(replies.outlives_its_input, "it does not end when its input ends");
  say(replies.others > 0,
      "it also prints " + count(replies.others, "line that is no answer", "lines that are no answers") +
          ", the first " + in_quotes(replies.first_other) + "; an answer is yes, no, undecided or distance 0.25");
  const std::size_t last = replies.said.find_last_not_of(" \r\n");
  if (last != std::string::npos) {
    const std::string said = replies.said.substr(0, last + 1);
    const std::size_t feed = said.rfind('\n');
    say(true, "it wrote to standard error: " + message_line(said.substr(feed == std::string::npos ? 0 : feed + 1)));
  }
  return text;
}

/// What is known of it already.
std::string accepted_line(const Report& report) {
  if (!report.accepted) return "";
  const auto& [file, names] = *report.accepted;
  const std::vector<std::string> news = report.accepted->news(report.judgement);
  const std::size_t known = report.judgement.faulty.size() - news.size();
  std::string line = "accepted: " + count(known, "fault is", "faults are") + " in " + printable(file) + ", " +
                     count(news.size()) + " new";
  if (!news.empty()) line += ", the first " + message_line(news.front());
  if (known < names.size()) line += "; " + count(names.size() - known) + " of the file are mended";
  return line + "\n";
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
    pair["relative"] = each.how_far.relative;
    pair["length"] = each.how_far.length;
    pair["at_most"] = each.how_far.is_bound;
  }
  if (!each.detail.empty()) pair["detail"] = printable(each.detail);
  pair.update(Json::parse(question_line({each.asked.pair.a, each.asked.pair.b})));
  return pair;
}

Json list_of(const std::vector<Judged>& all) {
  Json list = Json::array();
  for (const Judged& each : all) list.push_back(json_of(each));
  return list;
}

}  // namespace

std::vector<std::string> Accepted::news(const Judgement& judgement) const {
  std::vector<std::string> news;
  for (const std::string& name : judgement.faulty)
    if (!names.contains(name)) news.push_back(name);
  return news;
}

std::string first_screen(const Report& report) {
  return verdict_line(report) + worst_line(report) + scene_line(report) + cause_line(report) + next_line(report) +
         accepted_line(report) + behaviour(report.judgement);
}

std::string table(const Report& report) {
  std::string text =
      "| family | pairs | wrong yes | wrong no | undecided | no answer | how far at most "
      "|\n|---|---|---|---|---|---|---|\n";
  std::vector<Tally> rows = report.judgement.families;
  rows.push_back(report.judgement.all);
  for (const Tally& row : rows) {
    const std::uint64_t none = row.faults() - row.wrong() - row.false_evidence;
    text += "| " + message_line(row.family) + " | " + count(row.pairs) + " | " + count(row.of(Verdict::wrong_yes)) +
            " | " + count(row.of(Verdict::wrong_no)) + " | " + count(row.of(Verdict::undecided)) + " | " + count(none) +
            " | " + (row.wrong() > 0 ? size_text(row.worst) : "") + " |\n";
  }
  return text;
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
              {"notes", behaviour(found)}};
  if (report.accepted) all["new"] = report.accepted->news(found);
  return all.dump(1) + "\n";
}

std::vector<SavedScene> scenes_of_worst(const Report& report) {
  std::vector<SavedScene> files;
  for (const std::vector<Judged>* const list : {&report.judgement.worst, &report.judgement.failed})
    for (const Judged& each : *list) {
      const Pair pair{each.asked.pair.a, each.asked.pair.b};
      if (!can_be_drawn(each.asked.pair)) continue;
      std::string name = each.asked.name.substr(0, 60);
      for (char& letter : name)
        if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '-';
      const std::string what =
          is_wrong(each.verdict) ? word(each.verdict) + ", " + how_far_in_words(each) : word(each.verdict);
      files.push_back({std::to_string(files.size() + 1) + "-" + name + ".json",
                       "// " + printable(report.program) + ": " + what +
                           "\n// What is drawn is the report's algorithm, not that program.\n" + question_line(pair) +
                           "\n"});
    }
  return files;
}

}  // namespace walkthroughs::judge
