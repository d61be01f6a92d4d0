/// An OpenGL context that needs no window and no display.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

namespace render {

/// No usable OpenGL context; what() says what failed and what to try.
struct ContextError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The current OpenGL 3.3 core context of the thread that made it. One .cpp file knows OSMesa; everything else asks
/// for functions by name and draws into a framebuffer object of its own.
class OffscreenContext {
 public:
  /// Errors: ContextError, also where this thread has a context already.
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  using Function = void (*)();
  /// Returns: the OpenGL function of that name.
  /// Errors: ContextError where the driver has none. (Mesa has a stub for every name that begins with gl, so this does
  /// not tell what it supports; that a context of version 3.3 was made does.)
  Function function(const char* name) const;

  /// Returns: for example "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Core Profile) Mesa 22.3.6, OSMesa".
  std::string description() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace render
