/// Pictures, and what is laid out for them, as tests look at them.
#pragma once

#include <span>
#include <vector>

#include "render/image.hpp"
#include "render/triangles.hpp"

namespace kit {

/// Returns: a picture of one colour.
inline render::Image plain(render::Size size, render::Color color) {
  render::Image image(size);
  image.fill(color);
  return image;
}

/// How dark a pixel is: 0 white, 1 black.
inline double darkness(const render::Image& image, int x, int y) { return 1 - image.pixel(x, y).r / 255.0; }

/// Of the pixels of a box together: of what is black on white, its area.
inline double darkness(const render::Image& image, const render::Box& box) {
  double sum = 0;
  for (int y = static_cast<int>(box.min.y()); y < box.max.y(); ++y)
    for (int x = static_cast<int>(box.min.x()); x < box.max.x(); ++x) sum += darkness(image, x, y);
  return sum;
}

/// Returns: what the rasterizer draws, without the first vertices.
inline std::vector<render::CanvasVertex> vertices_of(const render::Canvas& canvas, std::size_t without = 0) {
  const std::vector<render::CanvasVertex> all = render::triangles_of(canvas).vertices;
  return {all.begin() + static_cast<std::ptrdiff_t>(without), all.end()};
}

/// Returns: the box around vertices. Requires: there is one.
inline render::Box box_around(std::span<const render::CanvasVertex> vertices) {
  const render::Vec2 first(vertices[0].x, vertices[0].y);
  render::Box box{first, first};
  for (const render::CanvasVertex& v : vertices) {
    box.min = box.min.cwiseMin(render::Vec2(v.x, v.y));
    box.max = box.max.cwiseMax(render::Vec2(v.x, v.y));
  }
  return box;
}

}  // namespace kit
