// An OpenGL driver without a window: compute shaders on buffers of floats.
#pragma once

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

/// What a driver says of a shader or a call that it does not take.
struct DriverError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Driver {
 public:
  /// What it speaks: compute shaders of GLSL 4.30 or later, or GLSL ES 3.00, that of WebGL 2.
  enum class Language { glsl, glsl_es };

  /// Hardware first, then software. Null where there is none, and `reason` then says why.
  static std::unique_ptr<Driver> open(std::string& reason, Language language = Language::glsl);
  ~Driver();
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  /// It is the one that the thread speaks to from now on, as after open().
  void use();
  /// The driver's name of itself.
  const std::string& renderer() const { return renderer_; }
  /// Whether it computes on the CPU: then to the bit as C++ does.
  bool is_software() const;

  /// Handles of OpenGL; they live as long as the driver.
  unsigned compile(const std::string& compute_shader);
  unsigned compile(const std::string& vertex_shader, const std::string& fragment_shader);
  unsigned make_buffer(const std::vector<float>& values);
  std::vector<float> read_buffer(unsigned buffer, std::size_t count);
  void delete_program(unsigned program);
  void delete_buffer(unsigned buffer);

  /// Runs so many groups with the buffers bound to 0, 1, ..., and a buffer of uniforms, if there is one, to the number
  /// after them; and waits. The time it takes, in milliseconds: by the driver's own timer, on a software driver by the
  /// clock.
  double run(unsigned program, const std::vector<unsigned>& buffers, unsigned groups, unsigned uniforms = 0);

  /// The pixels, rows from below, four floats each, of `width` x `height` of them that a program draws in whose
  /// vertices 0, 1 and 2 cover all. Its one texture is of floats, so many columns, read texel by texel. ES has it by an
  /// extension.
  std::vector<float> draw(unsigned program, const std::vector<float>& texels, int columns, int width, int height);

 private:
  struct Functions;
  Driver();
  std::string start(Language language);  // the reason why not, or empty
  unsigned compile_stage(unsigned stage, const std::string& source);
  unsigned link(const std::vector<unsigned>& stages);
  void check(const char* what);

  std::unique_ptr<Functions> gl_;
  std::string renderer_;
};

/// The driver of this process, opened once, and in use. Where there is none the test is skipped with the reason; where
/// the environment says CI=true it fails.
Driver* driver_or_skip(Driver::Language language = Driver::Language::glsl);
