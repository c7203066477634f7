#pragma once

#include "options.hpp"
#include "shared/names.hpp"

namespace example::field_capture {

inline const Names<Layout> layout_names{{"grid", Layout::grid}, {"planes", Layout::planes}, {"random", Layout::random}};

inline const Names<zonal::DeadAngle> dead_angle_names{{"black", zonal::DeadAngle::black},
                                                      {"missing", zonal::DeadAngle::missing}};

/// As in environment/mapping.hpp, with hyphens.
inline const Names<zonal::Mapping>& mapping_names() {
  static const Names<zonal::Mapping> names = [] {
    Names<zonal::Mapping> list;
    for (int i = 0; i < zonal::kMappingCount; ++i) {
      const auto mapping = static_cast<zonal::Mapping>(i);
      std::string name = zonal::mapping_name(mapping);
      std::replace(name.begin(), name.end(), ' ', '-');
      list.emplace_back(name, mapping);
    }
    return list;
  }();
  return names;
}

}  // namespace example::field_capture
