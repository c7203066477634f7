#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <zonal/grid/interpolation_weights.hpp>

#include "lights.hpp"
#include "reflector.hpp"
#include "shared/ray_caster.hpp"

namespace example::grid_render {

/// What is made by a number of bands known at run time, and used without knowing it.
class Interface {
 public:
  Interface() = default;
  virtual ~Interface() = default;
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;
};

/// The light that arrives everywhere, without visibility. Safe to use from many threads.
class LightField : public Interface {
 public:
  /// Radiance that leaves `hit` towards the unit direction `outgoing`. Bands are few, so it may be negative.
  virtual glm::vec3 reflected(const Hit& hit, const glm::vec3& outgoing, const Reflector& reflector) const = 0;
};

class LightGrid : public Interface {
 public:
  /// The grid must outlive it.
  virtual std::unique_ptr<LightField> interpolated(zonal::Interpolation method) const = 0;
};

/// Values alone, for trilinear interpolation, or gradients too.
enum class GridContent { values, values_and_gradients };

class Lighting : public Interface {
 public:
  /// Every light projected at every point: the reference. Its lights must outlive it.
  virtual std::unique_ptr<LightField> exact() const = 0;
  virtual std::unique_ptr<LightGrid> grid(const Bounds& box, const glm::ivec3& resolution,
                                          GridContent content) const = 0;
};

/// The lights in bands of spherical harmonics. The number is one of lighting_bands().
std::unique_ptr<Lighting> make_lighting(const SphereLights& lights, int bands);

/// The numbers of bands that are compiled in: each costs compile time.
std::vector<int> lighting_bands();

/// Bytes that a grid's floats take.
std::size_t grid_bytes(int bands, const glm::ivec3& resolution, GridContent content);

}  // namespace example::grid_render
