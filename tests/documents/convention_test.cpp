// docs/conventions/*.json: what any program may test itself against, written from the library's own table:
//   ZONAL_WRITE_DOCUMENTS=1 build/release/tests/test_documents "docs/conventions*"
#include <zonal/convention/convert.hpp>
#include <zonal/convention/diagnose.hpp>
#include <zonal/convention/named.hpp>
#include <zonal/transform/convolve.hpp>
#include <zonal/transform/dot.hpp>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>

#include "../catch.hpp"

namespace {

using namespace zonal;

std::string name_of(Axis axis) {
  return std::string(detail::sign(axis) < 0 ? "-" : "+") + "xyz"[detail::coordinate(axis)];
}
std::string name_of(CoefficientOrder order) {
  const char* const names[] = {"ascending", "alternating", "furse_malham", "descending"};
  return names[static_cast<int>(order)];
}
std::string name_of(Normalisation normalisation) {
  const char* const names[] = {"orthonormal", "n3d", "sn3d", "furse_malham", "polynomial"};
  return names[static_cast<int>(normalisation)];
}
std::string name_of(Quantity quantity) {
  const char* const names[] = {"radiance", "irradiance", "irradiance_over_pi"};
  return names[static_cast<int>(quantity)];
}

std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.15g", std::abs(value) < 1e-15 ? 0 : value);
  return text;
}
template <class Numbers>
std::string list_of(const Numbers& numbers) {
  std::string text = "[";
  for (const double value : numbers) text += (text.size() > 1 ? ", " : "") + text_of(value);
  return text + "]";
}

// Nothing special, and both poles' neighbourhood.
std::vector<Direction> test_directions() {
  std::vector<Direction> all{{0.48, 0.6, 0.64}, {-0.36, 0.48, -0.8}};
  for (int i = 0; i < 8; ++i) {
    const double z = 0.9375 - 0.25 * i, sine = std::sqrt(1 - z * z), angle = 0.7 + 2.4 * i;
    all.push_back({sine * std::cos(angle), sine * std::sin(angle), z});
  }
  return all;
}

// A soft light above and aside, as 1 / (l + 1) of a delta; in GLSL or Python one would do the same.
template <int N>
Sh<N, double> example_light() {
  const double axis[3] = {2.0 / 3, -1.0 / 3, 2.0 / 3};
  Sh<N, double> sh = evaluate<N>(axis);
  for (int l = 0; l < N; ++l) {
    for (int m = -l; m <= l; ++m) sh(l, m) /= l + 1;
  }
  return sh;
}

template <int N>
std::string vectors(const NamedConvention& named) {
  const Convention& c = named.convention;
  std::ostringstream text;
  const auto entry = [&](const char* key, const std::string& value) {
    text << "  \"" << key << "\": " << value << ",\n";
  };
  const auto word = [](std::string_view value) { return "\"" + std::string(value) + "\""; };
  text << "{\n";
  entry("name", word(named.name));
  entry("what", word(named.what));
  entry("source", word(named.source));
  entry("bands", std::to_string(N));
  entry("condon_shortley_phase", c.phase == Phase::condon_shortley ? "true" : "false");
  entry("order", word(name_of(c.order)));
  entry("normalisation", word(name_of(c.normalisation)));
  entry("meaning", word(c.meaning == Meaning::expansion ? "expansion" : "projection"));
  entry("harmonics_axes",
        "[" + word(name_of(c.axes.x)) + ", " + word(name_of(c.axes.y)) + ", " + word(name_of(c.axes.z)) + "]");
  entry("right_up_forward", "[" + word(name_of(named.frame.right)) + ", " + word(name_of(named.frame.up)) + ", " +
                                word(name_of(named.frame.forward)) + "]");
  entry("quantity", word(name_of(c.quantity)));
  entry("scale", text_of(c.scale));
  entry("offset", text_of(c.offset));
  const std::vector<Direction> directions = test_directions();
  const auto lines = [&](const char* key, const auto& line, const char* end) {
    text << "  \"" << key << "\": [\n";
    for (std::size_t i = 0; i < directions.size(); ++i) {
      text << "    " << line(directions[i]) << (i + 1 < directions.size() ? ",\n" : "\n");
    }
    text << "  ]" << end;
  };
  lines(
      "directions", [](const Direction& d) { return list_of(d); }, ",\n");
  lines(
      "basis", [&](const Direction& d) { return list_of(evaluate_in<N, double>(c, d)); }, ",\n");
  const Sh<N, double> light = example_light<N>();
  entry("radiance_in_zonal", list_of(light));
  entry("stored", list_of(convert(light, Convention{}, c)));
  const Sh<N, double> matt = convolve(light, project<N, double>(LambertLobe{}));
  const double factor = c.quantity == Quantity::irradiance ? 3.14159265358979323846 : 1;
  lines(
      "value",
      [&](const Direction& d) {
        return text_of(factor * reconstruct(c.quantity == Quantity::radiance ? light : matt, d));
      },
      "\n");
  text << "}\n";
  return text.str();
}

std::string vectors(const NamedConvention& named) { return named.bands == 3 ? vectors<3>(named) : vectors<4>(named); }

// Equal but for numbers, which may differ by 1e-12.
bool are_alike(const std::string& a, const std::string& b) {
  const auto words = [](std::string text) {
    for (char& c : text) {
      if (c == ',' || c == '[' || c == ']') c = ' ';
    }
    std::istringstream stream(text);
    return std::vector<std::string>(std::istream_iterator<std::string>(stream), {});
  };
  const auto left = words(a), right = words(b);
  if (left.size() != right.size()) return false;
  for (std::size_t i = 0; i < left.size(); ++i) {
    char *end = nullptr, *other_end = nullptr;
    const double x = std::strtod(left[i].c_str(), &end), y = std::strtod(right[i].c_str(), &other_end);
    if (*end == '\0' && *other_end == '\0' ? !(std::abs(x - y) <= 1e-12) : left[i] != right[i]) return false;
  }
  return true;
}

std::string path_of(const NamedConvention& named) {
  return std::string(ZONAL_DOCUMENTS) + "/conventions/" + std::string(named.name) + ".json";
}

}  // namespace

TEST_CASE("docs/conventions has every named convention as numbers, and they are what the library gives") {
  for (const NamedConvention& named : kConventions) {
    const std::string text = vectors(named), path = path_of(named);
    if (std::getenv("ZONAL_WRITE_DOCUMENTS") != nullptr) std::ofstream(path, std::ios::binary) << text;
    std::ifstream file(path, std::ios::binary);
    const std::string kept{std::istreambuf_iterator<char>(file), {}};
    INFO(path);
    CHECK(are_alike(kept, text));
    CHECK_FALSE(are_alike(kept, std::string(text).replace(text.find("0.64]"), 4, "0.63")));
  }
}

TEST_CASE("docs/rooms/convention.md names every convention, and none that is not") {
  std::ifstream file(std::string(ZONAL_DOCUMENTS) + "/rooms/convention.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  REQUIRE_FALSE(text.empty());
  for (const NamedConvention& named : kConventions) {
    INFO(named.name);
    CHECK(text.find("\n| `" + std::string(named.name) + "` |") != std::string::npos);
  }
}
