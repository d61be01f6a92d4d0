/// The formats that walkthroughs are written in: each is a sink for stories, in a source file of its own.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "walkthroughs/output/manifest.hpp"
#include "walkthroughs/output/renderer.hpp"

namespace walkthroughs::output {

class Sink {
 public:
  virtual ~Sink() = default;

  /// Returns: the names of what this format writes, and may remove, in the folder of a walkthrough, as patterns of fits().
  virtual std::vector<std::string> files(const Walkthrough& walkthrough) const = 0;

  /// Asks `renderer` for what this format makes of a story, behind all that was asked for before: formats may read the files
  /// of those that were given the story before them. Errors: those of Renderer.
  virtual void add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) = 0;
};

/// FOLDER/NAME/FILE. Where there is nothing to write, one of an earlier run is removed.
class OneFile : public Sink {
 public:
  /// Returns: what makes the file; empty where there is nothing to write.
  using Make = std::function<Renderer::Content(const std::shared_ptr<const StagedStory>& story, const Output& output,
                                               Renderer& renderer)>;

  OneFile(std::string name, Make make) : name_(std::move(name)), make_(std::move(make)) {}
  std::vector<std::string> files(const Walkthrough&) const override { return {name_}; }
  void add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) override {
    const std::filesystem::path folder = folder_of(output, story->walkthrough);
    if (Renderer::Content content = make_(story, output, renderer))
      renderer.write(folder / name_, std::move(content), story);
    else
      renderer.then([folder, files = files(story->walkthrough)] { remove_outputs(folder, files); });
  }

 private:
  std::string name_;
  Make make_;
};

/// Returns: what pictures of the whole walkthrough say of themselves.
inline render::PngText text_of(const Walkthrough& walkthrough) { return {walkthrough.title, walkthrough.summary}; }

/// strip.png: the whole walkthrough in one picture, as draw_strip() draws it.
OneFile strip();

/// deck.pdf: a slide for each frame, its panels and its caption as large as they can be.
OneFile deck();

/// notes.pdf: what to say to each slide, on paper: a small picture, caption and facts, and what is seen.
OneFile notes();

/// Told how many of how many questions are asked, where these are not all, or none.
using Unasked = std::function<void(const Story& story, std::size_t asked, std::size_t known)>;

/// quiz.pdf: the questions of a story to be answered on paper, each beside the frame before the answer, without its numbers; on
/// further pages the answers. None where nothing is asked.
OneFile quiz(Unasked unasked);

/// animation.png: all frames as an animated PNG, which shows each for so many seconds, the last one for `of_last`. Joins the
/// files of Frames, which must be given the story before.
OneFile animated_png(double seconds, double of_last);

}  // namespace walkthroughs::output
