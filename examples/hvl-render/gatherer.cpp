#include "gatherer.hpp"

#include <zonal/gather/vpl.hpp>
#include <zonal/gather/vsgl.hpp>
#include <zonal/gather/vsl.hpp>

#include "gather_hvl.hpp"
#include "random.hpp"
#include "shared/input_error.hpp"

namespace example::hvl_render {

extern template std::unique_ptr<Gatherer> make_hvl<zonal::Horizon::smoothstep>(const GatherInput& input);
extern template std::unique_ptr<Gatherer> make_hvl<zonal::Horizon::exact>(const GatherInput& input);
std::unique_ptr<Gatherer> make_hvl_zonal(const GatherInput& input);

namespace {

class VplGatherer final : public Gatherer {
 public:
  explicit VplGatherer(const GatherInput& input) : input_(input), cache_(lit(input.map)) {}

  glm::vec3 indirect_radiance(const Hit& hit, const glm::vec3& outgoing, std::size_t) const override {
    return gather_vpl(cache_, receiver(hit, outgoing), input_.scene.materials[hit.material].brdf,
                      input_.options.vpl_clamp, visibility(input_, hit));
  }

 private:
  GatherInput input_;
  zonal::LightCache cache_;
};

class VslGatherer final : public Gatherer {
 public:
  explicit VslGatherer(const GatherInput& input) : input_(input), cache_(lit(input.map)) {}

  glm::vec3 indirect_radiance(const Hit& hit, const glm::vec3& outgoing, std::size_t sample) const override {
    Pcg32 random(hash64(input_.options.seed) ^ static_cast<std::uint64_t>(sample));
    return gather_vsl(
        cache_, receiver(hit, outgoing), input_.scene.materials[hit.material].brdf, input_.options.vsl_samples,
        [&random] { return random.uniform(); }, visibility(input_, hit));
  }

 private:
  GatherInput input_;
  zonal::LightCache cache_;
};

class VsglGatherer final : public Gatherer {
 public:
  explicit VsglGatherer(const GatherInput& input)
      : input_(input),
        cache_(zonal::make_gaussian_lights(input.map.lights.data(), input.map.side, block_side(input.options))) {}

  glm::vec3 indirect_radiance(const Hit& hit, const glm::vec3& outgoing, std::size_t) const override {
    return gather_vsgl(cache_, receiver(hit, outgoing), input_.scene.materials[hit.material].brdf,
                       visibility(input_, hit));
  }

 private:
  GatherInput input_;
  zonal::GaussianCache cache_;
};

}  // namespace

std::unique_ptr<Gatherer> make_gatherer(const GatherInput& input) {
  std::unique_ptr<Gatherer> gatherer;
  switch (input.options.method) {
    case Method::vpl: return std::make_unique<VplGatherer>(input);
    case Method::vsl: return std::make_unique<VslGatherer>(input);
    case Method::vsgl: return std::make_unique<VsglGatherer>(input);
    case Method::hvl:
      gatherer = input.options.horizon == HorizonRule::exact ? make_hvl<zonal::Horizon::exact>(input)
                                                             : make_hvl<zonal::Horizon::smoothstep>(input);
      break;
    case Method::hvl_zonal: gatherer = make_hvl_zonal(input); break;
    case Method::path: break;
  }
  if (!gatherer) throw InputError("these numbers of bands are not compiled in");
  return gatherer;
}

std::vector<int> gather_bands() { return {compiled_bands.begin(), compiled_bands.end()}; }
std::vector<int> zonal_bands() { return {compiled_zonal_bands.begin(), compiled_zonal_bands.end()}; }
std::vector<int> emission_bands() { return {compiled_emission_bands.begin(), compiled_emission_bands.end()}; }

}  // namespace example::hvl_render
