/// A page that shows what a comparison of pictures has found. One HTML file with everything in it, which asks the network
/// for nothing; failures first.
#pragma once

#include <optional>
#include <string>

#include "render/compare.hpp"
#include "render/rendered_by.hpp"

namespace render {

/// What the page says of all pictures.
struct ReportHead {
  std::string expected, actual;                                ///< what the sides are, such as their folders
  std::optional<RenderedBy> expected_by = {}, actual_by = {};  ///< empty: not recorded
  std::string where = {};                                      ///< the folder in which the commands work; may be empty
};

/// So that a page stays small enough to be opened. Pairs beyond are told in words only, and the page says so.
struct ReportLimits {
  int failures = 100;                    ///< pairs that fail and are shown with their pictures
  int passes = 10;                       ///< pairs within the tolerance that are
  std::size_t bytes = 64 * 1024 * 1024;  ///< of pages with pictures; no more pictures beyond
};

/// Collects pairs one by one and keeps text only: the pictures as PNG inside it.
class CompareReport {
 public:
  explicit CompareReport(ReportHead head, ReportLimits limits = {}) : head_(std::move(head)), limits_(limits) {}

  /// `accept` is the shell command that accepts the new picture, or empty where there is none. Several are joined by &&
  /// into one that accepts all.
  void add(const ComparedFiles& compared, const std::string& accept);
  /// Returns: the page, in UTF-8.
  std::string html() const;

 private:
  bool take_pictures(const ComparedFiles& compared);

  ReportHead head_;
  ReportLimits limits_;
  int failed_ = 0, passed_ = 0, failures_shown_ = 0, passes_shown_ = 0;
  int without_pictures_ = 0, commands_ = 0;
  std::string failures_, passes_, same_;  // HTML
  std::string accept_all_;                // for a shell
};

}  // namespace render
