/// An OpenGL context that needs no window and no display.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "render/context_backend.hpp"

namespace render {

/// The current OpenGL 3.3 core context of the thread that made it, which must destroy it as well. One .cpp file knows
/// OSMesa and one EGL; everything else asks for functions by name and draws into a framebuffer object of its own.
class OffscreenContext {
 public:
  /// Errors: ContextError, also where this thread has a context already, of whichever backend; where this build lacks
  /// the backend; where Mesa is told to draw with anything but llvmpipe. std::system_error where no thread can be started.
  explicit OffscreenContext(Backend backend = default_backend());
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  /// Returns: the OpenGL function of that name.
  /// Errors: ContextError where the driver has none. (Mesa has a stub for every name that begins with gl, so this does
  /// not tell what it supports; that a context of version 3.3 was made does.)
  GlFunction function(const char* name) const;

  /// Returns: for example "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Core Profile) Mesa 22.3.6, OSMesa"; EGL ends
  /// with "EGL surfaceless".
  std::string description() const;

 private:
  /// Returns: what OpenGL says of itself, or nothing.
  std::string text(unsigned name) const;

  std::string_view title_;
  std::unique_ptr<CurrentContext> context_;
};

}  // namespace render
