// The gathers that are measured and counted; apart from the other kernels, for they take long to compile.
#pragma once

#include <array>
#include <cstddef>

#include <zonal/gather/hvl.hpp>

#include "built_bands.hpp"

namespace zonal_bench {

using zonal::Horizon;

constexpr const char* gather_name(int emission_bands, Horizon horizon) {
  switch (horizon) {
    case Horizon::none: return "gather-none-3";
    case Horizon::smoothstep: return emission_bands == 1 ? "gather-smoothstep-1" : "gather-smoothstep-3";
    case Horizon::exact: break;
  }
  return "gather-exact-3";
}

/// A kernel as in kernels.hpp, but for draw: one light's share of a gather, its radiance and the addition of
/// it. What is done once per receiver is not in it.
template <int N, int NE, Horizon method>
struct Gather {
  using Domain = Gather;
  static constexpr const char* name = gather_name(NE, method);
  static constexpr int bands = N, emission_bands = NE;
  static constexpr Horizon horizon = method;
  static constexpr std::size_t inputs = zonal::field_count<zonal::HvlRecord<NE, float>> + 9 + 3;

  template <class T>
  static std::array<T, 3> run(const std::array<T, inputs>& numbers) {
    zonal::HvlRecord<NE, T> light;
    zonal::ReceiverFrame<T> frame;
    std::array<T, 3> sum, result;
    const T* next = numbers.data();
    zonal::for_each_field(light, [&](T& field) ZONAL_INLINE { field = *next++; });
    for (auto* vector : {&frame.position, &frame.normal, &frame.tangent}) {
      for (T& x : *vector) x = *next++;
    }
    for (T& x : sum) x = *next++;
    // Coefficients that all differ, and none 0 or 1, which would save operations.
    zonal::EvenSh<N, glm::vec3> material{};
    for (int i = 0; i < material.size(); ++i) {
      material[i] = 0.1F + float(i) * glm::vec3(0.001F, 0.0013F, 0.0017F);
    }

    T radiance[3];
    zonal::hvl_radiance<N, NE, method>(light, frame, material, radiance);
    for (std::size_t c = 0; c < 3; ++c) result[c] = sum[c] + radiance[c];
    return result;
  }
};

template <class Visit>
void for_gather_kernels(Visit&& visit) {
  // The bands of HVL Table 1.
  for_bands(Built<Bands<3, 5, 7, 9>, Bands<5>>{}, [&](auto n) {
    visit(Gather<n, 3, Horizon::smoothstep>{});
    visit(Gather<n, 1, Horizon::smoothstep>{});
  });
  visit(Gather<5, 3, Horizon::none>{});
  visit(Gather<5, 3, Horizon::exact>{});
}

}  // namespace zonal_bench
