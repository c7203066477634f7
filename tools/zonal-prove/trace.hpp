// A scalar that writes down what a kernel does, an operation a node, for a proof of its rounding error: constants as
// exact as there are, and nothing folded or shared, so that each rounding has a node of its own.
//
// A Recorder (scalar/recorder.hpp) writes down a shader function instead: constants as floats, and those folded.
#pragma once

#include <zonal/scalar/recorder.hpp>
#include <zonal/scalar/scalar.hpp>

#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace zonal_prove {

using zonal::Operation;

struct Node {
  Operation operation;
  int operands[3];       // numbers of nodes; -1 where unused
  long double constant;  // of Operation::constant, before it is rounded
};

struct Trace {
  int digits = 0, least_exponent = 0;  // of the scalar: half an ulp is never below 2^(least_exponent - 1)
  std::vector<Node> nodes;
  std::vector<int> inputs, outputs;

  int append(Operation operation, int a = -1, int b = -1, int c = -1, long double constant = 0) {
    nodes.push_back({operation, {a, b, c}, constant});
    return static_cast<int>(nodes.size()) - 1;
  }
};

/// `Lane`: float or double, whose digits a kernel chooses its series by.
template <class Lane>
class Traced {
 public:
  inline static thread_local Trace* trace = nullptr;  // where operations go

  Traced() = default;
  template <class C, class = std::enable_if_t<std::is_arithmetic_v<C>>>
  explicit Traced(C constant)
      : node_(trace->append(Operation::constant, -1, -1, -1, static_cast<long double>(constant))) {}

  static Traced input() {
    const Traced result = from(trace->append(Operation::input));
    trace->inputs.push_back(result.node_);
    return result;
  }
  static Traced of(Operation operation, const Traced& a) { return from(trace->append(operation, a.node_)); }
  static Traced of(Operation operation, const Traced& a, const Traced& b) {
    return from(trace->append(operation, a.node_, b.node_));
  }
  struct Mask {
    Traced flag;
  };
  int node() const { return node_; }

  Traced operator-() const { return of(Operation::negate, *this); }
  friend Traced operator+(const Traced& a, const Traced& b) { return of(Operation::add, a, b); }
  friend Traced operator-(const Traced& a, const Traced& b) { return of(Operation::subtract, a, b); }
  friend Traced operator*(const Traced& a, const Traced& b) { return of(Operation::multiply, a, b); }
  template <class C, class = std::enable_if_t<std::is_arithmetic_v<C>>>
  friend Traced operator*(C constant, const Traced& b) {
    return Traced(constant) * b;
  }
  friend Traced operator/(const Traced& a, const Traced& b) { return of(Operation::divide, a, b); }
  friend Traced minimum(const Traced& a, const Traced& b) { return of(Operation::minimum, a, b); }
  friend Traced maximum(const Traced& a, const Traced& b) { return of(Operation::maximum, a, b); }
  friend Traced abs(const Traced& a) { return of(Operation::absolute, a); }
  friend Traced sqrt(const Traced& a) { return of(Operation::square_root, a); }
  friend Mask operator<(const Traced& a, const Traced& b) { return {of(Operation::less, a, b)}; }
  friend Mask operator<=(const Traced& a, const Traced& b) { return {of(Operation::less_equal, a, b)}; }
  friend Mask operator>(const Traced& a, const Traced& b) { return b < a; }
  friend Mask operator>=(const Traced& a, const Traced& b) { return b <= a; }
  friend Traced select(const Mask& mask, const Traced& a, const Traced& b) {
    return from(trace->append(Operation::select, mask.flag.node_, a.node_, b.node_));
  }

 private:
  static Traced from(int node) {
    Traced result;
    result.node_ = node;
    return result;
  }
  int node_;
};

}  // namespace zonal_prove

namespace zonal {
inline namespace ZONAL_TARGET {
template <class L>
struct ScalarTraits<zonal_prove::Traced<L>> {
  using Lane = L;
};
}  // namespace ZONAL_TARGET
}  // namespace zonal
