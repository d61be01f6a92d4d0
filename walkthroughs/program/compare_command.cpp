// gjkstep compare: are two pictures, or two folders of pictures, the same?

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/compare_report.hpp"
#include "render/file.hpp"
#include "walkthroughs/output/manifest.hpp"
#include "walkthroughs/program/command_line.hpp"
#include "walkthroughs/program/places.hpp"
#include "walkthroughs/text/printable.hpp"

namespace walkthroughs::program {
namespace {

namespace fs = std::filesystem;

enum Answer { same = 0, different = 1, unreadable = 3 };

fs::file_type kind_of(const std::string& word) {
  std::error_code error;
  const fs::file_status status = fs::status(word, error);
  if (!fs::exists(status))
    throw render::ReadError("cannot read " + word + ": " + (error ? error.message() : "No such file or directory") +
                            "; name a PNG file or a folder of them");
  return status.type();
}

/// Returns: the pictures to compare, at least one.
std::vector<render::FilePair> pairs_of(const std::string& expected, const std::string& actual) {
  const bool expected_folder = kind_of(expected) == fs::file_type::directory,
             actual_folder = kind_of(actual) == fs::file_type::directory;
  if (expected_folder != actual_folder)
    throw UsageError("compare: '" + (expected_folder ? expected : actual) + "' is a folder and '" +
                     (expected_folder ? actual : expected) + "' is not; name two files or two folders");
  if (!expected_folder) return {{fs::path(actual).filename().string(), expected, actual}};
  std::vector<render::FilePair> pairs = render::file_pairs(expected, actual);
  if (pairs.empty())
    throw UsageError("compare: there is no .png file in '" + expected + "' nor in '" + actual +
                     "'; name folders of pictures");
  return pairs;
}

/// Returns: the command that makes the new state the expected one; empty where that would accept a damaged file.
std::string accept_command(const render::ComparedFiles& compared) {
  const render::FilePair& files = compared.files;
  if (compared.verdict == render::Verdict::unreadable) return "";
  if (files.sides == render::Sides::only_expected) return "rm " + shell_word(files.expected);
  const fs::path folder = files.expected.parent_path();
  std::error_code unknown;
  const bool is_in_the_way = fs::is_directory(files.expected, unknown);  // cp would copy into it
  const std::string copy = (is_in_the_way ? "rm -r " + shell_word(files.expected) + " && " : "") + "cp " +
                           shell_word(files.actual) + " " + shell_word(files.expected);
  if (folder.empty() || fs::is_directory(folder, unknown)) return copy;
  return "mkdir -p " + shell_word(folder) + " && " + copy;
}

fs::path folder_of(const std::string& side) {
  return fs::is_directory(side) ? fs::path(side) : fs::path(side).parent_path();
}

render::CompareReport empty_report(const std::string& expected, const std::string& actual) {
  return render::CompareReport({.expected = expected,
                                .actual = actual,
                                .expected_by = render::read_rendered_by(folder_of(expected)),
                                .actual_by = render::read_rendered_by(folder_of(actual)),
                                .where = fs::current_path().string()});
}

constexpr const char* page_of_report = "index.html";

Places places_of(const std::vector<render::FilePair>& pairs, const fs::path& report) {
  Places places;
  for (const render::FilePair& files : pairs) {
    places.read(files.expected, "the picture " + files.expected.string());
    places.read(files.actual, "the picture " + files.actual.string());
  }
  places.write(report / page_of_report, "the page of --report");
  places.write_standard_output();
  return places;
}

/// Counts verdicts, and says each that is not plainly "same".
class Tally {
 public:
  void add(const render::ComparedFiles& compared) {
    ++count_[compared.verdict];
    const std::string line = compared.verdict == render::Verdict::unreadable
                                 ? compared.words
                                 : compared.files.name + ": " + render::name(compared.verdict) + ": " + compared.words;
    if (compared.verdict == render::Verdict::unreadable)
      std::cerr << "gjkstep: " << message_line(line) << std::endl;
    else if (compared.verdict != render::Verdict::same)
      std::cout << message_line(line) << std::endl;
    for (const std::string& note : compared.notes)
      std::cout << message_line(compared.files.name + ": note: " + note) << std::endl;
  }

  /// Returns: "2 of 5 pictures fail: 1 different, 1 missing" or "5 pictures are the same, 1 of them within the tolerance".
  std::string summary() const {
    int all = 0, failed = 0;
    std::string kinds;
    for (const auto& [verdict, count] : count_) {
      all += count;
      if (render::passes(verdict)) continue;
      failed += count;
      kinds += (kinds.empty() ? "" : ", ") + std::to_string(count) + " " + render::name(verdict);
    }
    const std::string pictures = std::to_string(all) + (all == 1 ? " picture" : " pictures");
    if (failed > 0) return std::to_string(failed) + " of " + pictures + (failed == 1 ? " fails: " : " fail: ") + kinds;
    const auto within = count_.find(render::Verdict::within_tolerance);
    return pictures + (all == 1 ? " is the same" : " are the same") +
           (within == count_.end() ? "" : ", " + std::to_string(within->second) + " of them within the tolerance");
  }

  int exit_code() const {
    if (count_.contains(render::Verdict::unreadable)) return unreadable;
    return std::ranges::all_of(count_, [](const auto& each) { return render::passes(each.first); }) ? same : different;
  }

 private:
  std::map<render::Verdict, int> count_;
};

struct CompareCommand {
  std::string expected, actual;
  std::optional<std::string> report;  ///< folder to write index.html to
  bool force = false;

  /// Returns: the exit code: 0 the same, 1 different, 3 a picture cannot be read (told on standard error).
  /// Errors: UsageError; render::ReadError where a side is not there; render::FileError where the report cannot be
  /// written.
  int run() const {
    if (report) expect_named("--report", *report, "a folder to write to, for example --report differences");
    const std::vector<render::FilePair> pairs = pairs_of(expected, actual);
    std::optional<render::CompareReport> page;
    Places places;
    if (report) {
      places = places_of(pairs, *report);
      places.expect_apart();
      places.expect_no_loss(force ? Others::overwritten : Others::kept, "--report");
      render::make_folder(*report, "choose another with --report");  // before all that is compared, not after it
      render::expect_writable(fs::path(*report) / page_of_report);
      page = empty_report(expected, actual);
    }
    Tally tally;
    for (const render::FilePair& files : pairs) {
      const render::ComparedFiles compared = render::compare_files(files);
      tally.add(compared);
      if (page) page->add(compared, accept_command(compared));
    }
    std::cout << tally.summary() << std::endl;
    if (page) {
      const fs::path file = fs::path(*report) / page_of_report;
      write_output(file, page->html());
      std::cout << "report: " << printable(file.string()) << std::endl;
    }
    places.tidy_manifests();
    return tally.exit_code();
  }
};

}  // namespace

Command add_compare_command(CLI::App& app) {
  const auto compare = std::make_shared<CompareCommand>();
  CLI::App* const command = app.add_subcommand("compare", "are two pictures, or two folders of pictures, the same?");
  command->add_option("EXPECTED", compare->expected, "PNG file, or folder of them and of folders")->required();
  command->add_option("ACTUAL", compare->actual, "what to compare it with: as EXPECTED a file or a folder")->required();
  command->add_option("--report", compare->report,
                      "folder to write index.html to: a page that shows what differs, and how to accept it");
  add_force_flag(*command, compare->force);
  command->footer(
      "Stored samples are compared, transparent ones on white, of animations the first picture. A pixel is off when a\n"
      "channel differs by more than 2. Pictures pass when at most one of 100,000 pixels is off, of a small picture\n"
      "none, and no group of them, joined by edges or corners, is larger than 4. That is more than other processors "
      "(2\n"
      "of 255 in a channel, no pixel off) and Mesa 25 in place of 22 (nothing) were measured to change. In folders, a "
      "file\n"
      "that one side lacks is a difference, and links are followed. If a folder holds rendered-by.json, an object of\n"
      "strings, the report shows it.\n"
      "Exit codes: 0 the same, 1 different, 2 wrong usage, 3 a picture cannot be read, 5 cannot write.");
  return {command, [compare] { return compare->run(); }};
}

}  // namespace walkthroughs::program
