// The shaders of docs/examples, with the functions that they include.
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "request.hpp"

/// The example with its #include "zonal_..." replaced by these functions, precise, and `defines` after its #version.
inline std::string example(const std::string& file, const std::vector<std::string>& functions, int bands,
                           const std::string& defines) {
  std::ifstream source(std::string(ZONAL_DOCUMENTS "/examples/") + file);
  if (!source) throw std::runtime_error("no example " + file);
  zonal_glsl::Request request;
  request.functions = functions;
  request.bands = bands;
  request.text.precise = true;
  std::string text, line;
  while (std::getline(source, line)) {
    const bool includes = line.rfind("#include \"zonal_", 0) == 0;
    text += includes ? zonal_glsl::shader_file(request, *zonal::shader::find_dialect("glsl450")) : line + "\n";
    if (line.rfind("#version", 0) == 0) text += defines;
  }
  return text;
}

/// The gather or the grid, with the loops over lights forward or reversed.
inline std::string gather_example(int bands, const std::string& shell) {
  const std::string n = std::to_string(bands);
  return example("gather.comp", {shell, "material_with_cosine", "tangent_towards"}, bands,
                 "#define BANDS " + n + "\n#define GATHER zonal_" + shell + "_" + n +
                     "\n#define MATERIAL zonal_material_with_cosine_" + n + "\n");
}
inline std::string grid_example(int bands, const std::string& shell) {
  const std::string n = std::to_string(bands);
  return example("grid.comp", {shell}, bands,
                 "#define BANDS " + n + "\n#define SUM_LIGHTS zonal_" + shell + "_" + n + "\n");
}
/// A pass of the screen's filter, 1 or 2.
inline std::string screen_example(int bands, int pass) {
  const std::string n = std::to_string(bands);
  std::string defines = "#define PASS " + std::to_string(pass) + "\n#define BANDS " + n + "\n";
  std::vector<std::string> functions;
  for (const auto& [macro, function] : {std::pair("FILTER_ACROSS", "filter_across"),
                                        {"FILTER_DOWN", "filter_down"},
                                        {"LAMBERT", "reconstruct_lambert_colour"},
                                        {"PHONG", "phong"},
                                        {"CONVOLVED", "reconstruct_convolved_colour"}}) {
    functions.push_back(function);
    defines += std::string("#define ") + macro + " zonal_" + function + "_" + n + "\n";
  }
  return example("screen.comp", functions, bands, defines);
}
