// libFuzzer on every reader of files of the library, and on OBJ with MTL of the programs: whatever stands in a file, it
// is read or refused, by the errors stated, without a report of the sanitizers. The first byte chooses the reader.
//
//   ZONAL_SEEDS=<folder> readers ...   writes small valid files there first
#include <zonal/field/sample_file.hpp>
#include <zonal/field/sequence.hpp>
#include <zonal/grid/grid_file.hpp>
#include <zonal/grid/visibility_file.hpp>
#include <zonal/material/material_file.hpp>
#include <zonal/material/merl.hpp>
#include <zonal/material/rgl.hpp>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include <unistd.h>

#include "../../examples/shared/input_error.hpp"
#include "../../examples/shared/obj_file.hpp"
#include "../material/tensor_writer.hpp"

namespace {

using Path = std::filesystem::path;

struct Reader {
  bool ends_in_checksum;  // which is put right, or hardly any input would come past it
  std::function<void(const Path&)> read, write_seed;
};

void write_text(const Path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary).write(text.data(), std::streamsize(text.size()));
}

void ask(const zonal::RglBrdf& brdf) {
  for (const double x : {-0.6, 0.0, 0.6}) brdf({x, 0, 0.8}, {0, 0.6, 0.8});
}

const std::vector<Reader>& readers() {
  static const std::vector<Reader> all{
      {true, [](const Path& p) { zonal::load_grid<2>(p); },
       [](const Path& p) {
         save_grid(p, zonal::CoefficientGrid<2>({0, 0, 0}, {1, 1, 1}, {2, 2, 2}));
       }},
      {true, [](const Path& p) { zonal::load_grid<1, zonal::GridContent::values>(p); },
       [](const Path& p) {
         const zonal::CoefficientGrid<1, zonal::GridContent::values> grid({0, 0, 0}, {1, 1, 1}, {2, 3, 2});
         save_grid(p, grid, zonal::GridNumbers::halves);
       }},
      {true, [](const Path& p) { zonal::load_visibility(p); },
       [](const Path& p) {
         save_visibility(p, zonal::GridVisibility({0, 0, 0}, {1, 1, 1}, {2, 2, 2}, 1));
       }},
      {true, [](const Path& p) { zonal::load_material_table(p).with_cosine<2>(0.5F); },
       [](const Path& p) {
         const std::vector<glm::vec3> rows(3, glm::vec3(1));
         save_material_table(p, zonal::MaterialTable(2, 1, 0.0, rows, zonal::MirroredRows(rows)));
       }},
      {false,
       [](const Path& p) {
         zonal::SampleFile file(p);
         const auto probes = file.header().probes;
         std::vector<zonal::RadianceSample> samples(zonal::SampleBlock::most_buckets * probes);
         if (file.header().buckets > 0) file.read_block(0, samples.data(), probes);
       },
       [](const Path& p) {
         const std::vector<zonal::RadianceSample> samples(6, {1, 2, 3});
         zonal::write_samples(p, {0, 2, 3, 7}, samples.data());
       }},
      {false, [](const Path& p) { zonal::read_sequence(p); },
       [](const Path& p) {
         write_text(p,
                    "# a comment\nmapping mirror sphere\nsphere-radius 0.1\ndead-angle 5 missing\norientation 1 0 0 0\n"
                    "probe \"a b.exr\" 1 2.5 -3e-1\nprobe \"c\" 1 2 3 0 1 0 0\n");
       }},
      {false, [](const Path& p) { ask(zonal::load_rgl(p)); },
       [](const Path& p) {
         using namespace material_test;
         write_text(p, tensor_file(rgl_tensors({0.3, 0.3}, {1, 2, 3, 3, 1, true})));
       }},
      {false, [](const Path& p) { zonal::load_merl(p); }, [](const Path& p) { write_text(p, "Z   Z   \xb4   "); }},
      {false, [](const Path& p) { example::read_obj(p.string()); },
       [](const Path& p) {
         write_text(
             p,
             "mtllib a b.mtl\no box\ng left\nv 0 0 0\nv 1 0 0\nv 1 1 0 1\nv 0 1 0\nvt 0 0\nvn 0 0 1\nusemtl m\ns 1\n"
             "f 1/1/1 2/1/1 \\\n3//1 -1\nf 1 2 3 # a comment\n");
       }},
  };
  return all;
}

// The checksum of a file of the library's formats: FNV-1a by words.
std::string checksum_of(const std::string& file) {
  std::uint64_t sum = 14695981039346656037U;
  for (std::size_t i = 0; i + 4 <= file.size(); i += 4) {
    std::uint32_t word = 0;
    for (std::size_t b = 0; b < 4; ++b) word |= std::uint32_t(static_cast<unsigned char>(file[i + b])) << (8 * b);
    sum = (sum ^ word) * 1099511628211U;
  }
  std::string bytes;
  for (int b = 0; b < 8; ++b) bytes += char(sum >> (8 * b) & 0xff);
  return bytes;
}

Path scratch() {
  static const Path path = std::filesystem::temp_directory_path() / ("zonal_fuzz_" + std::to_string(::getpid()));
  return path;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  const char* const folder = std::getenv("ZONAL_SEEDS");
  for (std::size_t i = 0; folder != nullptr && i < readers().size(); ++i) {
    readers()[i].write_seed(scratch());
    std::ifstream file(scratch(), std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (readers()[i].ends_in_checksum) bytes.resize(bytes.size() - 8);
    write_text(Path(folder) / std::to_string(i), char(i) + bytes);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Reader& reader = readers()[data[0] % readers().size()];
  std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (reader.ends_in_checksum) bytes += checksum_of(bytes);
  write_text(scratch(), bytes);
  try {
    reader.read(scratch());
  } catch (const zonal::FileError&) {
  } catch (const example::InputError&) {
  }
  return 0;
}
