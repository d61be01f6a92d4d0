/// Searches that nobody chose, and how gjkstep render is asked to draw each: most of what no walkthrough comes to.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/model/walkthrough.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/story/storyboard.hpp"

namespace golden {

struct RandomSearch {
  std::string name;     ///< "random/017"
  std::string scene;    ///< the scene file
  std::string options;  ///< of gjkstep render
  walkthroughs::model::Walkthrough walkthrough;
  walkthroughs::picture::Look look;
  walkthroughs::story::Detail detail = walkthroughs::story::Detail::decision;
};

const std::vector<RandomSearch>& random_searches();

}  // namespace golden
