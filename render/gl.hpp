/// The OpenGL functions that the rasterizer uses, fetched from a context: nothing links against libGL.
#pragma once

#include <GL/glcorearb.h>

#include "render/offscreen_context.hpp"

namespace render {

/// Fetches a function by name and converts it to the type of the pointer that it initialises.
struct GlLoader {
  struct Named {
    const OffscreenContext& context;
    const char* name;
    template <class F>
    operator F*() const {
      return reinterpret_cast<F*>(context.function(name));
    }
  };

  const OffscreenContext& context;
  Named operator()(const char* name) const { return {context, name}; }
};

/// Construct as Gl{{context}}. Errors: ContextError where the driver lacks a function.
struct Gl {
  GlLoader load;

  // State and errors
  PFNGLGETERRORPROC get_error = load("glGetError");
  PFNGLENABLEPROC enable = load("glEnable");
  PFNGLBLENDFUNCSEPARATEPROC blend_func_separate = load("glBlendFuncSeparate");
  PFNGLVIEWPORTPROC viewport = load("glViewport");
  PFNGLSCISSORPROC scissor = load("glScissor");
  PFNGLPIXELSTOREIPROC pixel_store = load("glPixelStorei");

  // Framebuffer
  PFNGLGENFRAMEBUFFERSPROC gen_framebuffers = load("glGenFramebuffers");
  PFNGLDELETEFRAMEBUFFERSPROC delete_framebuffers = load("glDeleteFramebuffers");
  PFNGLBINDFRAMEBUFFERPROC bind_framebuffer = load("glBindFramebuffer");
  PFNGLCHECKFRAMEBUFFERSTATUSPROC check_framebuffer_status = load("glCheckFramebufferStatus");
  PFNGLGENRENDERBUFFERSPROC gen_renderbuffers = load("glGenRenderbuffers");
  PFNGLDELETERENDERBUFFERSPROC delete_renderbuffers = load("glDeleteRenderbuffers");
  PFNGLBINDRENDERBUFFERPROC bind_renderbuffer = load("glBindRenderbuffer");
  PFNGLRENDERBUFFERSTORAGEPROC renderbuffer_storage = load("glRenderbufferStorage");
  PFNGLFRAMEBUFFERRENDERBUFFERPROC framebuffer_renderbuffer = load("glFramebufferRenderbuffer");
  PFNGLREADPIXELSPROC read_pixels = load("glReadPixels");

  // Shader
  PFNGLCREATESHADERPROC create_shader = load("glCreateShader");
  PFNGLSHADERSOURCEPROC shader_source = load("glShaderSource");
  PFNGLCOMPILESHADERPROC compile_shader = load("glCompileShader");
  PFNGLDELETESHADERPROC delete_shader = load("glDeleteShader");
  PFNGLCREATEPROGRAMPROC create_program = load("glCreateProgram");
  PFNGLATTACHSHADERPROC attach_shader = load("glAttachShader");
  PFNGLLINKPROGRAMPROC link_program = load("glLinkProgram");
  PFNGLGETPROGRAMIVPROC get_program = load("glGetProgramiv");
  PFNGLGETPROGRAMINFOLOGPROC get_program_info_log = load("glGetProgramInfoLog");
  PFNGLDELETEPROGRAMPROC delete_program = load("glDeleteProgram");
  PFNGLUSEPROGRAMPROC use_program = load("glUseProgram");
  PFNGLGETUNIFORMLOCATIONPROC get_uniform_location = load("glGetUniformLocation");
  PFNGLUNIFORM2FPROC uniform2f = load("glUniform2f");

  // Texture
  PFNGLGENTEXTURESPROC gen_textures = load("glGenTextures");
  PFNGLDELETETEXTURESPROC delete_textures = load("glDeleteTextures");
  PFNGLBINDTEXTUREPROC bind_texture = load("glBindTexture");
  PFNGLTEXPARAMETERIPROC tex_parameter = load("glTexParameteri");
  PFNGLTEXIMAGE2DPROC tex_image_2d = load("glTexImage2D");

  // Vertices and drawing
  PFNGLGENVERTEXARRAYSPROC gen_vertex_arrays = load("glGenVertexArrays");
  PFNGLDELETEVERTEXARRAYSPROC delete_vertex_arrays = load("glDeleteVertexArrays");
  PFNGLBINDVERTEXARRAYPROC bind_vertex_array = load("glBindVertexArray");
  PFNGLGENBUFFERSPROC gen_buffers = load("glGenBuffers");
  PFNGLDELETEBUFFERSPROC delete_buffers = load("glDeleteBuffers");
  PFNGLBINDBUFFERPROC bind_buffer = load("glBindBuffer");
  PFNGLBUFFERDATAPROC buffer_data = load("glBufferData");
  PFNGLENABLEVERTEXATTRIBARRAYPROC enable_vertex_attrib_array = load("glEnableVertexAttribArray");
  PFNGLVERTEXATTRIBPOINTERPROC vertex_attrib_pointer = load("glVertexAttribPointer");
  PFNGLVERTEXATTRIBIPOINTERPROC vertex_attrib_i_pointer = load("glVertexAttribIPointer");
  PFNGLCLEARCOLORPROC clear_color = load("glClearColor");
  PFNGLCLEARPROC clear = load("glClear");
  PFNGLDRAWARRAYSPROC draw_arrays = load("glDrawArrays");
};

}  // namespace render
