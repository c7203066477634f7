#pragma once

#include <string>
#include <vector>

#include <zonal/convention/named.hpp>

#include "light.hpp"
#include "shared/names.hpp"

namespace zonal_probe {

/// Numbers as somebody stores them.
struct Stored {
  const zonal::NamedConvention* named = nullptr;
  zonal::Quantity quantity = zonal::Quantity::radiance;
  zonal::Frame frame{};
  int bands = 0;
  std::vector<Colour> numbers;  // bands * bands of them, in the convention's order

  /// The convention, of this quantity.
  zonal::Convention convention() const;
};

/// `to` says all but the numbers. Throws InputError where they are no floats.
Stored store(const Light& light, Stored to);
Light load(const Stored& stored);

/// The convention of this name. Throws InputError, with the name that is next to it, where there is none; `option` is
/// what was given.
const zonal::NamedConvention& convention_of(const std::string& option, const std::string& name);

/// What the convention's numbers are where nobody says: its own quantity. Throws InputError where it stores another one
/// than was asked for. Asked for irradiance, a convention of E / pi gives that.
zonal::Quantity quantity_of(const zonal::NamedConvention& named, const zonal::Quantity* asked);

/// Throws InputError where the convention stores fewer.
void check_bands(const zonal::NamedConvention& named, int bands);

/// A frame's name, or its axes to the right, up and ahead: x,y,-z. False where it is neither.
bool parse_frame(const std::string& text, zonal::Frame& frame);
bool parse_axis(const std::string& text, zonal::Axis& axis);
std::string axis_text(zonal::Axis axis);
/// right x, up y, ahead -z
std::string frame_text(const zonal::Frame& frame);
std::string frame_names();  // picture, opengl, ...

/// As --quantity has them; in files a blank stands for each hyphen.
inline const example::Names<zonal::Quantity> quantity_names{
    {"radiance", zonal::Quantity::radiance},
    {"irradiance", zonal::Quantity::irradiance},
    {"irradiance-over-pi", zonal::Quantity::irradiance_over_pi}};
std::string quantity_text(zonal::Quantity quantity);

/// All conventions, for --list.
std::string convention_list();

}  // namespace zonal_probe
