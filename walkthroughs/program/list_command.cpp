// gjkstep list: the walkthroughs that there are.

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/program/command_line.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/story/words.hpp"
#include "walkthroughs/text/names.hpp"
#include "walkthroughs/text/printable.hpp"

namespace walkthroughs::program {
namespace {

/// Returns: what stands before the last '/', or nothing.
std::string folder_of(const Walkthrough& w) {
  const std::size_t slash = w.name.rfind('/');
  return slash == std::string::npos ? "" : w.name.substr(0, slash);
}

std::size_t length(const std::string& text) { return code_points(text).size(); }

/// Returns: the blanks that `text` lacks to be so wide.
std::string rest_of(std::size_t width, const std::string& text) { return std::string(width - length(text), ' '); }

/// Returns: the summary, behind the report's name of the region ("R7: ") where it does not say that itself.
std::string summary_of(const Walkthrough& w) {
  if (!w.region_case) return w.summary;
  const std::string region = w.region_case->text.substr(0, 2);
  const bool is_missing = region[0] == 'R' && w.summary.find(region) == std::string::npos;
  return is_missing ? region + ": " + w.summary : w.summary;
}

using Row = std::array<std::string, 5>;

std::string how_it_ends(const Story& story) {
  const auto answer = [](const Telling& telling) { return to_string(answer_of(telling.trace)); };
  return story.tellings.empty() ? "-" : joined(story.tellings, ", ", answer);
}

/// What is true, where one search answers otherwise.
std::string truth_beside(const Story& story) {
  for (const Telling& telling : story.tellings)
    if (is_otherwise(telling.truth, answer_of(telling.trace)))
      return " (in truth " + std::string(to_string(telling.truth.answer.status)) + ")";
  return "";
}

Row row_of(const Walkthrough& w) {
  const Story story = tell(w);
  return {w.name, plain(w.region_case ? w.region_case->text : w.summary),
          w.region_case ? w.region_case->section : w.source, how_it_ends(story) + truth_beside(story),
          std::to_string(story.frames.size())};
}

void write_row(std::ostream& out, const Row& row, const std::array<std::size_t, 5>& widths) {
  for (std::size_t column = 0; column + 1 < row.size(); ++column)
    out << row[column] << rest_of(widths[column] + 2, row[column]);
  out << rest_of(widths.back(), row.back()) << row.back() << '\n';  // a number: to the right
}

/// Writes one line for each walkthrough, name and summary, the folders one after the other with an empty line between.
void write_list(std::ostream& out, const std::vector<Walkthrough>& walkthroughs) {
  std::vector<std::string> folders;
  for (const Walkthrough& w : walkthroughs)
    if (std::ranges::count(folders, folder_of(w)) == 0) folders.push_back(folder_of(w));
  for (const std::string& folder : folders) {
    if (folder != folders.front()) out << '\n';
    std::size_t widest = 0;
    for (const Walkthrough& w : walkthroughs)
      if (folder_of(w) == folder) widest = std::max(widest, length(w.name));
    for (const Walkthrough& w : walkthroughs)
      if (folder_of(w) == folder) out << w.name << rest_of(widest + 2, w.name) << summary_of(w) << '\n';
  }
}

/// Writes a table with a header: name, case (of those that have none their summary), section of the report, how the
/// search ends, and the number of frames. Runs the scenes.
void write_table(std::ostream& out, const std::vector<const Walkthrough*>& walkthroughs) {
  std::vector<Row> rows = {{"name", "case", "section", "status", "frames"}};
  for (const Walkthrough* w : walkthroughs) rows.push_back(row_of(*w));
  std::array<std::size_t, 5> widths{};
  for (const Row& row : rows)
    for (std::size_t column = 0; column < row.size(); ++column)
      widths[column] = std::max(widths[column], length(row[column]));
  for (const Row& row : rows) write_row(out, row, widths);
}

struct ListCommand {
  std::optional<std::string> name;

  /// Errors: UsageError where nothing has that name or says that word.
  int run() const {
    if (name)
      write_table(std::cout, found());
    else
      write_list(std::cout, whole_catalogue());
    return ok;
  }

 private:
  std::vector<const Walkthrough*> found() const {
    if (name->find_first_not_of(' ') == std::string::npos)
      throw UsageError(in_quotes(*name) + " is no word to look for; leave it out: 'gjkstep list' shows all");
    std::vector<const Walkthrough*> found = find_walkthroughs(*name);
    if (found.empty()) found = walkthroughs_that_say(*name);
    if (found.empty())
      throw UsageError("no walkthrough has or says " + in_quotes(*name) + "; " + did_you_mean(nearest_name(*name)) +
                       "'gjkstep list' shows all");
    return found;
  }
};

}  // namespace

Command add_list_command(CLI::App& app) {
  const auto list = std::make_shared<ListCommand>();
  CLI::App* const command =
      app.add_subcommand("list", "the walkthroughs, one line each, or those of a folder or with a word");
  command->add_option(
      "NAME", list->name,
      "a folder, a walkthrough, or a word of names, titles and cases such as R7: the cases and how they "
      "end, as a table");
  return {command, [list] { return list->run(); }};
}

}  // namespace walkthroughs::program
