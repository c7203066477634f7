#include "machine.hpp"

#include <fstream>

namespace zonal_bench {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

// Of what this processor has, the part that the compiler was told to use.
std::string compiler() {
  std::string text = ZONAL_BENCH_COMPILER;
#if defined(__AVX512F__)
  text += ", AVX-512";
#elif defined(__AVX__)
  text += ", AVX";
#endif
#if defined(__FMA__)
  text += ", FMA";
#endif
  return text;
}

}  // namespace zonal_bench
