#include "truth.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>
#include <glm/gtc/constants.hpp>
#include <zonal/basis/evaluate.hpp>
#include <zonal/file/number_text.hpp>

#include "shared/interrupt.hpp"
#include "shared/spread_points.hpp"

namespace example::field_capture {
namespace {

constexpr int emitter_samples = 4096;

glm::dvec3 sphere_direction(const glm::dvec2& u) {
  const double z = 1.0 - 2.0 * u.x, sine = std::sqrt(std::max(1.0 - z * z, 0.0)), phi = glm::two_pi<double>() * u.y;
  return {sine * std::cos(phi), sine * std::sin(phi), z};
}

void add(const glm::dvec3& direction, const glm::dvec3& amount, Truth& sums) {
  const auto basis = zonal::evaluate<most_truth_bands>(direction);
  for (int i = 0; i < sums.size(); ++i) sums[i] += amount * basis[i];
}

/// body(first, end, sums of its own) for runs of `count`; the sums of all, always in the same order.
template <class Body>
Truth sum_in_parallel(int count, const Body& body) {
  constexpr int run = 512;
  std::vector<Truth> parts(static_cast<std::size_t>((count + run - 1) / run));
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t part) {
    const int first = static_cast<int>(part) * run;
    if (!stop_requested()) body(first, std::min(first + run, count), parts[part]);
  });
  throw_if_interrupted();
  Truth sum{};
  for (const Truth& part : parts) sum += part;
  return sum;
}

}  // namespace

Truth true_coefficients(const IncidentRadiance& light, const glm::vec3& place, int paths, std::uint64_t seed) {
  Pcg32 shared(hash64(seed));
  const SpreadPoints directions(shared), on_emitter(shared);
  const double solid_angle = 4.0 * glm::pi<double>() / paths;
  Truth sum = sum_in_parallel(paths, [&](int first, int end, Truth& part) {
    Pcg32 random(hash64(seed + 1) ^ static_cast<std::uint64_t>(first));
    for (int i = first; i < end; ++i) {
      const glm::dvec3 direction = sphere_direction(glm::vec2(directions.point(static_cast<std::uint32_t>(i))));
      add(direction, solid_angle * glm::dvec3(light.of_surfaces(place, direction, random)), part);
    }
  });
  for (const Emitter& emitter : light.emitters()) {
    sum += sum_in_parallel(emitter_samples, [&](int first, int end, Truth& part) {
      for (int i = first; i < end; ++i) {
        const IncidentRadiance::Arrival arrival =
            light.arrival(emitter, place, glm::vec2(on_emitter.point(static_cast<std::uint32_t>(i))), emitter_samples);
        if (arrival.irradiance == glm::vec3(0.0f) || !light.visible(place, arrival.point)) continue;
        add(glm::normalize(glm::dvec3(arrival.direction)), arrival.irradiance, part);
      }
    });
  }
  return sum;
}

std::string truth_csv(const IncidentRadiance& light, const std::vector<glm::vec3>& places, int bands, int paths,
                      std::uint64_t seed, bool quiet) {
  std::string text = "x,y,z";
  for (int i = 0; i < bands * bands; ++i) {
    for (const char* channel : {"r", "g", "b"}) text += ",c" + std::to_string(i) + channel;
  }
  text += "\n";
  Progress progress(!quiet);
  progress.expect(static_cast<double>(places.size()));
  for (std::size_t place = 0; place < places.size(); ++place) {
    const Truth truth = true_coefficients(light, places[place], paths, hash64(seed) + place);
    const glm::vec3& p = places[place];
    text += zonal::shortest_text(p.x) + "," + zonal::shortest_text(p.y) + "," + zonal::shortest_text(p.z);
    for (int i = 0; i < bands * bands; ++i) {
      for (int c = 0; c < 3; ++c) text.append(",").append(zonal::shortest_text(static_cast<float>(truth[i][c])));
    }
    text += "\n";
    progress.advance("positions", 1.0);
  }
  return text;
}

}  // namespace example::field_capture
