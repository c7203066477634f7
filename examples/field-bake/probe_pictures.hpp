#pragma once

#include <zonal/field/buckets.hpp>
#include <zonal/field/sequence.hpp>

#include "shared/image_file.hpp"
#include "shared/interrupt.hpp"

namespace example::field_bake {

/// Pictures of a sequence, one at a time, as the library takes them: load(probe, use). Throws InputError, also where a
/// picture is of no mapping, and Interrupted.
class ProbePictures {
 public:
  explicit ProbePictures(const zonal::ProbeSequence& sequence) : sequence_(sequence) {}

  template <class Use>
  void operator()(const zonal::SequenceProbe& probe, const Use& use) const {
    throw_if_interrupted();
    const Image picture = read_picture(probe.picture);
    use(environment(probe, picture));
  }

  /// The buckets of a sequence: the texels of its first picture.
  zonal::DirectionBuckets buckets() const;

 private:
  zonal::Environment<float> environment(const zonal::SequenceProbe& probe, const Image& picture) const;

  const zonal::ProbeSequence& sequence_;
};

}  // namespace example::field_bake
