/// FOLDER/report.html: what was found about a program, beside scenes and pages of the worst pairs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "render/offscreen_context.hpp"
#include "walkthroughs/judge/judged_text.hpp"
#include "walkthroughs/program/places.hpp"

namespace walkthroughs::program {

inline constexpr std::size_t kept_worst = 10;

/// Writes the worst pairs as FOLDER/1.json, 2.json, …, and removes what an earlier run has left of these. Errors: render::FileError.
void write_scenes(const std::string& folder, const judge::Judgement& judgement);

/// Where a report is written, and what with.
struct ReportFolder {
  std::string folder;
  render::Backend backend = render::default_backend();
  bool force = false;

  /// Adds what may be written. Errors: UsageError where the folder has no name.
  void add_written(Places& places) const;

  /// Makes the folder, and makes sure that it can be written to, and that pictures can be drawn, before a program is asked.
  /// Errors: render::FileError, render::ContextError.
  void expect_possible() const;

  /// Returns: report.html, which is written last: a run that is interrupted leaves none. The first wrong step of those that the
  /// program tells stands above the worst pairs.
  /// Requires: report.shown is the folder. Errors: render::FileError, render::ContextError; UsageError where files of others
  /// have come since.
  std::filesystem::path write(const judge::Report& report) const;
};

}  // namespace walkthroughs::program
