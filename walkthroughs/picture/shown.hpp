/// What a panel shows, and where it stands.
#pragma once

#include <string>

#include "render/panel.hpp"
#include "walkthroughs/picture/stage.hpp"
#include "walkthroughs/picture/style.hpp"

namespace walkthroughs::picture {

/// Where a panel stands on the page: its title and its key on top, the scene below.
struct Place {
  render::Box frame;
  std::string title;
  render::View view;
};

/// What is shown, and how it is looked at.
struct Shown {
  const Telling& telling;
  const Stage& stage;
  const Moment& now;
  const Names& names;
  Focus focus;
  const Lens& lens;
  const Style& style;
  bool values = true;           ///< whether numbers that decide are written into the picture
  bool regions_beside = false;  ///< whether pictures of planes beside this one show the regions
  bool is_parting = false;      ///< whether another search goes another way here
};

}  // namespace walkthroughs::picture
