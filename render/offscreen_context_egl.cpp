#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "render/offscreen_context.hpp"

namespace render {
namespace {

constexpr const char* install = "; it comes with: apt-get install libegl1 libegl-mesa0";

std::string last_error() {
  char code[16];
  std::snprintf(code, sizeof code, "0x%04x", static_cast<unsigned>(eglGetError()));
  return std::string(" (EGL error ") + code + ")";
}

/// Whether `name` is one of the words of `extensions`, which may be null.
bool has_word(const char* extensions, std::string_view name) {
  const std::string list = std::string(" ") + (extensions == nullptr ? "" : extensions) + " ";
  return list.find(" " + std::string(name) + " ") != std::string::npos;
}

/// The platform of surfaceless displays would take a graphics card where there is one, whose pixels are others, unless
/// LIBGL_ALWAYS_SOFTWARE is set; and the environment is not ours to set. So the software device is asked for by name.
EGLDeviceEXT software_device() {
  const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  const auto query_string =
      reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
  std::array<EGLDeviceEXT, 64> devices{};
  EGLint count = 0;
  if (query_devices != nullptr && query_string != nullptr &&
      query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count)) {
    const auto end = devices.begin() + count;
    const auto found = std::find_if(devices.begin(), end, [&](EGLDeviceEXT device) {
      return has_word(query_string(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
    });
    if (found != end) return *found;
  }
  throw ContextError(std::string("EGL has no device for Mesa's software renderer") + suspects() + install);
}

/// Returns: the one display of the software device. It is never terminated, because other threads may have contexts
/// of it; EGL does so when the process ends.
EGLDisplay software_display() {
  const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, software_device(), nullptr);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
    throw ContextError("EGL cannot start Mesa's software renderer" + last_error() + suspects() + install);
  }
  const char* const extensions = eglQueryString(display, EGL_EXTENSIONS);
  for (const char* needed : {"EGL_KHR_no_config_context", "EGL_KHR_surfaceless_context"}) {
    if (!has_word(extensions, needed)) throw ContextError(std::string("EGL lacks ") + needed + suspects() + install);
  }
  return display;
}

class EglContext final : public CurrentContext {
 public:
  EglContext() {
    constexpr std::array attributes = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    if (eglBindAPI(EGL_OPENGL_API))
      context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    if (context_ == EGL_NO_CONTEXT)
      throw ContextError("EGL gives no OpenGL 3.3 core context" + last_error() + suspects() + install);
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
      const std::string error = last_error();
      eglDestroyContext(display_, context_);
      throw ContextError("EGL cannot make its OpenGL context current" + error + suspects());
    }
  }
  ~EglContext() override {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
  }
  GlFunction function(const char* name) const override { return eglGetProcAddress(name); }

 private:
  EGLDisplay display_ = software_display();
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<CurrentContext> make_egl_context() { return std::make_unique<EglContext>(); }

}  // namespace render
