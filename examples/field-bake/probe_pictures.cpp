#include "probe_pictures.hpp"

#include <stdexcept>

#include <zonal/environment/guess.hpp>

#include "shared/input_error.hpp"

namespace example::field_bake {

zonal::Environment<float> ProbePictures::environment(const zonal::SequenceProbe& probe, const Image& picture) const {
  const auto* const numbers = reinterpret_cast<const float*>(picture.pixels.data());
  const zonal::Picture<const float> view(numbers, picture.width, picture.height);
  try {
    if (!sequence_.mapping) return zonal::guess_environment(view);
    return {view, *sequence_.mapping, double(sequence_.dead_angle)};
  } catch (const std::invalid_argument& error) {
    throw InputError(probe.picture.string() + ": " + error.what());
  }
}

zonal::DirectionBuckets ProbePictures::buckets() const {
  const zonal::SequenceProbe& first = sequence_.probes.front();
  const Image picture = read_picture(first.picture);
  const zonal::Environment<float> view = environment(first, picture);
  return {view.mapping(), view.width(), view.height(), sequence_.orientation_of(first)};
}

}  // namespace example::field_bake
