// Every named convention against what its system publishes: the function that the stored numbers stand for, written out
// as that system's own code or text has it, and so independent of the library's description of it.
#include <zonal/convention/complex.hpp>
#include <zonal/convention/convert.hpp>
#include <zonal/convention/named.hpp>
#include <zonal/convention/shader_forms.hpp>
#include <zonal/lobe/lambert.hpp>
#include <zonal/transform/convolve.hpp>
#include <zonal/transform/dot.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "../catch.hpp"

namespace {

using namespace zonal;
using Vector = std::array<double, 3>;
using Numbers = std::vector<double>;

constexpr double pi = 3.14159265358979323846;

// The function of stored numbers, as published; `digits`: how exactly the text gives its constants.
struct Published {
  std::string name;
  double digits;
  std::function<double(const Numbers&, const Vector&)> value;
  Quantity quantity = Quantity::radiance;
};

double sum(const Numbers& c, const Numbers& basis) {
  double s = 0;
  for (std::size_t i = 0; i < std::min(c.size(), basis.size()); ++i) s += c[i] * basis[i];
  return s;
}

// Sloan 2008, appendix A2: to degree 3, as products of square roots.
Numbers with_phase(const Vector& d) {
  const double x = d[0], y = d[1], z = d[2], s = std::sqrt(pi);
  return {1 / (2 * s),
          -std::sqrt(3) * y / (2 * s),
          std::sqrt(3) * z / (2 * s),
          -std::sqrt(3) * x / (2 * s),
          std::sqrt(15) * y * x / (2 * s),
          -std::sqrt(15) * y * z / (2 * s),
          std::sqrt(5) * (3 * z * z - 1) / (4 * s),
          -std::sqrt(15) * x * z / (2 * s),
          std::sqrt(15) * (x * x - y * y) / (4 * s),
          -std::sqrt(2) * std::sqrt(35) * y * (3 * x * x - y * y) / (8 * s),
          std::sqrt(105) * y * x * z / (2 * s),
          -std::sqrt(2) * std::sqrt(21) * y * (-1 + 5 * z * z) / (8 * s),
          std::sqrt(7) * z * (5 * z * z - 3) / (4 * s),
          -std::sqrt(2) * std::sqrt(21) * x * (-1 + 5 * z * z) / (8 * s),
          std::sqrt(105) * (x * x - y * y) * z / (4 * s),
          -std::sqrt(2) * std::sqrt(35) * x * (x * x - 3 * y * y) / (8 * s)};
}

// three.js' getAt, to five or six digits.
Numbers threejs(const Vector& d) {
  const double x = d[0], y = d[1], z = d[2];
  return {0.282095,
          0.488603 * y,
          0.488603 * z,
          0.488603 * x,
          1.092548 * x * y,
          1.092548 * y * z,
          0.315392 * (3 * z * z - 1),
          1.092548 * x * z,
          0.546274 * (x * x - y * y)};
}

// The same with exact constants: SHforHLSL's BasisL0 to BasisL2_M2, MaterialX' BASIS_CONSTANT_0 to _4.
Numbers without_phase(const Vector& d) {
  Numbers r = with_phase(d);
  for (std::size_t odd = 1; odd < 16; odd += 2) r[odd] = -r[odd];
  return r;
}

// 3D Gaussian splatting's SH_C0 to SH_C3; also the text of KHR_gaussian_splatting with the squares that its (3, 0)
// lacks.
Numbers splats(const Vector& d) {
  const double x = d[0], y = d[1], z = d[2], xx = x * x, yy = y * y, zz = z * z;
  return {0.28209479177387814,
          -0.4886025119029199 * y,
          0.4886025119029199 * z,
          -0.4886025119029199 * x,
          1.0925484305920792 * x * y,
          -1.0925484305920792 * y * z,
          0.31539156525252005 * (2 * zz - xx - yy),
          -1.0925484305920792 * x * z,
          0.5462742152960396 * (xx - yy),
          -0.5900435899266435 * y * (3 * xx - yy),
          2.890611442640554 * x * y * z,
          -0.4570457994644658 * y * (4 * zz - xx - yy),
          0.3731763325901154 * z * (2 * zz - 3 * xx - 3 * yy),
          -0.4570457994644658 * x * (4 * zz - xx - yy),
          1.445305721320277 * z * (xx - yy),
          -0.5900435899266435 * x * (xx - 3 * yy)};
}

// Unity's seven vectors, filled as its own C# does from SphericalHarmonicsL2, and its shader's two functions.
double unity(const Numbers& sh, const Vector& n) {
  const std::array<double, 4> a{sh[3], sh[1], sh[2], sh[0] - sh[6]}, b{sh[4], sh[5], sh[6] * 3, sh[7]};
  const double linear = a[0] * n[0] + a[1] * n[1] + a[2] * n[2] + a[3] * 1;
  const double quadratic = b[0] * n[0] * n[1] + b[1] * n[1] * n[2] + b[2] * n[2] * n[2] + b[3] * n[2] * n[0];
  return linear + quadratic + sh[8] * (n[0] * n[0] - n[1] * n[1]);
}

// Filament's Irradiance_SphericalHarmonics.
double filament_shader(const Numbers& sh, const Vector& n) {
  return sh[0] + sh[1] * n[1] + sh[2] * n[2] + sh[3] * n[0] + sh[4] * (n[1] * n[0]) + sh[5] * (n[1] * n[2]) +
         sh[6] * (3 * n[2] * n[2] - 1) + sh[7] * (n[2] * n[0]) + sh[8] * (n[0] * n[0] - n[1] * n[1]);
}

// e3nn's generated code for 'component', with its x, y, z.
Numbers e3nn_component(const Vector& d) {
  const double x = d[0], y = d[1], z = d[2];
  Numbers r{1};
  for (const double v : {x, y, z}) r.push_back(std::sqrt(3) * v);
  const double x2 = x * x, y2 = y * y, z2 = z * z, x2z2 = x2 + z2;
  const double s20 = std::sqrt(3) * x * z, s24 = std::sqrt(3) / 2 * (z2 - x2);
  for (const double v : {s20, std::sqrt(3) * x * y, y2 - x2z2 / 2, std::sqrt(3) * y * z, s24}) {
    r.push_back(std::sqrt(5) * v);
  }
  const double s30 = std::sqrt(5.0 / 6) * (s20 * z + s24 * x), s31 = std::sqrt(5) * s20 * y,
               s32 = std::sqrt(3.0 / 8) * (4 * y2 - x2z2) * x, s33 = y * (2 * y2 - 3 * x2z2) / 2,
               s34 = std::sqrt(3.0 / 8) * z * (4 * y2 - x2z2), s35 = std::sqrt(5) * s24 * y,
               s36 = std::sqrt(5.0 / 6) * (s24 * z - s20 * x);
  for (const double v : {s30, s31, s32, s33, s34, s35, s36}) r.push_back(std::sqrt(7) * v);
  return r;
}

Numbers scaled_degrees(Numbers r, const std::function<double(int)>& factor) {
  for (int i = 0; i < static_cast<int>(r.size()); ++i) {
    r[static_cast<std::size_t>(i)] *= factor(static_cast<int>(std::sqrt(i + 0.5)));
  }
  return r;
}

const std::vector<Published>& published() {
  static const auto by_basis = [](Numbers (*basis)(const Vector&)) {
    return [basis](const Numbers& c, const Vector& d) { return sum(c, basis(d)); };
  };
  static const std::vector<Published> all{
      {"zonal", 0, by_basis(with_phase)},
      {"sloan", 0, by_basis(with_phase)},
      {"directxmath", 0, by_basis(with_phase)},
      {"google", 0, by_basis(with_phase)},
      {"unreal", 2e-6, by_basis([](const Vector& d) -> Numbers {
         const double x = d[0], y = d[1], z = d[2];
         return {0.282095,
                 -0.488603 * y,
                 0.488603 * z,
                 -0.488603 * x,
                 1.092548 * x * y,
                 -1.092548 * y * z,
                 0.315392 * (3 * z * z - 1),
                 -1.092548 * x * z,
                 0.546274 * (x * x - y * y)};
       })},
      {"babylon", 0, by_basis(with_phase)},
      {"filament", 0, by_basis(with_phase)},
      {"filament_shader", 0, filament_shader, Quantity::irradiance_over_pi},
      {"unity", 0, unity, Quantity::irradiance_over_pi},
      {"threejs", 2e-6, by_basis(threejs)},
      // Its shader gives E, with the cosine's factors in the constants.
      {"godot", 2e-6,
       [](const Numbers& c, const Vector& d) {
         const double x = d[0], y = d[1], z = d[2];
         return 0.886227 * c[0] + 1.023327 * (c[1] * y + c[2] * z + c[3] * x) +
                0.858086 * (c[4] * x * y + c[5] * y * z + c[7] * x * z) + 0.247708 * c[6] * (3 * z * z - 1) +
                0.429043 * c[8] * (x * x - y * y);
       },
       Quantity::irradiance},
      {"gaussian_splatting", 0, [](const Numbers& c, const Vector& d) { return sum(c, splats(d)) + 0.5; }},
      {"khr_gaussian_splatting", 0, [](const Numbers& c, const Vector& d) { return sum(c, splats(d)) + 0.5; }},
      {"spz", 0, [](const Numbers& c, const Vector& d) { return sum(c, splats(d)) + 0.5; }},
      // As Babylon.js loads it: of E, which its polynomial divides by pi.
      {"gltf_image_based", 0, by_basis(with_phase), Quantity::irradiance},
      // ARCore's hello_ar multiplies by these and by the plain polynomials, which is E / pi.
      {"webxr", 3e-6,
       [](const Numbers& c, const Vector& d) {
         const double f[9] = {0.282095,  -0.325735, 0.325735,  -0.325735, 0.273137,
                              -0.273137, 0.078848,  -0.273137, 0.136569};
         Numbers scaled = c;
         for (std::size_t i = 0; i < 9; ++i) scaled[i] *= f[i];
         return filament_shader(scaled, d);
       },
       Quantity::irradiance_over_pi},
      {"materialx", 0, by_basis(without_phase)},
      {"shforhlsl", 0, by_basis(without_phase)},
      {"sphericart", 0, by_basis(without_phase)},
      {"e3nn", 0, by_basis([](const Vector& d) {
         return scaled_degrees(e3nn_component(d), [](int) { return 1 / std::sqrt(4 * pi); });
       })},
      {"e3nn_component", 0, by_basis(e3nn_component)},
      {"e3nn_norm", 0, by_basis([](const Vector& d) {
         return scaled_degrees(e3nn_component(d), [](int l) { return 1 / std::sqrt(2 * l + 1); });
       })},
  };
  return all;
}

// Ambisonics publish how a plane wave is encoded: a direction and its channels. By azimuth a and elevation e, to degree
// 3; SN3D of Nachbar et al. 2011.
Numbers encoded_sn3d(const Vector& d) {
  const double a = std::atan2(d[1], d[0]), e = std::asin(d[2]), s = std::sin(e), c = std::cos(e);
  const double s3 = std::sqrt(3) / 2;
  return {1,
          std::sin(a) * c,
          s,
          std::cos(a) * c,
          s3 * std::sin(2 * a) * c * c,
          s3 * std::sin(a) * std::sin(2 * e),
          (3 * s * s - 1) / 2,
          s3 * std::cos(a) * std::sin(2 * e),
          s3 * std::cos(2 * a) * c * c,
          std::sqrt(5.0 / 8) * std::sin(3 * a) * c * c * c,
          std::sqrt(15.0) / 2 * std::sin(2 * a) * s * c * c,
          std::sqrt(3.0 / 8) * std::sin(a) * c * (5 * s * s - 1),
          s * (5 * s * s - 3) / 2,
          std::sqrt(3.0 / 8) * std::cos(a) * c * (5 * s * s - 1),
          std::sqrt(15.0) / 2 * std::cos(2 * a) * s * c * c,
          std::sqrt(5.0 / 8) * std::cos(3 * a) * c * c * c};
}

// Furse and Malham's table, channels W X Y Z R S T U V K L M N O P Q.
Numbers encoded_fuma(const Vector& d) {
  const double a = std::atan2(d[1], d[0]), e = std::asin(d[2]), s = std::sin(e), c = std::cos(e);
  const double l = std::sqrt(135.0 / 256);
  return {std::sqrt(0.5),
          std::cos(a) * c,
          std::sin(a) * c,
          s,
          1.5 * s * s - 0.5,
          std::cos(a) * std::sin(2 * e),
          std::sin(a) * std::sin(2 * e),
          std::cos(2 * a) * c * c,
          std::sin(2 * a) * c * c,
          s * (5 * s * s - 3) / 2,
          l * std::cos(a) * c * (5 * s * s - 1),
          l * std::sin(a) * c * (5 * s * s - 1),
          std::sqrt(27.0 / 4) * std::cos(2 * a) * s * c * c,
          std::sqrt(27.0 / 4) * std::sin(2 * a) * s * c * c,
          std::cos(3 * a) * c * c * c,
          std::sin(3 * a) * c * c * c};
}

// What a function of ours is in that quantity, at a direction: the definition by Funk and Hecke's factors.
template <int N>
double value_of(const Sh<N, double>& sh, Quantity quantity, const Vector& d) {
  if (quantity == Quantity::radiance) return reconstruct(sh, d);
  return (quantity == Quantity::irradiance ? pi : 1) * reconstruct(convolve(sh, project<N, double>(LambertLobe{})), d);
}

template <int N>
Sh<N, double> drawn(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Sh<N, double> sh;
  for (double& c : sh) c = uniform(random);
  return sh;
}

std::vector<Vector> directions(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<Vector> all;
  while (static_cast<int>(all.size()) < count) {
    const Vector v{normal(random), normal(random), normal(random)};
    const double length = std::hypot(v[0], v[1], v[2]);
    if (length > 1e-3) all.push_back({v[0] / length, v[1] / length, v[2] / length});
  }
  return all;
}

// The refusal's text, or none.
template <class F>
std::string refusal(const F& call) {
  try {
    call();
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return {};
}

// Greatest difference between the published function of our numbers, converted, and our own, over directions.
template <int N>
double greatest_difference(const Sh<N, double>& sh, const NamedConvention& named, const Published& text, int flipped,
                           int swapped = -1) {
  const Sh<N, double> stored = convert(sh, Convention{}, named.convention);
  Numbers numbers(stored.begin(), stored.end());
  if (flipped >= 0) numbers[static_cast<std::size_t>(flipped)] *= -1;
  if (swapped >= 0) {
    std::swap(numbers[static_cast<std::size_t>(swapped)], numbers[static_cast<std::size_t>(swapped + 1)]);
  }
  numbers.resize(16, 0);
  double greatest = 0;
  for (const Vector& d : directions(40, 7)) {
    greatest = std::max(greatest, std::abs(text.value(numbers, d) - value_of(sh, text.quantity, d)));
  }
  return greatest;
}

}  // namespace

TEST_CASE("conventions: the stored numbers make the function that the system's own formula says") {
  std::mt19937 random(1);
  std::set<std::string> tested;
  const auto test = [&](const NamedConvention& named, const Published& text, auto bands) {
    constexpr int N = decltype(bands)::value;
    const Sh<N, double> sh = drawn<N>(random);
    INFO(named.name << ", " << N << " bands");
    // Constants of d digits are off by so much of each of up to 16 terms.
    const double bound = text.digits > 0 ? 12 * text.digits : 2e-14;
    CHECK(greatest_difference(sh, named, text, -1) < bound);
    // Any one sign, or two terms exchanged, is seen.
    for (int i = 0; i < N * N; ++i) {
      if (text.quantity != Quantity::radiance && i >= 9) continue;  // degree 3 is nothing there
      INFO("term " << i);
      CHECK(greatest_difference(sh, named, text, i) > 100 * bound);
      if (i > 0) CHECK(greatest_difference(sh, named, text, -1, i - 1) > 100 * bound);
    }
  };
  for (const Published& text : published()) {
    const NamedConvention* named = find_convention(text.name);
    REQUIRE(named != nullptr);
    tested.insert(text.name);
    if (named->bands == 3) {
      test(*named, text, std::integral_constant<int, 3>{});
    } else {
      test(*named, text, std::integral_constant<int, 4>{});
    }
  }
  for (const NamedConvention& named : kConventions) {
    if (named.convention.meaning == Meaning::projection) continue;
    INFO(named.name);
    CHECK(tested.count(std::string(named.name)) == 1);
  }
}

TEST_CASE("conventions: ambisonics' channels are those of a plane wave") {
  for (const Vector& d : directions(40, 8)) {
    const Sh<4, double> wave = evaluate<4>(d);
    const Numbers sn3d = encoded_sn3d(d), fuma = encoded_fuma(d);
    const auto at = [&](const char* name) { return convert(wave, Convention{}, find_convention(name)->convention); };
    const Sh<4, double> ambix = at("ambix"), n3d = at("n3d"), furse = at("fuma");
    for (int i = 0; i < 16; ++i) {
      const std::size_t k = static_cast<std::size_t>(i);
      INFO("channel " << i << " at " << d[0] << ", " << d[1] << ", " << d[2]);
      const double degree = std::floor(std::sqrt(i + 0.5));
      CHECK(std::abs(ambix[i] - sn3d[k]) < 1e-14);
      CHECK(std::abs(n3d[i] - sn3d[k] * std::sqrt(2 * degree + 1)) < 2e-14);
      CHECK(std::abs(furse[i] - fuma[k]) < 1e-14);
    }
  }
}

TEST_CASE("conventions: there and back is what it was, and twice is the same as at once") {
  std::mt19937 random(2);
  const Sh<3, double> sh = drawn<3>(random);
  const Sh<3, float> single(sh);
  for (const NamedConvention& a : kConventions) {
    const Sh<3, double> stored = convert(sh, Convention{}, a.convention);
    const Sh<3, double> back = convert(stored, a.convention, Convention{});
    const Sh<3, float> single_back = convert(convert(single, Convention{}, a.convention), a.convention, Convention{});
    CHECK(convert(stored, a.convention, a.convention) == stored);
    for (int i = 0; i < 9; ++i) {
      INFO(a.name << ", " << i);
      CHECK(std::abs(back[i] - sh[i]) < 1e-15);
      CHECK(std::abs(single_back[i] - single[i]) < 6e-7F);
    }
    for (const NamedConvention& b : kConventions) {
      const Sh<3, double> through = convert(stored, a.convention, b.convention);
      const Sh<3, double> direct = convert(sh, Convention{}, b.convention);
      for (int i = 0; i < 9; ++i) {
        INFO(a.name << " to " << b.name << ", " << i);
        CHECK(std::abs(through[i] - direct[i]) < 1e-14);
      }
    }
  }
}

TEST_CASE("conventions: the basis is the derivative of the function by its numbers, at nine bands too") {
  std::mt19937 random(3);
  for (const NamedConvention& named : kConventions) {
    Convention c = named.convention;
    if (greatest_degree(c) < 8) continue;
    c.quantity = Quantity::radiance;
    const Sh<9, double> sh = drawn<9>(random);
    const Sh<9, double> stored = convert(sh, Convention{}, c);
    for (const Vector& d : directions(10, 9)) {
      const Sh<9, double> basis = evaluate_in<9, double>(c, d);
      INFO(named.name);
      if (c.meaning == Meaning::expansion) {
        CHECK(std::abs(dot(stored, basis) + c.offset - reconstruct(sh, d)) < 1e-13);
      } else {
        const Sh<9, double> wave = convert(evaluate<9>(d), Convention{}, c);
        for (int i = 0; i < 81; ++i) CHECK(std::abs(wave[i] - basis[i]) < 1e-14);
      }
    }
  }
}

TEST_CASE("conventions: what cannot be is refused, with its reason") {
  Sh<5, double> five{};
  CHECK(refusal([&] {
          convert(five, Convention{}, find_convention("fuma")->convention);
        }).find("degrees 0 to 3 for 5 bands") != std::string::npos);
  Convention twice{};
  twice.axes = {Axis::x, Axis::minus_x, Axis::z};
  CHECK(refusal([&] { convert(five, twice, Convention{}); }).find("three coordinates") != std::string::npos);
  for (const double scale : {0.0, std::nan("")}) {
    Convention nothing{};
    nothing.scale = scale;
    CHECK(refusal([&] { convert(five, nothing, Convention{}); }).find("scale") != std::string::npos);
  }
  // Of irradiance, what the cosine has taken away stays away: zeros, no infinities.
  Sh<6, double> irradiance{};
  for (double& c : irradiance) c = 1;
  Convention e{};
  e.quantity = Quantity::irradiance;
  const Sh<6, double> radiance = convert(irradiance, e, Convention{});
  for (int m = -3; m <= 3; ++m) CHECK_FALSE(std::abs(radiance(3, m)) > 0);
  CHECK(std::abs(radiance(4, 0) + 24 / pi) < 1e-14);
}

TEST_CASE("conventions: complex coefficients are those of SciPy's harmonics") {
  std::mt19937 random(4);
  const Sh<5, double> sh = drawn<5>(random);
  const auto complex = to_complex(sh);
  // std::sph_legendre is Y_l^m at phi = 0, m >= 0, with the phase.
  for (const Vector& d : directions(30, 10)) {
    const double theta = std::acos(d[2]), phi = std::atan2(d[1], d[0]);
    std::complex<double> f = 0;
    for (int l = 0; l < 5; ++l) {
      for (int m = -l; m <= l; ++m) {
        const unsigned order = static_cast<unsigned>(std::abs(m));
        const double sign = m < 0 && m % 2 != 0 ? -1 : 1;  // Y_l^-m = (-1)^m conj(Y_l^m)
        f += complex(l, m) * sign * std::sph_legendre(static_cast<unsigned>(l), order, theta) *
             std::exp(std::complex<double>(0, m * phi));
      }
    }
    CHECK(std::abs(f.imag()) < 1e-13);
    CHECK(std::abs(f.real() - reconstruct(sh, d)) < 1e-13);
  }
  const Sh<5, double> back = from_complex(complex);
  for (int i = 0; i < 25; ++i) CHECK(std::abs(back[i] - sh[i]) < 1e-15);
}

TEST_CASE("conventions: another frame is the same light, where its axes are") {
  std::mt19937 random(5);
  const Sh<6, double> sh = drawn<6>(random);
  const Frame all[] = {frames::opengl, frames::gltf,   frames::unity,
                       frames::unreal, frames::colmap, frames::zonal_picture};
  CHECK(is_right_handed(frames::opengl));
  CHECK(is_right_handed(frames::gltf));
  CHECK(is_right_handed(frames::colmap));
  CHECK(is_right_handed(frames::zonal_picture));
  CHECK(!is_right_handed(frames::unity));
  CHECK(!is_right_handed(frames::unreal));
  const auto coordinates = [](const Frame& f, double right, double up, double forward) {
    Vector d{};
    const Axis axes[3] = {f.right, f.up, f.forward};
    const double along[3] = {right, up, forward};
    for (int i = 0; i < 3; ++i) {
      const int number = static_cast<int>(axes[i]);
      d[static_cast<std::size_t>(std::abs(number) - 1)] = number < 0 ? -along[i] : along[i];
    }
    return d;
  };
  for (const Frame& from : all) {
    for (const Frame& to : all) {
      const Sh<6, double> moved = change_frame(sh, from, to);
      for (const Vector& d : directions(10, 11)) {
        CHECK(std::abs(reconstruct(moved, coordinates(to, d[0], d[1], d[2])) -
                       reconstruct(sh, coordinates(from, d[0], d[1], d[2]))) < 1e-13);
      }
    }
  }
}

TEST_CASE("conventions: what shaders take is E / pi of the radiance that it came of") {
  std::mt19937 random(6);
  const Sh<3, double> sh = drawn<3>(random);
  const Sh<3, double> unity = convert(sh, Convention{}, find_convention("unity")->convention);
  const SevenVectors<double> seven = seven_vectors(unity);
  const NinePolynomials<double> nine = nine_polynomials(unity);
  const Sh<3, double> back = to_unity(seven);
  for (int i = 0; i < 9; ++i) CHECK(std::abs(back[i] - unity[i]) < 1e-15);
  // Unreal's SetupSkyIrradianceEnvironmentMapConstants, of its own coefficients; Babylon.js' updateFromHarmonics.
  const double s = std::sqrt(pi), c0 = 1 / (2 * s), c1 = std::sqrt(3) / (3 * s), c2 = std::sqrt(15) / (8 * s),
               c3 = std::sqrt(5) / (16 * s), c4 = c2 / 2;
  const double unreal[9] = {-c1 * sh[3],    -c1 * sh[1], c1 * sh[2], c0 * sh[0] - c3 * sh[6], c2 * sh[4], -c2 * sh[5],
                            3 * c3 * sh[6], -c2 * sh[7], c4 * sh[8]};
  for (int i = 0; i < 4; ++i) {
    CHECK(std::abs(seven.a[i] - unreal[i]) < 1e-15);
    CHECK(std::abs(seven.b[i] - unreal[4 + i]) < 1e-15);
  }
  CHECK(std::abs(seven.c - unreal[8]) < 1e-15);
  const Sh<3, double> e = convert(sh, Convention{}, [] {
    Convention c;
    c.quantity = Quantity::irradiance;
    return c;
  }());
  CHECK(std::abs(nine.xx - (0.282095 * e[0] - 0.315392 * e[6] + 0.546274 * e[8]) / pi) < 2e-6);
  for (const Vector& d : directions(30, 12)) {
    const double truth = value_of(sh, Quantity::irradiance_over_pi, d);
    CHECK(std::abs(reconstruct(seven, d) - truth) < 1e-15 * 8);
    CHECK(std::abs(reconstruct(nine, d) - truth) < 1e-15 * 8);
    CHECK(std::abs(reconstruct_polynomials(unity, d) - truth) < 1e-15 * 8);
    const Numbers numbers(unity.begin(), unity.end());
    CHECK(std::abs(::unity(numbers, d) - truth) < 1e-15 * 8);
  }
}
