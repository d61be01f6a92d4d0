/// The whole walkthrough in one wide picture.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "walkthroughs/output/sink.hpp"

namespace walkthroughs {

/// FOLDER/NAME/strip.png, as draw_strip() draws it.
class Strip : public Sink {
 public:
  explicit Strip(FileWritten written) : written_(std::move(written)) {}
  std::vector<std::string> files(const Walkthrough&) const override { return {"strip.png"}; }
  void add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) override;

 private:
  FileWritten written_;
};

}  // namespace walkthroughs
