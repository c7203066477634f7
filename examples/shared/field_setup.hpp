#pragma once

#include <optional>
#include <vector>

#include "emitter.hpp"
#include "names.hpp"
#include "scene.hpp"

namespace example {

/// The two set-ups of [1], Fig. 8: an area light in the ceiling and a projector of four coloured squares; and a red
/// spotlight, half of it behind a board, a projector of a cone of white light, and a little stray light.
///
/// [1] Loew, Ynnerman, Larsson, Unger, HDR light probe sequence resampling for realtime incident light field rendering,
///     SCCG 2009.
enum class FieldSetup { projector, spots };
inline const Names<FieldSetup> field_setup_names{{"projector", FieldSetup::projector}, {"spots", FieldSetup::spots}};

/// Of --box.
inline const std::string field_box_help =
    "of the volume, in metres, that probes stand in and lamps are placed about; without it a cube near the middle of "
    "the "
    "scene";

/// The volume that probes stand in: the one that is asked for, or one near the middle of the scene, a metre wide in the
/// built-in hall. Throws InputError where it is none.
Bounds field_box(const Scene& scene, const std::optional<Bounds>& box);

/// The lamps of a set-up, placed about the box; what blocks light is added to the scene.
std::vector<Emitter> set_up_field(FieldSetup setup, const Bounds& box, Scene& scene);

}  // namespace example
