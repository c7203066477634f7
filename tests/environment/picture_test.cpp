// Pictures that are none, numbers that are no radiance, half floats, strides; guesses; and pictures made of
// coefficients.
#include "accuracy.hpp"
#include "catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <zonal/environment/guess.hpp>
#include <zonal/environment/project.hpp>
#include <zonal/environment/project_reference.hpp>
#include <zonal/environment/reconstruct_picture.hpp>
#include <zonal/transform/dot.hpp>

#include "environment/pictures.hpp"

using zonal::Environment;
using zonal::Half;
using zonal::Mapping;
using zonal::Picture;
using zonal::Rgb;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity(), no_number = std::numeric_limits<float>::quiet_NaN();

std::vector<float> random_numbers(std::size_t count, unsigned seed = 1) {
  std::vector<float> numbers(count);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
  for (float& number : numbers) number = uniform(random);
  return numbers;
}

/// What it says when it refuses.
template <class F>
std::string refusal(const F& f) {
  try {
    f();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

template <class Sh>
bool are_finite(const Sh& sh) {
  for (const auto& c : sh) {
    if (!(std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b))) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("picture: half floats to floats and back, all of them") {
  for (std::uint32_t bits = 0; bits < 65536; ++bits) {
    const float number = zonal::to_float(Half{std::uint16_t(bits)});
    const std::uint32_t exponent = bits >> 10U & 31U, mantissa = bits & 1023U;
    const float sign = (bits & 0x8000U) != 0 ? -1.0F : 1.0F;
    if (exponent == 31 && mantissa != 0) {
      REQUIRE(std::isnan(number));
      REQUIRE(std::isnan(zonal::to_float(zonal::to_half(number))));
      continue;
    }
    const float expected = exponent == 31  ? sign * infinity
                           : exponent == 0 ? sign * std::ldexp(float(mantissa), -24)
                                           : sign * std::ldexp(float(1024 + mantissa), int(exponent) - 25);
    REQUIRE(!(number < expected || number > expected));
    REQUIRE(std::signbit(number) == std::signbit(expected));
    REQUIRE(zonal::to_half(number).bits == bits);
    if (exponent == 31 || (bits & 0x8000U) != 0) continue;
    // halfway to the next goes to the even one, and beyond it to the next
    const float next = exponent == 30 && mantissa == 1023 ? 65536.0F : zonal::to_float(Half{std::uint16_t(bits + 1)});
    const float middle = number + (next - number) / 2;
    REQUIRE(zonal::to_half(middle).bits == bits + (bits & 1U));
    REQUIRE(zonal::to_half(std::nextafter(middle, infinity)).bits == bits + 1);
    REQUIRE(zonal::to_half(std::nextafter(middle, 0.0F)).bits == bits);
  }
}

TEST_CASE("picture: what is none is refused, and says why") {
  std::vector<float> numbers(600);
  const auto reason = [&](int width, int height, int channels, Mapping mapping) {
    const Picture<const float> picture(numbers.data(), width, height, channels);
    const std::string wrong = Environment<float>::what_is_wrong(picture, mapping);
    CHECK(refusal([&] { Environment(picture, mapping); }) == wrong);
    return wrong;
  };
  CHECK(reason(0, 5, 3, Mapping::equirectangular) == "an empty picture, 0 x 5");
  CHECK(reason(5, -1, 3, Mapping::equirectangular) == "an empty picture, 5 x -1");
  for (const int channels : {-1, 0, 2, 5}) {
    CHECK(reason(2, 1, channels, Mapping::equirectangular) ==
          "a picture of " + std::to_string(channels) + " channels, not of 1, 3 or 4");
  }
  CHECK(reason(3, 4, 3, Mapping::vertical_cross).empty());
  CHECK(reason(4, 4, 3, Mapping::vertical_cross) ==
        "no vertical cross, 4 x 4: its faces are no squares of whole texels");
  CHECK(reason(7, 1, 3, Mapping::horizontal_faces) ==
        "no horizontal faces, 7 x 1: its faces are no squares of whole texels");
  CHECK(reason(4, 3, 3, Mapping::octahedral) == "no octahedral, 4 x 3: it is not square");
  CHECK(reason(4, 3, 3, Mapping::angular_map) == "no angular map, 4 x 3: it is not square");
  CHECK(reason(4, 3, 3, Mapping::mirror_sphere) == "no mirror sphere, 4 x 3: it is not square");
  CHECK(reason(1, 7, 1, Mapping::equirectangular).empty());

  // Sizes whose products overflow, here and on machines of 32 bits.
  constexpr int most = std::numeric_limits<int>::max();
  CHECK(reason(most, most, 3, Mapping::equirectangular).find("too large") != std::string::npos);
  CHECK(reason(most, 1, 1, Mapping::equirectangular).find("too many texels") != std::string::npos);
  CHECK(!reason(most - 1, (most - 1) / 2, 4, Mapping::equirectangular).empty());

  CHECK(refusal([] { Environment(Picture<const float>(nullptr, 2, 1), Mapping::equirectangular); }) ==
        "a picture without data");
  // cut off: one number is missing
  CHECK(refusal([&] { Picture<const float>::of(numbers, 20, 10); }).empty());
  numbers.pop_back();
  CHECK(refusal([&] { Picture<const float>::of(numbers, 20, 10); }) ==
        "a picture cut off: 20 x 10, 3 channels with 599 numbers");
  std::vector<float> none;
  CHECK(!refusal([&] { Picture<const float>::of(none, 1, 1); }).empty());

  const Picture<const float> square(numbers.data(), 4, 4);
  for (const double angle : {-0.1, 3.2, double(no_number)}) {
    CHECK(!Environment<float>::what_is_wrong(square, Mapping::mirror_sphere, angle).empty());
  }
  CHECK(!Environment<float>::what_is_wrong(square, Mapping::octahedral, 0.1).empty());
  CHECK(Environment<float>::what_is_wrong(square, Mapping::mirror_sphere, 3.1) ==
        "a mirror sphere of which the dead angle leaves no texel");

  std::array<Picture<const float>, 6> faces;
  faces.fill(square);
  CHECK(refusal([&] { Environment<float>{faces}; }).empty());
  faces[3] = Picture<const float>(numbers.data(), 4, 3);
  CHECK(refusal([&] { Environment<float>{faces}; }) == "faces of a cube that are not of one size");
  faces[3] = Picture<const float>(numbers.data(), 2, 2);
  CHECK(!refusal([&] { Environment<float>{faces}; }).empty());
  faces[3] = {};
  CHECK(!refusal([&] { Environment<float>{faces}; }).empty());
}

TEST_CASE("picture: what is no radiance counts as 0, and is counted") {
  for (int i = 0; i < zonal::kMappingCount; ++i) {
    for (const int size : {1, 2, 40, 71}) {
      const auto mapping = Mapping(i);
      const auto [width, height] = picture_size(mapping, size);
      const int columns = width;
      std::vector<float> numbers = random_numbers(std::size_t(3 * width * height)), clean = numbers;
      const float wrong[] = {no_number, infinity, -infinity, -1.0F, -std::numeric_limits<float>::denorm_min(), -0.0F};
      zonal::PictureFaults expected;
      std::mt19937 random(4);
      Environment(Picture<const float>::of(numbers, width, height), mapping).visit([&](const auto& m) {
        for (std::size_t k = 0; k < numbers.size(); k += 1 + random() % 40) {
          const std::size_t which = random() % 6;
          numbers[k] = wrong[which];
          clean[k] = 0;
          if (!m.has_direction(int(k / 3) % columns, int(k / 3) / columns)) continue;
          expected.not_a_number += which == 0;
          expected.infinite += which == 1 || which == 2;
          expected.negative += which == 3 || which == 4;
        }
      });
      const Environment dirty(Picture<const float>::of(numbers, width, height), mapping);
      const Environment washed(Picture<const float>::of(clean, width, height), mapping);
      zonal::PictureFaults fast, slow, none;
      const auto sh = zonal::project<3>(dirty, zonal::SerialForEach{}, &fast);
      zonal::project_by_texel<3>(dirty, zonal::TexelRule::constant_exact, &slow);
      CAPTURE(zonal::mapping_name(mapping), size);
      CHECK(sh == zonal::project<3>(washed, zonal::SerialForEach{}, &none));
      CHECK(none.total() == 0);
      for (const auto& found : {fast, slow}) {
        CHECK(found.not_a_number == expected.not_a_number);
        CHECK(found.infinite == expected.infinite);
        CHECK(found.negative == expected.negative);
      }
    }
  }
  const std::vector<float> all_wrong(24, no_number);
  const auto sh =
      zonal::project<3>(Environment(Picture<const float>(all_wrong.data(), 4, 2), Mapping::equirectangular));
  CHECK((are_finite(sh) && !(sh[0].r < 0) && !(sh[0].r > 0)));
}

TEST_CASE("picture: strides, planes, alpha, grey and half floats are the same picture") {
  for (int i = 0; i < zonal::kMappingCount; ++i) {
    const auto mapping = Mapping(i);
    const auto [w, h] = picture_size(mapping, 17);
    const auto width = std::size_t(w), height = std::size_t(h);
    std::vector<float> numbers = random_numbers(3 * width * height);
    std::vector<Half> halves;
    for (float& number : numbers) {
      halves.push_back(zonal::to_half(number));
      number = zonal::to_float(halves.back());
    }
    const auto sh = zonal::project<3>(Environment(Picture<const float>::of(numbers, w, h), mapping));
    CAPTURE(zonal::mapping_name(mapping));
    CHECK(sh == zonal::project<3>(Environment(Picture<const Half>::of(halves, w, h), mapping)));

    std::vector<float> alpha(4 * width * height, no_number), planes(3 * width * height),
        flipped(3 * (width + 5) * height, no_number);
    for (std::size_t row = 0; row < height; ++row) {
      for (std::size_t column = 0; column < width; ++column) {
        for (std::size_t c = 0; c < 3; ++c) {
          const float number = numbers[3 * (row * width + column) + c];
          alpha[4 * (row * width + column) + c] = number;
          planes[(c * height + row) * width + column] = number;
          flipped[3 * ((height - 1 - row) * (width + 5) + column) + c] = number;
        }
      }
    }
    CHECK(sh == zonal::project<3>(Environment(Picture<const float>::of(alpha, w, h, 4), mapping)));
    Picture<const float> planar(planes.data(), w, h);
    planar.column_stride = 1;
    planar.row_stride = w;
    planar.channel_stride = w * h;
    CHECK(planar.what_is_wrong(planes.size()).empty());
    CHECK(!planar.what_is_wrong(planes.size() - 1).empty());
    CHECK(sh == zonal::project<3>(Environment(planar, mapping)));
    Picture<const float> upwards(flipped.data() + 3 * (height - 1) * (width + 5), w, h);
    upwards.row_stride = -std::ptrdiff_t(3 * (width + 5));
    CHECK(sh == zonal::project<3>(Environment(upwards, mapping)));

    std::vector<float> grey(width * height), as_rgb;
    for (std::size_t k = 0; k < grey.size(); ++k) {
      grey[k] = numbers[3 * k];
      as_rgb.insert(as_rgb.end(), 3, grey[k]);
    }
    CHECK(zonal::project<3>(Environment(Picture<const float>::of(grey, w, h, 1), mapping)) ==
          zonal::project<3>(Environment(Picture<const float>::of(as_rgb, w, h), mapping)));
  }
}

TEST_CASE("picture: six separate faces are those under one another") {
  const std::vector<float> numbers = random_numbers(3 * 11 * 66);
  const Environment together(Picture<const float>::of(numbers, 11, 66), Mapping::vertical_faces);
  std::array<Picture<const float>, 6> faces;
  for (std::size_t i = 0; i < 6; ++i) faces[i] = Picture<const float>(numbers.data() + 3 * 11 * 11 * i, 11, 11);
  const Environment separate(faces);
  CHECK(separate.height() == 66);
  CHECK(separate.rgb(3, 50) == together.rgb(3, 50));
  CHECK(zonal::project<4>(separate) == zonal::project<4>(together));
}

TEST_CASE("picture: one texel, one column, one row") {
  const std::vector<float> numbers = random_numbers(3 * 64);
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{1, 64}, std::pair{64, 1}, std::pair{3, 5}}) {
    const Environment environment(Picture<const float>(numbers.data(), width, height), Mapping::equirectangular);
    const auto fast = zonal::project<4>(environment),
               slow = zonal::Sh<4, Rgb<float>>(zonal::project_by_texel<4>(environment));
    CAPTURE(width, height);
    for (int i = 0; i < 16; ++i) CHECK(fast[i].g == Approx(slow[i].g).margin(1e-6));
    if (width * height == 1) {
      for (int i = 1; i < 16; ++i) CHECK(fast[i].g == Approx(0).margin(1e-7));
    }
  }
}

TEST_CASE("picture: guesses") {
  const auto guess = [](int width, int height, const std::vector<float>& numbers) {
    Mapping mapping{};
    const bool found = zonal::guess_mapping(Picture<const float>::of(numbers, width, height), mapping);
    return found ? std::string(zonal::mapping_name(mapping)) : "";
  };
  const std::vector<float> numbers = random_numbers(3 * 48 * 96);
  CHECK(guess(96, 48, numbers) == "equirectangular");
  CHECK(guess(36, 48, numbers) == "vertical cross");
  CHECK(guess(48, 36, numbers) == "horizontal cross");
  CHECK(guess(8, 48, numbers) == "vertical faces");
  CHECK(guess(48, 8, numbers) == "horizontal faces");
  CHECK(guess(48, 48, numbers) == "octahedral");
  CHECK(guess(2, 2, numbers) == "octahedral");
  CHECK(guess(47, 48, numbers).empty());
  std::vector<float> disc(3 * 48 * 48, 0.0F);
  const zonal::AngularMap mapping(48, 48);
  for (int row = 0; row < 48; ++row) {
    for (int column = 0; column < 48; ++column) {
      if (mapping.has_direction(column, row)) disc[std::size_t(3 * (48 * row + column))] = numbers[std::size_t(column)];
    }
  }
  CHECK(guess(48, 48, disc) == "angular map");
  CHECK(zonal::guess_environment(Picture<const float>::of(disc, 48, 48)).mapping() == Mapping::angular_map);
  CHECK(refusal([&] { zonal::guess_environment(Picture<const float>::of(numbers, 10, 7)); }) ==
        "a picture of 10 x 7: no mapping has this shape as a rule; name one");
  CHECK(!refusal([&] { zonal::guess_environment(Picture<const float>(numbers.data(), 0, 0)); }).empty());
}

TEST_CASE("picture: coefficients to a picture and back, in every mapping") {
  Met met("environment", "reconstruct");
  zonal::Sh<4, Rgb<float>> sh;
  const std::vector<float> numbers = random_numbers(48, 9);
  for (int i = 0; i < 16; ++i) {
    const float* const n = numbers.data() + 3 * i;
    sh[i] = i == 0 ? Rgb<float>{9, 8, 7} : Rgb<float>{n[0] - 0.5F, n[1] - 0.5F, n[2] - 0.5F};  // nowhere negative
  }
  for (int i = 0; i < zonal::kMappingCount; ++i) {
    const auto mapping = Mapping(i);
    for (const int size : {3, 64}) {
      const auto [width, height] = picture_size(mapping, size);
      std::vector<float> texels(std::size_t(4 * width * height), no_number);
      const auto picture = Picture<float>::of(texels, width, height, 4);
      zonal::reconstruct(sh, mapping, picture);
      CAPTURE(zonal::mapping_name(mapping), size);
      double worst = 0, alpha = 0;
      const Environment environment(picture, mapping);
      environment.visit([&](const auto& m) {
        for (int row = 0; row < picture.height; ++row) {
          for (int column = 0; column < picture.width; ++column) {
            const auto found = picture.rgb(column, row);
            alpha = std::max(alpha, std::abs(double(picture.at(column, row)[3]) - 1));
            Rgb<double> expected{};
            if (m.has_direction(column, row)) {
              expected = zonal::reconstruct(zonal::Sh<4, Rgb<double>>(sh), m.direction(column + 0.5, row + 0.5));
            }
            for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(double(found[c]) - expected[c]));
          }
        }
      });
      CHECK(met.meet(worst / 9));
      CHECK(alpha <= 0);
      if (size < 64) continue;
      const auto back = zonal::project<4>(environment);
      double error = 0;
      for (int k = 0; k < 16; ++k) {
        for (int c = 0; c < 3; ++c) error = std::max(error, double(std::abs(back[k][c] - sh[k][c])));
      }
      CHECK(error < (mapping == Mapping::mirror_sphere ? 2e-2 : 3e-3));  // of texels this large
    }
  }
  CHECK_WORST_MET(met);
  std::vector<Half> halves(3 * 8 * 4);
  const auto half_picture = Picture<Half>::of(halves, 8, 4);
  zonal::reconstruct(sh, Mapping::equirectangular, half_picture);
  const zonal::Equirectangular m(8, 4);
  CHECK(half_picture.rgb(5, 1).g ==
        Approx(zonal::reconstruct(zonal::Sh<4, Rgb<double>>(sh), m.direction(5.5, 1.5)).g).epsilon(1e-3));
  std::vector<float> grey(8);
  CHECK(!refusal([&] { zonal::reconstruct(sh, Mapping::equirectangular, Picture<float>::of(grey, 4, 2, 1)); }).empty());
  CHECK(!refusal([&] { zonal::reconstruct(sh, Mapping::octahedral, Picture<float>(grey.data(), 2, 1)); }).empty());
}
