// zonal: spherical harmonics for renderers.
//
// This header is the part that needs the standard library alone: the basis, zonal lobes, and what is done to them.
// Packets and pictures are included by their own headers, zonal/scalar/packet.hpp, zonal/environment/..., as are the
// rooms that speak GLM or Eigen: zonal/light/..., zonal/material/..., zonal/gather/..., zonal/grid/...
//
// Conventions, everywhere in this library
//
// - degree l, order m, bands N: degrees 0 to N-1. The coefficient of (l, m) stands at l(l+1)+m.
// - real harmonics, orthonormal over the sphere, with the Condon-Shortley phase:
//   Y_0^0 = sqrt(1/4pi),  (Y_1^-1, Y_1^0, Y_1^1) = sqrt(3/4pi) (-y, z, -x).
//   As Sloan's generated code, DirectXMath, google/spherical-harmonics and 3D Gaussian splatting have it.
// - the polar axis is z; frames are right-handed.
// - a zonal coefficient is z_l = integral of f Y_l^0; oriented, f_l^m = sqrt(4pi/(2l+1)) z_l Y_l^m(axis).
// - directions are unit vectors (asserted in debug builds) and point from the receiver to the light.
// - radiance, irradiance E, and E/pi are different quantities; each function says which.
#pragma once

#include "basis/bands.hpp"
#include "basis/evaluate.hpp"
#include "basis/gradient.hpp"
#include "basis/sh.hpp"
#include "lobe/cap.hpp"
#include "lobe/lambert.hpp"
#include "lobe/phong.hpp"
#include "lobe/spherical_gaussian.hpp"
#include "scalar/math.hpp"
#include "transform/convolve.hpp"
#include "transform/dot.hpp"
#include "transform/orient.hpp"
#include "transform/product.hpp"
#include "transform/rotate.hpp"
#include "transform/sample.hpp"
#include "transform/window.hpp"
#include "version.hpp"
