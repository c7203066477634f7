#include "conventions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>

#include <zonal/convention/convert.hpp>

#include "shared/input_error.hpp"

namespace zonal_probe {
namespace {

using example::InputError;
using zonal::Axis;

// A convention that ends at degree 3 cannot be asked for more.
constexpr int listed_bands = 4;

bool is_listed(const zonal::Convention& convention) { return zonal::greatest_degree(convention) < max_bands - 1; }

Coefficients convert(const Coefficients& sh, const zonal::Convention& from, const zonal::Convention& to) {
  if (!is_listed(from) && !is_listed(to)) return zonal::convert(sh, from, to);
  const auto few = zonal::convert(zonal::with_bands<listed_bands>(sh), from, to);
  return zonal::with_bands<max_bands>(few);
}

zonal::Convention ours(zonal::Quantity quantity) {
  zonal::Convention convention;
  convention.quantity = quantity;
  return convention;
}

/// How many letters to change, add or leave out.
std::size_t letters_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

/// Letters and digits alone, in lower case: Three.js is threejs, and glTF-image-based gltf_image_based.
std::string letters_of(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    if (c >= 'A' && c <= 'Z') letters += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) letters += c;
  }
  return letters;
}

const std::pair<const char*, zonal::Frame> known_frames[] = {
    {"picture", zonal::frames::zonal_picture}, {"opengl", zonal::frames::opengl}, {"gltf", zonal::frames::gltf},
    {"unity", zonal::frames::unity},           {"unreal", zonal::frames::unreal}, {"colmap", zonal::frames::colmap}};

}  // namespace

void keep_bands(Light& light, int bands) {
  light.bands = bands;
  for (int i = bands * bands; i < light.sh.size(); ++i) light.sh[i] = Colour{0, 0, 0};
}

Light of_quantity(Light light, zonal::Quantity quantity) {
  light.sh = zonal::convert(light.sh, ours(light.quantity), ours(quantity));
  light.quantity = quantity;
  return light;
}

zonal::Convention Stored::convention() const {
  zonal::Convention convention = named->convention;
  convention.quantity = quantity;
  return convention;
}

Stored store(const Light& light, Stored to) {
  Coefficients sh = zonal::change_frame(light.sh, zonal::frames::zonal_picture, to.frame);
  sh = convert(sh, ours(light.quantity), to.convention());
  const Colour zero{0, 0, 0};
  for (int i = 0; i < to.bands * to.bands; ++i) to.numbers.push_back(sh[i] + zero);  // and no -0
  for (const Colour& number : to.numbers) {
    for (int c = 0; c < 3; ++c) {
      if (!(std::abs(number[c]) <= double{std::numeric_limits<float>::max()})) {
        throw InputError("the light is too bright: its coefficients are beyond what a float holds");
      }
    }
  }
  return to;
}

Light load(const Stored& stored) {
  Light light;
  light.bands = stored.bands;
  light.quantity = stored.quantity;
  for (std::size_t i = 0; i < stored.numbers.size(); ++i) light.sh[static_cast<int>(i)] = stored.numbers[i];
  light.sh = zonal::change_frame(convert(light.sh, stored.convention(), ours(stored.quantity)), stored.frame,
                                 zonal::frames::zonal_picture);
  return light;
}

const zonal::NamedConvention& convention_of(const std::string& option, const std::string& name) {
  const std::string asked = letters_of(name);
  for (const zonal::NamedConvention& known : zonal::kConventions) {
    if (letters_of(known.name) == asked) return known;
  }
  const auto nearer = [&](const auto& a, const auto& b) {
    return letters_between(asked, letters_of(a.name)) < letters_between(asked, letters_of(b.name));
  };
  const auto nearest = std::min_element(std::begin(zonal::kConventions), std::end(zonal::kConventions), nearer);
  throw InputError(option + ": '" + example::one_line(name) + "' is no convention; did you mean " +
                   std::string(nearest->name) + "? --list names them all");
}

zonal::Quantity quantity_of(const zonal::NamedConvention& named, const zonal::Quantity* asked) {
  using zonal::Quantity;
  const Quantity own = named.convention.quantity;
  if (asked == nullptr || *asked == own) return own;
  if (own == Quantity::radiance) return *asked;
  if (own == Quantity::irradiance_over_pi && *asked == Quantity::irradiance) return own;
  throw InputError("--quantity: " + std::string(named.name) + " stores " + quantity_text(own) + ", not " +
                   quantity_text(*asked));
}

void check_bands(const zonal::NamedConvention& named, int bands) {
  if (named.bands == 0 || bands <= named.bands) return;
  throw InputError("--bands: " + std::string(named.name) + " stores at most " + std::to_string(named.bands) +
                   " bands, not " + std::to_string(bands));
}

bool parse_axis(const std::string& text, Axis& axis) {
  const bool is_signed = !text.empty() && (text[0] == '-' || text[0] == '+');
  const std::string letter = text.substr(is_signed ? 1 : 0);
  if (letter != "x" && letter != "y" && letter != "z") return false;
  axis = static_cast<Axis>(letter[0] - 'x' + 1);
  if (text[0] == '-') axis = -axis;
  return true;
}

bool parse_frame(const std::string& text, zonal::Frame& frame) {
  for (const auto& [name, known] : known_frames) {
    if (text == name) {
      frame = known;
      return true;
    }
  }
  const std::size_t first = text.find(','), second = text.find(',', first + 1);
  if (first == std::string::npos || second == std::string::npos) return false;
  zonal::Frame parsed{};
  const bool are_axes = parse_axis(text.substr(0, first), parsed.right) &&
                        parse_axis(text.substr(first + 1, second - first - 1), parsed.up) &&
                        parse_axis(text.substr(second + 1), parsed.forward);
  if (!are_axes || !zonal::detail::are_three(parsed.right, parsed.up, parsed.forward)) return false;
  frame = parsed;
  return true;
}

std::string axis_text(Axis axis) { return zonal::detail::axis_name(axis); }

std::string frame_text(const zonal::Frame& frame) {
  return "right " + axis_text(frame.right) + ", up " + axis_text(frame.up) + ", ahead " + axis_text(frame.forward);
}

std::string frame_names() {
  std::string text;
  for (const auto& known : known_frames) text += (text.empty() ? "" : ", ") + std::string(known.first);
  return text;
}

std::string quantity_text(zonal::Quantity quantity) {
  std::string text = example::name_of(quantity_names, quantity);
  std::replace(text.begin(), text.end(), '-', ' ');
  return text;
}

std::string convention_list() {
  std::string text;
  for (const zonal::NamedConvention& named : zonal::kConventions) {
    const std::string bands =
        named.bands == 0 ? "any number of bands" : "at most " + std::to_string(named.bands) + " bands";
    const bool is_fixed = named.convention.quantity != zonal::Quantity::radiance;
    text += std::string(named.name) + ": " + std::string(named.what) + "\n    " + (is_fixed ? "always " : "") +
            quantity_text(named.convention.quantity) + "; " + bands + "; " + frame_text(named.frame) + "\n    " +
            std::string(named.source) + "\n";
  }
  return text;
}

}  // namespace zonal_probe
