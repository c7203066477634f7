#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <zonal/gather/virtual_light.hpp>
#include <zonal/material/anisotropic_table.hpp>
#include <zonal/material/material_table.hpp>
#include <zonal/material/zonal_table.hpp>
#include <zonal/plan/kept_table.hpp>

#include "options.hpp"
#include "shared/materials.hpp"
#include "shared/ray_caster.hpp"
#include "shared/scene.hpp"

namespace example::hvl_render {

/// A material as receivers read it: its table, and once there is a plan what it keeps of that.
class ReceivingTable {
 public:
  ReceivingTable(zonal::MaterialTable table) : whole_(std::move(table)) {}  // NOLINT: a table is one

  void keep(const zonal::CoefficientPlan& plan, int bits) {
    kept_.emplace(*whole_, plan, bits);
    whole_.reset();
  }
  /// Until then.
  const zonal::MaterialTable& whole() const { return *whole_; }

  int angles() const { return kept_ ? kept_->angles() : whole_->angles(); }
  template <int N>
  zonal::EvenSh<N, glm::vec3> with_cosine(float cos_outgoing) const {
    return kept_ ? kept_->with_cosine<N>(cos_outgoing) : whole_->with_cosine<N>(cos_outgoing);
  }
  std::size_t bytes() const;

 private:
  std::optional<zonal::MaterialTable> whole_;
  std::optional<zonal::KeptTable> kept_;
};

std::size_t bytes_of(const zonal::MaterialTable& table);

/// A material with a texture of colours or a relief: its body and the rest apart, since what it reflects is rest +
/// colour body. The tables are for HVL.
struct MaterialParts : BodyAndRest {
  std::optional<ReceivingTable> receiving;  // of the body, where the texture is white
  std::optional<zonal::MaterialTable> emitting;
};

/// A scene's materials as the method needs them; what it does not need is empty. For HVL, windowed for the bands with
/// which a receiver reads them, and for those of a virtual light's emission; of materials in parts, the rest.
struct MaterialTables {
  std::vector<ReceivingTable> receiving;
  std::vector<zonal::MaterialTable> emitting;
  std::vector<zonal::ZonalTable> zonal;
  /// Null for isotropic materials; those of the others fill themselves, and what stands above for them is black.
  std::vector<std::shared_ptr<const zonal::AnisotropicTable>> anisotropic;
  std::map<std::uint32_t, MaterialParts> parts;  // by the material's number
  double error = 0.0;  // greatest of the isotropic projections, of each table's largest coefficient

  /// What those of HVL take, anisotropic ones aside.
  std::size_t bytes() const;
};

MaterialTables project_materials(const std::vector<Material>& materials, const Options& options);

/// One virtual light where each ray of the spotlight's square map lands, with its radius set. Rays that find no
/// surface, or carry no light, leave one without flux.
struct VirtualLightMap {
  int side = 0;
  std::vector<zonal::VirtualLight> lights;  // row by row; of materials in parts, what the rest sends,
  std::vector<zonal::VirtualLight> bodies;  // and here what the body does; empty where there are none
};

/// The greatest map of the options' method, as the square root of --lights.
int greatest_side(const Options& options);

VirtualLightMap shoot_virtual_lights(const Scene& scene, const RayCaster& caster, const MaterialTables& tables,
                                     const Options& options);

inline bool is_lit(const zonal::VirtualLight& light) { return light.flux != glm::vec3(0.0f); }

/// Those that carry light.
std::vector<zonal::VirtualLight> lit(const VirtualLightMap& map);

}  // namespace example::hvl_render
