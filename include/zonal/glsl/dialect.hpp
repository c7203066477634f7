// How each shading language spells what a record holds: a language is a value of one struct.
#pragma once

#include <string_view>

#include "../scalar/target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace glsl {

/// How parameters are declared, which no word in a table can say.
enum class Declarations {
  glsl,  // out float y[25], in float zh[5]
  hlsl,  // the same; results are precise by a local variable alone
  wgsl,  // y: ptr<function, array<f32, 25>>, zh: array<f32, 5>
  cpp,   // float (&y)[25], const float (&zh)[5]
};

struct Dialect {
  std::string_view name, title;  // on the command line, and in comments
  Declarations declarations;
  std::string_view number, pair, triple;     // types
  std::string_view temporary, flag, result;  // what stands before a new number, a new bool, a precise result
  std::string_view function;                 // what stands before a function
  std::string_view square_root, absolute;    // functions
  bool has_components;                       // v.x, or v[0]
  bool has_minimum;                          // min(a, b), or b < a ? b : a
  bool has_ternary;                          // a < b ? c : d, or select(d, c, a < b)
  std::string_view prologue;                 // at the top of a file
};

// Where a compiler may reassociate and contract, results are `precise`. Defined as nothing before this file is
// included, the macro allows both: faster on some hardware, and no longer equal to C++ to the bit.
inline constexpr std::string_view precise_macro = R"(#ifndef ZONAL_PRECISE
#define ZONAL_PRECISE precise
#endif
)";
inline constexpr std::string_view no_precise_macro = R"(#ifndef ZONAL_PRECISE
#define ZONAL_PRECISE
#endif
)";
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
    {"glsl450", "GLSL 4.50", Declarations::glsl, "float", "vec2", "vec3", "float ", "bool ", "ZONAL_PRECISE ", "",
     "sqrt", "abs", true, true, true, precise_macro},
    {"glsles300", "GLSL ES 3.00", Declarations::glsl, "float", "vec2", "vec3", "float ", "bool ", "ZONAL_PRECISE ", "",
     "sqrt", "abs", true, true, true, no_precise_macro},
    {"hlsl", "HLSL", Declarations::hlsl, "float", "float2", "float3", "precise float ", "bool ", "precise ", "", "sqrt",
     "abs", true, true, true, ""},
    {"wgsl", "WGSL", Declarations::wgsl, "f32", "vec2<f32>", "vec3<f32>", "let ", "let ", "let ", "", "sqrt", "abs",
     true, true, false, ""},
    {"cpp", "C++ and CUDA", Declarations::cpp, "float", "float", "float", "const float ", "const bool ", "const ",
     "ZONAL_FUNCTION ", "sqrtf", "fabsf", false, false, true, cpp_prologue},
};

/// The dialect of this name, or null.
constexpr const Dialect* find_dialect(std::string_view name) {
  for (const Dialect& dialect : dialects) {
    if (dialect.name == name) return &dialect;
  }
  return nullptr;
}

}  // namespace glsl
}  // namespace ZONAL_TARGET
}  // namespace zonal
