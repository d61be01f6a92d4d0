/// An OpenGL context that needs no window and no display.
#pragma once

#include <array>
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

/// All that there can be, whether this build has them or not.
inline constexpr std::array all_backends{Backend::osmesa, Backend::egl};
/// Returns: those that this build has, the default first; at least one.
std::span<const Backend> built_in_backends();
inline Backend default_backend() { return built_in_backends().front(); }

/// Returns: for example "egl".
std::string_view name_of(Backend backend);

/// Returns: what is usually the reason why OpenGL fails, as the end of a message: variables of the environment that are set,
/// a limit of memory; or nothing.
std::string suspects();

/// Any function of OpenGL.
using GlFunction = void (*)();

/// A context of one backend, current in the thread that made it until this is destroyed there. OpenGL calls go to the one current
/// context of their thread, whichever backend has made it.
class CurrentContext {
 public:
  virtual ~CurrentContext() = default;
  /// Returns: the OpenGL function of that name, or null.
  virtual GlFunction function(const char* name) const = 0;
};

/// Each in a file of its own, which is only compiled where its library is there. Errors: ContextError.
std::unique_ptr<CurrentContext> make_osmesa_context();
std::unique_ptr<CurrentContext> make_egl_context();

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
