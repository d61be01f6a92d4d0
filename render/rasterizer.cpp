#include "render/rasterizer.hpp"

#include <GL/glcorearb.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

#include "render/triangles.hpp"

namespace render {
namespace {

// The page's y points down, and so does the framebuffer's as it is used here: its row 0, which OpenGL calls the bottom
// one and reads back first, is the page's top row. So nothing is turned over here; only View does that.
constexpr const char* vertex_source = R"(#version 330 core
uniform vec2 pixels_to_clip;
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv_in;
layout(location = 2) in vec2 shape_in;
layout(location = 3) in vec4 color_in;
out vec2 uv;
flat out vec2 shape;
flat out vec4 color;
void main() {
  gl_Position = vec4(position * pixels_to_clip - 1.0, 0.0, 1.0);
  uv = uv_in;
  shape = shape_in;
  color = color_in;
}
)";

// Only operations whose result IEEE 754 fixes (so no pow, exp, sin): the picture must not depend on a math library.
// Each kind of vertex has a program of its own: software renderers compute all ways of a branch.
constexpr std::string_view coverages[] = {  // in the order of CanvasVertex::Kind
    "uv.x", "0.5 + shape.y - length_of(vec2(max(abs(uv.x) - shape.x, 0.0), uv.y))",
    "0.5 + shape.y - abs(length_of(uv) - shape.x)", "texelFetch(atlas, ivec2(uv), 0).r"};
constexpr const char* fragment_source = R"(#version 330 core
uniform sampler2D atlas;
in vec2 uv;
flat in vec2 shape;  // half length, radius
flat in vec4 color;
out vec4 pixel;
float length_of(vec2 v) { return sqrt(v.x * v.x + v.y * v.y); }
void main() {
  pixel = vec4(color.rgb, color.a * clamp(COVERAGE, 0.0, 1.0));
}
)";

const void* byte_offset(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

/// The OpenGL functions that are used, fetched from a context: nothing links against libGL. Construct as Gl{context}.
/// Errors: ContextError where the driver lacks a function.
struct Gl {
  /// Becomes a pointer of the type that it initialises.
  struct Loaded {
    GlFunction function;
    template <class F>
    operator F*() const {
      return reinterpret_cast<F*>(function);
    }
  };

  const OffscreenContext& context;
  Loaded load(const char* name) const { return {context.function(name)}; }

  // State and errors
  PFNGLGETERRORPROC get_error = load("glGetError");
  PFNGLENABLEPROC enable = load("glEnable");
  PFNGLBLENDFUNCSEPARATEPROC blend_func_separate = load("glBlendFuncSeparate");
  PFNGLVIEWPORTPROC viewport = load("glViewport");
  PFNGLSCISSORPROC scissor = load("glScissor");
  PFNGLPIXELSTOREIPROC pixel_store = load("glPixelStorei");

  // Framebuffer
  PFNGLGENFRAMEBUFFERSPROC gen_framebuffers = load("glGenFramebuffers");
  PFNGLBINDFRAMEBUFFERPROC bind_framebuffer = load("glBindFramebuffer");
  PFNGLCHECKFRAMEBUFFERSTATUSPROC check_framebuffer_status = load("glCheckFramebufferStatus");
  PFNGLGENRENDERBUFFERSPROC gen_renderbuffers = load("glGenRenderbuffers");
  PFNGLBINDRENDERBUFFERPROC bind_renderbuffer = load("glBindRenderbuffer");
  PFNGLRENDERBUFFERSTORAGEPROC renderbuffer_storage = load("glRenderbufferStorage");
  PFNGLFRAMEBUFFERRENDERBUFFERPROC framebuffer_renderbuffer = load("glFramebufferRenderbuffer");
  PFNGLREADPIXELSPROC read_pixels = load("glReadPixels");

  // Shader
  PFNGLCREATESHADERPROC create_shader = load("glCreateShader");
  PFNGLSHADERSOURCEPROC shader_source = load("glShaderSource");
  PFNGLCOMPILESHADERPROC compile_shader = load("glCompileShader");
  PFNGLCREATEPROGRAMPROC create_program = load("glCreateProgram");
  PFNGLATTACHSHADERPROC attach_shader = load("glAttachShader");
  PFNGLLINKPROGRAMPROC link_program = load("glLinkProgram");
  PFNGLGETPROGRAMIVPROC get_program = load("glGetProgramiv");
  PFNGLGETPROGRAMINFOLOGPROC get_program_info_log = load("glGetProgramInfoLog");
  PFNGLUSEPROGRAMPROC use_program = load("glUseProgram");
  PFNGLGETUNIFORMLOCATIONPROC get_uniform_location = load("glGetUniformLocation");
  PFNGLUNIFORM2FPROC uniform2f = load("glUniform2f");

  // Texture
  PFNGLGENTEXTURESPROC gen_textures = load("glGenTextures");
  PFNGLBINDTEXTUREPROC bind_texture = load("glBindTexture");
  PFNGLTEXPARAMETERIPROC tex_parameter = load("glTexParameteri");
  PFNGLTEXIMAGE2DPROC tex_image_2d = load("glTexImage2D");

  // Vertices and drawing
  PFNGLGENVERTEXARRAYSPROC gen_vertex_arrays = load("glGenVertexArrays");
  PFNGLBINDVERTEXARRAYPROC bind_vertex_array = load("glBindVertexArray");
  PFNGLGENBUFFERSPROC gen_buffers = load("glGenBuffers");
  PFNGLBINDBUFFERPROC bind_buffer = load("glBindBuffer");
  PFNGLBUFFERDATAPROC buffer_data = load("glBufferData");
  PFNGLENABLEVERTEXATTRIBARRAYPROC enable_vertex_attrib_array = load("glEnableVertexAttribArray");
  PFNGLVERTEXATTRIBPOINTERPROC vertex_attrib_pointer = load("glVertexAttribPointer");
  PFNGLCLEARCOLORPROC clear_color = load("glClearColor");
  PFNGLCLEARPROC clear = load("glClear");
  PFNGLDRAWARRAYSPROC draw_arrays = load("glDrawArrays");
};

/// Returns: the OpenGL name of a new object, which goes with its context.
GLuint new_object(void(APIENTRYP generate)(GLsizei, GLuint*)) {
  GLuint name = 0;
  generate(1, &name);
  return name;
}

/// Returns: what OpenGL calls a status or an error.
std::string name_of(GLenum code) {
  switch (code) {
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT: return "GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT";
    case GL_FRAMEBUFFER_UNSUPPORTED: return "GL_FRAMEBUFFER_UNSUPPORTED";
    case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION: return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION: return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY: return "GL_OUT_OF_MEMORY";
    default: return "code " + std::to_string(code);
  }
}

std::string describe(Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height) + " pixels"; }

}  // namespace

struct Rasterizer::Impl {
  explicit Impl(OffscreenContext& context) : gl{context} {
    gl.bind_framebuffer(GL_FRAMEBUFFER, new_object(gl.gen_framebuffers));
    gl.bind_renderbuffer(GL_RENDERBUFFER, pixels);
    gl.bind_vertex_array(new_object(gl.gen_vertex_arrays));
    gl.bind_buffer(GL_ARRAY_BUFFER, new_object(gl.gen_buffers));
    gl.bind_texture(GL_TEXTURE_2D, new_object(gl.gen_textures));
    describe_vertices();
    set_state();
    link_programs();
  }

  // -- Set up --

  void describe_vertices() {
    constexpr GLsizei stride = sizeof(CanvasVertex);
    const auto floats = [&](GLuint location, std::size_t offset) {
      gl.enable_vertex_attrib_array(location);
      gl.vertex_attrib_pointer(location, 2, GL_FLOAT, GL_FALSE, stride, byte_offset(offset));
    };
    floats(0, offsetof(CanvasVertex, x));
    floats(1, offsetof(CanvasVertex, u));
    floats(2, offsetof(CanvasVertex, half_length));
    gl.enable_vertex_attrib_array(3);
    gl.vertex_attrib_pointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, byte_offset(offsetof(CanvasVertex, color)));
  }

  void set_state() {
    gl.enable(GL_SCISSOR_TEST);
    gl.enable(GL_BLEND);
    // The picture is opaque whatever is drawn on it: its alpha accumulates and is not read.
    gl.blend_func_separate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl.pixel_store(GL_PACK_ALIGNMENT, 1);
    gl.pixel_store(GL_UNPACK_ALIGNMENT, 1);
    // Without these the texture, which has no mipmaps, is incomplete and reads black.
    gl.tex_parameter(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.tex_parameter(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }

  void attach(GLuint program, GLenum type, const std::string& source) {
    const GLuint shader = gl.create_shader(type);
    const char* text = source.c_str();
    gl.shader_source(shader, 1, &text, nullptr);
    gl.compile_shader(shader);  // what is wrong with it shows when the program is linked
    gl.attach_shader(program, shader);
  }

  void link_programs() {
    for (std::size_t kind = 0; kind < programs.size(); ++kind) {
      programs[kind] = gl.create_program();
      std::string fragments = fragment_source;
      const std::string_view place = "COVERAGE";
      fragments.replace(fragments.find(place), place.size(), coverages[kind]);
      attach(programs[kind], GL_VERTEX_SHADER, vertex_source);
      attach(programs[kind], GL_FRAGMENT_SHADER, fragments);
      link(programs[kind]);
    }
    check_errors("set up");
  }

  void link(GLuint program) {
    gl.link_program(program);
    GLint linked = GL_FALSE;
    gl.get_program(program, GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return;
    std::array<GLchar, 2000> log{};
    gl.get_program_info_log(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw ContextError(std::string("the shader does not link: ") + log.data() + suspects());
  }

  // -- Drawing --

  void resize(Size wanted) {
    if (wanted == size) return;
    gl.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, wanted.width, wanted.height);
    gl.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels);
    const GLenum status = gl.check_framebuffer_status(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
      size = {};
      gl.get_error();  // thrown with this one; the next drawing starts without it
      throw ContextError("no framebuffer of " + describe(wanted) + ": " + name_of(status) + suspects());
    }
    gl.viewport(0, 0, wanted.width, wanted.height);
    for (const GLuint program : programs) {
      gl.use_program(program);
      gl.uniform2f(gl.get_uniform_location(program, "pixels_to_clip"), 2.0f / static_cast<float>(wanted.width),
                   2.0f / static_cast<float>(wanted.height));
    }
    size = wanted;
  }

  void upload(const Triangles& triangles, const Font& font) {
    const auto bytes = static_cast<GLsizeiptr>(triangles.vertices.size() * sizeof(CanvasVertex));
    gl.buffer_data(GL_ARRAY_BUFFER, bytes, triangles.vertices.data(), GL_STREAM_DRAW);
    gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_R8, Font::atlas_width, font.atlas_height(), 0, GL_RED, GL_UNSIGNED_BYTE,
                    font.atlas().data());
  }

  void draw_runs(const Triangles& triangles, Color color) {
    const auto channel = [](std::uint8_t value) { return static_cast<float>(value) / 255.0f; };
    gl.scissor(0, 0, size.width, size.height);
    gl.clear_color(channel(color.r), channel(color.g), channel(color.b), 1);
    gl.clear(GL_COLOR_BUFFER_BIT);

    const auto& [vertices, runs] = triangles;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const Triangles::Run& run = runs[i];
      const int end = i + 1 < runs.size() ? runs[i + 1].first : static_cast<int>(vertices.size());
      if (end == run.first || run.right <= run.left || run.bottom <= run.top) continue;
      gl.scissor(run.left, run.top, run.right - run.left, run.bottom - run.top);
      draw(vertices, run.first, end);
    }
  }

  /// Vertices of one kind after the other, in their order.
  void draw(const std::vector<CanvasVertex>& vertices, int first, int end) {
    const auto kind = [&](int i) { return static_cast<std::size_t>(vertices[static_cast<std::size_t>(i)].kind); };
    for (int next = first; first < end; first = next) {
      while (next < end && kind(next) == kind(first)) ++next;
      gl.use_program(programs[kind(first)]);
      gl.draw_arrays(GL_TRIANGLES, first, next - first);
    }
  }

  Image read_back() {
    Image image(size);
    gl.read_pixels(0, 0, size.width, size.height, GL_RGB, GL_UNSIGNED_BYTE, image.row(0));
    return image;
  }

  void check_errors(const char* step) {
    const GLenum error = gl.get_error();
    if (error != GL_NO_ERROR) {
      throw ContextError(std::string("OpenGL reports ") + name_of(error) + " on " + step + suspects());
    }
  }

  Gl gl;
  GLuint pixels = new_object(gl.gen_renderbuffers);
  std::array<GLuint, std::size(coverages)> programs{};
  Size size;  // of `pixels`
};

Rasterizer::Rasterizer(OffscreenContext& context) : impl_(std::make_unique<Impl>(context)) {}
Rasterizer::~Rasterizer() = default;

Image Rasterizer::draw(const Canvas& canvas) {
  const Size size = canvas.pixels();
  const auto allowed = [](int side) { return side >= min_pixels && side <= max_pixels; };
  if (!allowed(size.width) || !allowed(size.height)) {
    throw ContextError("cannot draw a picture of " + describe(size) + ": choose " + std::to_string(min_pixels) +
                       " to " + std::to_string(max_pixels) + " each way");
  }
  impl_->resize(size);
  const Triangles triangles = triangles_of(canvas);
  impl_->upload(triangles, canvas.font());
  impl_->draw_runs(triangles, canvas.background());
  Image image = impl_->read_back();
  impl_->check_errors("drawing");
  return image;
}

}  // namespace render
