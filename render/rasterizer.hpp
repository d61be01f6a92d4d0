/// Turns a Canvas into an Image: one shader, one framebuffer object, one read back.
#pragma once

#include <memory>

#include "render/canvas.hpp"
#include "render/image.hpp"
#include "render/offscreen_context.hpp"

namespace render {

class Rasterizer {
 public:
  /// Compiles the shader in `context`, which must outlive the rasterizer and be used by nothing else: what it makes there goes
  /// with the context.
  /// Errors: ContextError.
  explicit Rasterizer(OffscreenContext& context);
  ~Rasterizer();
  Rasterizer(const Rasterizer&) = delete;
  Rasterizer& operator=(const Rasterizer&) = delete;

  /// The same canvas gives the same image, whatever was drawn before.
  /// Errors: ContextError where the canvas is not min_pixels..max_pixels each way, the framebuffer is incomplete, or
  /// OpenGL reports an error.
  Image draw(const Canvas& canvas);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace render
