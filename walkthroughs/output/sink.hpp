/// The formats that walkthroughs are written in: each is a sink for stories, in a source file of its own.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

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

/// FOLDER/NAME/FILE.
class OneFile : public Sink {
 public:
  /// Returns: what makes the file.
  using Make = std::function<Renderer::Content(const std::shared_ptr<const StagedStory>& story, const Output& output,
                                               Renderer& renderer)>;

  OneFile(std::string name, Make make) : name_(std::move(name)), make_(std::move(make)) {}
  std::vector<std::string> files(const Walkthrough&) const override { return {name_}; }
  void add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) override {
    renderer.write(folder_of(output, story->walkthrough) / name_, make_(story, output, renderer), story);
  }

 private:
  std::string name_;
  Make make_;
};

/// Returns: what pictures of the whole walkthrough say of themselves.
inline render::PngText text_of(const Walkthrough& walkthrough) { return {walkthrough.title, walkthrough.summary}; }

/// strip.png: the whole walkthrough in one picture, as draw_strip() draws it.
OneFile strip();

/// animation.png: all frames as an animated PNG, which shows each for so many seconds, the last one for `of_last`. Joins the
/// files of Frames, which must be given the story before.
OneFile animated_png(double seconds, double of_last);

}  // namespace walkthroughs::output
