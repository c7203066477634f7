// Bounds of rounding errors, proved.
//
// A computed result is f(p, e_1 .. e_n): each operation gives its exact result plus an e_i of at most half an ulp; each
// constant is off by a known e_i. By the mean value theorem f(p, e) - f(p, 0) is the sum of e_i df/de_i, taken at some
// e between: so it is at most the sum of max|e_i| max|df/de_i|, both over all p of a cell and all such e. Values come
// from intervals forwards, derivatives from intervals backwards; no term is left out, there is no remainder.
//
// - Inputs count as exact. What is exact has no e: a sign, a choice, a doubling, a difference of numbers within a
// factor
//   of two (Sterbenz), which is not relied on where it could be fused with a product.
// - A compiler may fuse a product and a sum: the product's e is then 0 in that sum, which the bound covers, for where
//   several sums use a product each counts for itself. It may not sum in another order.
// - The exact result chooses as the computed one did, as in a Shadow. Where a comparison is open over a cell, the cell
//   is bounded with either answer.
#pragma once

#include <vector>

#include "centred.hpp"
#include "subject.hpp"

namespace zonal_prove {

/// A part of the domain: a box of parameters, and the signs that its inputs have.
struct Part {
  Cell cell;
  std::array<int, 3> signs{1, 1, 1};
};

/// Parts that together are the whole domain, but for what symmetry gives: a kernel in which a change of sign of an
/// input changes nothing but signs needs one of them.
std::vector<Part> whole_domain(const Subject& subject, double greatest);

/// Bounds one part after the other.
class Prover {
 public:
  explicit Prover(const Subject& subject);
  /// The greatest error of any output over the part, in the subject's unit.
  double bound(const Part& part);
  /// Where the inputs lie.
  std::vector<Interval> ranges(const Part& part);

 private:
  void set_inputs(const Part& part);
  double bound_choices(int depth);
  void run_forwards();
  double error_of(int output);
  void hand_on(std::size_t node);
  void give(int node, const Centred& share);
  double unit_of(std::size_t output) const;

  const Subject& subject_;
  CellOffsets offsets_{};
  std::vector<Centred> values_, worth_;
  std::vector<double> errors_;   // max|e| by node
  std::vector<double> handed_;   // of products that several users have: the sum of what each may hand on
  std::vector<char> is_shared_;  // a product with several users, of which one may be fused
  std::vector<char> is_reached_;
  static constexpr char unknown = 2;
  std::vector<char> answers_;  // of comparisons: 0 or 1 where it is assumed
  int open_ = -1;              // the first comparison that is open
};

/// Either half of a part.
std::array<Part, 2> halves(const Part& part);

struct Proof {
  double bound = 0;
  Part worst{};
  long parts = 0;
};

/// As low a bound over the whole domain as so many parts give: the worst part is halved again and again.
Proof lowest_bound(const Subject& subject, double greatest, long parts);

/// Whether all parts, or those of every `stride`-th of so many, starting with `first`, have errors of at most `bound`.
/// Halves a part up to `depth` times.
struct Check {
  bool holds = true;
  Part failed{};
  long parts = 0;
};
Check check_bound(const Subject& subject, double greatest, double bound, int depth, long stride = 1, long first = 0);

}  // namespace zonal_prove
