/// The ways to an OpenGL context that needs no window and no display: what can be asked for, and what offscreen_context.cpp
/// asks of the two files that know one.
#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
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

/// A context, current in the thread that made it and until this is destroyed there. OpenGL calls go to the one current
/// context of their thread, whichever backend has made it. The backends cannot be asked: each of them knows only its own.
class CurrentContext {
 public:
  /// Errors: ContextError where this thread has one already.
  CurrentContext();
  virtual ~CurrentContext();
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;

  /// Returns: the OpenGL function of that name, or null.
  virtual GlFunction function(const char* name) const = 0;

 private:
  static inline thread_local bool taken_ = false;
};

/// Each in a file of its own, which is only compiled where its library is there. Errors: ContextError.
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
