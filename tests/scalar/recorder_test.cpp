// What a Recording keeps and counts. That running it gives what the kernel gives: kernels/every_scalar_test.cpp.

#include <zonal/basis/evaluate.hpp>
#include <zonal/basis/polynomial.hpp>
#include <zonal/scalar/recorder.hpp>

#include <array>
#include <vector>

#include "../catch.hpp"

namespace {

using zonal::OperationCount;
using zonal::Recorder;
using zonal::Recording;

std::array<Recorder, 3> inputs(Recording& recording) {
  return {recording.input("x"), recording.input("y"), recording.input("z")};
}

OperationCount count(const Recording& recording, const std::vector<Recorder>& outputs) {
  return recording.count(outputs.begin(), outputs.end());
}

}  // namespace

TEST_CASE("Constants combine, and x+0, x-0, x*1 and x/1 are x, and x*0 is 0") {
  Recording recording;
  const Recorder x = recording.input("x");
  const Recorder sum = Recorder(2) * Recorder(3) + Recorder(4) / Recorder(8) - sqrt(Recorder(4));
  REQUIRE(sum.is_constant());
  CHECK(sum.constant() == 4.5F);
  CHECK(minimum(Recorder(1), Recorder(2)).constant() == 1);
  CHECK(maximum(Recorder(1), Recorder(2)).constant() == 2);
  CHECK(abs(Recorder(-1)).constant() == 1);
  CHECK((-Recorder(1)).constant() == -1);
  CHECK(select(Recorder(1) < Recorder(2), x, Recorder(5)).line() == x.line());
  CHECK(select(Recorder(2) <= Recorder(1), x, Recorder(5)).constant() == 5);
  for (const Recorder& same :
       {x + Recorder(0), Recorder(0) + x, x - Recorder(0), x * Recorder(1), Recorder(1) * x, x / Recorder(1)}) {
    CHECK(same.line() == x.line());
  }
  CHECK((x * Recorder(0)).is_constant());
  CHECK((Recorder(0) * x).constant() == 0);
  CHECK(recording.lines().size() == 1);
}

TEST_CASE("An operation written before on the same operands is not written again") {
  Recording recording;
  const auto [x, y, z] = inputs(recording);
  CHECK((x * y).line() == (y * x).line());
  CHECK((x + y).line() == (y + x).line());
  CHECK((x - y).line() != (y - x).line());
  CHECK((x / y).line() != (y / x).line());
  CHECK((x * y).line() != (x * z).line());
  CHECK((x * Recorder(2)).line() == (Recorder(2) * x).line());
  CHECK((x * Recorder(2)).line() != (x * Recorder(3)).line());
  CHECK((x < y).flag.line() == (y > x).flag.line());
  CHECK((x < y).flag.line() != (x <= y).flag.line());
}

TEST_CASE("Each operation counts as its kind") {
  Recording recording;
  const auto [x, y, z] = inputs(recording);
  const OperationCount c = count(recording, {-x, x + y, x - y, x * y, x / y, sqrt(x), minimum(x, y), maximum(x, y),
                                             abs(x), select(x < y, x, y), select(x <= y, x, z)});
  CHECK(c.additions == 3);
  CHECK(c.multiplications == 1);
  CHECK(c.divisions == 1);
  CHECK(c.functions == 1);
  CHECK(c.comparisons == 7);
  CHECK(c.total() == 13);
}

TEST_CASE("Additions count as fused with a product that nothing else needs, one product each") {
  const auto fused = [](auto expression) {
    Recording recording;
    const auto [x, y, z] = inputs(recording);
    return count(recording, expression(x, y, z)).fused;
  };
  using Outputs = std::vector<Recorder>;
  CHECK(fused([](auto x, auto y, auto z) { return Outputs{x * y + z}; }) == 1);
  CHECK(fused([](auto x, auto y, auto z) { return Outputs{z - x * y}; }) == 1);
  CHECK(fused([](auto x, auto y, auto z) { return Outputs{x * y + y * z}; }) == 1);
  CHECK(fused([](auto x, auto y, auto z) { return Outputs{x * y + z, x * y}; }) == 0);
  CHECK(fused([](auto x, auto y, auto z) { return Outputs{x * y + z, x * y - z}; }) == 0);
  CHECK(fused([](auto x, auto y, auto z) { return Outputs{(x + y) * z}; }) == 0);
  CHECK(fused([](auto x, auto y, auto z) { return Outputs{-(x * y), x + z}; }) == 0);
}

TEST_CASE("evaluate<5> takes the operations that one counts by hand, and no more than asked for") {
  Recording recording;
  const auto y = zonal::evaluate<5>(inputs(recording));
  const OperationCount all = recording.count(y.begin(), y.end());
  CAPTURE(all.additions, all.multiplications);
  // Multiplications: z^2; 4 in each of 3 steps to (x+iy)^m, but x*y and y*x are one; the polynomials in z, 7 at m = 0,
  // 4 at 1, 2 at 2 and 1 at 3; two for each pair of values with m > 0. Additions: 2 in each step, and 3, 2 and 1.
  CHECK(all.divisions + all.functions + all.comparisons == 0);
  CHECK(all.multiplications == 1 + 11 + (7 + 4 + 2 + 1) + 20);
  CHECK(all.additions == 2 * 3 + (3 + 2 + 1));
  CHECK(all.fused == all.additions - 1);  // all but x y + y x

  std::vector<Recorder> even, degree_2;
  for (int l = 0; l < 5; ++l) {
    for (int m = 0; m <= l; ++m) even.push_back(y(l, m));
  }
  for (int m = -2; m <= 2; ++m) degree_2.push_back(y(2, m));
  CHECK(count(recording, even).total() < all.total());
  CHECK(count(recording, degree_2).total() < count(recording, even).total());
  CHECK(count(recording, {y(0, 0)}).total() == 0);
  CHECK(count(recording, {}).total() == 0);

  Recording slow;
  const auto polynomial = zonal::reference::evaluate_polynomial<5>(inputs(slow));
  CHECK(all.total() < slow.count(polynomial.begin(), polynomial.end()).total());
}
