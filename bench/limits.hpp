// What one thread of the processor can do at best, measured; what kernels cannot do without; and which of the two
// binds.
#pragma once

#include <zonal/scalar/recorder.hpp>

#include "report/timing.hpp"

namespace zonal_bench {

/// ns for one register of the target each, of operations that do not wait for each other.
struct Limits {
  double multiply;      // alone, or fused with an addition
  double operation;     // of any kind: multiply-adds and additions by turns
  double divide, root;  // which one unit does
  double load, store;   // of the first-level cache
};

/// Medians.
Limits measure_limits(const zonal_report::Repetitions& repetitions);

/// What a kernel cannot do without, for each register of lanes: operations, and how many registers its inputs and
/// results are. Constants, and values that registers have no room for, are read and written too: they do not count.
struct Work {
  zonal::OperationCount count;
  double loads = 0, stores = 0;
};

/// The limit that binds, and how many ns for each register it asks for: no kernel takes less.
struct Bound {
  const char* name;
  double ns;
};
Bound find_bound(const Limits& limits, const Work& work);

}  // namespace zonal_bench
