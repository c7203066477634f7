// How each shading language spells what a record holds: a language is a value of one struct.
#pragma once

#include <string_view>

#include "../scalar/target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace shader {

/// How parameters and locals are declared, which no word in a table can say.
enum class Declarations {
  glsl,  // out float y[25], in float zh[5]
  hlsl,  // the same; results are precise by every local variable on their way
  wgsl,  // y: ptr<function, array<f32, 25>>, zh: array<f32, 5>
  cpp,   // float (&y)[25], const float (&zh)[5]
};

struct Dialect {
  std::string_view name, title;  // on the command line, and in comments
  Declarations declarations;
  std::string_view number, pair, triple;  // types
  std::string_view precision;             // stands before a type where that needs one: a default may be missing or low
  std::string_view precise;               // forbids to reassociate and contract; empty where there is no such word
  std::string_view local;                 // stands before a new number
  std::string_view function;              // stands before a function
  std::string_view square_root, absolute;
  bool has_components;           // v.x, or v[0]
  bool has_minimum;              // min(a, b), or b < a ? b : a
  bool has_ternary;              // a < b ? c : d, or select(d, c, a < b)
  bool has_preprocessor;         // hence guards
  bool has_loops;                // whether the loops of shells.hpp are written in it
  std::string_view prologue;     // at the top of a file
  int max_parameters = 1 << 20;  // of a function
};

inline constexpr std::string_view cpp_prologue = R"(#include <math.h>
#ifndef ZONAL_FUNCTION
#ifdef __CUDACC__
#define ZONAL_FUNCTION __host__ __device__ inline
#else
#define ZONAL_FUNCTION inline
#endif
#endif
)";

inline constexpr Dialect dialects[] = {
    {"glsl450", "GLSL 4.50", Declarations::glsl, "float", "vec2", "vec3", "", "precise ", "", "", "sqrt", "abs", true,
     true, true, true, true, ""},
    {"glsles300", "GLSL ES 3.00", Declarations::glsl, "float", "vec2", "vec3", "highp ", "", "", "", "sqrt", "abs",
     true, true, true, true, true, ""},
    {"hlsl", "HLSL", Declarations::hlsl, "float", "float2", "float3", "", "precise ", "", "", "sqrt", "abs", true, true,
     true, true, false, ""},
    {"wgsl", "WGSL", Declarations::wgsl, "f32", "vec2<f32>", "vec3<f32>", "", "", "let ", "", "sqrt", "abs", true, true,
     false, false, false, "", 255},
    {"cpp", "C++ and CUDA", Declarations::cpp, "float", "float", "float", "", "", "const ", "ZONAL_FUNCTION ", "sqrtf",
     "fabsf", false, false, true, true, false, cpp_prologue},
};

/// The dialect of this name, or null.
constexpr const Dialect* find_dialect(std::string_view name) {
  for (const Dialect& dialect : dialects) {
    if (dialect.name == name) return &dialect;
  }
  return nullptr;
}

}  // namespace shader
}  // namespace ZONAL_TARGET
}  // namespace zonal
