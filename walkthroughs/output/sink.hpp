/// The formats that walkthroughs are written in: each is a sink for stories, in a file of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "walkthroughs/output/renderer.hpp"

namespace walkthroughs {

/// Told after each file about a story.
using FileWritten = std::function<void(const std::filesystem::path& file, const Story& story)>;

class Sink {
 public:
  virtual ~Sink() = default;

  /// Returns: the names of what this format writes, and may remove, in the folder of a walkthrough, as patterns of fits().
  virtual std::vector<std::string> files(const Walkthrough& walkthrough) const = 0;

  /// Asks `renderer` for what this format makes of a story, behind all that was asked for before: formats may read the files
  /// of those that were given the story before them. Errors: those of Renderer.
  virtual void add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) = 0;
};

}  // namespace walkthroughs
