#include "driver.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>

namespace {

template <class F>
void load(F& function, PFNEGLGETPROCADDRESSPROC get, const char* name) {
  function = reinterpret_cast<F>(get(name));
  if (function == nullptr) throw DriverError(std::string("the driver has no ") + name);
}

}  // namespace

// Everything but libEGL itself comes by name from the driver: a program that finds none must still start.
struct Driver::Functions {
  void* library = nullptr;
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  PFNEGLGETPROCADDRESSPROC get = nullptr;
  PFNEGLQUERYSTRINGPROC query_string = nullptr;
  PFNEGLINITIALIZEPROC initialize = nullptr;
  PFNEGLTERMINATEPROC terminate = nullptr;
  PFNEGLBINDAPIPROC bind_api = nullptr;
  PFNEGLCREATECONTEXTPROC create_context = nullptr;
  PFNEGLDESTROYCONTEXTPROC destroy_context = nullptr;
  PFNEGLMAKECURRENTPROC make_current = nullptr;

  PFNGLGETSTRINGPROC GetString = nullptr;
  PFNGLGETERRORPROC GetError = nullptr;
  PFNGLCREATESHADERPROC CreateShader = nullptr;
  PFNGLSHADERSOURCEPROC ShaderSource = nullptr;
  PFNGLCOMPILESHADERPROC CompileShader = nullptr;
  PFNGLGETSHADERIVPROC GetShaderiv = nullptr;
  PFNGLGETSHADERINFOLOGPROC GetShaderInfoLog = nullptr;
  PFNGLDELETESHADERPROC DeleteShader = nullptr;
  PFNGLCREATEPROGRAMPROC CreateProgram = nullptr;
  PFNGLATTACHSHADERPROC AttachShader = nullptr;
  PFNGLLINKPROGRAMPROC LinkProgram = nullptr;
  PFNGLGETPROGRAMIVPROC GetProgramiv = nullptr;
  PFNGLGETPROGRAMINFOLOGPROC GetProgramInfoLog = nullptr;
  PFNGLDELETEPROGRAMPROC DeleteProgram = nullptr;
  PFNGLUSEPROGRAMPROC UseProgram = nullptr;
  PFNGLGENBUFFERSPROC GenBuffers = nullptr;
  PFNGLDELETEBUFFERSPROC DeleteBuffers = nullptr;
  PFNGLBINDBUFFERPROC BindBuffer = nullptr;
  PFNGLBINDBUFFERBASEPROC BindBufferBase = nullptr;
  PFNGLBUFFERDATAPROC BufferData = nullptr;
  PFNGLGETBUFFERSUBDATAPROC GetBufferSubData = nullptr;
  PFNGLDISPATCHCOMPUTEPROC DispatchCompute = nullptr;
  PFNGLMEMORYBARRIERPROC MemoryBarrier = nullptr;
  PFNGLFINISHPROC Finish = nullptr;
  PFNGLGENQUERIESPROC GenQueries = nullptr;
  PFNGLDELETEQUERIESPROC DeleteQueries = nullptr;
  PFNGLBEGINQUERYPROC BeginQuery = nullptr;
  PFNGLENDQUERYPROC EndQuery = nullptr;
  PFNGLGETQUERYOBJECTUI64VPROC GetQueryObjectui64v = nullptr;
  PFNGLGENTEXTURESPROC GenTextures = nullptr;
  PFNGLDELETETEXTURESPROC DeleteTextures = nullptr;
  PFNGLBINDTEXTUREPROC BindTexture = nullptr;
  PFNGLTEXIMAGE2DPROC TexImage2D = nullptr;
  PFNGLTEXPARAMETERIPROC TexParameteri = nullptr;
  PFNGLGENRENDERBUFFERSPROC GenRenderbuffers = nullptr;
  PFNGLDELETERENDERBUFFERSPROC DeleteRenderbuffers = nullptr;
  PFNGLBINDRENDERBUFFERPROC BindRenderbuffer = nullptr;
  PFNGLRENDERBUFFERSTORAGEPROC RenderbufferStorage = nullptr;
  PFNGLGENFRAMEBUFFERSPROC GenFramebuffers = nullptr;
  PFNGLDELETEFRAMEBUFFERSPROC DeleteFramebuffers = nullptr;
  PFNGLBINDFRAMEBUFFERPROC BindFramebuffer = nullptr;
  PFNGLFRAMEBUFFERRENDERBUFFERPROC FramebufferRenderbuffer = nullptr;
  PFNGLCHECKFRAMEBUFFERSTATUSPROC CheckFramebufferStatus = nullptr;
  PFNGLVIEWPORTPROC Viewport = nullptr;
  PFNGLDRAWARRAYSPROC DrawArrays = nullptr;
  PFNGLREADPIXELSPROC ReadPixels = nullptr;

  void load_egl() {
    load(query_string, get, "eglQueryString");
    load(initialize, get, "eglInitialize");
    load(terminate, get, "eglTerminate");
    load(bind_api, get, "eglBindAPI");
    load(create_context, get, "eglCreateContext");
    load(destroy_context, get, "eglDestroyContext");
    load(make_current, get, "eglMakeCurrent");
  }

  void load_gl() {
    load(GetString, get, "glGetString");
    load(GetError, get, "glGetError");
    load(CreateShader, get, "glCreateShader");
    load(ShaderSource, get, "glShaderSource");
    load(CompileShader, get, "glCompileShader");
    load(GetShaderiv, get, "glGetShaderiv");
    load(GetShaderInfoLog, get, "glGetShaderInfoLog");
    load(DeleteShader, get, "glDeleteShader");
    load(CreateProgram, get, "glCreateProgram");
    load(AttachShader, get, "glAttachShader");
    load(LinkProgram, get, "glLinkProgram");
    load(GetProgramiv, get, "glGetProgramiv");
    load(GetProgramInfoLog, get, "glGetProgramInfoLog");
    load(DeleteProgram, get, "glDeleteProgram");
    load(UseProgram, get, "glUseProgram");
    load(GenBuffers, get, "glGenBuffers");
    load(DeleteBuffers, get, "glDeleteBuffers");
    load(BindBuffer, get, "glBindBuffer");
    load(BindBufferBase, get, "glBindBufferBase");
    load(BufferData, get, "glBufferData");
    load(GetBufferSubData, get, "glGetBufferSubData");
    load(DispatchCompute, get, "glDispatchCompute");
    load(MemoryBarrier, get, "glMemoryBarrier");
    load(Finish, get, "glFinish");
    load(GenQueries, get, "glGenQueries");
    load(DeleteQueries, get, "glDeleteQueries");
    load(BeginQuery, get, "glBeginQuery");
    load(EndQuery, get, "glEndQuery");
    load(GetQueryObjectui64v, get, "glGetQueryObjectui64v");
    load(GenTextures, get, "glGenTextures");
    load(DeleteTextures, get, "glDeleteTextures");
    load(BindTexture, get, "glBindTexture");
    load(TexImage2D, get, "glTexImage2D");
    load(TexParameteri, get, "glTexParameteri");
    load(GenRenderbuffers, get, "glGenRenderbuffers");
    load(DeleteRenderbuffers, get, "glDeleteRenderbuffers");
    load(BindRenderbuffer, get, "glBindRenderbuffer");
    load(RenderbufferStorage, get, "glRenderbufferStorage");
    load(GenFramebuffers, get, "glGenFramebuffers");
    load(DeleteFramebuffers, get, "glDeleteFramebuffers");
    load(BindFramebuffer, get, "glBindFramebuffer");
    load(FramebufferRenderbuffer, get, "glFramebufferRenderbuffer");
    load(CheckFramebufferStatus, get, "glCheckFramebufferStatus");
    load(Viewport, get, "glViewport");
    load(DrawArrays, get, "glDrawArrays");
    load(ReadPixels, get, "glReadPixels");
  }

  /// The displays to try: each device, then the platform without any.
  std::vector<EGLDisplay> displays() const {
    std::vector<EGLDisplay> found;
    const auto platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(get("eglGetPlatformDisplayEXT"));
    const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(get("eglQueryDevicesEXT"));
    if (platform_display == nullptr) return found;
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (query_devices != nullptr && query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count)) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        found.push_back(platform_display(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
      }
    }
    found.push_back(platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    found.erase(std::remove(found.begin(), found.end(), EGL_NO_DISPLAY), found.end());
    return found;
  }

  /// A core context of 4.6 down to 4.3, or one of ES 3.0, on this display, made current.
  bool start(EGLDisplay candidate, Language language) {
    if (!initialize(candidate, nullptr, nullptr)) return false;
    const char* extensions = query_string(candidate, EGL_EXTENSIONS);
    const bool is_surfaceless =
        extensions && std::string(extensions).find("EGL_KHR_surfaceless_context") != std::string::npos;
    const bool is_es = language == Language::glsl_es;
    if (is_surfaceless && bind_api(is_es ? EGL_OPENGL_ES_API : EGL_OPENGL_API)) {
      for (const EGLint minor : is_es ? std::vector<EGLint>{0} : std::vector<EGLint>{6, 5, 4, 3}) {
        std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION, is_es ? 3 : 4, EGL_CONTEXT_MINOR_VERSION, minor};
        if (!is_es) {
          attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT});
        }
        attributes.push_back(EGL_NONE);
        context = create_context(candidate, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
        if (context == EGL_NO_CONTEXT) continue;
        if (make_current(candidate, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
          display = candidate;
          return true;
        }
        destroy_context(candidate, context);
      }
    }
    terminate(candidate);
    return false;
  }
};

Driver::Driver() : gl_(std::make_unique<Functions>()) {}

Driver::~Driver() {
  if (gl_->display == EGL_NO_DISPLAY) return;
  gl_->make_current(gl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  gl_->destroy_context(gl_->display, gl_->context);
  gl_->terminate(gl_->display);
  // The library stays: some drivers do not survive their own unloading.
}

std::unique_ptr<Driver> Driver::open(std::string& reason, Language language) {
  std::unique_ptr<Driver> driver(new Driver);
  reason = driver->start(language);
  return reason.empty() ? std::move(driver) : nullptr;
}

std::string Driver::start(Language language) {
  const std::string packages = " (Debian packages: libegl1 libgl1-mesa-dri)";
  gl_->library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (gl_->library == nullptr) return "no libEGL.so.1" + packages;
  gl_->get = reinterpret_cast<PFNEGLGETPROCADDRESSPROC>(dlsym(gl_->library, "eglGetProcAddress"));
  if (gl_->get == nullptr) return "libEGL.so.1 has no eglGetProcAddress";
  try {
    gl_->load_egl();
    for (const EGLDisplay display : gl_->displays()) {
      if (!gl_->start(display, language)) continue;
      gl_->load_gl();
      renderer_ = reinterpret_cast<const char*>(gl_->GetString(GL_RENDERER));
      return "";
    }
  } catch (const DriverError& error) {
    return error.what();
  }
  const std::string wanted = language == Language::glsl_es ? "OpenGL ES 3.0" : "OpenGL 4.3";
  return "no EGL display gives a context of " + wanted + " or later without a window" + packages;
}

void Driver::use() { gl_->make_current(gl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, gl_->context); }

bool Driver::is_software() const {
  return renderer_.find("llvmpipe") != std::string::npos || renderer_.find("softpipe") != std::string::npos ||
         renderer_.find("SwiftShader") != std::string::npos;
}

unsigned Driver::compile_stage(unsigned stage, const std::string& source) {
  const GLuint shader = gl_->CreateShader(stage);
  const char* text = source.c_str();
  gl_->ShaderSource(shader, 1, &text, nullptr);
  gl_->CompileShader(shader);
  GLint done = 0;
  gl_->GetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done) return shader;
  std::vector<char> log(10000);
  gl_->GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  throw DriverError(std::string("does not compile:\n") + log.data());
}

unsigned Driver::link(const std::vector<unsigned>& stages) {
  const GLuint program = gl_->CreateProgram();
  for (const unsigned stage : stages) gl_->AttachShader(program, stage);
  gl_->LinkProgram(program);
  for (const unsigned stage : stages) gl_->DeleteShader(stage);
  GLint done = 0;
  gl_->GetProgramiv(program, GL_LINK_STATUS, &done);
  if (done) return program;
  std::vector<char> log(10000);
  gl_->GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
  throw DriverError(std::string("does not link:\n") + log.data());
}

unsigned Driver::compile(const std::string& compute_shader) {
  return link({compile_stage(GL_COMPUTE_SHADER, compute_shader)});
}

unsigned Driver::compile(const std::string& vertex_shader, const std::string& fragment_shader) {
  return link({compile_stage(GL_VERTEX_SHADER, vertex_shader), compile_stage(GL_FRAGMENT_SHADER, fragment_shader)});
}

unsigned Driver::make_buffer(const std::vector<float>& values) {
  GLuint buffer = 0;
  gl_->GenBuffers(1, &buffer);
  gl_->BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  gl_->BufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(float)), values.data(),
                  GL_DYNAMIC_COPY);
  check("making a buffer");
  return buffer;
}

std::vector<float> Driver::read_buffer(unsigned buffer, std::size_t count) {
  std::vector<float> values(count);
  gl_->BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  gl_->GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(count * sizeof(float)), values.data());
  check("reading a buffer");
  return values;
}

void Driver::delete_program(unsigned program) { gl_->DeleteProgram(program); }
void Driver::delete_buffer(unsigned buffer) { gl_->DeleteBuffers(1, &buffer); }

double Driver::run(unsigned program, const std::vector<unsigned>& buffers, unsigned groups, unsigned uniforms) {
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    gl_->BindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(i), buffers[i]);
  }
  if (uniforms != 0) gl_->BindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(buffers.size()), uniforms);
  gl_->UseProgram(program);
  GLuint query = 0;
  gl_->GenQueries(1, &query);
  const auto start = std::chrono::steady_clock::now();
  gl_->BeginQuery(GL_TIME_ELAPSED, query);
  gl_->DispatchCompute(groups, 1, 1);
  gl_->MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  gl_->EndQuery(GL_TIME_ELAPSED);
  gl_->Finish();
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
  GLuint64 nanoseconds = 0;
  gl_->GetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
  gl_->DeleteQueries(1, &query);
  check("running a compute shader");
  // llvmpipe's timer does not count compute shaders.
  return is_software() ? elapsed.count() : static_cast<double>(nanoseconds) * 1e-6;
}

std::vector<float> Driver::draw(unsigned program, const std::vector<float>& texels, int columns, int width,
                                int height) {
  GLuint texture = 0, target = 0, frame = 0;
  gl_->GenTextures(1, &texture);
  gl_->BindTexture(GL_TEXTURE_2D, texture);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, columns, static_cast<int>(texels.size()) / columns, 0, GL_RED, GL_FLOAT,
                  texels.data());
  // Floats are not filtered, and there are no smaller levels.
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl_->GenRenderbuffers(1, &target);
  gl_->BindRenderbuffer(GL_RENDERBUFFER, target);
  gl_->RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, width, height);
  gl_->GenFramebuffers(1, &frame);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, frame);
  gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target);
  if (gl_->CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw DriverError("the driver does not draw to floats");
  }
  gl_->Viewport(0, 0, width, height);
  gl_->UseProgram(program);
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<float> pixels(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  gl_->ReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, pixels.data());
  gl_->DeleteFramebuffers(1, &frame);
  gl_->DeleteRenderbuffers(1, &target);
  gl_->DeleteTextures(1, &texture);
  check("drawing");
  return pixels;
}

void Driver::check(const char* what) {
  const GLenum error = gl_->GetError();
  if (error != GL_NO_ERROR) throw DriverError(std::string(what) + ": OpenGL error " + std::to_string(error));
}
