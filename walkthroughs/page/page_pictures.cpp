#include "walkthroughs/page/page_pictures.hpp"

#include <cmath>
#include <cstdio>

namespace walkthroughs {
namespace {

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f%%", 100 * share);
  return text;
}

}  // namespace

std::string cut_out(render::Size page, const render::Box& part) {
  return "--width:" + percent(page.width / part.width()) + ";--left:" + percent(-part.min.x() / part.width()) +
         ";--top:" + percent(-part.min.y() / part.height()) +
         ";aspect-ratio:" + std::to_string(std::lround(part.width())) + "/" +
         std::to_string(std::lround(part.height()));
}

std::string text_size(double scale) { return scale == 1 ? "" : "html{font-size:" + percent(scale) + "}"; }

}  // namespace walkthroughs
