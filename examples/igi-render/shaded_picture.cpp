#include "shaded_picture.hpp"

#include <array>
#include <chrono>

#include <tbb/parallel_for.h>

#include <zonal/screen/filter.hpp>
#include <zonal/screen/moments.hpp>
#include <zonal/screen/shade.hpp>
#include <zonal/transform/window.hpp>

#include "option_names.hpp"
#include "shared/frame.hpp"

namespace example::igi_render {
namespace {

using Lanes = zonal::LightSet::Lanes;

double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <int N>
glm::vec3 shade(const ScreenScene& screen, const Hit& hit, const zonal::Sh<N, glm::vec3>& radiance,
                zonal::Window window = zonal::Window::none) {
  const glm::vec3 outgoing = towards_camera(screen.scene, hit);
  const auto row = screen.materials[hit.material].row<N>(hit.colour, glm::dot(hit.normal, outgoing), window);
  return zonal::reflected_radiance(zonal::in_shading_frame(radiance, hit.normal, outgoing), row);
}

/// What the light that arrives makes of a hit's material, by the material itself: of its body, white where it has a
/// texture, and of the rest.
class ReflectedSum {
 public:
  ReflectedSum(const ScreenScene& screen, const Hit& hit)
      : material_(screen.materials[hit.material]),
        outgoing_(Frame(hit.normal).to_local(towards_camera(screen.scene, hit))) {
    const Frame frame(hit.normal);
    for (int i = 0; i < 3; ++i) axes_[i] = frame.to_world(glm::vec3(i == 0, i == 1, i == 2));
    for (auto& part : sums_) part[0] = part[1] = part[2] = Lanes(0);
  }

  void operator()(const zonal::Arrival<Lanes>& arrival) {
    const auto along = [&](const glm::vec3& axis) {
      return arrival.direction[0] * Lanes(axis.x) + arrival.direction[1] * Lanes(axis.y) +
             arrival.direction[2] * Lanes(axis.z);
    };
    const glm::vec<3, Lanes> incoming(along(axes_[0]), along(axes_[1]), along(axes_[2]));
    const Lanes cosine = maximum(incoming.z, Lanes(0));
    const zonal::Brdf* const parts[] = {&material_.body, &material_.rest};
    for (int part = 0; part < 2; ++part) {
      if (parts[part]->lobes.empty()) continue;
      const glm::vec<3, Lanes> f = zonal::evaluate(*parts[part], incoming, glm::vec<3, Lanes>(outgoing_));
      for (int c = 0; c < 3; ++c) sums_[part][c] = sums_[part][c] + f[c] * arrival.irradiance[c] * cosine;
    }
  }
  glm::vec3 body() const { return total(0); }
  glm::vec3 rest() const { return total(1); }

 private:
  glm::vec3 total(int part) const { return {sums_[part][0].sum(), sums_[part][1].sum(), sums_[part][2].sum()}; }

  const SplitMaterial& material_;
  glm::vec3 axes_[3];  // of the normal's frame
  glm::vec3 outgoing_;
  Lanes sums_[2][3];
};

// ---- What is filtered: a value of a position, made of sums over lights, kept in a picture, and how it is shaded
// ------

template <int N>
struct Coefficients {
  template <class Element>
  using Picture = zonal::RadiancePicture<N, Element>;
  static zonal::RadianceSum<N> sum(const ScreenScene&, const Hit&) { return {}; }
  static zonal::Sh<N, glm::vec3> value(const zonal::RadianceSum<N>& sum) { return sum.radiance(); }
  static glm::vec3 shaded(const ScreenScene& screen, const Hit& hit, const zonal::Sh<N, glm::vec3>& radiance) {
    return shade(screen, hit, radiance, screen.options.window);
  }
};

using Pair = std::array<glm::vec3, 2>;

/// Six numbers at each position.
template <class Element>
class PairPicture : public zonal::PlanePicture<Element> {
 public:
  PairPicture(int width, int height) : zonal::PlanePicture<Element>(width, height, 6) {}

  Pair at(int x, int y) const {
    Pair pair;
    for (int i = 0; i < 6; ++i) pair[std::size_t(i / 3)][i % 3] = this->get(x, y, i);
    return pair;
  }
  void set_at(int x, int y, const Pair& pair) {
    for (int i = 0; i < 6; ++i) this->set(x, y, i, pair[std::size_t(i / 3)][i % 3]);
  }
};

struct Reflected {
  template <class Element>
  using Picture = PairPicture<Element>;
  static ReflectedSum sum(const ScreenScene& screen, const Hit& hit) { return {screen, hit}; }
  static Pair value(const ReflectedSum& sum) { return {sum.body(), sum.rest()}; }
  static glm::vec3 shaded(const ScreenScene&, const Hit& hit, const Pair& light) {
    return hit.colour * light[0] + light[1];
  }
};

template <bool as_gaussian>
struct Moments {
  template <class Element>
  using Picture = PairPicture<Element>;
  static constexpr int gaussian_bands = 9;
  static zonal::MomentSum sum(const ScreenScene&, const Hit&) { return {}; }
  static Pair value(const zonal::MomentSum& sum) {
    const zonal::RadianceMoments moments = sum.moments();
    return {moments.total, moments.vector};
  }
  static glm::vec3 shaded(const ScreenScene& screen, const Hit& hit, const Pair& light) {
    const zonal::RadianceMoments moments{light[0], light[1]};
    if constexpr (as_gaussian) return shade(screen, hit, moments.as_gaussian<gaussian_bands>());
    if constexpr (!as_gaussian) return shade(screen, hit, moments.as_first_degree());
  }
};

// ---- Passes ---------------------------------------------------------------------------------------------------------

/// body(x, y) for every position, on all threads.
template <class Body>
void for_each_position(const ScreenScene& screen, const Stage& stage, const Body& body) {
  const auto width = static_cast<std::size_t>(screen.width);
  for_each_pixel(screen.hits.pixel_count(), stage,
                 [&](std::size_t pixel) { body(static_cast<int>(pixel % width), static_cast<int>(pixel / width)); });
}

template <class Sum>
void sum_light(const ScreenScene& screen, const Hit& hit, const zonal::LightSet& set, Sum& sum) {
  const auto visible = [&](const glm::vec3& direction, float distance) {
    return screen.sees(hit, direction, distance);
  };
  zonal::for_each_arrival(set, hit.position, hit.geometric_normal, screen.least_distance, visible,
                          [&](const auto& arrival) { sum(arrival); });
}

/// What a position shows beside the light that it reflects.
glm::vec3 seen(const ScreenScene& screen, int x, int y) {
  const std::optional<Hit>& hit = screen.hit_at(x, y);
  if (hit) return screen.scene.materials[hit->material].emission;
  if (screen.probe == nullptr) return glm::vec3(0.0f);
  const CameraRays rays(screen.scene.camera, screen.width, screen.height);
  return screen.probe->radiance(rays.direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f));
}

/// The picture of all positions, each the sum of what it shows and radiance(x, y, hit); positions become pixels.
template <class Radiance>
Image make_picture(const ScreenScene& screen, const Stage& stage, const Radiance& radiance) {
  Image picture(screen.width, screen.height);
  for_each_position(screen, stage, [&](int x, int y) {
    const std::optional<Hit>& hit = screen.hit_at(x, y);
    picture.at(x, y) = seen(screen, x, y) + (hit ? radiance(x, y, *hit) : glm::vec3(0.0f));
  });
  if (screen.options.antialias == 1) return picture;
  return resample(picture, screen.options.width, screen.options.height);
}

template <class Quantity, class Element>
Pass pass_of(const ScreenScene& screen, Filter filter, Progress& progress) {
  Pass pass{name_of(filter_names, filter)};
  const double cost = pass_cost(screen) / static_cast<double>(screen.hits.pixel_count());
  typename Quantity::template Picture<Element> values(screen.width, screen.height);
  pass.numbers = values.planes();
  pass.bytes = values.bytes();
  pass.light_seconds = seconds_of([&] {
    for_each_position(screen, {progress, pass.name.c_str(), cost}, [&](int x, int y) {
      const std::optional<Hit>& hit = screen.hit_at(x, y);
      if (!hit) return;
      auto sum = Quantity::sum(screen, *hit);
      sum_light(screen, *hit, screen.sets[static_cast<std::size_t>(screen.options.pattern.set_of(x, y))], sum);
      values.set_at(x, y, Quantity::value(sum));
    });
  });
  if (filter != Filter::none) {
    const bool strict = filter == Filter::irradiance_strict;
    const zonal::SurfacePicture as_shaded =
        strict ? make_surfaces(screen.hits, screen.width, screen.height, true) : zonal::SurfacePicture();
    pass.filter_seconds = seconds_of([&] {
      zonal::filter(values, strict ? as_shaded : screen.surfaces, screen.options.pattern, screen.options.tests,
                    [](int count, const auto& body) { tbb::parallel_for(0, count, body); });
    });
  }
  pass.shading_seconds = seconds_of([&] {
    pass.picture = make_picture(screen, {progress, pass.name.c_str(), 0.0}, [&](int x, int y, const Hit& hit) {
      return Quantity::shaded(screen, hit, values.at(x, y));
    });
  });
  return pass;
}

template <class Quantity>
Pass pass_of(const ScreenScene& screen, Filter filter, Progress& progress) {
  return screen.options.half ? pass_of<Quantity, zonal::Half>(screen, filter, progress)
                             : pass_of<Quantity, float>(screen, filter, progress);
}

/// call(Bands<N>) for the options' number of bands.
template <int N>
using Bands = std::integral_constant<int, N>;
template <class Call>
auto with_bands(int bands, const Call& call) {
  switch (bands) {  // what --bands offers
    case 2: return call(Bands<2>{});
    case 4: return call(Bands<4>{});
    case 5: return call(Bands<5>{});
    default: return call(Bands<3>{});
  }
}

template <int N>
Reference reference_of(const ScreenScene& screen, Progress& progress) {
  Reference reference{{"reference"}, {"truncated"}};
  const double cost = reference_cost(screen) / static_cast<double>(screen.hits.pixel_count());
  const float share = 1.0f / static_cast<float>(screen.sets.size());
  std::vector<glm::vec3> truncated(screen.hits.pixel_count());
  const auto index = [&](int x, int y) { return static_cast<std::size_t>(y * screen.width + x); };
  reference.exact.light_seconds = seconds_of([&] {
    const Stage stage{progress, "reference", cost};
    reference.exact.picture = make_picture(screen, stage, [&](int x, int y, const Hit& hit) {
      ReflectedSum exact(screen, hit);
      zonal::RadianceSum<N> coefficients;
      const auto both = [&](const auto& arrival) {
        exact(arrival);
        coefficients(arrival);
      };
      for (const zonal::LightSet& set : screen.sets) sum_light(screen, hit, set, both);
      truncated[index(x, y)] = shade(screen, hit, coefficients.radiance() * share, screen.options.window);
      return (hit.colour * exact.body() + exact.rest()) * share;
    });
  });
  reference.truncated.picture = make_picture(screen, {progress, "reference", 0.0},
                                             [&](int x, int y, const Hit&) { return truncated[index(x, y)]; });
  return reference;
}

double lights_of(const ScreenScene& screen) {
  double count = 0.0;
  for (const zonal::LightSet& set : screen.sets) count += set.size();
  return count;
}

}  // namespace

double pass_cost(const ScreenScene& screen) {
  return static_cast<double>(screen.hits.pixel_count()) * (1.0 + lights_of(screen) / double(screen.sets.size()));
}
double reference_cost(const ScreenScene& screen) {
  return static_cast<double>(screen.hits.pixel_count()) * (1.0 + lights_of(screen));
}

Pass filtered_pass(const ScreenScene& screen, Filter filter, Progress& progress) {
  switch (filter) {
    case Filter::irradiance:
    case Filter::irradiance_strict: return pass_of<Reflected>(screen, filter, progress);
    case Filter::gaussian: return pass_of<Moments<true>>(screen, filter, progress);
    case Filter::first_degree: return pass_of<Moments<false>>(screen, filter, progress);
    default: break;
  }
  return with_bands(screen.options.bands, [&](auto bands) {
    return pass_of<Coefficients<decltype(bands)::value>>(screen, filter, progress);
  });
}

Reference reference_pass(const ScreenScene& screen, Progress& progress) {
  return with_bands(screen.options.bands,
                    [&](auto bands) { return reference_of<decltype(bands)::value>(screen, progress); });
}

}  // namespace example::igi_render
