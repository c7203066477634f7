#pragma once

#include <zonal/basis/sh.hpp>
#include <zonal/convention/convention.hpp>
#include <zonal/environment/rgb.hpp>

namespace zonal_probe {

constexpr double pi = static_cast<double>(zonal::kPi);

/// For more, `many_bands` has the basis, but neither pictures nor conventions.
constexpr int max_bands = 10;

using Colour = zonal::Rgb<double>;
using Coefficients = zonal::Sh<max_bands, Colour>;

/// A function of all directions, in the library's convention and its frame of pictures (x ahead, y left, z up),
/// whatever it was read from.
struct Light {
  Coefficients sh{};  // zeros from `bands` on
  int bands = 0;
  zonal::Quantity quantity = zonal::Quantity::radiance;
};

/// The first bands; those beyond become zeros.
void keep_bands(Light& light, int bands);

/// Another quantity of the same light. What the cosine has taken away, degrees 3, 5, 7, ..., does not come back.
Light of_quantity(Light light, zonal::Quantity quantity);

}  // namespace zonal_probe
