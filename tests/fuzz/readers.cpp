// Every reader of files of the library, and those of the programs: OBJ with MTL, pictures, positions, plans.
#include "targets.hpp"

#include <zonal/field/sample_file.hpp>
#include <zonal/field/sequence.hpp>
#include <zonal/grid/grid_file.hpp>
#include <zonal/grid/visibility_file.hpp>
#include <zonal/material/material_file.hpp>
#include <zonal/material/merl.hpp>
#include <zonal/material/rgl.hpp>

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "../../examples/field-capture/positions.hpp"
#include "../../examples/shared/image_file.hpp"
#include "../../examples/shared/input_error.hpp"
#include "../../examples/shared/mtl_file.hpp"
#include "../../examples/shared/obj_file.hpp"
#include "../../tools/zonal-doctor/table.hpp"
#include "../../tools/zonal-glsl/plan_file.hpp"
#include "../../tools/zonal-glsl/request.hpp"
#include "../../tools/zonal-probe/coefficients_file.hpp"
#include "../../tools/zonal-probe/window.hpp"
#include "../material/tensor_writer.hpp"

namespace fuzz {
namespace {

using Path = std::filesystem::path;

void ask(const zonal::RglBrdf& brdf) {
  for (const double x : {-0.6, 0.0, 0.6}) brdf({x, 0, 0.8}, {0, 0.6, 0.8});
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

/// What read(path) does not stand for, but by the errors that are stated.
template <class Read>
void refuse_or_read(const std::string& bytes, const char* extension, const Read& read) {
  write_scratch(scratch(extension), bytes);
  try {
    read(scratch(extension));
  } catch (const zonal::FileError&) {
  } catch (const example::InputError&) {
  } catch (const zonal_glsl::RequestError&) {
  } catch (const zonal_doctor::InputError&) {
  }
}

std::string content_of(const Path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Of a file that ends in a checksum the checksum is put right, or hardly any input would come past it.
template <class Read, class Write>
Target checked(const char* name, const Read& read, const Write& write) {
  write(scratch());
  std::string seed = content_of(scratch());
  seed.resize(seed.size() - 8);
  return {name, [read](const std::string& bytes) { refuse_or_read(bytes + checksum_of(bytes), "", read); }, {seed}};
}
template <class Read>
Target plain(const char* name, const Read& read, const std::vector<std::string>& seeds, const char* extension = "") {
  return {name, [read, extension](const std::string& bytes) { refuse_or_read(bytes, extension, read); }, seeds};
}

/// Read, written and read again; and windowed, which is a search.
void ask(const Path& path, const zonal_probe::ListOf& list) {
  using namespace zonal_probe;
  const Stored stored = read_coefficients(path, list);
  write_scratch(path, json_text(stored, ""));
  const Stored again = read_coefficients(path, {});
  require(again.bands == stored.bands && again.named == stored.named, "written coefficients are read as they were");
  for (std::size_t i = 0; i < stored.numbers.size(); ++i) {
    const Colour &a = stored.numbers[i], &b = again.numbers[i];
    require(a.r == b.r && a.g == b.g && a.b == b.b, "written numbers are read as they were");
  }
  Light light = load(stored);
  if (stored.bands <= 3) apply_window(light, {WindowKind::automatic, {}, WindowBy::channel}, stored.quantity);
  store(light, stored);
}
/// Read, and what it holds diagnosed.
void ask(const zonal_doctor::Table& table) {
  require(table.values.size() == table.directions.size() * std::size_t(table.bands * table.bands), "a full table");
  if (table.bands <= 3) describe(zonal::diagnose(table.bands, table.directions, table.values));
}

/// Small ones, or a few bytes that stand for many pixels would take all the time.
constexpr std::int64_t most_pixels = 1 << 16;

std::vector<std::string> pictures_seen() {
  example::Image image(4, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = glm::vec3(0.1F * float(i), 0.5F, 1.0F);
  const std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n\x80\x40\x20\x81\x10\x20\x30\x80";
  const std::string ppm = "P6 2 1 255\nabcdef", pgm16 = std::string("P5 2 1 65535\nab\0d", 17);
  return {example::png_bytes(image), hdr, ppm, pgm16};
}
std::vector<std::string> exr_seen() {
  example::Image image(4, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = glm::vec3(0.1F * float(i), 0.5F, 1.0F);
  return {example::exr_bytes(image)};
}

/// Two bands as the doctor reads them: directions and values.
std::string two_bands_seen() {
  std::string text = "x y z and four values\n";
  for (const zonal::Direction& d : zonal::diagnosis_directions(2)) {
    char line[200];
    std::snprintf(line, sizeof line, "%.6f %.6f %.6f 0.282095 %.6f;%.6f,%.6f # a remark\n", d[0], d[1], d[2],
                  0.488603 * d[1], 0.488603 * d[2], 0.488603 * d[0]);
    text += line;
  }
  return text;
}

}  // namespace

std::vector<Target> readers() {
  using zonal::GridContent;
  std::vector<Target> all{
      checked(
          "grid", [](const Path& p) { zonal::load_grid<2>(p); },
          [](const Path& p) {
            save_grid(p, zonal::CoefficientGrid<2>({0, 0, 0}, {1, 1, 1}, {2, 2, 2}));
          }),
      checked(
          "grid-of-values", [](const Path& p) { zonal::load_grid<1, GridContent::values>(p); },
          [](const Path& p) {
            const zonal::CoefficientGrid<1, GridContent::values> grid({0, 0, 0}, {1, 1, 1}, {2, 3, 2});
            save_grid(p, grid, zonal::GridNumbers::halves);
          }),
      checked(
          "visibility", [](const Path& p) { zonal::load_visibility(p); },
          [](const Path& p) {
            save_visibility(p, zonal::GridVisibility({0, 0, 0}, {1, 1, 1}, {2, 2, 2}, 1));
          }),
      checked(
          "material-table", [](const Path& p) { zonal::load_material_table(p).with_cosine<2>(0.5F); },
          [](const Path& p) {
            const std::vector<glm::vec3> rows(3, glm::vec3(1));
            save_material_table(p, zonal::MaterialTable(2, 1, 0.0, rows, zonal::MirroredRows(rows)));
          }),
      plain("sequence", [](const Path& p) { zonal::read_sequence(p); },
            {"# a comment\nmapping mirror sphere\nsphere-radius 0.1\ndead-angle 5 missing\norientation 1 0 0 0\n"
             "probe \"a b.exr\" 1 2.5 -3e-1\nprobe \"c\" 1 2 3 0 1 0 0\n"}),
      plain("rgl", [](const Path& p) { ask(zonal::load_rgl(p)); },
            {material_test::tensor_file(material_test::rgl_tensors({0.3, 0.3}, {1, 2, 3, 3, 1, true}))}),
      plain("merl", [](const Path& p) { zonal::load_merl(p); }, {"Z   Z   \xb4   "}),
      plain("obj", [](const Path& p) { example::read_obj(p.string()); },
            {"mtllib a b.mtl\no box\ng left\nv 0 0 0\nv 1 0 0\nv 1 1 0 1\nv 0 1 0\nvt 0 0\nvn 0 0 1\nusemtl m\ns 1\n"
             "f 1/1/1 2/1/1 \\\n3//1 -1\nf 1 2 3 # a comment\n"}),
      plain("mtl",
            [](const Path& p) {
              example::MtlLibrary library;
              library.read(p);
              library.find("m # x");
            },
            {"newmtl m\nKd 0.5 0.4 0.3\nKs 0.1 0.1 0.1\nNs 30\nPr 0.3\nPm 1\nillum 2\nKe 1 1 1\nd 0.5\n"
             "map_Kd -s 2 2 2 -o 0.5 0 0 -clamp on a b.png\nnorm n.png\nmap_Bump -bm 0.3 \"b.png\"\n"}),
      plain("positions", [](const Path& p) { example::field_capture::read_positions(p); },
            {"# x y z\n1 2.5 -3e-1\n\n0 0 0 # a comment\n"}),
      plain(
          "plan",
          [](const Path& p) {
            const auto plan = zonal_glsl::read_plan(p.string());
            require(!plan.receiving.empty() && (plan.coefficient_bits == 16 || plan.coefficient_bits == 32) &&
                        (plan.emission_bands == 1 || plan.emission_bands == 3),
                    "a plan is as its reader has it");
          },
          {R"({"plan": {"horizon": "none", "coefficient_bits": 16, "emission_bands": 2, "drawn_lights": true, "materials": [)"
           R"({"receiving": {"symmetry": "zonal", "bands": 2, "left_out": []}}, )"
           R"({"receiving": {"symmetry": "mirror", "bands": 3, "left_out": [[1, 0], [2, 1]]}}]}})"}),
      plain(
          "picture", [](const Path& p) { example::read_picture(p, most_pixels); }, pictures_seen()),
      plain(
          "texture",
          [](const Path& p) {
            const auto texture = example::read_texture(p, example::TextureUse::colour, most_pixels);
            texture.at({0.3F, 1.7F}, false);
          },
          pictures_seen()),
      plain(
          "exr", [](const Path& p) { example::read_texture(p, example::TextureUse::colour, most_pixels); }, exr_seen(),
          ".exr"),
  };
  all.push_back(plain("coefficients",
                      [](const Path& p) {
                        ask(p, {&zonal_probe::convention_of("", "unity"), {}, false});
                      },
                      {"# nine\n1, 0.5f, +0.25\n0.1 (-2e-1) [3]; {4} 5 6 // irradiance\n",
                       R"({"convention": "three.js", "quantity": "radiance", "bands": 1, )"
                       R"("frame": {"right": "x", "up": "y", "ahead": "-z"}, "coefficients": [[1, 0.5, 2]]})"}));
  all.push_back(
      plain("doctor",
            [](const Path& p) { ask(zonal_doctor::parse_table("values.txt", zonal_doctor::read_text(p.string()), 0)); },
            {two_bands_seen()}));
  const std::vector<zonal::RadianceSample> samples(6, {1, 2, 3});
  zonal::write_samples(scratch(), {0, 2, 3, 7}, samples.data());
  all.push_back(plain("samples",
                      [](const Path& p) {
                        zonal::SampleFile file(p);
                        const auto probes = file.header().probes;
                        std::vector<zonal::RadianceSample> block(zonal::SampleBlock::most_buckets * probes);
                        if (file.header().buckets > 0) file.read_block(0, block.data(), probes);
                      },
                      {content_of(scratch())}));
  return all;
}

}  // namespace fuzz
