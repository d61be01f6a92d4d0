/// The ways to an OpenGL context that needs no window and no display.
#pragma once

#include <span>
#include <stdexcept>
#include <string_view>

namespace render {

/// No usable OpenGL context; what() says what failed and what to try.
struct ContextError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Ways to a context of llvmpipe, Mesa's software renderer. Both draw the same pixels.
enum class Backend {
  osmesa,  ///< one library and nothing else; left Mesa with version 25.1
  egl,     ///< EGL without surfaces, on the software device even where there is a graphics card
};

/// Returns: all that there can be, whether this build has them or not.
std::span<const Backend> all_backends();
/// Returns: those that this build has, the default first; at least one.
std::span<const Backend> built_in_backends();
inline Backend default_backend() { return built_in_backends().front(); }

/// Returns: for example "egl".
std::string_view name_of(Backend backend);

/// Any function of OpenGL.
using GlFunction = void (*)();

}  // namespace render
