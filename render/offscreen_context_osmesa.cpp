#include <GL/osmesa.h>
#include <dlfcn.h>

#include <array>
#include <string>
#include <type_traits>

#include "render/offscreen_context.hpp"

namespace render {
namespace {

const std::string install = "; the library comes with: apt-get install libosmesa6";

/// OSMesa's functions. It is loaded when something is drawn, and not when the program starts: with its LLVM that would take
/// seven times as long as all else. It stays until the end, since LLVM cannot be unloaded.
struct Osmesa {
  decltype(&OSMesaCreateContextAttribs) create_context;
  decltype(&OSMesaDestroyContext) destroy_context;
  decltype(&OSMesaMakeCurrent) make_current;
  decltype(&OSMesaGetProcAddress) address_of;

  Osmesa() {
    void* const library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
      throw ContextError(std::string("OSMesa cannot be loaded: ") + dlerror() + suspects() + install);
    const auto find = [&]<class Function>(Function*& to, const char* name) {
      to = reinterpret_cast<Function*>(dlsym(library, name));
      if (to == nullptr) throw ContextError(std::string("OSMesa has no ") + name + install);
    };
    find(create_context, "OSMesaCreateContextAttribs");
    find(destroy_context, "OSMesaDestroyContext");
    find(make_current, "OSMesaMakeCurrent");
    find(address_of, "OSMesaGetProcAddress");
  }
  static const Osmesa& get() {
    static const Osmesa loaded;
    return loaded;
  }
};

class OsmesaContext final : public CurrentContext {
 public:
  OsmesaContext() {
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
    context_.reset(Osmesa::get().create_context(attributes.data(), nullptr));
    if (context_ == nullptr) throw ContextError("OSMesa gives no OpenGL 3.3 core context" + suspects() + install);
    if (!Osmesa::get().make_current(context_.get(), pixel_.data(), GL_UNSIGNED_BYTE, 1, 1))
      throw ContextError("OSMesa cannot make its OpenGL context current" + suspects());
  }
  GlFunction function(const char* name) const override { return Osmesa::get().address_of(name); }

 private:
  // OSMesa wants a buffer of its own, though everything is drawn into a framebuffer object.
  std::array<unsigned char, 4> pixel_{};
  std::unique_ptr<std::remove_pointer_t<OSMesaContext>, decltype(&OSMesaDestroyContext)> context_{
      nullptr, Osmesa::get().destroy_context};
};

}  // namespace

std::unique_ptr<CurrentContext> make_osmesa_context() { return std::make_unique<OsmesaContext>(); }

}  // namespace render
