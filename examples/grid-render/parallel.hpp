#pragma once

#include <tbb/parallel_for.h>

#include "shared/interrupt.hpp"

namespace example::grid_render {

/// body(0), ..., body(count - 1) on all threads; throws Interrupted soon after Ctrl-C.
template <class Body>
void for_each_in_parallel(int count, const Body& body) {
  tbb::parallel_for(0, count, [&](int i) {
    if (!stop_requested()) body(i);
  });
  throw_if_interrupted();
}

}  // namespace example::grid_render
