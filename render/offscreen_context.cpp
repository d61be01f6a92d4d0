#include "render/offscreen_context.hpp"

#include <GL/glcorearb.h>

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <thread>

#include "render/file.hpp"

namespace render {
namespace {

struct BuiltIn {
  Backend backend;
  std::string_view title;
  std::unique_ptr<CurrentContext> (*make)();
};

/// The build names those of these two that it has by GJKSTEP_BACKENDS, the default first.
constexpr auto of_build = [] {
  [[maybe_unused]] constexpr BuiltIn osmesa{Backend::osmesa, "OSMesa", make_osmesa_context};
  [[maybe_unused]] constexpr BuiltIn egl{Backend::egl, "EGL surfaceless", make_egl_context};
  return std::array{GJKSTEP_BACKENDS};
}();

const BuiltIn& find(Backend backend) {
  const auto* const found = std::ranges::find(of_build, backend, &BuiltIn::backend);
  if (found != of_build.end()) return *found;
  const std::string package = backend == Backend::osmesa ? "libosmesa6-dev" : "libegl-dev";
  throw ContextError("this gjkstep was built without '" + std::string(name_of(backend)) + "' and has '" +
                     std::string(name_of(default_backend())) + "'; to have both: apt-get install " + package +
                     ", then configure and build again");
}

/// Settings under which Mesa crashes, hangs or draws something else instead of failing (Mesa 22.3 and 25.0). Its other
/// software renderer, softpipe, is among them: in 932 frames it is up to 8 of 255 off, up to 25 pixels of one by more
/// than 2 (22.3). Asked to draw with zink where there is no Vulkan, it never ends (25.0).
void refuse_wrong_settings() {
  const auto require = [](const char* name, std::initializer_list<std::string_view> allowed) {
    const char* value = std::getenv(name);
    if (value == nullptr || std::ranges::count(allowed, std::string_view(value)) > 0) return;
    std::string advice = "unset it";
    for (const std::string_view each : allowed) advice.append(" or choose ").append(each);
    throw ContextError(std::string(name) + "=" + value +
                       " is set, with which Mesa crashes, hangs or draws other pixels; " + advice);
  };
  require("GALLIUM_DRIVER", {"llvmpipe"});
  require("LP_NATIVE_VECTOR_WIDTH", {"128", "256"});
  for (const char* name : {"DRAW_USE_LLVM", "LP_PERF", "MESA_GLSL_VERSION_OVERRIDE", "MESA_EXTENSION_OVERRIDE"})
    require(name, {});
  const char* const loaded = "MESA_LOADER_DRIVER_OVERRIDE";  // others than zink do no harm
  if (const char* value = std::getenv(loaded); value != nullptr && std::string_view(value) == "zink")
    require(loaded, {});
}

thread_local bool has_context = false;

/// Mesa draws with threads of its own, and waits without end for one that it could not start.
void expect_threads() {
  std::thread([] {}).join();
}

}  // namespace

std::span<const Backend> built_in_backends() {
  static constexpr auto list = [] {
    std::array<Backend, of_build.size()> backends{};
    std::ranges::transform(of_build, backends.begin(), &BuiltIn::backend);
    return backends;
  }();
  return list;
}

std::string_view name_of(Backend backend) { return backend == Backend::osmesa ? "osmesa" : "egl"; }

std::string suspects() {
  std::string set;
  for (const char* name : {"GALLIUM_DRIVER", "MESA_GL_VERSION_OVERRIDE", "MESA_LOADER_DRIVER_OVERRIDE",
                           "LIBGL_DRIVERS_PATH", "__EGL_VENDOR_LIBRARY_FILENAMES", "__EGL_VENDOR_LIBRARY_DIRS"}) {
    if (const char* value = std::getenv(name)) set += std::string("; ") + name + "=" + value + " is set, try without";
  }
  return set + memory_limit();
}

OffscreenContext::OffscreenContext(Backend backend) {
  const BuiltIn& chosen = find(backend);
  refuse_wrong_settings();
  expect_threads();
  if (has_context)
    throw ContextError("this thread has an OpenGL context already: destroy it first, or use another thread");
  title_ = chosen.title;
  context_ = chosen.make();
  const std::string renderer = text(GL_RENDERER);
  if (!renderer.starts_with("llvmpipe")) {
    throw ContextError(std::string(title_) + " would draw with '" + renderer +
                       "', whose pixels are others than those of Mesa's llvmpipe" + suspects());
  }
  has_context = true;
}

OffscreenContext::~OffscreenContext() { has_context = false; }

GlFunction OffscreenContext::function(const char* name) const {
  if (const GlFunction found = context_->function(name)) return found;
  throw ContextError(std::string("the OpenGL driver has no ") + name + suspects());
}

std::string OffscreenContext::text(unsigned name) const {
  const auto* const said = reinterpret_cast<PFNGLGETSTRINGPROC>(function("glGetString"))(name);
  return said == nullptr ? "" : reinterpret_cast<const char*>(said);
}

std::string OffscreenContext::description() const {
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION) + ", " + std::string(title_);
}

}  // namespace render
