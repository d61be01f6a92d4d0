#include "render/rasterizer.hpp"

#include <array>
#include <cstddef>
#include <string>

#include "render/context_backend.hpp"
#include "render/gl.hpp"
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
layout(location = 4) in uint kind_in;
out vec2 uv;
flat out vec2 shape;
flat out vec4 color;
flat out uint kind;
void main() {
  gl_Position = vec4(position * pixels_to_clip - 1.0, 0.0, 1.0);
  uv = uv_in;
  shape = shape_in;
  color = color_in;
  kind = kind_in;
}
)";

// Only operations whose result IEEE 754 fixes (so no pow, exp, sin): the picture must not depend on a math library.
// `kind` counts like CanvasVertex::Kind.
constexpr const char* fragment_source = R"(#version 330 core
uniform sampler2D atlas;
in vec2 uv;
flat in vec2 shape;  // half length, radius
flat in vec4 color;
flat in uint kind;
out vec4 pixel;
float length_of(vec2 v) { return sqrt(v.x * v.x + v.y * v.y); }
float coverage() {
  if (kind == 0u) return uv.x;
  if (kind == 1u) return 0.5 + shape.y - length_of(vec2(max(abs(uv.x) - shape.x, 0.0), uv.y));
  if (kind == 2u) return 0.5 + shape.y - abs(length_of(uv) - shape.x);
  return texelFetch(atlas, ivec2(uv), 0).r;
}
void main() {
  pixel = vec4(color.rgb, color.a * clamp(coverage(), 0.0, 1.0));
}
)";

const void* byte_offset(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

/// The OpenGL names of one kind of object, deleted with this.
struct Object {
  using Generate = void(APIENTRYP)(GLsizei, GLuint*);
  using Delete = void(APIENTRYP)(GLsizei, const GLuint*);

  Object(Generate generate, Delete remove) : remove_(remove) { generate(1, &name); }
  ~Object() { remove_(1, &name); }
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

  GLuint name = 0;

 private:
  Delete remove_;
};

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
  explicit Impl(OffscreenContext& context) : gl{{context}} {
    gl.bind_framebuffer(GL_FRAMEBUFFER, framebuffer.name);
    gl.bind_renderbuffer(GL_RENDERBUFFER, pixels.name);
    gl.bind_vertex_array(vertex_array.name);
    gl.bind_buffer(GL_ARRAY_BUFFER, vertices.name);
    gl.bind_texture(GL_TEXTURE_2D, atlas.name);
    describe_vertices();
    set_state();
    link_program();
  }
  ~Impl() { gl.delete_program(program); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void describe_vertices();
  void set_state();
  void link_program();
  void attach(GLenum type, const char* source);
  void resize(Size size);
  void upload(const Triangles& triangles, const Font& font);
  void draw_runs(const Triangles& triangles, Color color);
  Image read_back();
  void check_errors(const char* step);

  Gl gl;
  Object framebuffer{gl.gen_framebuffers, gl.delete_framebuffers};
  Object pixels{gl.gen_renderbuffers, gl.delete_renderbuffers};
  Object vertex_array{gl.gen_vertex_arrays, gl.delete_vertex_arrays};
  Object vertices{gl.gen_buffers, gl.delete_buffers};
  Object atlas{gl.gen_textures, gl.delete_textures};
  GLuint program = gl.create_program();
  Size size;  // of `pixels`
};

// ---------------------------------------------------------------------------------------------- set up

void Rasterizer::Impl::describe_vertices() {
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
  gl.enable_vertex_attrib_array(4);
  gl.vertex_attrib_i_pointer(4, 1, GL_UNSIGNED_INT, stride, byte_offset(offsetof(CanvasVertex, kind)));
}

void Rasterizer::Impl::set_state() {
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

void Rasterizer::Impl::attach(GLenum type, const char* source) {
  const GLuint shader = gl.create_shader(type);
  gl.shader_source(shader, 1, &source, nullptr);
  gl.compile_shader(shader);  // what is wrong with it shows when the program is linked
  gl.attach_shader(program, shader);
  gl.delete_shader(shader);  // when the program goes
}

void Rasterizer::Impl::link_program() {
  attach(GL_VERTEX_SHADER, vertex_source);
  attach(GL_FRAGMENT_SHADER, fragment_source);
  gl.link_program(program);
  GLint linked = GL_FALSE;
  gl.get_program(program, GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    std::array<GLchar, 2000> log{};
    gl.get_program_info_log(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw ContextError(std::string("the shader does not link: ") + log.data() + suspects());
  }
  gl.use_program(program);
  check_errors("set up");
}

// ---------------------------------------------------------------------------------------------- drawing

void Rasterizer::Impl::resize(Size wanted) {
  if (wanted == size) return;
  gl.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, wanted.width, wanted.height);
  gl.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels.name);
  const GLenum status = gl.check_framebuffer_status(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    size = {};
    gl.get_error();  // thrown with this one; the next drawing starts without it
    throw ContextError("no framebuffer of " + describe(wanted) + ": " + name_of(status) + suspects());
  }
  gl.viewport(0, 0, wanted.width, wanted.height);
  gl.uniform2f(gl.get_uniform_location(program, "pixels_to_clip"), 2.0f / static_cast<float>(wanted.width),
               2.0f / static_cast<float>(wanted.height));
  size = wanted;
}

void Rasterizer::Impl::upload(const Triangles& triangles, const Font& font) {
  const auto bytes = static_cast<GLsizeiptr>(triangles.vertices.size() * sizeof(CanvasVertex));
  gl.buffer_data(GL_ARRAY_BUFFER, bytes, triangles.vertices.data(), GL_STREAM_DRAW);
  gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_R8, Font::atlas_width, font.atlas_height(), 0, GL_RED, GL_UNSIGNED_BYTE,
                  font.atlas().data());
}

void Rasterizer::Impl::draw_runs(const Triangles& triangles, Color color) {
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
    gl.draw_arrays(GL_TRIANGLES, run.first, end - run.first);
  }
}

Image Rasterizer::Impl::read_back() {
  Image image(size);
  gl.read_pixels(0, 0, size.width, size.height, GL_RGB, GL_UNSIGNED_BYTE, image.row(0));
  return image;
}

void Rasterizer::Impl::check_errors(const char* step) {
  const GLenum error = gl.get_error();
  if (error != GL_NO_ERROR) {
    throw ContextError(std::string("OpenGL reports ") + name_of(error) + " on " + step + suspects());
  }
}

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
