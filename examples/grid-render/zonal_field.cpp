#include "zonal_field.hpp"

#include <vector>

#include <glm/gtc/constants.hpp>

#include "band_list.hpp"
#include "light_packet.hpp"

namespace example::grid_render {
namespace {

using Packets = std::vector<LightPacket<zonal::SphereLight<float>>>;

/// The light that a lobe about the axis reflects, per albedo.
template <int N>
glm::vec3 reflected_by(const zonal::Zh<N, float>& lobe, const glm::vec3& axis, const Packets& packets,
                       const glm::vec3& position) {
  const Lanes x(position.x), y(position.y), z(position.z);
  const Lanes a[3] = {Lanes(axis.x), Lanes(axis.y), Lanes(axis.z)};
  Lanes sum[3] = {Lanes(0), Lanes(0), Lanes(0)};
  for (const auto& packet : packets) {
    const auto sight = zonal::detail::sight(packet.light, x, y, z);
    const auto factors = packet.light.template profile<N>(sight).value;
    const Lanes cosine = zonal::clamp(zonal::detail::dot3(sight.direction, a), Lanes(-1), Lanes(1));
    Lanes integral(0);
    zonal::evaluate_zonal<N>(cosine, [&](auto l, const Lanes& basis) ZONAL_INLINE {
      zonal::add_product(integral, factors.values[l] * Lanes(lobe.values[l]), basis);
    });
    integral = integral * maximum(cosine, Lanes(0));
    for (std::size_t c = 0; c < 3; ++c) zonal::add_product(sum[c], integral, packet.colour[c]);
  }
  return {sum[0].sum(), sum[1].sum(), sum[2].sum()};
}

template <int N>
class ZonalField final : public LightField {
 public:
  explicit ZonalField(const SphereLights& lights) : packets_(packets_of(lights)) {}

  glm::vec3 reflected(const Hit& hit, const glm::vec3& outgoing, const Reflector& reflector) const override {
    const auto diffuse = [&](const glm::vec3& normal) {
      const zonal::Zh<1, float> lambert{{2.0f / glm::root_pi<float>()}};  // 1 / pi
      return reflected_by(lambert, normal, packets_, hit.position);
    };
    const auto glossy = [&](const GlossyLobe& lobe, const glm::vec3& mirrored) {
      return reflected_by(first_bands<N>(lobe.without_cosine), mirrored, packets_, hit.position);
    };
    return sum_of_lobes(hit, outgoing, reflector, diffuse, glossy);
  }

 private:
  Packets packets_;
};

}  // namespace

std::unique_ptr<LightField> make_zonal_field(const SphereLights& lights, int bands) {
  std::unique_ptr<LightField> field;
  AllBands::dispatch(bands, [&](auto n) { field = std::make_unique<ZonalField<n>>(lights); });
  return field;
}

}  // namespace example::grid_render
