// Files in the format of the MERL database, of models: for a scene of measured materials where none are at hand.
#include <filesystem>
#include <string>

#include <zonal/file/output_file.hpp>

#include "material/merl_writer.hpp"
#include "materials.hpp"
#include "report.hpp"

namespace zonal_report {

void write_merl_files(const char* folder) {
  const auto write = [folder](const char* name, const zonal::Brdf& brdf) {
    const std::filesystem::path path = std::filesystem::path(folder) / name;
    const std::string bytes = material_test::merl_bytes(brdf);
    zonal::OutputFile file(path);
    file.write(bytes.data(), bytes.size());
    file.move_into_place();
  };
  write("gold.binary", gold(0.2F));
  write("lacquer.binary", plastic({0.5F, 0.08F, 0.05F}, 0.15F));
  write("stone.binary", plastic({0.55F, 0.5F, 0.45F}, 0.4F));
}

}  // namespace zonal_report
