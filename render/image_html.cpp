#include "render/html.hpp"
#include "render/image.hpp"

namespace render {

std::string img(const Image& image, std::string_view alt) {
  return "<img width=\"" + std::to_string(image.size().width) + "\" height=\"" + std::to_string(image.size().height) +
         "\" alt=\"" + escaped(alt) + "\" src=\"" + data_url(encode_png(image, {})) + "\">";
}

}  // namespace render
