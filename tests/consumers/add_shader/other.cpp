#include "light.inl"
// In the other order than main.cpp.
#include "basis.inl"

float value_elsewhere(const float (&direction)[3]);

float value_elsewhere(const float (&direction)[3]) {
  float even[6];
  zonal_evaluate_3_even(direction, even);
  return even[5];
}
