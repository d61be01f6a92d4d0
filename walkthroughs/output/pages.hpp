/// A page a walkthrough, and one over all of them.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "walkthroughs/output/sink.hpp"
#include "walkthroughs/page/page.hpp"

namespace walkthroughs::output {

inline constexpr const char *compare_file = "compare.html", *trace_file = "trace.jsonl";

/// A walkthrough of the run, and what it was read from.
struct PageOrigin {
  std::string name, title;
  std::string option;          ///< of the command line, before the file: "--from-trace "
  std::filesystem::path file;  ///< empty where it is one of the catalogue
  std::string scene;           ///< the text of a scene file
  std::string made_by = {};    ///< the command that tells it, where that is not render
};

/// What is said of pages on the command line.
struct PagesWanted {
  /// Pages show the files; else they hold all of them, and can be moved and mailed, but have no links to others.
  bool has_files_beside;
  std::filesystem::path folder;     ///< that of the output
  std::string options;              ///< what else was said about the pictures
  bool is_usual;                    ///< whether nothing was said that the program in a page would tell otherwise
  std::string report;               ///< a page that shows them and lies beside the index; empty: none
  std::vector<PageOrigin> origins;  ///< one for each walkthrough of the run, in order
};

/// FOLDER/NAME/index.html, what it asks for and what it was made of, beside the files of Frames, which must be given
/// the story before.
class Pages : public Sink {
 public:
  explicit Pages(PagesWanted wanted);

  /// Requires, as add(): the walkthrough is one of the run.
  std::vector<std::string> files(const Walkthrough& walkthrough) const override;
  void add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) override;

 private:
  PagesWanted wanted_;
};

/// Returns: the names of the files that write_index() may write.
std::vector<std::string> index_file_names(bool has_files_beside);

/// Returns: the names of the walkthroughs that FOLDER/index.html is over.
std::vector<std::string> names_in_index(const std::filesystem::path& folder);

/// Writes FOLDER/index.html over all pages in that folder, those of earlier runs, too; and where two of them show a
/// search FOLDER/compare.html, where not removes it. And the programs that pages ask, unless each holds all that it needs. Errors:
/// render::FileError.
void write_index(const std::filesystem::path& folder, bool has_files_beside);

}  // namespace walkthroughs::output
