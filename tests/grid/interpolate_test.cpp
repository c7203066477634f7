// Interpolation on a grid: by definition, on polynomials it must reproduce, against dual numbers, and at the edges.
#include <zonal/grid/add_lights.hpp>
#include <zonal/grid/interpolate.hpp>
#include <zonal/light/sphere.hpp>
#include <zonal/scalar/dual.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "../accuracy.hpp"
#include "../catch.hpp"

namespace {

constexpr int N = 2;
using Grid = zonal::CoefficientGrid<N>;
using zonal::Interpolation;
using Dual = zonal::Dual<double, 3>;

const glm::vec3 low{-1, 0.5F, -3}, high{1, 2, -1};
const glm::ivec3 resolution{4, 3, 5};

/// Calls body(vertex) for all of a grid.
template <class Body>
void for_each_vertex(const glm::ivec3& size, const Body& body) {
  for (int k = 0; k < size.z; ++k) {
    for (int j = 0; j < size.y; ++j) {
      for (int i = 0; i < size.x; ++i) body(glm::ivec3(i, j, k));
    }
  }
}

/// A grid of the function's values and gradients; each of the 3 N*N numbers is another multiple of it.
float multiple(int coefficient, int channel) { return 1.0F + 0.25F * static_cast<float>(3 * coefficient + channel); }
template <class Function>
Grid grid_of(const Function& function) {
  Grid grid(low, high, resolution);
  for_each_vertex(resolution, [&](const glm::ivec3& vertex) {
    const glm::dvec3 p(grid.position(vertex));
    const Dual f = function(Dual::variable(p.x, 0), Dual::variable(p.y, 1), Dual::variable(p.z, 2));
    zonal::ShGradient<N, glm::vec3> coefficients;
    for (int i = 0; i < N * N; ++i) {
      for (int c = 0; c < 3; ++c) {
        coefficients.value[i][c] = multiple(i, c) * static_cast<float>(f.value);
        for (int a = 0; a < 3; ++a) {
          coefficients.gradient[a][i][c] = multiple(i, c) * static_cast<float>(f.partial[static_cast<std::size_t>(a)]);
        }
      }
    }
    grid.set(vertex, coefficients);
  });
  return grid;
}

Grid random_grid(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-1, 1);
  Grid grid(low, high, resolution);
  std::generate_n(grid.data(), grid.size(), [&] { return uniform(random); });
  return grid;
}

std::vector<glm::vec3> random_positions(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  std::vector<glm::vec3> positions(count);
  for (glm::vec3& p : positions) {
    const float x = uniform(random), y = uniform(random), z = uniform(random);
    p = low + (high - low) * glm::vec3(x, y, z);
  }
  return positions;
}

/// Where a position stands on an axis, in double: the cell, and t in it.
struct Place {
  int cell;
  double t, size;
};
Place place(const Grid& grid, const glm::vec3& p, int axis) {
  const int last = grid.resolution()[axis] - 1;
  const double size = (static_cast<double>(grid.high()[axis]) - static_cast<double>(grid.low()[axis])) / last;
  const double x = std::clamp((static_cast<double>(p[axis]) - static_cast<double>(grid.low()[axis])) / size, 0.0,
                              static_cast<double>(last));
  const int cell = std::min(static_cast<int>(x), last - 1);
  return {cell, x - cell, size};
}

/// The interpolant by its definition: a function of t = (tx, ty, tz) in a cell, from a corner's four numbers
/// corner(i, j, k)[0 to 3], value and derivatives.
template <class T>
struct Cell {
  std::array<double, 4> corners[2][2][2];
  double size[3];

  // Trilinear: one axis after the other.
  T lerp(const T& a, const T& b, const T& t) const { return a + (b - a) * t; }
  template <class At>
  T trilinear(const At& at, const T (&t)[3]) const {
    const auto along_x = [&](int j, int k) { return lerp(at(0, j, k), at(1, j, k), t[0]); };
    const auto along_y = [&](int k) { return lerp(along_x(0, k), along_x(1, k), t[1]); };
    return lerp(along_y(0), along_y(1), t[2]);
  }
  T trilinear(const T (&t)[3]) const {
    return trilinear([&](int i, int j, int k) { return T(corners[i][j][k][0]); }, t);
  }
  // Taylor: every corner's expansion, blended.
  T taylor(const T (&t)[3]) const {
    return trilinear(
        [&](int i, int j, int k) {
          const auto& c = corners[i][j][k];
          return T(c[0]) + T(c[1] * size[0]) * (t[0] - T(i)) + T(c[2] * size[1]) * (t[1] - T(j)) +
                 T(c[3] * size[2]) * (t[2] - T(k));
        },
        t);
  }
  // Hermite: the tricubic of the 8 values, 24 derivatives and 32 cross derivatives, these by the differences of
  // interpolation_weights.hpp.
  T hermite(const T (&t)[3]) const {
    // Everything per cell: derivatives by t. d[p][i][j][k], p the bits of the axes that it is a derivative along.
    double d[8][2][2][2];
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        for (int k = 0; k < 2; ++k) {
          d[0][i][j][k] = corners[i][j][k][0];
          d[1][i][j][k] = corners[i][j][k][1] * size[0];
          d[2][i][j][k] = corners[i][j][k][2] * size[1];
          d[4][i][j][k] = corners[i][j][k][3] * size[2];
        }
      }
    }
    const auto difference = [&](int axes, int what, int i, int j, int k) {  // along all the axes of the bits
      double sum = 0;
      for (int a = 0; a < 2; ++a) {
        for (int b = 0; b < 2; ++b) {
          for (int c = 0; c < 2; ++c) {
            if ((!(axes & 1) && a != i) || (!(axes & 2) && b != j) || (!(axes & 4) && c != k)) continue;
            const int sign =
                ((axes & 1) && a == 0 ? -1 : 1) * ((axes & 2) && b == 0 ? -1 : 1) * ((axes & 4) && c == 0 ? -1 : 1);
            sum += sign * d[what][a][b][c];
          }
        }
      }
      return sum;
    };
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        for (int k = 0; k < 2; ++k) {
          for (const int pair : {3, 5, 6}) {
            const int p = pair & -pair, q = pair - p;
            d[pair][i][j][k] = difference(p, q, i, j, k) + difference(q, p, i, j, k) - difference(pair, 0, i, j, k);
          }
          d[7][i][j][k] = difference(6, 1, i, j, k) + difference(5, 2, i, j, k) + difference(3, 4, i, j, k) -
                          2 * difference(7, 0, i, j, k);
        }
      }
    }
    const auto basis = [&](int axis, int end, bool slope) {  // h00, h10, h01, h11
      const T s = t[axis], s2 = s * s, s3 = s2 * s;
      if (end == 0) return slope ? s3 - T(2) * s2 + s : T(2) * s3 - T(3) * s2 + T(1);
      return slope ? s3 - s2 : T(3) * s2 - T(2) * s3;
    };
    T sum(0);
    for (int p = 0; p < 8; ++p) {
      for (int c = 0; c < 8; ++c) {
        const int i = c & 1, j = c >> 1 & 1, k = c >> 2;
        sum = sum + T(d[p][i][j][k]) * basis(0, i, p & 1) * basis(1, j, p & 2) * basis(2, k, p & 4);
      }
    }
    return sum;
  }
};

template <Interpolation method>
Dual by_definition(const Grid& grid, const glm::vec3& position, int coefficient, int channel) {
  Cell<Dual> cell;
  Dual t[3];
  glm::ivec3 first;
  for (int a = 0; a < 3; ++a) {
    const Place at = place(grid, position, a);
    first[a] = at.cell;
    cell.size[a] = at.size;
    t[a] = Dual::variable(at.t, a);
    t[a].partial[static_cast<std::size_t>(a)] = 1 / at.size;
  }
  for_each_vertex({2, 2, 2}, [&](const glm::ivec3& corner) {
    const auto data = grid.value_with_gradient(first + corner);
    auto& numbers = cell.corners[corner.x][corner.y][corner.z];
    numbers[0] = static_cast<double>(data.value[coefficient][channel]);
    for (std::size_t a = 0; a < 3; ++a) {
      numbers[a + 1] = static_cast<double>(data.gradient[a][coefficient][channel]);
    }
  });
  if constexpr (method == Interpolation::trilinear) return cell.trilinear(t);
  if constexpr (method == Interpolation::taylor) return cell.taylor(t);
  return cell.hermite(t);
}

template <Interpolation method>
void check_definition(const char* name, Met& values, Met& slopes) {
  const Grid grid = random_grid(71);
  auto positions = random_positions(200, 72);
  for_each_vertex(resolution, [&](const glm::ivec3& vertex) { positions.push_back(grid.position(vertex)); });
  for (const glm::vec3& p : positions) {
    const auto value = zonal::interpolate<method>(grid, p);
    const auto both = zonal::interpolate_with_gradient<method>(grid, p);
    for (int i = 0; i < N * N; ++i) {
      for (int c = 0; c < 3; ++c) {
        const Dual expected = by_definition<method>(grid, p, i, c);
        CAPTURE(name, p.x, p.y, p.z, i, c);
        REQUIRE(values.meet(std::abs(static_cast<double>(value[i][c]) - expected.value)));
        REQUIRE(both.value[i][c] == value[i][c]);
        for (std::size_t a = 0; a < 3; ++a) {
          REQUIRE(slopes.meet(std::abs(static_cast<double>(both.gradient[a][i][c]) - expected.partial[a])));
        }
      }
    }
  }
}

/// Largest error of value and gradient over the box, in units of the function's multiples.
template <Interpolation method, class Function>
std::array<double, 2> error_on(const Function& function) {
  const Grid grid = grid_of(function);
  std::array<double, 2> worst{};
  for (const glm::vec3& p : random_positions(300, 73)) {
    const Dual exact =
        function(Dual::variable(static_cast<double>(p.x), 0), Dual::variable(static_cast<double>(p.y), 1),
                 Dual::variable(static_cast<double>(p.z), 2));
    const auto got = zonal::interpolate_with_gradient<method>(grid, p);
    for (int i = 0; i < N * N; ++i) {
      for (int c = 0; c < 3; ++c) {
        const auto unit = static_cast<double>(multiple(i, c));
        worst[0] = std::max(worst[0], std::abs(static_cast<double>(got.value[i][c]) / unit - exact.value));
        for (std::size_t a = 0; a < 3; ++a) {
          worst[1] = std::max(worst[1], std::abs(static_cast<double>(got.gradient[a][i][c]) / unit - exact.partial[a]));
        }
      }
    }
  }
  return worst;
}

constexpr double exact_in_float = 3e-5;  // the functions below reach about 10, their derivatives 30

}  // namespace

TEST_CASE("interpolation: is what its definition says, value and gradient") {
  Met values("grid", "interpolate"), slopes("grid", "interpolate_with_gradient");
  check_definition<Interpolation::trilinear>("trilinear", values, slopes);
  check_definition<Interpolation::taylor>("taylor", values, slopes);
  check_definition<Interpolation::hermite>("hermite", values, slopes);
  CHECK_WORST_MET(values);
  CHECK_WORST_MET(slopes);
}

TEST_CASE("interpolation: reproduces the polynomials it promises to, and no more") {
  const auto bilinear = [](const Dual& x, const Dual& y, const Dual& z) { return x * y * z + x * z - Dual(2) * y; };
  const auto linear = [](const Dual& x, const Dual& y, const Dual& z) { return x - Dual(2) * y + Dual(0.5) * z; };
  const auto quadratic = [](const Dual& x, const Dual& y, const Dual& z) { return x * x - y * z + Dual(0.5) * z * z; };
  const auto cubic = [](const Dual& x, const Dual& y, const Dual& z) {
    return x * x * x - x * x * y + x * y * z + Dual(0.25) * z * z * z - y * y * z;
  };
  const auto cubic_by_lines = [](const Dual& x, const Dual& y, const Dual& z) {
    return (x * x * x - x) * y * z + x * y * (Dual(0.25) * z * z * z);
  };
  const auto quadratic_by_quadratic = [](const Dual& x, const Dual& y, const Dual&) { return x * x * y * y; };

  const auto exact = [](const std::array<double, 2>& error) {
    CAPTURE(error[0], error[1]);
    CHECK(error[0] <= exact_in_float);
    CHECK(error[1] <= 10 * exact_in_float);
  };
  exact(error_on<Interpolation::trilinear>(bilinear));
  exact(error_on<Interpolation::taylor>(linear));
  exact(error_on<Interpolation::hermite>(linear));
  exact(error_on<Interpolation::hermite>(quadratic));
  exact(error_on<Interpolation::hermite>(cubic));
  exact(error_on<Interpolation::hermite>(cubic_by_lines));

  CHECK(error_on<Interpolation::trilinear>(quadratic)[0] > 1e-2);
  CHECK(error_on<Interpolation::taylor>(quadratic)[0] > 1e-2);
  CHECK(error_on<Interpolation::hermite>(quadratic_by_quadratic)[0] > 1e-2);
}

TEST_CASE("interpolation: at a vertex Hermite gives the vertex back, value and gradient") {
  const Grid grid = random_grid(74);
  for_each_vertex(resolution, [&](const glm::ivec3& vertex) {
    const auto got = zonal::interpolate_with_gradient<Interpolation::hermite>(grid, grid.position(vertex));
    const auto expected = grid.value_with_gradient(vertex);
    for (int i = 0; i < N * N; ++i) {
      for (int c = 0; c < 3; ++c) {
        CAPTURE(vertex.x, vertex.y, vertex.z, i, c);
        REQUIRE(std::abs(got.value[i][c] - expected.value[i][c]) <= 2e-6F);
        for (int a = 0; a < 3; ++a) REQUIRE(std::abs(got.gradient[a][i][c] - expected.gradient[a][i][c]) <= 2e-5F);
      }
    }
  });
}

TEST_CASE("interpolation: Hermite converges with the fourth power of the cell, the others with the second") {
  // A sphere light outside of the box; the greatest error, from 8 to 15 vertices per axis: half the cell.
  const std::vector<zonal::ColouredLight<zonal::SphereLight<float>>> lights{{{{1.6F, 0.7F, 0.9F}, 0.4F}, {1, 1, 1}}};
  const auto serially = [](int count, const auto& body) {
    for (int i = 0; i < count; ++i) body(i);
  };
  const auto worst = [&](auto method, int vertices) {
    zonal::CoefficientGrid<4> grid({-1, -1, -1}, {1, 1, 1}, glm::ivec3(vertices));
    zonal::add_lights(grid, lights, serially);
    double error = 0;
    for (const glm::vec3& at : random_positions(400, 75)) {
      const glm::vec3 p = 2.0F * (at - low) / (high - low) - 1.0F;
      const auto exact =
          zonal::project<4>(zonal::SphereLight<double>{glm::dvec3(lights[0].light.center), 0.4}, glm::dvec3(p));
      const auto got = zonal::interpolate<method()>(grid, p);
      for (int i = 0; i < 16; ++i) error = std::max(error, std::abs(static_cast<double>(got[i][0]) - exact[i]));
    }
    return error;
  };
  using Trilinear = std::integral_constant<Interpolation, Interpolation::trilinear>;
  using Taylor = std::integral_constant<Interpolation, Interpolation::taylor>;
  using Hermite = std::integral_constant<Interpolation, Interpolation::hermite>;
  const double trilinear = worst(Trilinear{}, 8) / worst(Trilinear{}, 15);
  const double taylor = worst(Taylor{}, 8) / worst(Taylor{}, 15);
  const double hermite = worst(Hermite{}, 8) / worst(Hermite{}, 15);
  CAPTURE(trilinear, taylor, hermite);
  CHECK(trilinear > 3);
  CHECK(trilinear < 5);
  CHECK(taylor > 2.5);
  CHECK(taylor < 5);
  CHECK(hermite > 10);
}

TEST_CASE("interpolation: outside of the box it is constant across the face") {
  const Grid grid = random_grid(76);
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float far : {0.5F, 1e6F, 3e38F, infinity}) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const bool above : {false, true}) {
        glm::vec3 face(0.3F, 1.1F, -1.7F);
        face[axis] = above ? high[axis] : low[axis];
        glm::vec3 outside = face;
        outside[axis] = above ? high[axis] + far : low[axis] - far;
        const auto at = zonal::interpolate_with_gradient<Interpolation::hermite>(grid, face);
        const auto beyond = zonal::interpolate_with_gradient<Interpolation::hermite>(grid, outside);
        for (int i = 0; i < N * N; ++i) {
          for (int c = 0; c < 3; ++c) {
            CAPTURE(far, axis, above, i, c);
            REQUIRE(beyond.value[i][c] == at.value[i][c]);
            for (int a = 0; a < 3; ++a) {
              REQUIRE(beyond.gradient[a][i][c] == (a == axis ? 0.0F : at.gradient[a][i][c]));
            }
            REQUIRE(at.gradient[axis][i][c] != 0.0F);  // on the face it is the inside's
          }
        }
      }
    }
  }
}

TEST_CASE("interpolation: a coordinate that is not a number gives no number, and touches no memory outside") {
  const Grid grid = random_grid(77);
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 p(0.3F, 1.1F, -1.7F);
    p[axis] = std::numeric_limits<float>::quiet_NaN();
    const auto got = zonal::interpolate<Interpolation::hermite>(grid, p);
    for (int i = 0; i < N * N; ++i) {
      for (int c = 0; c < 3; ++c) REQUIRE(std::isnan(got[i][c]));
    }
  }
}

TEST_CASE("interpolation: the cell is in the grid, however many vertices an axis has") {
  for (const int vertices : {2, 3, (1 << 24) - 1, (1 << 24) + 1, (1 << 24) + 3, (1 << 25) + 1, (1 << 25) + 3}) {
    for (const float x :
         {-2.0F, -1.0F, 0.0F, 0.5F, 0.99999994F, 1.0F, 3e38F, std::numeric_limits<float>::quiet_NaN()}) {
      const auto at = zonal::detail::locate(x, -1, 1, vertices);
      CAPTURE(vertices, x, at.cell, at.t);
      CHECK(0 <= at.cell);
      CHECK(at.cell <= vertices - 2);
      CHECK((std::isnan(x) || (0 <= at.t && at.t <= 1)));
    }
  }
}

TEST_CASE("grid: vertices stand where they should, and a box that is none is refused") {
  const Grid grid(low, high, resolution);
  CHECK(grid.position({0, 0, 0}) == low);
  CHECK(grid.position(resolution - 1) == high);
  CHECK(grid.vertex_index({1, 2, 3}) == 1 + 4 * (2 + 3 * 3));
  CHECK(grid.vertex_count() == 60);

  const float nan = std::numeric_limits<float>::quiet_NaN(), huge = std::numeric_limits<float>::max();
  const glm::vec3 unit(1);
  CHECK_THROWS_AS(Grid(low, high, {1, 2, 2}), std::invalid_argument);
  CHECK_THROWS_AS(Grid(low, high, {2, -5, 2}), std::invalid_argument);
  CHECK_THROWS_AS(Grid(high, low, resolution), std::invalid_argument);
  CHECK_THROWS_AS(Grid(unit, unit, resolution), std::invalid_argument);
  CHECK_THROWS_AS(Grid({0, nan, 0}, unit, resolution), std::invalid_argument);
  CHECK_THROWS_AS(Grid(glm::vec3(-huge), glm::vec3(huge), resolution), std::invalid_argument);
  CHECK_THROWS_AS(Grid(glm::vec3(1000), glm::vec3(1000.001F), {200, 2, 2}), std::invalid_argument);
  CHECK_THROWS_AS(Grid(low, high, glm::ivec3(2000000)), std::invalid_argument);
}
