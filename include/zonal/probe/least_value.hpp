// The least value of a function on N bands over all directions: found and bounded from below, not sampled.
//
// Two bands: the mean less the length of degree 1. Three: the least of a quadratic form and a linear one on the
// sphere, x'Ax + b'x + c; for mu below all eigenvalues a_i of A it is at least c + mu - sum b_i^2 / 4(a_i - mu), which
// is attained where sum b_i^2 / 4(a_i - mu)^2 = 1 (the trust region's equation [1]). More: cells of the sphere, halved
// until the bound of each is as good as the least value found.
//
// A cell's bound. Along a great circle, t the angle, the third derivative of a function of degree l is at most
//
//   ||f_l|| sqrt((2l+1)/4pi) sqrt(k/2 + 15/8 k(k-2) + 5/16 k(k-2)(k-6)),  k = l (l + 1),
//
// for by Cauchy and the addition theorem the square of the greatest one of norm 1 is the sixth derivative of (2l+1)/4pi
// P_l(cos t) at t = 0 but for its sign, and P_l = 1 - k/2 (1-x) + k(k-2)/16 (1-x)^2 - k(k-2)(k-6)/288 (1-x)^3 + ... So
// within an angle r of the centre f is not below the least value there of its Taylor polynomial of degree 2, less r^3/6
// times the sum of these over l. Of the polynomial, for any nu >= 0 that makes H + nu positive definite, that is at
// least f(c) - g'(H + nu)^-1 g / 2 - nu r^2 / 2. A bound without H would need thousands of cells along each circle on
// which f is least.
//
// [1] J. More, D. Sorensen, Computing a trust region step, SIAM J. Sci. Stat. Comput. 4(3), 1983.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "../basis/gradient.hpp"
#include "../basis/normalisation.hpp"
#include "../scalar/vector3.hpp"
#include "../transform/dot.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// No value is below `bound`; `value` is that of `direction`, a unit vector, so it is at least the least one.
struct LeastValue {
  double value, bound;
  std::array<double, 3> direction;
};

namespace detail {

// The norm of each degree times sqrt((2l+1)/4pi): no value of that degree is greater.
template <int N>
std::array<double, std::size_t{N}> greatest_of_degrees(const Sh<N, double>& f) {
  std::array<double, std::size_t{N}> greatest{};
  for (int l = 0; l < N; ++l) {
    double square = 0;
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) square += f[i] * f[i];
    greatest[std::size_t(l)] = std::sqrt(square * (2 * l + 1) / (4 * double(kPi)));
  }
  return greatest;
}
template <int N>
double sum_of_degrees(const Sh<N, double>& f) {
  double sum = 0;
  for (const double x : greatest_of_degrees(f)) sum += x;
  return sum;
}
// What a value may be off by its rounding in double, generously.
template <int N>
double rounding_of_values(const Sh<N, double>& f) {
  return 32 * N * std::numeric_limits<double>::epsilon() * sum_of_degrees(f);
}

inline LeastValue least_value(const Sh<1, double>& f) {
  const double value = f[0] * double(zonal_normalisation<0>);
  return {value, value - rounding_of_values(f), {0, 0, 1}};
}

inline LeastValue least_value(const Sh<2, double>& f) {
  const double length = std::sqrt(f[1] * f[1] + f[2] * f[2] + f[3] * f[3]);
  std::array<double, 3> direction{0, 0, 1};
  if (length > 0) direction = {f[3] / length, f[1] / length, -f[2] / length};
  const double value = f[0] * double(zonal_normalisation<0>) - length * double(zonal_normalisation<1>);
  return {value, value - rounding_of_values(f), direction};
}

// The eigenvalues of a symmetric matrix, and its eigenvectors as columns: Jacobi's rotations.
inline void diagonalise(double (&a)[3][3], double (&vectors)[3][3]) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) vectors[i][j] = i == j ? 1 : 0;
  }
  for (int sweep = 0; sweep < 16; ++sweep) {
    double off = 0;
    for (int p = 0; p < 2; ++p) {
      for (int q = p + 1; q < 3; ++q) {
        if (!(std::abs(a[p][q]) > 0)) continue;
        off += std::abs(a[p][q]);
        const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
        const double c = 1 / std::sqrt(t * t + 1), s = t * c;
        for (int k = 0; k < 3; ++k) {
          const double x = a[k][p], y = a[k][q];
          a[k][p] = c * x - s * y, a[k][q] = s * x + c * y;
        }
        for (int k = 0; k < 3; ++k) {
          const double x = a[p][k], y = a[q][k];
          a[p][k] = c * x - s * y, a[q][k] = s * x + c * y;
        }
        for (auto& row : vectors) {
          const double x = row[p], y = row[q];
          row[p] = c * x - s * y, row[q] = s * x + c * y;
        }
      }
    }
    if (!(off > 0)) break;
  }
}

// The matrix of degree 2, f = x'Ax.
template <class T>
void quadratic_form(const T (&degree)[5], T (&a)[3][3]) {
  const T q = T(std::sqrt(15 / (16 * double(kPi)))), r = T(std::sqrt(5 / (16 * double(kPi))));
  a[0][0] = q * degree[4] - r * degree[2], a[1][1] = -q * degree[4] - r * degree[2], a[2][2] = 2 * r * degree[2];
  a[0][1] = a[1][0] = q * degree[0];
  a[1][2] = a[2][1] = -q * degree[1];
  a[0][2] = a[2][0] = -q * degree[3];
}

inline LeastValue least_value(const Sh<3, double>& f) {
  const double rounding = rounding_of_values(f);
  double a[3][3], vectors[3][3];
  const double degree[5] = {f[4], f[5], f[6], f[7], f[8]};
  quadratic_form(degree, a);
  diagonalise(a, vectors);
  const double linear[3] = {-f[3] * double(zonal_normalisation<1>), -f[1] * double(zonal_normalisation<1>),
                            f[2] * double(zonal_normalisation<1>)};
  double b[3], length = 0;
  for (int i = 0; i < 3; ++i) {
    b[i] = vectors[0][i] * linear[0] + vectors[1][i] * linear[1] + vectors[2][i] * linear[2];
    length += b[i] * b[i];
  }
  length = std::sqrt(length);
  const int lowest = a[0][0] <= a[1][1] ? (a[0][0] <= a[2][2] ? 0 : 2) : (a[1][1] <= a[2][2] ? 1 : 2);
  const double least = a[lowest][lowest];

  // The equation's left side grows with mu, is at most 1 at the lower end, and is at least 1 at the upper one but where
  // b has nothing along the lowest eigenvector.
  double low = least - length / 2, high = least;
  for (int i = 0; i < 100; ++i) {
    const double middle = low + (high - low) / 2;
    if (!(low < middle && middle < high)) break;
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += b[k] * b[k] / (4 * (a[k][k] - middle) * (a[k][k] - middle));
    (sum > 1 ? high : low) = middle;
  }
  double bound = f[0] * double(zonal_normalisation<0>) + low, y[3], rest = 1;
  for (int k = 0; k < 3; ++k) {
    const double over = a[k][k] - low;
    y[k] = over > 0 ? -b[k] / (2 * over) : 0;
    if (over > 0) bound -= b[k] * b[k] / (4 * over);
    if (k != lowest) rest -= y[k] * y[k];
  }
  y[lowest] = std::copysign(std::sqrt((std::max)(rest, 0.0)), y[lowest]);
  LeastValue result{0, bound - rounding, {}};
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    result.direction[i] = vectors[i][0] * y[0] + vectors[i][1] * y[1] + vectors[i][2] * y[2];
    square += result.direction[i] * result.direction[i];
  }
  for (double& x : result.direction) x /= std::sqrt(square);
  result.value = reconstruct(f, result.direction);
  return result;
}

// Along a great circle, of a function of degree l, in units of ||f_l|| sqrt((2l+1)/4pi).
inline double greatest_third_derivative(int l) {
  const double k = l * (l + 1);
  return std::sqrt(k / 2 + 15 * k * (k - 2) / 8 + 5 * k * (k - 2) * (k - 6) / 16);
}

// A square of a cube's face: its middle and half its side, in the plane at distance 1.
struct SphereCell {
  double u, v, half, bound;
  int face;
  friend bool operator<(const SphereCell& a, const SphereCell& b) { return a.bound > b.bound; }  // the lowest first
};
inline std::array<double, 3> on_face(int face, double u, double v) {
  const double scale = (face % 2 == 0 ? 1 : -1) / std::sqrt(1 + u * u + v * v);
  std::array<double, 3> d{};
  const auto axis = std::size_t(face / 2);
  d[axis] = scale, d[(axis + 1) % 3] = u * scale, d[(axis + 2) % 3] = v * scale;
  return d;
}

// The least of g'x + x'Hx/2 over |x| <= radius in the plane, from below.
inline double least_of_quadratic(const double (&g)[2], double h00, double h01, double h11, double radius) {
  const double middle = (h00 + h11) / 2, spread = std::hypot((h00 - h11) / 2, h01);
  const double steepness = std::hypot(g[0], g[1]);
  if (!(steepness > 0)) return (std::min)(0.0, middle - spread) * radius * radius / 2;
  // Each nu is good that makes H + nu positive definite; the best is where the solution is as long as the radius.
  const double scale = std::abs(middle) + spread + steepness / radius;
  double low = (std::max)(0.0, spread - middle), high = low + steepness / radius + 1e-9 * scale, best = 0;
  const auto inside = [&](double nu) {
    const double a = h00 + nu, b = h11 + nu, determinant = a * b - h01 * h01;
    if (!(determinant > 0) || !(a + b > 0)) return false;
    const double x = (b * g[0] - h01 * g[1]) / determinant, y = (a * g[1] - h01 * g[0]) / determinant;
    best = -(g[0] * x + g[1] * y) / 2 - nu * radius * radius / 2;
    return x * x + y * y <= radius * radius;
  };
  if (inside(low)) return best;
  for (int i = 0; i < 12; ++i) {
    const double nu = low + (high - low) / 2;
    (inside(nu) ? high : low) = nu;
  }
  inside(high);
  return best;
}

// What the third derivative may be anywhere.
template <int N>
double third_derivative_of(const Sh<N, double>& f) {
  const auto greatest = greatest_of_degrees(f);
  double sum = 0;
  for (int l = 1; l < N; ++l) sum += greatest[std::size_t(l)] * greatest_third_derivative(l);
  return sum;
}

// The value in a direction, and a bound of those within an angle of it.
struct BoundedValue {
  double value, bound;
};
template <int N>
BoundedValue bound_about(const Sh<N, double>& f, double third, const std::array<double, 3>& d, double angle) {
  const auto basis = evaluate_with_hessian<N>(d);
  const double z[3] = {d[0], d[1], d[2]}, value = dot(f, basis.value);
  double x[3], y[3], first[3], second[6];
  complete_frame(z, x, y);
  for (int i = 0; i < 3; ++i) first[i] = dot(f, basis.gradient[i]);
  for (int i = 0; i < 6; ++i) second[i] = dot(f, basis.hessian[i]);
  const auto twice = [&](const double(&a)[3], const double(&b)[3]) {
    return a[0] * (second[0] * b[0] + second[1] * b[1] + second[2] * b[2]) +
           a[1] * (second[1] * b[0] + second[3] * b[1] + second[4] * b[2]) +
           a[2] * (second[2] * b[0] + second[4] * b[1] + second[5] * b[2]);
  };
  const double g[2] = {dot3(first, x), dot3(first, y)};
  const double least = least_of_quadratic(g, twice(x, x), twice(x, y), twice(y, y), angle);
  return {value, value + least - angle * angle * angle * third / 6};
}

// By cells, to the tolerance; or, if `enough` is finite, until no value is below that, or the least one, below it, is
// known to a tenth of what it lacks.
template <int N>
LeastValue least_value_by_cells(const Sh<N, double>& f, double enough, double tolerance) {
  const double rounding = rounding_of_values(f), third = third_derivative_of(f);
  LeastValue result{std::numeric_limits<double>::infinity(), 0, {0, 0, 1}};
  if (!(third < std::numeric_limits<double>::infinity())) return {result.value, -result.value, result.direction};
  const auto look = [&](int face, double u, double v, double half) {
    const std::array<double, 3> d = on_face(face, u, v);
    double chord = 0;  // squared, to the farthest corner: a cap that holds the corners of a cell holds the cell
    for (int corner = 0; corner < 4; ++corner) {
      const auto e = on_face(face, u + (corner % 2 == 0 ? half : -half), v + (corner < 2 ? half : -half));
      double square = 0;
      for (std::size_t i = 0; i < 3; ++i) square += (e[i] - d[i]) * (e[i] - d[i]);
      chord = (std::max)(chord, square);
    }
    const double radius = 2 * std::asin((std::min)(std::sqrt(chord) / 2, 1.0)) * (1 + 1e-12);
    const BoundedValue found = bound_about(f, third, d, radius);
    if (found.value < result.value) result.value = found.value, result.direction = d;
    return SphereCell{u, v, half, found.bound, face};
  };

  std::vector<SphereCell> cells;  // a heap
  constexpr int side = N < 6 ? 2 : N / 2;
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < side * side; ++i) {
      const double half = 1.0 / side;
      cells.push_back(look(face, half * (2 * (i % side) + 1) - 1, half * (2 * (i / side) + 1) - 1, half));
    }
  }
  std::make_heap(cells.begin(), cells.end());
  while (true) {
    const SphereCell cell = cells.front();
    const double lacking = enough - result.value;
    double slack = tolerance;
    if (enough > -std::numeric_limits<double>::infinity()) {
      slack = (std::max)(slack, lacking > 0 ? lacking / 10 : -lacking);
    }
    if (cell.bound >= result.value - slack || cell.half < 1e-9) break;
    std::pop_heap(cells.begin(), cells.end());
    cells.pop_back();
    for (int i = 0; i < 4; ++i) {
      const double half = cell.half / 2;
      const SphereCell part =
          look(cell.face, cell.u + (i % 2 == 0 ? half : -half), cell.v + (i < 2 ? half : -half), half);
      cells.push_back(part);
      std::push_heap(cells.begin(), cells.end());
    }
  }
  result.bound = (std::min)(cells.front().bound, result.value) - rounding;
  return result;
}

// What there is to know about whether f reaches `enough` everywhere.
template <int N>
LeastValue least_value(const Sh<N, double>& f, double enough, double tolerance) {
  if constexpr (N <= 3) {
    static_cast<void>(enough), static_cast<void>(tolerance);
    return least_value(f);
  } else {
    return least_value_by_cells(f, enough, tolerance);
  }
}
}  // namespace detail

/// The least value of a function over all directions, and a bound that no value is below. The two differ by at most
/// `tolerance` times the sum of the degrees' greatest values: up to 3 bands by 1e-12 of it whatever the tolerance.
template <int N, class T, class = std::enable_if_t<is_builtin_scalar_v<T>>>
LeastValue least_value(const Sh<N, T>& sh, double tolerance = 1e-5) {
  const auto f = static_cast<Sh<N, double>>(sh);
  return detail::least_value(f, -std::numeric_limits<double>::infinity(), tolerance * detail::sum_of_degrees(f));
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
