// Writes every GLSL function, with a caller between flat arrays of floats, for glm_functions.cpp: 1, 2 and 4 bands.
#include <zonal/shader/function_text.hpp>

#include <cstdio>
#include <fstream>
#include <regex>
#include <string>

#include "../shader/caller.hpp"
#include "shader_functions.hpp"

/// An out parameter that is no array has to be a reference.
static std::string as_cpp(const std::string& glsl) {
  return std::regex_replace(glsl, std::regex("out (\\w+) (\\w+)(?=[,)])"), "$1 &$2");
}

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  std::ofstream file(argv[1]);
  std::string table;
  for (const auto& entry : zonal_glsl::shader_functions()) {
    for (const int bands : {1, 2, 4}) {
      if (!entry.has_bands && bands > 1) continue;
      const auto function = entry.record(bands, zonal::shader::all_orders);
      file << as_cpp(function_text(function, *zonal::shader::find_dialect("glsl450"))) << caller_text(function, "int");
      table += "    {\"" + function.name + "\", call_" + function.name + "},\n";
    }
  }
  file << "const std::map<std::string, void (*)(int, int)> callers = {\n" << table << "};\n";
  return file ? 0 : 1;
}
