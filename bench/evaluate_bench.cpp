// The basis at a direction: the recurrences, the explicit polynomials, and the sum over the basis without an array.

#include <zonal/basis/evaluate.hpp>
#include <zonal/basis/polynomial.hpp>

#include "bench.hpp"

namespace zonal_bench {
namespace {

struct OfDirection {
  static constexpr int inputs = 3;
  static auto draw(Random& random) { return random_direction(random); }
};

template <int N>
struct Evaluate : OfDirection {
  template <class T>
  static auto run(const std::array<T, 3>& direction) {
    return zonal::evaluate<N>(direction);
  }
};

template <int N>
struct Polynomial : OfDirection {
  template <class T>
  static auto run(const std::array<T, 3>& direction) {
    return zonal::reference::evaluate_polynomial<N>(direction);
  }
};

}  // namespace

void register_evaluate(const Effort& effort) {
  register_kernels<Evaluate, 10>("evaluate", effort);
  register_kernel<Evaluate<21>>("evaluate", 21, effort);
  register_kernel<Evaluate<32>>("evaluate", 32, effort);
  register_kernels<Polynomial, 10>("polynomial", effort);
}

}  // namespace zonal_bench
