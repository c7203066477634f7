// Half floats, as pictures hold them, and what is trained: 16 bits, IEEE 754 binary16. Nothing but their bits and the
// way to floats and back. Many at once: half_lanes.hpp.
#pragma once

#include <cstdint>
#include <cstring>

#include "target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// One number: an array of std::uint16_t, of OpenEXR's or Imath's half, of _Float16 is one of these in memory.
struct Half {
  std::uint16_t bits;
};

namespace detail {
inline float float_of_bits(std::uint32_t bits) {
  float number;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}
inline std::uint32_t bits_of(float number) {
  std::uint32_t bits;
  std::memcpy(&bits, &number, sizeof bits);
  return bits;
}
}  // namespace detail

/// Exact; infinities and NaN stay what they are.
inline float to_float(Half half) {
  // The exponent moved to a float's place is too small by 112, which a multiplication puts right: subnormals with it.
  const std::uint32_t magnitude = (half.bits & 0x7fffU) << 13U, sign = (half.bits & 0x8000U) << 16U;
  const std::uint32_t finite = detail::bits_of(detail::float_of_bits(magnitude) * 0x1p112F);
  const std::uint32_t beyond = magnitude >= 0x0f800000U ? 0x7f800000U : 0U;  // no finite number has this exponent
  return detail::float_of_bits(finite | beyond | sign);
}
inline float to_float(float number) { return number; }

/// The nearest half float, of two the even one; from 65520 on infinity, and NaN stays NaN.
inline Half to_half(float number) {
  const std::uint32_t bits = detail::bits_of(number), magnitude = bits & 0x7fffffffU;
  const auto sign = static_cast<std::uint16_t>((bits >> 16U) & 0x8000U);
  std::uint32_t half;
  if (magnitude > 0x7f800000U) {
    half = 0x7e00U;
  } else if (magnitude >= 0x477ff000U) {  // 65520
    half = 0x7c00U;
  } else if (magnitude < 0x38800000U) {  // subnormal: in units of 2^-24, which the addition rounds to
    half = detail::bits_of(detail::float_of_bits(magnitude) + 0.5F) - 0x3f000000U;
  } else {
    half = (magnitude - 0x38000000U + 0x0fffU + ((magnitude >> 13U) & 1U)) >> 13U;
  }
  return {static_cast<std::uint16_t>(half | sign)};
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
