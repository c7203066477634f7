// The table of accuracy (zonal/accuracy.hpp) as tests read it.
#pragma once

#include <zonal/accuracy.hpp>

#include <string_view>

using zonal::Accuracy, zonal::accuracy_bound, zonal::accuracy_of, zonal::many_bands_bound;
using zonal::accuracy::run_bands;

/// "float" or "double", and the packets of either.
template <class T>
inline constexpr std::string_view scalar_name = sizeof(T) == sizeof(float) ? "float" : "double";
template <class T>
inline constexpr std::string_view packet_name = sizeof(T) == sizeof(float) ? "Packet of float" : "Packet of double";
