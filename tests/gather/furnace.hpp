// A closed white sphere of virtual lights, in which every material reflects its albedo: for tests and for the report.
#pragma once

#include <zonal/gather/receiver.hpp>
#include <zonal/gather/virtual_light.hpp>

#include <cmath>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

namespace gather_test {

/// A unit sphere of a white diffuse material, lit from its centre so that its walls reflect a radiance of 1: `count`
/// lights on a spiral, each as large as its share of the sphere.
inline std::vector<zonal::VirtualLight> furnace(int count, const zonal::Brdf& white,
                                                const zonal::MaterialTable& table) {
  const double pi = double(zonal::kPi);
  std::vector<zonal::VirtualLight> lights;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, phi = i * pi * (3 - std::sqrt(5.0)), r = std::sqrt(1 - z * z);
    zonal::VirtualLight light;
    light.position = glm::vec3(r * std::cos(phi), r * std::sin(phi), z);
    light.normal = light.to_primary = -light.position;
    light.flux = glm::vec3(float(pi * 4 * pi / count));  // E = pi where the radiance of white is 1
    light.primary_distance = 1;
    light.radius = float(2 / std::sqrt(double(count)));
    light.material = &table;
    light.brdf = &white;
    lights.push_back(light);
  }
  return lights;
}

/// The mean over receivers all over the wall, seen from `degrees`, of what a material reflects by gather(receiver),
/// over what it reflects of uniform light, its albedo.
template <class Gather>
double furnace_energy(const zonal::MaterialTable& material, double degrees, int receivers, const Gather& gather) {
  const double theta = degrees / 180 * double(zonal::kPi);
  const auto cosine = float(std::cos(theta)), sine = float(std::sin(theta));
  const double albedo = double(material.with_cosine<1>(cosine)[0].x) * std::sqrt(4 * double(zonal::kPi));
  std::mt19937 engine(39);
  std::normal_distribution<float> normal_distribution;
  const auto direction = [&] {
    const float x = normal_distribution(engine), y = normal_distribution(engine);
    return glm::normalize(glm::vec3(x, y, normal_distribution(engine)));
  };
  double sum = 0;
  for (int i = 0; i < receivers; ++i) {
    const glm::vec3 position = direction(), normal = -position;
    const glm::vec3 tangent = glm::normalize(glm::cross(normal, direction()));
    sum += double(gather(zonal::Receiver{position, normal, cosine * normal + sine * tangent}).x);
  }
  return sum / receivers / albedo;
}

}  // namespace gather_test
