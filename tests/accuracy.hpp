// The table of accuracy (zonal/accuracy.hpp) as tests read it.
#pragma once

#include <zonal/accuracy.hpp>

#include <cstdio>
#include <cstdlib>
#include <string_view>

using zonal::Accuracy, zonal::accuracy_bound, zonal::accuracy_of, zonal::many_bands_bound;
using zonal::accuracy::run_bands;

/// "float" or "double", and the packets of either.
template <class T>
inline constexpr std::string_view scalar_name = sizeof(T) == sizeof(float) ? "float" : "double";
template <class T>
inline constexpr std::string_view packet_name = sizeof(T) == sizeof(float) ? "Packet of float" : "Packet of double";

/// The errors met of a function over data, in its row's unit.
class Met {
 public:
  Met(std::string_view room, std::string_view function) : row(zonal::accuracy_over_data(room, function)) {}
  /// Whether it is within the bound.
  bool meet(double error) {
    if (!(error <= worst)) worst = error;
    return error <= row.bound;
  }
  Accuracy row;
  double worst = 0;
};
#define CHECK_MET(met)                                                                                         \
  do {                                                                                                         \
    if (std::getenv("ZONAL_PRINT_WORST") != nullptr) {                                                         \
      std::printf("worst of %s, %s: %.3g\n", (met).row.room.data(), (met).row.function.data(), (met).worst);   \
    }                                                                                                          \
    INFO((met).row.room << ", " << (met).row.function << ": " << (met).worst << ", kept " << (met).row.worst); \
    CHECK((met).worst <= (met).row.bound);                                                                     \
  } while (false)
/// And the table's worst is not far from what is found: by other processors sums have another order.
#define CHECK_WORST_MET(met)                     \
  do {                                           \
    CHECK_MET(met);                              \
    CHECK((met).worst >= 0.2 * (met).row.worst); \
  } while (false)
