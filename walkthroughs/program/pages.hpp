/// The pages that one run of gjkstep render writes beside its pictures.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "walkthroughs/page/index_page.hpp"
#include "walkthroughs/page/page.hpp"
#include "walkthroughs/picture/render_frames.hpp"

namespace walkthroughs {

inline constexpr const char* page_file = "index.html";

/// A walkthrough of the run, and what it was read from.
struct PageOrigin {
  std::string name;
  std::string option;          ///< of the command line, before the file: "--from-trace "
  std::filesystem::path file;  ///< empty where it is one of the catalogue
};

class Pages {
 public:
  enum class Pictures {
    beside,  ///< pages show the files
    inside,  ///< pages hold them, and can be moved and mailed; they have no links to others
  };

  /// `options`: what else was said on the command line about the pictures. `origins`: one for each walkthrough of the run, in
  /// order.
  Pages(Pictures pictures, std::string options, std::vector<PageOrigin> origins)
      : pictures_(pictures), options_(std::move(options)), origins_(std::move(origins)) {}

  /// Asks for FOLDER/NAME/index.html, to be written after what has been asked of `renderer` so far.
  void add(std::shared_ptr<const StagedStory> story, const Output& output, Renderer& renderer,
           const FileWritten& written);
  /// Writes FOLDER/index.html over all that were added. Errors: render::FileError.
  void write_index(const std::filesystem::path& folder) const;

 private:
  PageSurroundings surroundings_of(const std::string& name, const std::filesystem::path& folder) const;

  Pictures pictures_;
  std::string options_;
  std::vector<PageOrigin> origins_;
  std::vector<IndexEntry> entries_;
};

}  // namespace walkthroughs
