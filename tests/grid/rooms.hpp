// Two rooms with a thin wall between them, a lamp in one: boxes, rays by hand, and light by paths.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <thread>
#include <vector>

#include <glm/glm.hpp>

namespace rooms_test {

constexpr float pi = 3.14159265F;

/// Seen from within if it is a room, else from outside.
struct Box {
  glm::vec3 low, high;
  bool is_room;
};

struct Met {
  float distance = std::numeric_limits<float>::infinity();
  bool is_back_face = false;
  glm::vec3 normal{0};  // towards the ray's origin
};

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}
  float operator()() { return static_cast<float>(random_() >> 8) / 16777216.0F; }  // below 1

 private:
  std::mt19937 random_;
};

/// Unit vectors: number i of n spread evenly over the sphere; any that makes a frame with a normal.
inline glm::vec3 spread_direction(int i, int n) {
  const float z = 1 - 2 * (static_cast<float>(i) + 0.5F) / static_cast<float>(n), r = std::sqrt(1 - z * z);
  const float phi = 2 * pi * std::fmod(static_cast<float>(i) * 0.61803399F, 1.0F);
  return {r * std::cos(phi), r * std::sin(phi), z};
}
inline glm::vec3 in_frame(const glm::vec3& normal, const glm::vec3& local) {
  const glm::vec3 x =
      glm::normalize(std::abs(normal.x) > 0.5F ? glm::vec3(normal.y, -normal.x, 0) : glm::vec3(0, normal.z, -normal.y));
  return local.x * x + local.y * glm::cross(normal, x) + local.z * normal;
}

/// White walls of albedo 0.7; the lamp is a sphere that blocks nothing.
struct Rooms {
  float wall;  // x of the dark side of the wall, which is 2 cm thick
  std::vector<Box> boxes;
  glm::vec3 lamp{1.2F, 1.9F, 2.0F};
  float lamp_radius = 0.2F, lamp_radiance = 40;

  static constexpr float albedo = 0.7F;
  static constexpr glm::vec3 size{4.4F, 2.5F, 3.2F};

  explicit Rooms(float dark_side = 2.23F)
      : wall(dark_side),
        boxes{{{0, 0, 0}, size, true},
              {{wall - 0.02F, 0, 0}, {wall, size.y, size.z}, false},
              {{0.6F, 0, 0.7F}, {1.3F, 0.8F, 1.5F}, false},
              {{3.1F, 0, 1.4F}, {3.7F, 0.9F, 2.2F}, false}} {}

  bool is_dark(const glm::vec3& p) const { return p.x > wall - 0.01F; }

  Met operator()(const glm::vec3& origin, const glm::vec3& direction) const {
    Met nearest;
    for (const Box& box : boxes) meet(box, origin, direction, nearest);
    return nearest;
  }

  float distance_to_lamp(const glm::vec3& origin, const glm::vec3& direction) const {
    const glm::vec3 to = lamp - origin;
    const float along = glm::dot(to, direction), half2 = lamp_radius * lamp_radius - glm::dot(to, to) + along * along;
    return half2 < 0 || along < 0 ? std::numeric_limits<float>::infinity() : along - std::sqrt(half2);
  }

  /// Irradiance straight from the lamp, by one direction to it.
  float direct(const glm::vec3& p, const glm::vec3& normal, float u, float v) const {
    const glm::vec3 to = lamp - p;
    const float distance = glm::length(to), sine = lamp_radius / distance, cosine = std::sqrt(1 - sine * sine);
    const float z = 1 - u * (1 - cosine), r = std::sqrt(std::max(0.0F, 1 - z * z));
    const glm::vec3 w = in_frame(to / distance, {r * std::cos(2 * pi * v), r * std::sin(2 * pi * v), z});
    const glm::vec3 origin = p + 1e-4F * normal;
    if (glm::dot(w, normal) <= 0 || (*this)(origin, w).distance < distance_to_lamp(origin, w)) return 0;
    return lamp_radiance * glm::dot(w, normal) * 2 * pi * (1 - cosine);
  }

  /// Radiance that arrives, by one path of at most four surfaces.
  float arriving(glm::vec3 origin, glm::vec3 direction, Random& random, bool with_lamp) const {
    float sum = 0, weight = 1;
    for (int bounce = 0; bounce < 4; ++bounce) {
      const Met met = (*this)(origin, direction);
      if (bounce == 0 && with_lamp && distance_to_lamp(origin, direction) < met.distance) return lamp_radiance;
      if (met.is_back_face || std::isinf(met.distance)) break;
      const glm::vec3 p = origin + met.distance * direction;
      weight *= albedo;
      const float u = random(), v = random();
      sum += weight / pi * direct(p, met.normal, u, v);
      origin = p + 1e-4F * met.normal;
      direction = by_cosine(met.normal, random(), random());
    }
    return sum;
  }

  static glm::vec3 by_cosine(const glm::vec3& normal, float u, float v) {
    return in_frame(normal,
                    {std::sqrt(u) * std::cos(2 * pi * v), std::sqrt(u) * std::sin(2 * pi * v), std::sqrt(1 - u)});
  }

  /// What falls on a surface, by paths; in the dark room it is 0, for nothing is open.
  float irradiance(const glm::vec3& p, const glm::vec3& normal, int paths, Random& random) const {
    if (is_dark(p)) return 0;
    float sum = 0;
    for (int i = 0; i < paths; ++i) {
      const float u = (static_cast<float>(i) + 0.5F) / static_cast<float>(paths);
      const float v = std::fmod(static_cast<float>(i) * 0.61803399F, 1.0F);
      sum += direct(p, normal, u, v) + pi * arriving(p + 1e-4F * normal, by_cosine(normal, u, v), random, false);
    }
    return sum / static_cast<float>(paths);
  }

 private:
  static void meet(const Box& box, const glm::vec3& origin, const glm::vec3& direction, Met& nearest) {
    float in = -std::numeric_limits<float>::infinity(), out = -in;
    int in_axis = 0, out_axis = 0;
    for (int a = 0; a < 3; ++a) {
      const float t = (box.low[a] - origin[a]) / direction[a], u = (box.high[a] - origin[a]) / direction[a];
      if (std::min(t, u) > in) in = std::min(t, u), in_axis = a;
      if (std::max(t, u) < out) out = std::max(t, u), out_axis = a;
    }
    if (!(in <= out)) return;
    const bool is_entry = in > 1e-5F;
    const float t = is_entry ? in : out;
    if (!(t > 1e-5F) || t >= nearest.distance) return;
    const int axis = is_entry ? in_axis : out_axis;
    nearest = {t, is_entry == box.is_room, glm::vec3(0)};
    nearest.normal[axis] = direction[axis] > 0 ? -1.0F : 1.0F;
  }
};

/// body(0) to body(count - 1), on two threads.
struct TwoThreads {
  template <class Body>
  void operator()(int count, const Body& body) const {
    const auto every_second = [&](int first) {
      for (int i = first; i < count; i += 2) body(i);
    };
    std::thread other(every_second, 1);
    every_second(0);
    other.join();
  }
};

}  // namespace rooms_test
