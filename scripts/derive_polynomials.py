#!/usr/bin/env python3
"""Writes the explicit polynomial forms of the slow reference from Rodrigues' formula, in exact rational arithmetic:

    include/zonal/basis/polynomial.hpp             the real spherical harmonics
    include/zonal/basis/polynomial_gradient.hpp    their derivatives by x, y and z
    include/zonal/lobe/cap_closed_form.hpp         the zonal coefficients of a spherical cap

    scripts/derive_polynomials.py             writes all
    scripts/derive_polynomials.py --check     compares them with the files that stand there, and fails if one differs

A polynomial in one variable is the list of its coefficients, that of the power k at index k.
"""

import math
import sys
from fractions import Fraction
from pathlib import Path

BANDS = 10
COLUMNS = 120
INCLUDE = Path(__file__).resolve().parent.parent / "include" / "zonal"


def derivative(polynomial, times=1):
    for _ in range(times):
        polynomial = [k * c for k, c in enumerate(polynomial)][1:]
    return polynomial


def legendre(l):
    """P_l = 1 / (2^l l!) d^l/du^l (u^2 - 1)^l, Rodrigues."""
    power = [Fraction(0)] * (2 * l + 1)
    for k in range(l + 1):
        power[2 * k] = Fraction((-1) ** (l - k) * math.comb(l, k))
    return [c / (2**l * math.factorial(l)) for c in derivative(power, l)]


def content_and_integers(polynomial):
    """c > 0 and integers p without a common divisor, polynomial = c p."""
    denominator = math.lcm(*(Fraction(c).denominator for c in polynomial))
    integers = [int(c * denominator) for c in polynomial]
    divisor = math.gcd(*integers)
    return Fraction(divisor, denominator), [i // divisor for i in integers]


def divided_by_1_minus_u2(polynomial):
    """polynomial / (1 - u^2), which must leave no rest."""
    rest, quotient = list(polynomial), [Fraction(0)] * (len(polynomial) - 2)
    for k in reversed(range(len(quotient))):
        quotient[k] = -rest[k + 2]
        rest[k] -= quotient[k]
        rest[k + 2] += quotient[k]
    assert not any(rest)
    return quotient


def power(name, exponent):
    """A parenthesised product, or None for the power 0."""
    if exponent == 0:
        return None
    return name if exponent == 1 else "(" + " * ".join([name] * exponent) + ")"


def term_sum(terms):
    """terms: (integer coefficient, factors or None ...), written as a sum without outer parentheses."""
    text = ""
    for coefficient, *factors in terms:
        factors = [f for f in factors if f]
        assert abs(coefficient) < 2**31
        if abs(coefficient) != 1 or not factors:
            factors = [f"T({abs(coefficient)})"] + factors
        sign = "-" if coefficient < 0 else "+"
        text += f" {sign} " if text else ("-" if coefficient < 0 else "")
        text += " * ".join(factors)
    return text


def in_one_variable(integers, name):
    """The factors of an even or odd polynomial: the name, if it is odd, and the even rest; highest power first."""
    lowest = next(k for k, c in enumerate(integers) if c)
    terms = [(c, power(name, k - lowest)) for k, c in enumerate(integers) if c]
    rest = [] if terms == [(1, None)] else [f"({term_sum(reversed(terms))})"]
    return ([power(name, lowest)] if lowest else []) + rest


def in_x_and_y(m):
    """The content of Re or Im (x + iy)^|m|, and its factors: Re for m > 0, Im for m < 0."""
    n = abs(m)
    terms = [((-1) ** (k // 2) * math.comb(n, k), n - k, k) for k in range(n + 1) if k % 2 == (m < 0)]
    divisor = math.gcd(*(t[0] for t in terms))
    x_power, y_power = min(t[1] for t in terms), min(t[2] for t in terms)
    rest = [(c // divisor, power("x", i - x_power), power("y", j - y_power)) for c, i, j in terms]
    factors = [f for f in (power("x", x_power), power("y", y_power)) if f]
    return divisor, factors + ([] if len(rest) == 1 else [f"({term_sum(rest)})"])


def wrapped(first, factors):
    """`first factor * factor * ...;` in lines of COLUMNS, broken before a factor or else before a term."""
    line, lines = first + " * ".join(factors) + ";", []
    indent = " " * (len(first) - len(first.lstrip()) + 4)
    while len(line) > COLUMNS:
        depth, breaks = 0, {}
        for i, c in enumerate(line[:COLUMNS]):
            depth += (c == "(") - (c == ")")
            if c == " " and line[i + 1] in ("+-" if depth else "*") and line[i + 2] == " " and i > len(indent):
                breaks.setdefault(depth, []).append(i)
        late = [b for d in sorted(breaks) for b in [breaks[d][-1]] if b > COLUMNS // 2]
        at = late[0]
        lines.append(line[:at])
        line = indent + line[at + 1 :]
    return lines + [line]


def root(name, square):
    assert square.numerator < 2**63 and square.denominator < 2**63
    return f"{name}<{square.numerator}, {square.denominator}>"


def product(sign, square, in_z, n, part):
    """The factors of sign sqrt(square / pi) in_z(z) part((x + iy)^n), the constant first; None where it is zero."""
    if sign == 0 or not any(in_z):
        return None
    content, integers = content_and_integers(in_z)
    square *= content**2
    factors = in_one_variable(integers, "z")
    if n:
        xy_content, xy_factors = in_x_and_y(n if part == "re" else -n)
        square *= xy_content**2
        factors += xy_factors
    elif part == "im":
        return None
    return [f"T({'-' if sign < 0 else ''}{root('root_over_pi', square)})"] + factors


def parts(l, m):
    """Y_l^m = sign sqrt(square / pi) in_z(z) part((x + iy)^n)."""
    n = abs(m)
    square = Fraction(2 * l + 1, 4) * Fraction(math.factorial(l - n), math.factorial(l + n)) * (2 if m else 1)
    return (-1) ** n, square, derivative(legendre(l), n), n, "im" if m < 0 else "re"


def harmonic(l, m):
    """The factors of Y_l^m."""
    return product(*parts(l, m))


def harmonic_derivative(l, m, axis):
    """The factors of the derivative of Y_l^m, as the polynomial that it is, by x, y or z; None where it is zero."""
    sign, square, in_z, n, part = parts(l, m)
    if axis == 2:
        return product(sign, square, derivative(in_z), n, part)
    if n == 0:
        return None
    # d/dx (x + iy)^n = n (x + iy)^(n-1), and d/dy is i times that: Re becomes -Im, Im becomes Re.
    if axis == 1:
        sign, part = (-sign, "im") if part == "re" else (sign, "re")
    return product(sign, square * n**2, in_z, n - 1, part)


def cap(l):
    """The factors of z_l = sqrt(pi (2l+1)) integral of P_l from c to 1, the constant first."""
    integral = [Fraction(0)] + [c / (k + 1) for k, c in enumerate(legendre(l))]
    below = [-c for c in integral]
    below[0] += sum(integral)
    if l == 0:
        content, factors = Fraction(1), ["(T(1) - c)"]
        assert below == [1, -1]
    else:
        content, integers = content_and_integers(divided_by_1_minus_u2(below))
        factors = ["(T(1) - c)", "(T(1) + c)"] + in_one_variable(integers, "c")
    return [f"T({root('root_of_pi', (2 * l + 1) * content**2)})"] + factors


GENERATED = "// Generated by scripts/derive_polynomials.py, in exact arithmetic from Rodrigues' formula: change it there."

POLYNOMIAL_HEAD = f"""\
// The real spherical harmonics as explicit polynomials, to {BANDS} bands: the slow reference.
// {{generated}}
//
// Y_l^m = sqrt(p / (q pi)) * polynomial in z * Re or Im of (x + iy)^|m|, with the coefficients as in textbooks and
// every power written out. Conventions: zonal.hpp.
#pragma once

#include "../scalar/constexpr_math.hpp"
#include "../scalar/vector3.hpp"
#include "sh.hpp"

namespace zonal {{{{
inline namespace ZONAL_TARGET {{{{
namespace reference {{{{

namespace detail {{{{
template <long long p, long long q>
inline constexpr long double root_over_pi =
    constexpr_sqrt(static_cast<long double>(p) / (static_cast<long double>(q) * kPi));
}}}}  // namespace detail

/// evaluate<N>, 1 <= N <= {BANDS}, from the explicit polynomials at a unit vector.
template <int N, class Direction>
constexpr Sh<N, component_t<Direction>> evaluate_polynomial(const Direction& direction) {{{{
  static_assert(1 <= N && N <= {BANDS}, "bands out of range: the polynomials are written out for 1 <= N <= {BANDS}");
  using T = component_t<Direction>;
  using detail::root_over_pi;
  [[maybe_unused]] const auto [x, y, z] = zonal::detail::as_direction<T>(direction);
  Sh<N, T> sh{{{{}}}};
"""

GRADIENT_HEAD = f"""\
// The gradients of the explicit polynomial forms, to {BANDS} bands: the slow reference.
// {{generated}}
//
// Each polynomial of polynomial.hpp, in z times Re or Im of (x + iy)^|m|, differentiated by x, y and z as it stands.
// Away from the sphere it is one of many continuations of Y_l^m; its gradient there has a part along the direction,
// which evaluate_with_gradient has not. across() takes it away.
#pragma once

#include "gradient.hpp"
#include "polynomial.hpp"

namespace zonal {{{{
inline namespace ZONAL_TARGET {{{{
namespace reference {{{{

/// Value and gradient of the explicit polynomials, 1 <= N <= {BANDS}, at a unit vector.
template <int N, class Direction>
constexpr ShGradient<N, component_t<Direction>> evaluate_polynomial_with_gradient(const Direction& direction) {{{{
  static_assert(1 <= N && N <= {BANDS}, "bands out of range: the polynomials are written out for 1 <= N <= {BANDS}");
  using T = component_t<Direction>;
  using detail::root_over_pi;
  [[maybe_unused]] const auto [x, y, z] = zonal::detail::as_direction<T>(direction);
  ShGradient<N, T> sh{{{{}}}};  // many derivatives are zero
  sh.value = evaluate_polynomial<N>(direction);
  auto& by_x = sh.gradient[0];
  auto& by_y = sh.gradient[1];
  auto& by_z = sh.gradient[2];
"""

GRADIENT_ACROSS = """
/// The gradients without their part along the unit vector: those of Y_l^m(v/|v|).
template <int N, class T, class Direction>
constexpr ShGradient<N, T> across(ShGradient<N, T> sh, const Direction& direction) {
  const auto d = zonal::detail::as_direction<T>(direction);
  const T v[3] = {d.x, d.y, d.z};
  for (int i = 0; i < N * N; ++i) {
    T along = T(0);
    for (int k = 0; k < 3; ++k) along = along + sh.gradient[k].values[i] * v[k];
    for (int k = 0; k < 3; ++k) sh.gradient[k].values[i] = sh.gradient[k].values[i] - along * v[k];
  }
  return sh;
}
"""

CAP_HEAD = f"""\
// The zonal coefficients of a spherical cap as explicit polynomials, to {BANDS} bands: the slow reference.
// {{generated}}
//
// z_l = sqrt(pi (2l+1)) integral of P_l(u) du from c to 1 = sqrt(pi p / q) (1 - c)(1 + c) polynomial in c for l >= 1,
// which are Sloan's closed forms [1].
//
// [1] Sloan, Stupid Spherical Harmonics (SH) Tricks, 2008, the appendix on spherical lights.
#pragma once

#include "../basis/sh.hpp"
#include "../scalar/constexpr_math.hpp"

namespace zonal {{{{
inline namespace ZONAL_TARGET {{{{
namespace reference {{{{

namespace detail {{{{
template <long long p, long long q>
inline constexpr long double root_of_pi =
    constexpr_sqrt(static_cast<long double>(p) * kPi / static_cast<long double>(q));
}}}}  // namespace detail

/// z_l of the indicator of the cap of all directions within an angle of the axis, 1 <= N <= {BANDS}, from the cosine
/// of that angle, -1 to 1.
template <int N, class T>
constexpr Zh<N, T> project_cap_closed_form(const T& cos_angle) {{{{
  static_assert(1 <= N && N <= {BANDS}, "bands out of range: the polynomials are written out for 1 <= N <= {BANDS}");
  using detail::root_of_pi;
  const T& c = cos_angle;
  Zh<N, T> zh{{{{}}}};
"""

TAIL = """\
  return {result};
}}
{more}
}}  // namespace reference
}}  // namespace ZONAL_TARGET
}}  // namespace zonal
"""


def polynomial_header():
    lines = []
    for l in range(BANDS):
        lines.append(f"  if constexpr (N > {l}) {{")
        for m in range(-l, l + 1):
            lines += wrapped(f"    sh({l}, {m}) = ", harmonic(l, m))
        lines.append("  }")
    head = POLYNOMIAL_HEAD.format(generated=GENERATED[3:])
    return head + "\n".join(lines) + "\n" + TAIL.format(result="sh", more="")


def gradient_header():
    lines = []
    for l in range(1, BANDS):
        lines.append(f"  if constexpr (N > {l}) {{")
        for m in range(-l, l + 1):
            for axis, name in enumerate("xyz"):
                factors = harmonic_derivative(l, m, axis)
                if factors:
                    lines += wrapped(f"    by_{name}({l}, {m}) = ", factors)
        lines.append("  }")
    head = GRADIENT_HEAD.format(generated=GENERATED[3:])
    return head + "\n".join(lines) + "\n" + TAIL.format(result="sh", more=GRADIENT_ACROSS)


def cap_header():
    lines = [line for l in range(BANDS) for line in wrapped(f"  if constexpr (N > {l}) zh[{l}] = ", cap(l))]
    return CAP_HEAD.format(generated=GENERATED[3:]) + "\n".join(lines) + "\n" + TAIL.format(result="zh", more="")


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    check = bool(sys.argv[1:])
    stale = False
    for path, text in [
        (INCLUDE / "basis" / "polynomial.hpp", polynomial_header()),
        (INCLUDE / "basis" / "polynomial_gradient.hpp", gradient_header()),
        (INCLUDE / "lobe" / "cap_closed_form.hpp", cap_header()),
    ]:
        if not check:
            path.write_text(text, newline="\n")
        elif not path.exists() or path.read_bytes() != text.encode():
            print(f"{path} is not what scripts/derive_polynomials.py writes", file=sys.stderr)
            stale = True
    sys.exit(stale)


if __name__ == "__main__":
    main()
