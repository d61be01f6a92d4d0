#include <GL/osmesa.h>

#include <array>
#include <type_traits>

#include "render/context_backend.hpp"

namespace render {
namespace {

class OsmesaContext final : public CurrentContext {
 public:
  OsmesaContext();
  GlFunction function(const char* name) const override { return OSMesaGetProcAddress(name); }

 private:
  struct Deleter {
    void operator()(OSMesaContext context) const { OSMesaDestroyContext(context); }
  };

  // OSMesa wants a buffer of its own, though everything is drawn into a framebuffer object.
  std::array<unsigned char, 4> pixel_{};
  std::unique_ptr<std::remove_pointer_t<OSMesaContext>, Deleter> context_;
};

OsmesaContext::OsmesaContext() {
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
  context_.reset(OSMesaCreateContextAttribs(attributes.data(), nullptr));
  if (context_ == nullptr) {
    throw ContextError("OSMesa gives no OpenGL 3.3 core context" + suspects() +
                       "; the library comes with: apt-get install libosmesa6");
  }
  if (!OSMesaMakeCurrent(context_.get(), pixel_.data(), GL_UNSIGNED_BYTE, 1, 1)) {
    throw ContextError("OSMesa cannot make its OpenGL context current" + suspects());
  }
}

}  // namespace

std::unique_ptr<CurrentContext> make_osmesa_context() { return std::make_unique<OsmesaContext>(); }

}  // namespace render
