#include "positions.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <zonal/scalar/index.hpp>

#include "shared/input_error.hpp"
#include "shared/random.hpp"
#include "shared/statements.hpp"

namespace example::field_capture {
namespace {

/// How many along each of some axes, so that all are about `count` and as far apart on each; one along an axis too
/// short for that, which leaves the others their distance.
template <int Axes>
glm::vec<Axes, int> counts_along(const glm::vec<Axes, float>& sides, int count) {
  glm::vec<Axes, int> counts(1);
  glm::vec<Axes, bool> is_long(true);
  for (int pass = 0; pass < Axes; ++pass) {
    double volume = 1.0;
    int axes = 0;
    for (int axis = 0; axis < Axes; ++axis) {
      if (!is_long[axis]) continue;
      volume *= static_cast<double>(sides[axis]);
      ++axes;
    }
    const double density = axes > 0 ? std::pow(count / volume, 1.0 / axes) : 0.0;
    for (int axis = 0; axis < Axes; ++axis) {
      const double along = std::round(static_cast<double>(sides[axis]) * density);
      is_long[axis] = is_long[axis] && along >= 1.0;
      counts[axis] = is_long[axis] ? zonal::detail::index_below(along, count) : 1;
    }
  }
  return counts;
}

/// From face to face; a single one in the middle.
float share(int i, int count) { return count == 1 ? 0.5f : static_cast<float>(i) / static_cast<float>(count - 1); }

/// visit(column, row), row after row, upwards or downwards, and each the other way than the one before.
template <class Visit>
void to_and_fro(const glm::ivec2& counts, int rows_before, bool downwards, const Visit& visit) {
  for (int j = 0; j < counts.y; ++j) {
    const bool back = (rows_before + j) % 2 == 1;
    for (int i = 0; i < counts.x; ++i) visit(back ? counts.x - 1 - i : i, downwards ? counts.y - 1 - j : j);
  }
}

template <class Place>
std::vector<glm::vec3> in_grid(const Bounds& box, int probes, const Place& place) {
  const glm::vec3 sides = box.upper - box.lower;
  const glm::ivec3 counts = counts_along(sides, probes);
  std::vector<glm::vec3> positions;
  for (int z = 0; z < counts.z; ++z) {
    to_and_fro({counts.x, counts.y}, z * counts.y, z % 2 == 1,
               [&](int x, int y) { positions.push_back(box.lower + sides * place(glm::ivec3(x, y, z), counts)); });
  }
  return positions;
}

std::vector<glm::vec3> in_planes(const Bounds& box, int probes) {
  std::vector<glm::vec3> positions;
  const glm::vec3 sides = box.upper - box.lower;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const glm::ivec2 counts = counts_along(glm::vec2(sides[u], sides[v]), std::max(probes / 3, 1));
    to_and_fro(counts, 0, false, [&](int i, int j) {
      glm::vec3 place(0.5f);
      place[u] = share(i, counts.x);
      place[v] = share(j, counts.y);
      positions.push_back(box.lower + sides * place);
    });
  }
  return positions;
}

}  // namespace

std::vector<glm::vec3> probe_positions(const Options& options, const Bounds& box) {
  if (options.layout == Layout::planes) return in_planes(box, options.probes);
  if (options.layout == Layout::grid) {
    return in_grid(box, options.probes, [](const glm::ivec3& cell, const glm::ivec3& counts) {
      return glm::vec3(share(cell.x, counts.x), share(cell.y, counts.y), share(cell.z, counts.z));
    });
  }
  Pcg32 random(hash64(options.seed) + 1);
  return in_grid(box, options.probes, [&](const glm::ivec3& cell, const glm::ivec3& counts) {
    const float x = random.uniform(), y = random.uniform(), z = random.uniform();
    return (glm::vec3(cell) + glm::vec3(x, y, z)) / glm::vec3(counts);
  });
}

std::vector<glm::vec3> read_positions(const std::filesystem::path& path) {
  check_is_file(path);
  Statements lines(path);
  std::vector<glm::vec3> positions;
  while (const auto line = lines.next()) {
    // What OBJ files have for a keyword is here the first number.
    std::string_view rest = without_comment(line->rest);
    const std::optional<double> numbers[] = {number_in(line->keyword), number_in(next_word(rest)),
                                             number_in(next_word(rest))};
    if (!numbers[0] || !numbers[1] || !numbers[2] || !without_blanks(rest).empty()) {
      throw InputError(path.string() + ": line " + std::to_string(line->line) + " is no position x y z");
    }
    if (!(std::abs(*numbers[0]) <= 1e8 && std::abs(*numbers[1]) <= 1e8 && std::abs(*numbers[2]) <= 1e8)) {
      throw InputError(path.string() + ": line " + std::to_string(line->line) + " is beyond 1e8");
    }
    positions.emplace_back(*numbers[0], *numbers[1], *numbers[2]);
  }
  if (positions.empty()) throw InputError(path.string() + ": has no positions");
  return positions;
}

}  // namespace example::field_capture
