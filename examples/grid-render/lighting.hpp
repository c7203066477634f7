#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <vector>

#include <zonal/grid/coefficient_grid.hpp>
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
  virtual glm::ivec3 resolution() const = 0;
  /// Of what the vertices see, beside the grid's own.
  virtual std::size_t visibility_bytes() const { return 0; }
  /// The grid must outlive it.
  virtual std::unique_ptr<LightField> interpolated(zonal::Interpolation method) const = 0;
  /// By what each point sees of the vertices: of grids that know.
  virtual std::unique_ptr<LightField> visible() const { throw std::logic_error("a grid without visibility"); }
  /// Throws zonal::GridFileError; the file is then what it was.
  virtual void save(const std::filesystem::path& path) const = 0;
};

using zonal::GridContent;

class Lighting : public Interface {
 public:
  virtual std::size_t light_count() const = 0;
  /// Every light projected at every point: the reference.
  virtual std::unique_ptr<LightField> exact() const = 0;
  virtual std::unique_ptr<LightGrid> grid(const Bounds& box, const glm::ivec3& resolution,
                                          GridContent content) const = 0;
};

/// The lights in bands of spherical harmonics, in the shape that is asked for; the panel is what squares are parallel
/// to. The number of bands is one of lighting_bands(shape).
std::unique_ptr<Lighting> make_lighting(Shape shape, const SphereLights& lights, const LightPanel& panel, int bands);

/// A grid from a file, of these bands and this box. Throws InputError.
std::unique_ptr<LightGrid> load_light_grid(const std::filesystem::path& path, const Bounds& box, int bands);

/// Bytes that a grid's floats take.
std::size_t grid_bytes(int bands, const glm::ivec3& resolution, GridContent content);

}  // namespace example::grid_render
