// fit_samples
#include <zonal/fit/least_squares.hpp>

zonal::Fit<BANDS, float> fitted(const zonal::DirectionSpan<float>& directions, const float* values) {
  return zonal::fit_samples<BANDS>(directions, values, nullptr, 0.0);
}
