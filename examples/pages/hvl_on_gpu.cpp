// Indirect light on a GPU: virtual lights and a material in buffers, gathered in a compute shader by generated
// functions, beside the same gather in C++. Needs GLM, EGL and OpenGL 4.3; a driver on the CPU will do (on
// Debian libegl-dev libgl-dev libgl1-mesa-dri). The functions first:
//
//   zonal-glsl --functions gather@5,material_with_cosine@5,tangent_towards -o hvl.glsl
//   g++ -std=c++17 -O2 -Iinclude examples/pages/hvl_on_gpu.cpp -o hvl_on_gpu -lEGL -lGL
//
// zonal-glsl: cmake --preset release && cmake --build build/release --target zonal-glsl, which leaves it in
// build/release/tools/zonal-glsl; or as it was installed. All that in a CMake build:
//
//   find_package(zonal REQUIRED)  # or add_subdirectory, FetchContent: docs/README.md
//   find_package(OpenGL REQUIRED COMPONENTS EGL)
//   add_executable(hvl_on_gpu hvl_on_gpu.cpp)
//   target_link_libraries(hvl_on_gpu PRIVATE zonal::render OpenGL::EGL OpenGL::GL)
//   zonal_add_shader(hvl_on_gpu OUTPUT hvl.glsl FUNCTIONS gather@5 material_with_cosine@5 tangent_towards)
//
// It reads hvl.glsl from the folder where it is run.
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>

#include <zonal/gather/radius.hpp>
#include <zonal/material/named.hpp>
#include <zonal/shader/buffers.hpp>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

const char* const before_functions = R"(#version 430
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Lights { float lights[]; };
layout(std430, binding = 1) readonly buffer Material { float material[]; };
layout(std430, binding = 2) readonly buffer Points { float points[]; };  // position, normal, direction to the eye
layout(std430, binding = 3) writeonly buffer Radiance { float radiance[]; };
layout(location = 0) uniform uint light_count;
#define ZONAL_LIGHT(i) lights[i]
#define ZONAL_MATERIAL(i) material[i]
)";
const char* const after_functions = R"(
vec3 vector(uint i) { return vec3(points[3u * i], points[3u * i + 1u], points[3u * i + 2u]); }
void main() {
  uint i = gl_GlobalInvocationID.x;
  if (9u * i >= uint(points.length())) return;
  vec3 position = vector(3u * i), normal = vector(3u * i + 1u), to_eye = vector(3u * i + 2u);
  vec3 f[15];  // of m >= 0: bands (bands + 1) / 2
  zonal_material_with_cosine_5(0u, dot(normal, to_eye), f);
  vec3 sum = zonal_gather_5(light_count, position, normal, zonal_tangent_towards(normal, to_eye), f);
  for (uint c = 0u; c < 3u; ++c) radiance[3u * i + c] = sum[c];
}
)";

// Any OpenGL of 4.3 or later, without a window: of Mesa, or the display's.
bool make_context() {
  eglBindAPI(EGL_OPENGL_API);
  for (EGLDisplay display :
       {eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr), eglGetDisplay(EGL_DEFAULT_DISPLAY)}) {
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    if (!eglInitialize(display, nullptr, nullptr)) continue;
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
    if (context && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return true;
  }
  return false;
}

void bind_buffer(GLuint binding, const std::vector<float>& floats) {
  GLuint buffer;
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer);
  glBufferData(GL_SHADER_STORAGE_BUFFER, GLsizeiptr(floats.size() * sizeof(float)), floats.data(), GL_STATIC_DRAW);
}

int main() {
  // Gold with a roughness of 0.4, five bands. A ceiling of it, 2 x 2 m and 1 m above a floor of the same, in the light
  // of a lamp at the floor's edge: 8 x 8 virtual lights, in a renderer the texels of a reflective shadow map.
  const zonal::MaterialTable gold = zonal::project_material(zonal::metal(*zonal::find_metal("gold"), 0.4F), 5, 1e-3);
  const int side = 8;
  std::vector<zonal::VirtualLight> lights(side * side);
  for (int i = 0; i < side * side; ++i) {
    zonal::VirtualLight& light = lights[i];
    light.position = {(i % side + 0.5F) * 2 / side - 1, (i / side + 0.5F) * 2 / side - 1, 1};
    light.normal = {0, 0, -1};
    light.to_primary = glm::normalize(glm::vec3(-1.5F, 0, 0) - light.position);
    light.flux = glm::vec3(1);
    light.material = &gold;
  }
  zonal::set_neighbour_radii(lights.data(), side, side, 0.5F);
  const zonal::HvlCache<3> cache(lights);  // three bands of emission

  std::vector<zonal::Receiver> points;
  for (const float x : {-0.5F, 0.0F, 0.5F}) points.push_back({{x, 0.2F, 0}, {0, 0, 1}, {0.6F, 0, 0.8F}});

  if (!make_context()) {
    std::puts("no OpenGL 4.3 without a window (on Debian: libegl1 libgl1-mesa-dri)");
    return 77;
  }

  // What the shader reads, and room for what it gives.
  bind_buffer(0, zonal::shader_buffer(cache));
  bind_buffer(1, zonal::shader_buffer(gold));
  std::vector<float> floats;
  for (const zonal::Receiver& point : points) {
    for (const glm::vec3& v : {point.position, point.normal, point.outgoing}) {
      floats.insert(floats.end(), {v.x, v.y, v.z});
    }
  }
  bind_buffer(2, floats);
  std::vector<float> radiance(3 * points.size());
  bind_buffer(3, radiance);

  std::ifstream functions("hvl.glsl");
  if (!functions) {
    std::puts("no hvl.glsl here: zonal-glsl writes it");
    return 1;
  }
  std::ostringstream source;
  source << before_functions << functions.rdbuf() << after_functions;
  const std::string text = source.str();
  const char* const string = text.c_str();
  const GLuint program = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &string);
  char log[1000] = "";
  glGetProgramInfoLog(program, sizeof log, nullptr, log);
  std::fputs(log, stderr);
  glUseProgram(program);
  glUniform1ui(0, GLuint(cache.size()));
  glDispatchCompute(GLuint(points.size() + 63) / 64, 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, GLsizeiptr(radiance.size() * sizeof(float)), radiance.data());

  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec3 expected = zonal::gather<5>(cache, points[i], gold);
    std::printf("x = %4.1f: C++ %.3f %.3f %.3f, the shader %.3f %.3f %.3f\n", double(points[i].position.x),
                double(expected.r), double(expected.g), double(expected.b), double(radiance[3 * i]),
                double(radiance[3 * i + 1]), double(radiance[3 * i + 2]));
  }
  return glGetError() == GL_NO_ERROR ? 0 : 1;
}

// It prints:
//   x = -0.5: C++ 0.915 0.628 0.099, the shader 0.915 0.628 0.099
//   x =  0.0: C++ 1.506 1.032 0.167, the shader 1.506 1.032 0.167
//   x =  0.5: C++ 1.982 1.361 0.232, the shader 1.982 1.361 0.232
