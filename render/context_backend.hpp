/// What offscreen_context.cpp asks of the two files that know a way to OpenGL.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "render/backend.hpp"

namespace render {

/// A context, current in the thread that made it and until this is destroyed there.
class CurrentContext {
 public:
  CurrentContext() = default;
  virtual ~CurrentContext() = default;
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;

  /// Returns: the OpenGL function of that name, or null.
  virtual GlFunction function(const char* name) const = 0;
};

/// Each in a file of its own, which is only compiled where its library is there. Require: this thread has no context.
/// Errors: ContextError.
std::unique_ptr<CurrentContext> make_osmesa_context();
std::unique_ptr<CurrentContext> make_egl_context();

/// Returns: what is usually the reason why OpenGL fails, as the end of a message: variables of the environment that are set,
/// a limit of memory; or nothing.
std::string suspects();

struct BuiltIn {
  Backend backend;
  std::string_view title;
  std::unique_ptr<CurrentContext> (*make)();
};

/// The build names those of these two that it has by GJKSTEP_BACKENDS, the default first.
namespace built_in {
inline constexpr BuiltIn osmesa{Backend::osmesa, "OSMesa", make_osmesa_context};
inline constexpr BuiltIn egl{Backend::egl, "EGL surfaceless", make_egl_context};
}  // namespace built_in

}  // namespace render
