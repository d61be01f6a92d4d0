#include <GL/osmesa.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <initializer_list>
#include <string_view>

#include "render/offscreen_context.hpp"

namespace render {
namespace {

struct ContextDeleter {
  void operator()(OSMesaContext context) const { OSMesaDestroyContext(context); }
};
using ContextHandle = std::unique_ptr<std::remove_pointer_t<OSMesaContext>, ContextDeleter>;

/// Mesa picks its driver from these variables; a wrong value is the usual reason why there is no context.
std::string environment() {
  std::string set;
  for (const char* name : {"GALLIUM_DRIVER", "MESA_GL_VERSION_OVERRIDE"}) {
    if (const char* value = std::getenv(name)) set += std::string("; ") + name + "=" + value + " is set, try without";
  }
  return set;
}

/// Settings under which OSMesa crashes instead of failing (Mesa 22.3 and 25.0).
void refuse_settings_that_crash() {
  const auto require = [](const char* name, std::initializer_list<std::string_view> allowed) {
    const char* value = std::getenv(name);
    if (value == nullptr || std::ranges::count(allowed, std::string_view(value)) > 0) return;
    std::string advice = "unset it";
    for (const std::string_view each : allowed) advice.append(" or choose ").append(each);
    throw ContextError(std::string(name) + "=" + value + " is set, and OSMesa cannot draw with it; " + advice);
  };
  require("GALLIUM_DRIVER", {"llvmpipe", "softpipe"});
  require("LP_NATIVE_VECTOR_WIDTH", {"128", "256"});
  for (const char* name : {"DRAW_USE_LLVM", "MESA_GLSL_VERSION_OVERRIDE", "MESA_EXTENSION_OVERRIDE"}) require(name, {});
}

}  // namespace

struct OffscreenContext::Impl {
  ContextHandle context;
  // OSMesa wants a buffer of its own, though everything is drawn into a framebuffer object.
  std::array<unsigned char, 4> pixel{};
};

OffscreenContext::OffscreenContext() : impl_(std::make_unique<Impl>()) {
  if (OSMesaGetCurrentContext() != nullptr) {
    throw ContextError("this thread has an OpenGL context already: destroy it first, or use another thread");
  }
  refuse_settings_that_crash();
  constexpr std::array attributes = {OSMESA_FORMAT,
                                     OSMESA_RGBA,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     3,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     3,
                                     OSMESA_DEPTH_BITS,
                                     0,
                                     0};
  impl_->context.reset(OSMesaCreateContextAttribs(attributes.data(), nullptr));
  if (impl_->context == nullptr) {
    throw ContextError("OSMesa gives no OpenGL 3.3 core context" + environment() +
                       "; the library comes with: apt-get install libosmesa6");
  }
  if (!OSMesaMakeCurrent(impl_->context.get(), impl_->pixel.data(), GL_UNSIGNED_BYTE, 1, 1)) {
    throw ContextError("OSMesa cannot make its OpenGL context current" + environment());
  }
}

OffscreenContext::~OffscreenContext() = default;

OffscreenContext::Function OffscreenContext::function(const char* name) const {
  if (const Function found = OSMesaGetProcAddress(name)) return found;
  throw ContextError(std::string("the OpenGL driver has no ") + name + environment());
}

std::string OffscreenContext::description() const {
  const auto get_string = reinterpret_cast<const GLubyte* (*)(GLenum)>(function("glGetString"));
  const auto text = [&](GLenum name) { return std::string(reinterpret_cast<const char*>(get_string(name))); };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION) + ", OSMesa";
}

}  // namespace render
