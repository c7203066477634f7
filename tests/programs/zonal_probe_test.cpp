// zonal-probe: Unity's nine numbers against a quadrature by hand, every convention there and back, what it writes for
// programs compiled and evaluated, and which way is which.
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include <stb_image_write.h>
#include <zonal/transform/dot.hpp>

#include "catch.hpp"
#include "shared/image_file.hpp"
#include "shared/input_error.hpp"
#include "zonal-probe/coefficients_file.hpp"
#include "zonal-probe/picture.hpp"
#include "zonal-probe/preview.hpp"
#include "zonal-probe/run.hpp"
#include "zonal-probe/window.hpp"

namespace texts {

// As much of GLSL and HLSL as the texts need, in double.
struct vec3 {
  double x, y, z;
  vec3(double a, double b, double c) : x(a), y(b), z(c) {}
  friend vec3 operator*(const vec3& v, double s) { return {v.x * s, v.y * s, v.z * s}; }
  friend vec3 operator+(const vec3& a, const vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
};
struct float4 {
  double x, y, z, w;
  float4(double a, double b, double c, double d) : x(a), y(b), z(c), w(d) {}
};
inline double dot(const float4& a, const float4& b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }
using float3 = vec3;

#include "e3nn_norm.hlsl"
#include "filament.glsl"
#include "fuma.glsl"
#include "splats.glsl"
#include "unity.cpp"
#include "unity_vectors.hlsl"

}  // namespace texts

namespace {

using namespace zonal_probe;
using example::Image;
namespace fs = std::filesystem;

/// A file on disk as long as this lives.
struct TemporaryFile {
  TemporaryFile(const std::string& name, const std::string& bytes) : path(place(name)) {
    if (!bytes.empty()) std::ofstream(path, std::ios::binary) << bytes;
  }
  ~TemporaryFile() { fs::remove(path); }
  static std::string place(const std::string& name) {
    return (fs::temp_directory_path() / ("zonal_probe_test_" + std::to_string(std::random_device{}()) + name)).string();
  }
  std::string path;
};

Image random_sky(int width, int height) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  Image image(width, height);
  for (glm::vec3& texel : image.pixels) texel = {uniform(random), 10 * uniform(random), uniform(random)};
  return image;
}

/// What the program writes as JSON, read again.
Stored run_to_json(Options options) {
  const TemporaryFile out(".json", "");
  options.out = out.path;
  options.format = Format::json;
  options.quiet = true;
  run(options);
  return read_coefficients(out.path, {});
}

Options options_for(const std::string& input) {
  Options options;
  options.input = input;
  return options;
}

using Direction = std::array<double, 3>;

std::vector<Direction> some_directions(int count = 50) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::vector<Direction> directions;
  for (int i = 0; i < count; ++i) {
    const double x = normal(random), y = normal(random), z = normal(random), length = std::sqrt(x * x + y * y + z * z);
    directions.push_back({x / length, y / length, z / length});
  }
  return directions;
}

}  // namespace

TEST_CASE("Unity's nine numbers of a picture are a quadrature of it") {
  const Image sky = random_sky(24, 12);
  const TemporaryFile file(".exr", example::exr_bytes(sky));
  Options options = options_for(file.path);
  options.convention = "unity";
  const Stored stored = run_to_json(options);
  REQUIRE(stored.numbers.size() == 9);
  CHECK(stored.quantity == zonal::Quantity::irradiance_over_pi);

  // E / pi = sum of c_i p_i with p = 1, y, z, x, xy, yz, 3zz-1, xz, xx-yy in Unity's x right, y up, z ahead: each c_i
  // is what the clamped cosine over pi leaves of a degree (1, 2/3, 1/4) times p_i's share, (integral of L p) / (that of
  // p p). The picture's mean is taken off first, for it is in the first number alone.
  const double squares[9] = {4 * pi,      4 * pi / 3,  4 * pi / 3,  4 * pi / 3,  4 * pi / 15,
                             4 * pi / 15, 16 * pi / 5, 4 * pi / 15, 16 * pi / 15};
  const double kept[9] = {1, 2.0 / 3, 2.0 / 3, 2.0 / 3, 0.25, 0.25, 0.25, 0.25, 0.25};
  double mean[3] = {}, sums[9][3] = {};
  for (const bool is_second : {false, true}) {
    for (int row = 0; row < 12; ++row) {
      const double above = pi * row / 12, below = pi * (row + 1) / 12, middle = (above + below) / 2;
      const double solid_angle = 2 * pi / 24 * (std::cos(above) - std::cos(below));
      for (int column = 0; column < 24; ++column) {
        const double to_the_left = pi - 2 * pi * (column + 0.5) / 24;
        const double x = -std::sin(middle) * std::sin(to_the_left), y = std::cos(middle),
                     z = std::sin(middle) * std::cos(to_the_left);
        const double p[9] = {1, y, z, x, x * y, y * z, 3 * z * z - 1, x * z, x * x - y * y};
        for (int c = 0; c < 3; ++c) {
          const double radiance = double(sky.at(column, row)[c]);
          if (!is_second) mean[c] += solid_angle / (4 * pi) * radiance;
          for (int i = 0; is_second && i < 9; ++i) sums[i][c] += solid_angle * (radiance - mean[c]) * p[i];
        }
      }
    }
  }
  for (int i = 0; i < 9; ++i) {
    for (int c = 0; c < 3; ++c) {
      const double expected = (i == 0 ? mean[c] : 0) + kept[i] * sums[i][c] / squares[i];
      CAPTURE(i, c, expected, stored.numbers[std::size_t(i)][c]);
      CHECK(std::abs(stored.numbers[std::size_t(i)][c] - expected) < 1e-6 * mean[c]);
    }
  }
}

TEST_CASE("irradiance is what it was asked for") {
  Image grey(16, 8);
  std::fill(grey.pixels.begin(), grey.pixels.end(), glm::vec3(0.5f));
  const TemporaryFile file(".exr", example::exr_bytes(grey));
  Options options = options_for(file.path);
  const double root = std::sqrt(4 * pi);
  CHECK(run_to_json(options).numbers[0].r == Approx(0.5 * root));
  options.quantity = zonal::Quantity::irradiance;
  CHECK(run_to_json(options).numbers[0].r == Approx(0.5 * pi * root));
  options.convention = "gltf_image_based";
  options.quantity.reset();
  CHECK(run_to_json(options).numbers[0].r == Approx(0.5 * pi * root));
  options.convention = "unity";
  options.quantity = zonal::Quantity::irradiance;
  CHECK(run_to_json(options).numbers[0].r == Approx(0.5));
  options.quantity = zonal::Quantity::radiance;
  CHECK_THROWS_AS(run_to_json(options), example::InputError);
}

TEST_CASE("through every convention and back, by JSON") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const zonal::NamedConvention& zonal_named = *zonal::find_convention("zonal");
  Stored given{&zonal_named, zonal::Quantity::radiance, zonal_named.frame, 3, {}};
  for (int i = 0; i < 9; ++i) given.numbers.push_back({uniform(random), uniform(random), uniform(random)});
  const TemporaryFile file(".json", json_text(given, ""));
  for (const zonal::NamedConvention& named : zonal::kConventions) {
    CAPTURE(named.name);
    Options options = options_for(file.path);
    options.convention = std::string(named.name);
    const Stored there = run_to_json(options);
    CHECK(there.named == &named);
    CHECK(there.quantity == named.convention.quantity);
    const TemporaryFile second(".json", json_text(there, "  \"more\": 1,\n"));
    const Stored back = run_to_json(options_for(second.path));
    CHECK(back.quantity == zonal::Quantity::radiance);
    REQUIRE(back.numbers.size() == 9);
    for (std::size_t i = 0; i < 9; ++i) {
      for (int c = 0; c < 3; ++c) {
        CAPTURE(i, c);
        CHECK(std::abs(back.numbers[i][c] - given.numbers[i][c]) < 4e-15);
      }
    }
  }
}

TEST_CASE("what it writes for programs compiles, and is the light it was given") {
  ListOf list;
  list.named = zonal::find_convention("zonal");
  const Light light = load(read_coefficients(std::string(ZONAL_PROBE_TEST_DATA) + "/random.txt", list));
  const Coefficients three = [&] {
    Coefficients sh = light.sh;
    for (int i = 9; i < sh.size(); ++i) sh[i] = Colour{0, 0, 0};
    return sh;
  }();
  const Coefficients over_pi =
      of_quantity({three, 3, zonal::Quantity::radiance}, zonal::Quantity::irradiance_over_pi).sh;
  const auto check = [](const texts::vec3& got, const Colour& expected, const char* text) {
    CAPTURE(text, got.x, got.y, got.z, expected.r, expected.g, expected.b);
    CHECK(std::abs(got.x - expected.r) < 1e-6);  // literals are floats
    CHECK(std::abs(got.y - expected.g) < 1e-6);
    CHECK(std::abs(got.z - expected.b) < 1e-6);
  };
  for (const Direction& d : some_directions()) {
    const double right = -d[1], up = d[2], ahead = d[0];  // a picture's x is ahead, y left, z up
    const Colour of_three = zonal::reconstruct(over_pi, d), of_four = zonal::reconstruct(light.sh, d);
    check(texts::evaluate_unity_vectors({right, up, ahead}), of_three, "unity");
    check(texts::evaluate_filament({right, up, -ahead}), of_three, "filament_shader");
    check(texts::evaluate_splats({right, -up, ahead}), of_four, "gaussian_splatting");
    check(texts::evaluate_e3nn_norm({right, up, -ahead}), of_four, "e3nn_norm");
    check(texts::evaluate_fuma({ahead, -right, up}), of_four, "fuma");
    const auto [x, y, z] = Direction{right, up, ahead};
    const double p[9] = {1, y, z, x, x * y, y * z, 3 * z * z - 1, x * z, x * x - y * y};
    texts::vec3 sum(0, 0, 0);
    for (int i = 0; i < 9; ++i) {
      const float* c = texts::unity[i];
      sum = sum + texts::vec3(double(c[0]), double(c[1]), double(c[2])) * p[i];
    }
    check(sum, of_three, "unity, as an array");
  }
}

TEST_CASE("turns and frames go the way their words say") {
  Image sky(64, 32);
  const auto lamp_at = [&](int x, int y) {
    std::fill(sky.pixels.begin(), sky.pixels.end(), glm::vec3(0.0f));
    for (const int dx : {-1, 0}) {
      for (const int dy : {-1, 0}) sky.at(x + dx, y + dy) = glm::vec3(100.0f);
    }
    return example::exr_bytes(sky);
  };
  // Degree 1 points at the lamp: x, y, z of the frame.
  const auto seen = [](Options options) {
    options.bands = 2;
    const Stored stored = run_to_json(options);
    const double x = -stored.numbers[3].r, y = -stored.numbers[1].r, z = stored.numbers[2].r;
    const double length = std::sqrt(x * x + y * y + z * z);
    return Direction{x / length, y / length, z / length};
  };
  const auto check = [](const Direction& got, const Direction& expected) {
    CAPTURE(got[0], got[1], got[2], expected[0], expected[1], expected[2]);
    for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(got[i] - expected[i]) < 1e-3);
  };
  const TemporaryFile ahead(".exr", lamp_at(32, 16)), left(".exr", lamp_at(16, 16)), above(".exr", lamp_at(32, 1));
  check(seen(options_for(ahead.path)), {1, 0, 0});
  check(seen(options_for(left.path)), {0, 1, 0});
  Options options = options_for(ahead.path);
  options.turns = {{TurnAxis::up, 90}};
  check(seen(options), {0, 1, 0});
  options.turns = {{TurnAxis::right, 90}};
  check(seen(options), {0, 0, 1});
  options.turns = {{TurnAxis::up, 90}, {TurnAxis::ahead, 90}};  // ahead to the left, left upwards
  check(seen(options), {0, 0, 1});
  options.turns.clear();
  options.frame = "unity";
  check(seen(options), {0, 0, 1});
  options.frame = "z,-x,y";  // right, up, ahead
  check(seen(options), {0, 1, 0});
  options.frame.reset();
  options.input_frame = "y,z,x";  // x ahead and z up as in a picture's, but y right: mirrored
  options.input = left.path;
  check(seen(options), {0, -1, 0});

  // A strip of faces is in the interface's own directions: its first is +x, to the right of who looks along +z, which
  // is the fifth, and its third +y, above.
  for (const auto& [face, expected] :
       {std::pair(0, Direction{0, -1, 0}), {2, Direction{0, 0, 1}}, {4, Direction{1, 0, 0}}}) {
    Image faces(8, 48);
    std::fill_n(faces.pixels.begin() + 64 * face, 64, glm::vec3(1.0f));
    const TemporaryFile strip(".exr", example::exr_bytes(faces));
    check(seen(options_for(strip.path)), expected);
  }
}

TEST_CASE("pictures of 8 bits are made linear, others are as they stand") {
  const float linear = 0.21586f;  // of the byte 128
  Image grey(16, 8);
  std::fill(grey.pixels.begin(), grey.pixels.end(), glm::vec3(linear));
  const TemporaryFile exr(".exr", example::exr_bytes(grey)), jpeg(".jpg", ""), hdr(".hdr", ""),
      png(".png", example::png_bytes(example::encode(grey, {0.0f, example::ToneMap::clamp})));
  const std::vector<unsigned char> bytes(3 * 16 * 8, 128);
  REQUIRE(stbi_write_jpg(jpeg.path.c_str(), 16, 8, 3, bytes.data(), 100) != 0);
  REQUIRE(stbi_write_hdr(hdr.path.c_str(), 16, 8, 3, &grey.pixels.front().x) != 0);
  for (const auto& [path, error] : {std::pair(exr.path, 1e-6), {png.path, 1e-5}, {jpeg.path, 1e-5}, {hdr.path, 4e-3}}) {
    Options options = options_for(path);
    options.convention = "unity";
    CAPTURE(path);
    const Stored stored = run_to_json(options);
    CHECK(stored.numbers[0].r == Approx(double(linear)).epsilon(error));
    CHECK(std::abs(stored.numbers[6].g) < 1e-7);
  }
}

TEST_CASE("numbers channel by channel, grey, and as they stand in programs") {
  ListOf list;
  list.named = zonal::find_convention("zonal");
  const TemporaryFile rows(".txt", "{{1.0f, 2, +3}, // mean\n {4, 5, 6}, {7, 8, 9}, {10, 11, 12e0F}};"),
      grey(".txt", "1\n2\n3\n4\n");
  const Stored by_rows = read_coefficients(rows.path, list);
  CHECK(by_rows.bands == 2);
  CHECK(by_rows.numbers[1] == Colour{4, 5, 6});
  CHECK(by_rows.numbers[3] == Colour{10, 11, 12});
  CHECK(read_coefficients(grey.path, list).numbers[2] == Colour{3, 3, 3});
  list.planes = true;
  CHECK(read_coefficients(rows.path, list).numbers[1] == Colour{2, 6, 10});
}

TEST_CASE("the window that auto finds leaves nothing negative, is the weakest, and says what it costs") {
  Image sky(64, 32);
  std::fill(sky.pixels.begin(), sky.pixels.end(), glm::vec3(0.1f));
  sky.at(20, 8) = {500.0f, 300.0f, 100.0f};
  Workers workers(1, false);
  zonal::PictureFaults faults;
  const Light light = project_sky({sky, zonal::Mapping::equirectangular, false}, 5, workers, faults);
  const auto least = [](const Light& of, int channel) {
    double lowest = 1e9;
    for (const Direction& d : some_directions(5000)) lowest = std::min(lowest, zonal::reconstruct(of.sh, d)[channel]);
    return lowest;
  };
  const double mean = light.sh[0].b * std::sqrt(0.25 / pi);
  CHECK(least(light, 2) < -0.1 * mean);
  double errors[2];
  for (const WindowBy by : {WindowBy::all, WindowBy::channel}) {
    Light windowed_light = light, weaker_light = light;
    const Windowed windowed = apply_window(windowed_light, {WindowKind::automatic, {}, by}, zonal::Quantity::radiance);
    for (int c = 0; c < 3; ++c) {
      const WindowedChannel& channel = windowed.channels[std::size_t(c)];
      CAPTURE(c, channel.width, channel.least_before, channel.least_after);
      CHECK(least(windowed_light, c) > 0);
      CHECK(channel.least_before < 0);
      CHECK(channel.least_after >= 0);
      double lost = 0, all = 0;
      for (int i = 0; i < 25; ++i) {
        lost += std::pow(light.sh[i][c] - windowed_light.sh[i][c], 2);
        all += std::pow(light.sh[i][c], 2);
      }
      CHECK(channel.error == Approx(std::sqrt(lost / all)));
    }
    apply_window(weaker_light, {WindowKind::laplacian, 1.02 * windowed.channels[0].width, by},
                 zonal::Quantity::radiance);
    CHECK(least(weaker_light, 0) < 0);
    errors[by == WindowBy::channel] = windowed.channels[2].error;
    CHECK(window_text(windowed).find("laplacian of width") == 0);
  }
  CHECK(errors[1] < errors[0]);  // blue needs less by itself
}

TEST_CASE("a preview marks what is negative, and shows no difference where there is none") {
  Image sky(panel_width, panel_height);
  std::fill(sky.pixels.begin(), sky.pixels.end(), glm::vec3(0.5f));
  Workers workers(0, false);
  Light light;
  light.bands = 2;
  light.sh[0] = Colour{1, 1, 1} * (0.5 * std::sqrt(4 * pi));
  const auto is_marked = [](const glm::vec3& p) { return p.r > 0.9f && p.g < 0.1f; };
  const auto marks = [&](const Image& preview) {
    return std::count_if(preview.pixels.begin(), preview.pixels.end(), is_marked);
  };
  const Image plain = make_preview(light, sky, {}, workers);
  CHECK(marks(plain) == 0);
  // Picture, reconstruction, difference: their middles.
  const auto middle = [&](int panel) {
    return plain.at(panel_width / 2 + panel * (panel_width + 16), plain.height / 2);
  };
  CHECK(glm::distance(middle(0), middle(1)) < 1e-5f);
  CHECK(glm::distance(middle(2), glm::vec3(0.97f)) < 1e-5f);
  light.sh[2] = Colour{2, 2, 2};  // below 0 where z < -0.51
  const Image ringing = make_preview(light, sky, {}, workers);
  const double share = double(marks(ringing)) / (panel_width * panel_height);
  CAPTURE(share);
  CHECK(share > 0.25 * 0.33);
  CHECK(share < 0.40 * 0.33);
  CHECK(make_preview(light, std::nullopt, {}, workers).width < ringing.width / 2);
}

TEST_CASE("a signal stops the work, and nothing is written") {
  struct Reset {
    ~Reset() { example::interrupt_detail::signal = 0; }
  } reset;
  example::listen_for_interrupts();
  Workers workers(2, false);
  std::atomic<int> done{0};
  CHECK_THROWS_AS(workers.loop("x", 1)(1000,
                                       [&](int i) {
                                         if (i == 3) std::raise(SIGINT);
                                         while (i > 3 && !example::stop_requested()) std::this_thread::yield();
                                         ++done;
                                       }),
                  example::Interrupted);
  CHECK(done < 7);
  const TemporaryFile file(".exr", example::exr_bytes(random_sky(24, 12)));
  Options options = options_for(file.path);
  options.out = file.path + ".txt";
  options.preview = file.path + ".png";
  options.quiet = true;
  CHECK_THROWS_AS(run(options), example::Interrupted);
  CHECK_FALSE(fs::exists(options.out));
  CHECK_FALSE(fs::exists(options.preview));
  std::signal(SIGINT, SIG_DFL);
}
