// Runs of texels as planes of numbers, checked on the way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "../scalar/lane_blocks.hpp"
#include "picture.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// Texels that stand `step` elements apart.
template <class Element>
struct Run {
  const Element* first;
  std::ptrdiff_t step, channel_stride;
  int channels;
};

#if defined(__GNUC__)
// Whether any of the numbers seen may be none of a radiance. Of bits: those of a negative number have the first set,
// those of infinities and NaN get it set by one more in the exponent. (-0, which is a radiance, raises the alarm too.)
template <int width>
class RadianceCheck {
  typedef std::uint32_t Bits __attribute__((vector_size(std::size_t{width} * sizeof(float))));

 public:
  ZONAL_INLINE void see(const Lanes<float, width>& lanes) {
    const Bits bits = lanes.template as<Bits>();
    seen_ |= bits | (bits + 0x00800000U);
  }
  bool has_doubts() const {
    std::uint32_t numbers[static_cast<std::size_t>(width)], all = 0;
    std::memcpy(numbers, &seen_, sizeof numbers);
    for (const std::uint32_t number : numbers) all |= number;
    return all >> 31U != 0;
  }

 private:
  Bits seen_{};
};
#endif

template <int width>
struct Backwards {
  static constexpr int at(int lane) { return width - 1 - lane; }
};
template <class T, int width>
ZONAL_INLINE inline Lanes<T, width> reversed(const Lanes<T, width>& x) {
  return Lanes<T, width>::template shuffle<Backwards<width>>(x, x);
}

inline void expect_reads(const float* numbers, int count) {
#if defined(__GNUC__)
  for (int i = 0; i < count; i += 16) __builtin_prefetch(numbers + i, 0, 2);
#endif
}

// One by one: any stride, any element. What is no radiance becomes 0 and is counted.
template <class Element>
inline void read_texels(const Run<Element>& run, int begin, int end, float* const (&planes)[3], PictureFaults& faults) {
  for (int c = 0; c < (run.channels == 1 ? 1 : 3); ++c) {
    const Element* element = run.first + begin * run.step + c * run.channel_stride;
    for (int i = begin; i < end; ++i, element += run.step) {
      const float number = to_float(*element);
      planes[c][i] = is_radiance(number) ? number : as_radiance(number, faults);
    }
  }
  if (run.channels != 1) return;
  for (int i = begin; i < end; ++i) planes[1][i] = planes[2][i] = planes[0][i];
}

// `count` texels to planes[0 to 2][0 to count - 1]. What is to be read after them, `ahead` elements on, is fetched:
// runs are too short for the processor to see it coming.
template <class Element>
inline void read_run(const Run<Element>& run, int count, float* const (&planes)[3], PictureFaults& faults,
                     std::ptrdiff_t ahead = 0) {
  int done = 0;
#if defined(__GNUC__)
  if constexpr (std::is_same_v<Element, float>) {
    constexpr int width = native_lanes_v<float>;
    const bool is_backward = run.step == -3;
    if (run.channels == 3 && run.channel_stride == 1 && (run.step == 3 || is_backward)) {
      RadianceCheck<width> check;
      for (; done + width <= count; done += width) {
        Lanes<float, width> v[3];
        const float* const lowest = run.first + run.step * (is_backward ? done + width - 1 : done);
        expect_reads(lowest + ahead, 3 * width);
        load_triples(lowest, v);
        for (int c = 0; c < 3; ++c) {
          check.see(v[c]);
          (is_backward ? reversed(v[c]) : v[c]).store(planes[c] + done);
        }
      }
      if (check.has_doubts()) done = 0;
    }
  }
#endif
  read_texels(run, done, count, planes, faults);
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
