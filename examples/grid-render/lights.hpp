#pragma once

#include <vector>

#include <zonal/grid/light_sums.hpp>
#include <zonal/light/sphere.hpp>
#include <zonal/light/triangle.hpp>

#include "options.hpp"
#include "shared/image.hpp"
#include "shared/scene.hpp"

namespace example::grid_render {

template <class Light>
using Lights = std::vector<zonal::ColouredLight<Light>>;
using SphereLights = Lights<zonal::SphereLight<float>>;
using TriangleLights = Lights<zonal::TriangleLight<float>>;
using TriangleSphereLights = Lights<zonal::TriangleSphereLight<float>>;

/// Strings of lanterns over the panel, sagging between their hooks, their hue changing along and across.
SphereLights make_lanterns(const LightPanel& panel, int count);

/// The picture at the texels of a panel whose longer side has `longest`: as square as they can be.
Image texels_of(const Image& picture, const LightPanel& panel, int longest);

/// A sphere for each texel, or for each leaf of a quadtree; its disc has the leaf's area, and its radiance is the
/// leaf's mean. Spheres shine to all sides, so neither is the panel dark behind nor does its cosine count.
/// `quadtree_error` is the greatest difference of a texel's channel from its leaf's mean, of the picture's mean;
/// without it every texel that is not black is a light.
SphereLights make_texture_lights(const LightPanel& panel, const Image& texels, std::optional<float> quadtree_error);

/// Two triangles for each sphere: a square as large as its disc, parallel to the panel. They shine to both sides.
TriangleLights triangles_of(const SphereLights& lights, const LightPanel& panel);

/// Each triangle approximated by a sphere with a cosine.
TriangleSphereLights triangle_spheres_of(const TriangleLights& triangles);

/// The lights that the options ask for, all together as bright as `panel.distance` wants: what lies there and faces
/// them reflects a radiance of about 1 if white. Throws InputError.
SphereLights make_lights(const Scene& scene, const Options& options);

}  // namespace example::grid_render
