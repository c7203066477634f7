// Pictures of all directions to coefficients.
#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

#include "../scalar/for_each.hpp"
#include "project_octants.hpp"
#include "project_rows.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// Rows to tasks: the same whatever the number of threads, so that sums are too.
struct RowTasks {
  int rows, per_task;
  RowTasks(int all, int unit) : rows(all), per_task(((all + 127) / 128 + unit - 1) / unit * unit) {}
  int count() const { return (rows + per_task - 1) / per_task; }
  int begin(int task) const { return task * per_task; }
  int end(int task) const { return rows - task * per_task < per_task ? rows : (task + 1) * per_task; }
};

// add(begin, end, sums) for all rows.
template <int N, class ForEach, class Add>
PictureSums<N> sum_rows(const RowTasks& tasks, ForEach&& for_each, const Add& add) {
  std::vector<PictureSums<N>> parts(static_cast<std::size_t>(tasks.count()));
  for_each(tasks.count(),
           [&](int task) { add(tasks.begin(task), tasks.end(task), parts[static_cast<std::size_t>(task)]); });
  for (std::size_t i = 1; i < parts.size(); ++i) parts[0] += parts[i];
  return parts[0];
}

}  // namespace detail

/// The coefficients of a picture's radiance, in its unit times sr: N bands, N*N colours C, which is made of three
/// numbers in braces (Rgb<float>, glm::vec3, Eigen::Vector3f, a struct of yours). E / pi: irradiance_over_pi().
/// for_each(count, body) calls body(0), ..., body(count - 1), in any order, on as many threads as it likes; the result
/// does not depend on them. What is no radiance counts as 0 and, where `faults` is given, is counted there
/// (PictureFaults).
///
/// Against project_by_texel, the plain sum in double: 2e-6 of the first coefficient up to 20 bands, however large or
/// contrasty the picture. Memory: N^2 / 32 kB for each of up to 128 parts.
template <int N, class C = Rgb<float>, class Element, class ForEach = SerialForEach>
Sh<N, C> project(const Environment<Element>& environment, ForEach&& for_each = {}, PictureFaults* faults = nullptr,
                 TexelRule rule = TexelRule::constant_exact) {
  static_assert(N >= 1, "bands out of range: N >= 1");
  static_assert(detail::is_colour_v<C>, "a picture's coefficients are colours: Rgb<float>, glm::vec3, ...");
  const detail::PictureSums<N> sums = environment.visit([&](const auto& mapping) {
    if constexpr (std::is_same_v<std::decay_t<decltype(mapping)>, Equirectangular>) {
      const detail::ColumnTable<N> table(environment.width());
      return detail::sum_rows<N>(detail::RowTasks(environment.height(), detail::LatitudeSums<N>::rows), for_each,
                                 [&](int begin, int end, detail::PictureSums<N>& part) {
                                   detail::add_latitudes<N>(environment, table, begin, end, part);
                                 });
    } else {
      return detail::sum_rows<N>(detail::RowTasks((mapping.size + 1) / 2, 1), for_each,
                                 [&](int begin, int end, detail::PictureSums<N>& part) {
                                   detail::add_octants<N>(environment, mapping, begin, end, part);
                                 });
    }
  });
  if (faults != nullptr) *faults = sums.faults;
  return sums.template finish<C>(rule);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
