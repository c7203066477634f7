// Files in the format of the MERL database, of models: for a scene of measured materials where none are at hand.
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "material/merl_writer.hpp"
#include "materials.hpp"
#include "report.hpp"

namespace zonal_report {

void write_merl_files(const char* folder) {
  const auto write = [folder](const char* name, const zonal::Brdf& brdf) {
    const std::filesystem::path path = std::filesystem::path(folder) / name;
    const std::string bytes = material_test::merl_bytes(brdf);
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), std::streamsize(bytes.size()));
    if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
  };
  write("gold.binary", gold(0.2F));
  write("lacquer.binary", plastic({0.5F, 0.08F, 0.05F}, 0.15F));
  write("stone.binary", plastic({0.55F, 0.5F, 0.45F}, 0.4F));
}

}  // namespace zonal_report
