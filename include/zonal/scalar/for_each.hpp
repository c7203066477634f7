// Loops that a caller may spread over threads: whoever takes one calls for_each(count, body).
#pragma once

#include "target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// for_each(count, body): calls body(0), ..., body(count - 1). Pass your own to spread the work over threads;
/// the calls are independent, in any order.
struct SerialForEach {
  template <class Body>
  void operator()(int count, const Body& body) const {
    for (int i = 0; i < count; ++i) body(i);
  }
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
