// zonal 0.2.0, WGSL. --bands 5 --functions evaluate@2,evaluate@3,evaluate@4,evaluate@5,evaluate_with_gradient@2,evaluate_with_gradient@3,evaluate_with_gradient@4,evaluate_with_gradient@5,reconstruct@2,reconstruct@3,reconstruct@4,reconstruct@5,reconstruct_colour@2,reconstruct_colour@3,reconstruct_colour@4,reconstruct_colour@5,reconstruct_lambert@2,reconstruct_lambert@3,reconstruct_lambert@4,reconstruct_lambert@5,reconstruct_lambert_colour@2,reconstruct_lambert_colour@3,reconstruct_lambert_colour@4,reconstruct_lambert_colour@5,orient@2,orient@3,orient@4,orient@5,orient_colour@2,orient_colour@3,orient_colour@4,orient_colour@5,dot@2,dot@3,dot@4,dot@5,dot_colour@2,dot_colour@3,dot_colour@4,dot_colour@5,dot_colours@2,dot_colours@3,dot_colours@4,dot_colours@5,convolve@2,convolve@3,convolve@4,convolve@5,convolve_colour@2,convolve_colour@3,convolve_colour@4,convolve_colour@5,lambert@2,lambert@3,lambert@4,lambert@5,cap@2,cap@3,cap@4,cap@5,cap_up_to_hemisphere@2,cap_up_to_hemisphere@3,cap_up_to_hemisphere@4,cap_up_to_hemisphere@5,sphere_cap@2,sphere_cap@3,sphere_cap@4,sphere_cap@5,phong@2,phong@3,phong@4,phong@5,spherical_gaussian@2,spherical_gaussian@3,spherical_gaussian@4,spherical_gaussian@5,project_sphere@2,project_sphere@3,project_sphere@4,project_sphere@5,reconstruct_with_adjoint@3,reconstruct_with_adjoint@4,splat_colour@3,splat_colour@4,splat_with_adjoint@3,splat_with_adjoint@4,rotate_about_z@2,rotate_about_z@3,prepare_rotation@2,prepare_rotation@3,rotate@2,rotate@3,rotate_colour@2,rotate_colour@3,product@2,product@3,product_colour@2,product_colour@3,triple_product@2,triple_product@3,reconstruct_seven_vectors,reconstruct_nine_polynomials_colour,reconstruct_polynomials_colour,linear_axis,hallucinate_zh3,hallucinate_zh3_colour,irradiance_zh3,irradiance_zh3_colour,irradiance_nonlinear,irradiance_nonlinear_colour,irradiance_six_floats,irradiance_six_floats_nonlinear,irradiance_bytes@2,irradiance_bytes@3
// 114 functions, 8708 operations. Written by zonal-glsl: do not edit.

// Y_l^m at a unit vector, at l (l + 1) + m.
// 3 operations: 0 additions, 3 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_evaluate_2(direction: vec3<f32>, y: ptr<function, array<f32, 4>>) {
  (*y)[0] = 0.2820948f;
  (*y)[1] = -0.48860252f * direction.y;
  (*y)[2] = 0.48860252f * direction.z;
  (*y)[3] = -0.48860252f * direction.x;
}

// Y_l^m at a unit vector, at l (l + 1) + m.
// 16 operations: 3 additions, 13 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_evaluate_3(direction: vec3<f32>, y: ptr<function, array<f32, 9>>) {
  (*y)[0] = 0.2820948f;
  (*y)[1] = -0.48860252f * direction.y;
  (*y)[2] = 0.48860252f * direction.z;
  (*y)[3] = -0.48860252f * direction.x;
  let t0 = direction.y * direction.x;
  (*y)[4] = 0.54627424f * (t0 + t0);
  let t1 = -1.0925485f * direction.z;
  (*y)[5] = t1 * direction.y;
  (*y)[6] = 0.9461747f * (direction.z * direction.z) + -0.31539157f;
  (*y)[7] = t1 * direction.x;
  (*y)[8] = 0.54627424f * (direction.x * direction.x - direction.y * direction.y);
}

// Y_l^m at a unit vector, at l (l + 1) + m.
// 34 operations: 7 additions, 27 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_evaluate_4(direction: vec3<f32>, y: ptr<function, array<f32, 16>>) {
  (*y)[0] = 0.2820948f;
  (*y)[1] = -0.48860252f * direction.y;
  (*y)[2] = 0.48860252f * direction.z;
  (*y)[3] = -0.48860252f * direction.x;
  let t0 = direction.y * direction.x;
  let t1 = t0 + t0;
  (*y)[4] = 0.54627424f * t1;
  let t2 = -1.0925485f * direction.z;
  (*y)[5] = t2 * direction.y;
  let t3 = direction.z * direction.z;
  (*y)[6] = 0.9461747f * t3 + -0.31539157f;
  (*y)[7] = t2 * direction.x;
  let t4 = direction.x * direction.x - direction.y * direction.y;
  (*y)[8] = 0.54627424f * t4;
  (*y)[9] = -0.5900436f * (direction.x * t1 + direction.y * t4);
  let t5 = 1.4453057f * direction.z;
  (*y)[10] = t5 * t1;
  let t6 = -2.285229f * t3 + 0.4570458f;
  (*y)[11] = t6 * direction.y;
  (*y)[12] = direction.z * (1.8658817f * t3 + -1.119529f);
  (*y)[13] = t6 * direction.x;
  (*y)[14] = t5 * t4;
  (*y)[15] = -0.5900436f * (direction.x * t4 - direction.y * t1);
}

// Y_l^m at a unit vector, at l (l + 1) + m.
// 58 operations: 12 additions, 46 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_evaluate_5(direction: vec3<f32>, y: ptr<function, array<f32, 25>>) {
  (*y)[0] = 0.2820948f;
  (*y)[1] = -0.48860252f * direction.y;
  (*y)[2] = 0.48860252f * direction.z;
  (*y)[3] = -0.48860252f * direction.x;
  let t0 = direction.y * direction.x;
  let t1 = t0 + t0;
  (*y)[4] = 0.54627424f * t1;
  let t2 = -1.0925485f * direction.z;
  (*y)[5] = t2 * direction.y;
  let t3 = direction.z * direction.z;
  let t4 = 0.9461747f * t3 + -0.31539157f;
  (*y)[6] = t4;
  (*y)[7] = t2 * direction.x;
  let t5 = direction.x * direction.x - direction.y * direction.y;
  (*y)[8] = 0.54627424f * t5;
  let t6 = direction.x * t1 + direction.y * t5;
  (*y)[9] = -0.5900436f * t6;
  let t7 = 1.4453057f * direction.z;
  (*y)[10] = t7 * t1;
  let t8 = -2.285229f * t3 + 0.4570458f;
  (*y)[11] = t8 * direction.y;
  let t9 = direction.z * (1.8658817f * t3 + -1.119529f);
  (*y)[12] = t9;
  (*y)[13] = t8 * direction.x;
  (*y)[14] = t7 * t5;
  let t10 = direction.x * t5 - direction.y * t1;
  (*y)[15] = -0.5900436f * t10;
  (*y)[16] = 0.6258357f * (direction.x * t6 + direction.y * t10);
  let t11 = -1.7701308f * direction.z;
  (*y)[17] = t11 * t6;
  let t12 = 3.3116114f * t3 + -0.47308734f;
  (*y)[18] = t12 * t1;
  let t13 = direction.z * (-4.683326f * t3 + 2.0071397f);
  (*y)[19] = t13 * direction.y;
  (*y)[20] = 1.9843135f * direction.z * t9 - 1.0062306f * t4;
  (*y)[21] = t13 * direction.x;
  (*y)[22] = t12 * t5;
  (*y)[23] = t11 * t10;
  (*y)[24] = 0.6258357f * (direction.x * t10 - direction.y * t6);
}

// Y_l^m and the gradient of Y_l^m(v / |v|) at a unit vector.
// 21 operations: 9 additions, 12 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_evaluate_with_gradient_2(direction: vec3<f32>, y: ptr<function, array<f32, 4>>,
    gradient: ptr<function, array<vec3<f32>, 4>>) {
  (*y)[0] = 0.2820948f;
  let t0 = -0.48860252f * direction.y;
  (*y)[1] = t0;
  let t1 = 0.48860252f * direction.z;
  (*y)[2] = t1;
  let t2 = -0.48860252f * direction.x;
  (*y)[3] = t2;
  (*gradient)[0].x = 0.0f;
  (*gradient)[0].y = 0.0f;
  (*gradient)[0].z = 0.0f;
  (*gradient)[1].x = 0.0f - direction.x * t0;
  (*gradient)[1].y = -0.48860252f - direction.y * t0;
  (*gradient)[1].z = 0.0f - direction.z * t0;
  (*gradient)[2].x = 0.0f - direction.x * t1;
  (*gradient)[2].y = 0.0f - direction.y * t1;
  (*gradient)[2].z = 0.48860252f - direction.z * t1;
  (*gradient)[3].x = -0.48860252f - direction.x * t2;
  (*gradient)[3].y = 0.0f - direction.y * t2;
  (*gradient)[3].z = 0.0f - direction.z * t2;
}

// Y_l^m and the gradient of Y_l^m(v / |v|) at a unit vector.
// 76 operations: 28 additions, 48 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_evaluate_with_gradient_3(direction: vec3<f32>, y: ptr<function, array<f32, 9>>,
    gradient: ptr<function, array<vec3<f32>, 9>>) {
  (*y)[0] = 0.2820948f;
  let t0 = -0.48860252f * direction.y;
  (*y)[1] = t0;
  let t1 = 0.48860252f * direction.z;
  (*y)[2] = t1;
  let t2 = -0.48860252f * direction.x;
  (*y)[3] = t2;
  let t3 = direction.y * direction.x;
  let t4 = 0.54627424f * (t3 + t3);
  (*y)[4] = t4;
  let t5 = -1.0925485f * direction.z;
  let t6 = t5 * direction.y;
  (*y)[5] = t6;
  let t7 = 0.9461747f * (direction.z * direction.z) + -0.31539157f;
  (*y)[6] = t7;
  let t8 = t5 * direction.x;
  (*y)[7] = t8;
  let t9 = 0.54627424f * (direction.x * direction.x - direction.y * direction.y);
  (*y)[8] = t9;
  (*gradient)[0].x = 0.0f;
  (*gradient)[0].y = 0.0f;
  (*gradient)[0].z = 0.0f;
  (*gradient)[1].x = 0.0f - direction.x * t0;
  (*gradient)[1].y = -0.48860252f - direction.y * t0;
  (*gradient)[1].z = 0.0f - direction.z * t0;
  (*gradient)[2].x = 0.0f - direction.x * t1;
  (*gradient)[2].y = 0.0f - direction.y * t1;
  (*gradient)[2].z = 0.48860252f - direction.z * t1;
  (*gradient)[3].x = -0.48860252f - direction.x * t2;
  (*gradient)[3].y = 0.0f - direction.y * t2;
  (*gradient)[3].z = 0.0f - direction.z * t2;
  let t10 = -2.236068f * t0;
  let t11 = 2.0f * direction.x;
  (*gradient)[4].x = t10 - t11 * t4;
  let t12 = -2.236068f * t2;
  let t13 = 2.0f * direction.y;
  (*gradient)[4].y = t12 - t13 * t4;
  let t14 = 2.0f * direction.z;
  (*gradient)[4].z = 0.0f - t14 * t4;
  (*gradient)[5].x = 0.0f - t11 * t6;
  let t15 = -2.236068f * t1;
  (*gradient)[5].y = t15 - t13 * t6;
  (*gradient)[5].z = 2.236068f * t0 - t14 * t6;
  (*gradient)[6].x = 1.2909944f * t2 - t11 * t7;
  (*gradient)[6].y = 1.2909944f * t0 - t13 * t7;
  (*gradient)[6].z = 2.5819888f * t1 - t14 * t7;
  (*gradient)[7].x = t15 - t11 * t8;
  (*gradient)[7].y = 0.0f - t13 * t8;
  (*gradient)[7].z = 2.236068f * t2 - t14 * t8;
  (*gradient)[8].x = t12 - t11 * t9;
  (*gradient)[8].y = -t10 - t13 * t9;
  (*gradient)[8].z = 0.0f - t14 * t9;
}

// Y_l^m and the gradient of Y_l^m(v / |v|) at a unit vector.
// 157 operations: 57 additions, 100 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_evaluate_with_gradient_4(direction: vec3<f32>, y: ptr<function, array<f32, 16>>,
    gradient: ptr<function, array<vec3<f32>, 16>>) {
  (*y)[0] = 0.2820948f;
  let t0 = -0.48860252f * direction.y;
  (*y)[1] = t0;
  let t1 = 0.48860252f * direction.z;
  (*y)[2] = t1;
  let t2 = -0.48860252f * direction.x;
  (*y)[3] = t2;
  let t3 = direction.y * direction.x;
  let t4 = t3 + t3;
  let t5 = 0.54627424f * t4;
  (*y)[4] = t5;
  let t6 = -1.0925485f * direction.z;
  let t7 = t6 * direction.y;
  (*y)[5] = t7;
  let t8 = direction.z * direction.z;
  let t9 = 0.9461747f * t8 + -0.31539157f;
  (*y)[6] = t9;
  let t10 = t6 * direction.x;
  (*y)[7] = t10;
  let t11 = direction.x * direction.x - direction.y * direction.y;
  let t12 = 0.54627424f * t11;
  (*y)[8] = t12;
  let t13 = -0.5900436f * (direction.x * t4 + direction.y * t11);
  (*y)[9] = t13;
  let t14 = 1.4453057f * direction.z;
  let t15 = t14 * t4;
  (*y)[10] = t15;
  let t16 = -2.285229f * t8 + 0.4570458f;
  let t17 = t16 * direction.y;
  (*y)[11] = t17;
  let t18 = direction.z * (1.8658817f * t8 + -1.119529f);
  (*y)[12] = t18;
  let t19 = t16 * direction.x;
  (*y)[13] = t19;
  let t20 = t14 * t11;
  (*y)[14] = t20;
  let t21 = -0.5900436f * (direction.x * t11 - direction.y * t4);
  (*y)[15] = t21;
  (*gradient)[0].x = 0.0f;
  (*gradient)[0].y = 0.0f;
  (*gradient)[0].z = 0.0f;
  (*gradient)[1].x = 0.0f - direction.x * t0;
  (*gradient)[1].y = -0.48860252f - direction.y * t0;
  (*gradient)[1].z = 0.0f - direction.z * t0;
  (*gradient)[2].x = 0.0f - direction.x * t1;
  (*gradient)[2].y = 0.0f - direction.y * t1;
  (*gradient)[2].z = 0.48860252f - direction.z * t1;
  (*gradient)[3].x = -0.48860252f - direction.x * t2;
  (*gradient)[3].y = 0.0f - direction.y * t2;
  (*gradient)[3].z = 0.0f - direction.z * t2;
  let t22 = -2.236068f * t0;
  let t23 = 2.0f * direction.x;
  (*gradient)[4].x = t22 - t23 * t5;
  let t24 = -2.236068f * t2;
  let t25 = 2.0f * direction.y;
  (*gradient)[4].y = t24 - t25 * t5;
  let t26 = 2.0f * direction.z;
  (*gradient)[4].z = 0.0f - t26 * t5;
  (*gradient)[5].x = 0.0f - t23 * t7;
  let t27 = -2.236068f * t1;
  (*gradient)[5].y = t27 - t25 * t7;
  (*gradient)[5].z = 2.236068f * t0 - t26 * t7;
  (*gradient)[6].x = 1.2909944f * t2 - t23 * t9;
  (*gradient)[6].y = 1.2909944f * t0 - t25 * t9;
  (*gradient)[6].z = 2.5819888f * t1 - t26 * t9;
  (*gradient)[7].x = t27 - t23 * t10;
  (*gradient)[7].y = 0.0f - t25 * t10;
  (*gradient)[7].z = 2.236068f * t2 - t26 * t10;
  (*gradient)[8].x = t24 - t23 * t12;
  (*gradient)[8].y = -t22 - t25 * t12;
  (*gradient)[8].z = 0.0f - t26 * t12;
  let t28 = -3.2403703f * t5;
  let t29 = 3.0f * direction.x;
  (*gradient)[9].x = t28 - t29 * t13;
  let t30 = -3.2403703f * t12;
  let t31 = 3.0f * direction.y;
  (*gradient)[9].y = t30 - t31 * t13;
  let t32 = 3.0f * direction.z;
  (*gradient)[9].z = 0.0f - t32 * t13;
  let t33 = -2.6457512f * t7;
  (*gradient)[10].x = t33 - t29 * t15;
  let t34 = -2.6457512f * t10;
  (*gradient)[10].y = t34 - t31 * t15;
  (*gradient)[10].z = 2.6457512f * t5 - t32 * t15;
  let t35 = 0.83666f * t5;
  (*gradient)[11].x = t35 - t29 * t17;
  let t36 = -2.8982754f * t9;
  let t37 = 0.83666f * t12;
  (*gradient)[11].y = t36 - t37 - t31 * t17;
  (*gradient)[11].z = 3.34664f * t7 - t32 * t17;
  (*gradient)[12].x = 2.04939f * t10 - t29 * t18;
  (*gradient)[12].y = 2.04939f * t7 - t31 * t18;
  (*gradient)[12].z = 3.5496478f * t9 - t32 * t18;
  (*gradient)[13].x = t37 + t36 - t29 * t19;
  (*gradient)[13].y = t35 - t31 * t19;
  (*gradient)[13].z = 3.34664f * t10 - t32 * t19;
  (*gradient)[14].x = t34 - t29 * t20;
  (*gradient)[14].y = -t33 - t31 * t20;
  (*gradient)[14].z = 2.6457512f * t12 - t32 * t20;
  (*gradient)[15].x = t30 - t29 * t21;
  (*gradient)[15].y = -t28 - t31 * t21;
  (*gradient)[15].z = 0.0f - t32 * t21;
}

// Y_l^m and the gradient of Y_l^m(v / |v|) at a unit vector.
// 266 operations: 97 additions, 169 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_evaluate_with_gradient_5(direction: vec3<f32>, y: ptr<function, array<f32, 25>>,
    gradient: ptr<function, array<vec3<f32>, 25>>) {
  (*y)[0] = 0.2820948f;
  let t0 = -0.48860252f * direction.y;
  (*y)[1] = t0;
  let t1 = 0.48860252f * direction.z;
  (*y)[2] = t1;
  let t2 = -0.48860252f * direction.x;
  (*y)[3] = t2;
  let t3 = direction.y * direction.x;
  let t4 = t3 + t3;
  let t5 = 0.54627424f * t4;
  (*y)[4] = t5;
  let t6 = -1.0925485f * direction.z;
  let t7 = t6 * direction.y;
  (*y)[5] = t7;
  let t8 = direction.z * direction.z;
  let t9 = 0.9461747f * t8 + -0.31539157f;
  (*y)[6] = t9;
  let t10 = t6 * direction.x;
  (*y)[7] = t10;
  let t11 = direction.x * direction.x - direction.y * direction.y;
  let t12 = 0.54627424f * t11;
  (*y)[8] = t12;
  let t13 = direction.x * t4 + direction.y * t11;
  let t14 = -0.5900436f * t13;
  (*y)[9] = t14;
  let t15 = 1.4453057f * direction.z;
  let t16 = t15 * t4;
  (*y)[10] = t16;
  let t17 = -2.285229f * t8 + 0.4570458f;
  let t18 = t17 * direction.y;
  (*y)[11] = t18;
  let t19 = direction.z * (1.8658817f * t8 + -1.119529f);
  (*y)[12] = t19;
  let t20 = t17 * direction.x;
  (*y)[13] = t20;
  let t21 = t15 * t11;
  (*y)[14] = t21;
  let t22 = direction.x * t11 - direction.y * t4;
  let t23 = -0.5900436f * t22;
  (*y)[15] = t23;
  let t24 = 0.6258357f * (direction.x * t13 + direction.y * t22);
  (*y)[16] = t24;
  let t25 = -1.7701308f * direction.z;
  let t26 = t25 * t13;
  (*y)[17] = t26;
  let t27 = 3.3116114f * t8 + -0.47308734f;
  let t28 = t27 * t4;
  (*y)[18] = t28;
  let t29 = direction.z * (-4.683326f * t8 + 2.0071397f);
  let t30 = t29 * direction.y;
  (*y)[19] = t30;
  let t31 = 1.9843135f * direction.z * t19 - 1.0062306f * t9;
  (*y)[20] = t31;
  let t32 = t29 * direction.x;
  (*y)[21] = t32;
  let t33 = t27 * t11;
  (*y)[22] = t33;
  let t34 = t25 * t22;
  (*y)[23] = t34;
  let t35 = 0.6258357f * (direction.x * t22 - direction.y * t13);
  (*y)[24] = t35;
  (*gradient)[0].x = 0.0f;
  (*gradient)[0].y = 0.0f;
  (*gradient)[0].z = 0.0f;
  (*gradient)[1].x = 0.0f - direction.x * t0;
  (*gradient)[1].y = -0.48860252f - direction.y * t0;
  (*gradient)[1].z = 0.0f - direction.z * t0;
  (*gradient)[2].x = 0.0f - direction.x * t1;
  (*gradient)[2].y = 0.0f - direction.y * t1;
  (*gradient)[2].z = 0.48860252f - direction.z * t1;
  (*gradient)[3].x = -0.48860252f - direction.x * t2;
  (*gradient)[3].y = 0.0f - direction.y * t2;
  (*gradient)[3].z = 0.0f - direction.z * t2;
  let t36 = -2.236068f * t0;
  let t37 = 2.0f * direction.x;
  (*gradient)[4].x = t36 - t37 * t5;
  let t38 = -2.236068f * t2;
  let t39 = 2.0f * direction.y;
  (*gradient)[4].y = t38 - t39 * t5;
  let t40 = 2.0f * direction.z;
  (*gradient)[4].z = 0.0f - t40 * t5;
  (*gradient)[5].x = 0.0f - t37 * t7;
  let t41 = -2.236068f * t1;
  (*gradient)[5].y = t41 - t39 * t7;
  (*gradient)[5].z = 2.236068f * t0 - t40 * t7;
  (*gradient)[6].x = 1.2909944f * t2 - t37 * t9;
  (*gradient)[6].y = 1.2909944f * t0 - t39 * t9;
  (*gradient)[6].z = 2.5819888f * t1 - t40 * t9;
  (*gradient)[7].x = t41 - t37 * t10;
  (*gradient)[7].y = 0.0f - t39 * t10;
  (*gradient)[7].z = 2.236068f * t2 - t40 * t10;
  (*gradient)[8].x = t38 - t37 * t12;
  (*gradient)[8].y = -t36 - t39 * t12;
  (*gradient)[8].z = 0.0f - t40 * t12;
  let t42 = -3.2403703f * t5;
  let t43 = 3.0f * direction.x;
  (*gradient)[9].x = t42 - t43 * t14;
  let t44 = -3.2403703f * t12;
  let t45 = 3.0f * direction.y;
  (*gradient)[9].y = t44 - t45 * t14;
  let t46 = 3.0f * direction.z;
  (*gradient)[9].z = 0.0f - t46 * t14;
  let t47 = -2.6457512f * t7;
  (*gradient)[10].x = t47 - t43 * t16;
  let t48 = -2.6457512f * t10;
  (*gradient)[10].y = t48 - t45 * t16;
  (*gradient)[10].z = 2.6457512f * t5 - t46 * t16;
  let t49 = 0.83666f * t5;
  (*gradient)[11].x = t49 - t43 * t18;
  let t50 = -2.8982754f * t9;
  let t51 = 0.83666f * t12;
  (*gradient)[11].y = t50 - t51 - t45 * t18;
  (*gradient)[11].z = 3.34664f * t7 - t46 * t18;
  (*gradient)[12].x = 2.04939f * t10 - t43 * t19;
  (*gradient)[12].y = 2.04939f * t7 - t45 * t19;
  (*gradient)[12].z = 3.5496478f * t9 - t46 * t19;
  (*gradient)[13].x = t51 + t50 - t43 * t20;
  (*gradient)[13].y = t49 - t45 * t20;
  (*gradient)[13].z = 3.34664f * t10 - t46 * t20;
  (*gradient)[14].x = t48 - t43 * t21;
  (*gradient)[14].y = -t47 - t45 * t21;
  (*gradient)[14].z = 2.6457512f * t12 - t46 * t21;
  (*gradient)[15].x = t44 - t43 * t23;
  (*gradient)[15].y = -t42 - t45 * t23;
  (*gradient)[15].z = 0.0f - t46 * t23;
  let t52 = -4.2426405f * t14;
  let t53 = 4.0f * direction.x;
  (*gradient)[16].x = t52 - t53 * t24;
  let t54 = -4.2426405f * t23;
  let t55 = 4.0f * direction.y;
  (*gradient)[16].y = t54 - t55 * t24;
  let t56 = 4.0f * direction.z;
  (*gradient)[16].z = 0.0f - t56 * t24;
  let t57 = -3.6742346f * t16;
  (*gradient)[17].x = t57 - t53 * t26;
  let t58 = -3.6742346f * t21;
  (*gradient)[17].y = t58 - t55 * t26;
  (*gradient)[17].z = 3.0f * t14 - t56 * t26;
  let t59 = 0.80178374f * t14;
  let t60 = -3.105295f * t18;
  (*gradient)[18].x = t59 + t60 - t53 * t28;
  let t61 = -3.105295f * t20;
  let t62 = 0.80178374f * t23;
  (*gradient)[18].y = t61 - t62 - t55 * t28;
  (*gradient)[18].z = 3.927922f * t16 - t56 * t28;
  let t63 = 1.3887302f * t16;
  (*gradient)[19].x = t63 - t53 * t30;
  let t64 = -3.5856857f * t19;
  let t65 = 1.3887302f * t21;
  (*gradient)[19].y = t64 - t65 - t55 * t30;
  (*gradient)[19].z = 4.3915505f * t18 - t56 * t30;
  (*gradient)[20].x = 2.7774603f * t20 - t53 * t31;
  (*gradient)[20].y = 2.7774603f * t18 - t55 * t31;
  (*gradient)[20].z = 4.5355735f * t19 - t56 * t31;
  (*gradient)[21].x = t65 + t64 - t53 * t32;
  (*gradient)[21].y = t63 - t55 * t32;
  (*gradient)[21].z = 4.3915505f * t20 - t56 * t32;
  (*gradient)[22].x = t62 + t61 - t53 * t33;
  (*gradient)[22].y = t59 - t60 - t55 * t33;
  (*gradient)[22].z = 3.927922f * t21 - t56 * t33;
  (*gradient)[23].x = t58 - t53 * t34;
  (*gradient)[23].y = -t57 - t55 * t34;
  (*gradient)[23].z = 3.0f * t23 - t56 * t34;
  (*gradient)[24].x = t54 - t53 * t35;
  (*gradient)[24].y = -t52 - t55 * t35;
  (*gradient)[24].z = 0.0f - t56 * t35;
}

// A function's value in a direction: basis and sum fused.
// 10 operations: 3 additions, 7 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_2(sh: array<f32, 4>, direction: vec3<f32>) -> f32 {
  let t0 = sh[2] * (0.48860252f * direction.z) + sh[3] * (-0.48860252f * direction.x);
  let value = sh[0] * 0.2820948f + sh[1] * (-0.48860252f * direction.y) + t0;
  return value;
}

// A function's value in a direction: basis and sum fused.
// 33 operations: 11 additions, 22 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_3(sh: array<f32, 9>, direction: vec3<f32>) -> f32 {
  let t0 = direction.y * direction.x;
  let t1 = sh[8] * (0.54627424f * (direction.x * direction.x - direction.y * direction.y));
  let t2 = -1.0925485f * direction.z;
  let t3 = sh[0] * 0.2820948f + sh[4] * (0.54627424f * (t0 + t0)) + t1 + (sh[1] * (-0.48860252f * direction.y) + sh[5] * (t2 * direction.y));
  let t4 = sh[2] * (0.48860252f * direction.z) + sh[6] * (0.9461747f * (direction.z * direction.z) + -0.31539157f);
  let t5 = t4 + (sh[3] * (-0.48860252f * direction.x) + sh[7] * (t2 * direction.x));
  let value = t3 + t5;
  return value;
}

// A function's value in a direction: basis and sum fused.
// 65 operations: 22 additions, 43 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_4(sh: array<f32, 16>, direction: vec3<f32>) -> f32 {
  let t0 = direction.z * direction.z;
  let t1 = sh[0] * 0.2820948f + sh[12] * (direction.z * (1.8658817f * t0 + -1.119529f));
  let t2 = direction.y * direction.x;
  let t3 = t2 + t2;
  let t4 = direction.x * direction.x - direction.y * direction.y;
  let t5 = -1.0925485f * direction.z;
  let t6 = -2.285229f * t0 + 0.4570458f;
  let t7 = sh[1] * (-0.48860252f * direction.y) + sh[5] * (t5 * direction.y) + sh[13] * (t6 * direction.x);
  let t8 = t1 + sh[4] * (0.54627424f * t3) + sh[8] * (0.54627424f * t4) + (t7 + sh[9] * (-0.5900436f * (direction.x * t3 + direction.y * t4)));
  let t9 = sh[2] * (0.48860252f * direction.z) + sh[6] * (0.9461747f * t0 + -0.31539157f);
  let t10 = 1.4453057f * direction.z;
  let t11 = sh[3] * (-0.48860252f * direction.x) + sh[7] * (t5 * direction.x) + sh[11] * (t6 * direction.y);
  let t12 = t9 + sh[10] * (t10 * t3) + sh[14] * (t10 * t4) + (t11 + sh[15] * (-0.5900436f * (direction.x * t4 - direction.y * t3)));
  let value = t8 + t12;
  return value;
}

// A function's value in a direction: basis and sum fused.
// 107 operations: 36 additions, 71 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_5(sh: array<f32, 25>, direction: vec3<f32>) -> f32 {
  let t0 = direction.z * direction.z;
  let t1 = direction.z * (1.8658817f * t0 + -1.119529f);
  let t2 = 0.9461747f * t0 + -0.31539157f;
  let t3 = sh[0] * 0.2820948f + sh[12] * t1 + sh[20] * (1.9843135f * direction.z * t1 - 1.0062306f * t2);
  let t4 = direction.y * direction.x;
  let t5 = t4 + t4;
  let t6 = direction.x * direction.x - direction.y * direction.y;
  let t7 = direction.x * t5 + direction.y * t6;
  let t8 = direction.x * t6 - direction.y * t5;
  let t9 = t3 + sh[4] * (0.54627424f * t5) + sh[8] * (0.54627424f * t6) + sh[16] * (0.6258357f * (direction.x * t7 + direction.y * t8));
  let t10 = -1.0925485f * direction.z;
  let t11 = -2.285229f * t0 + 0.4570458f;
  let t12 = sh[1] * (-0.48860252f * direction.y) + sh[5] * (t10 * direction.y) + sh[13] * (t11 * direction.x);
  let t13 = direction.z * (-4.683326f * t0 + 2.0071397f);
  let t14 = -1.7701308f * direction.z;
  let t15 = t12 + sh[21] * (t13 * direction.x) + sh[9] * (-0.5900436f * t7) + sh[17] * (t14 * t7);
  let t16 = t9 + sh[24] * (0.6258357f * (direction.x * t8 - direction.y * t7)) + t15;
  let t17 = 1.4453057f * direction.z;
  let t18 = sh[2] * (0.48860252f * direction.z) + sh[6] * t2 + sh[10] * (t17 * t5) + sh[14] * (t17 * t6);
  let t19 = 3.3116114f * t0 + -0.47308734f;
  let t20 = sh[3] * (-0.48860252f * direction.x) + sh[7] * (t10 * direction.x) + sh[11] * (t11 * direction.y);
  let t21 = t20 + sh[19] * (t13 * direction.y) + sh[15] * (-0.5900436f * t8) + sh[23] * (t14 * t8);
  let value = t16 + (t18 + sh[18] * (t19 * t5) + sh[22] * (t19 * t6) + t21);
  return value;
}

// A function's value in a direction: basis and sum fused. For colours.
// 24 operations: 9 additions, 15 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_colour_2(sh: array<vec3<f32>, 4>, direction: vec3<f32>) -> vec3<f32> {
  let t0 = -0.48860252f * direction.y;
  let t1 = 0.48860252f * direction.z;
  let t2 = -0.48860252f * direction.x;
  let value = vec3<f32>(sh[0].x * 0.2820948f + sh[1].x * t0 + (sh[2].x * t1 + sh[3].x * t2),
      sh[0].y * 0.2820948f + sh[1].y * t0 + (sh[2].y * t1 + sh[3].y * t2),
      sh[0].z * 0.2820948f + sh[1].z * t0 + (sh[2].z * t1 + sh[3].z * t2));
  return value;
}

// A function's value in a direction: basis and sum fused. For colours.
// 67 operations: 27 additions, 40 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_colour_3(sh: array<vec3<f32>, 9>, direction: vec3<f32>) -> vec3<f32> {
  let t0 = direction.y * direction.x;
  let t1 = 0.54627424f * (t0 + t0);
  let t2 = 0.54627424f * (direction.x * direction.x - direction.y * direction.y);
  let t3 = -0.48860252f * direction.y;
  let t4 = -1.0925485f * direction.z;
  let t5 = t4 * direction.y;
  let t6 = sh[0].x * 0.2820948f + sh[4].x * t1 + sh[8].x * t2 + (sh[1].x * t3 + sh[5].x * t5);
  let t7 = 0.48860252f * direction.z;
  let t8 = 0.9461747f * (direction.z * direction.z) + -0.31539157f;
  let t9 = -0.48860252f * direction.x;
  let t10 = t4 * direction.x;
  let t11 = sh[0].y * 0.2820948f + sh[4].y * t1 + sh[8].y * t2 + (sh[1].y * t3 + sh[5].y * t5);
  let t12 = sh[0].z * 0.2820948f + sh[4].z * t1 + sh[8].z * t2 + (sh[1].z * t3 + sh[5].z * t5);
  let value = vec3<f32>(t6 + (sh[2].x * t7 + sh[6].x * t8 + (sh[3].x * t9 + sh[7].x * t10)),
      t11 + (sh[2].y * t7 + sh[6].y * t8 + (sh[3].y * t9 + sh[7].y * t10)),
      t12 + (sh[2].z * t7 + sh[6].z * t8 + (sh[3].z * t9 + sh[7].z * t10)));
  return value;
}

// A function's value in a direction: basis and sum fused. For colours.
// 127 operations: 52 additions, 75 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_colour_4(sh: array<vec3<f32>, 16>, direction: vec3<f32>) -> vec3<f32> {
  let t0 = direction.z * direction.z;
  let t1 = direction.z * (1.8658817f * t0 + -1.119529f);
  let t2 = direction.y * direction.x;
  let t3 = t2 + t2;
  let t4 = 0.54627424f * t3;
  let t5 = direction.x * direction.x - direction.y * direction.y;
  let t6 = 0.54627424f * t5;
  let t7 = -0.48860252f * direction.y;
  let t8 = -1.0925485f * direction.z;
  let t9 = t8 * direction.y;
  let t10 = -2.285229f * t0 + 0.4570458f;
  let t11 = t10 * direction.x;
  let t12 = -0.5900436f * (direction.x * t3 + direction.y * t5);
  let t13 = sh[0].x * 0.2820948f + sh[12].x * t1 + sh[4].x * t4 + sh[8].x * t6 + (sh[1].x * t7 + sh[5].x * t9 + sh[13].x * t11 + sh[9].x * t12);
  let t14 = 0.48860252f * direction.z;
  let t15 = 0.9461747f * t0 + -0.31539157f;
  let t16 = 1.4453057f * direction.z;
  let t17 = t16 * t3;
  let t18 = t16 * t5;
  let t19 = -0.48860252f * direction.x;
  let t20 = t8 * direction.x;
  let t21 = t10 * direction.y;
  let t22 = -0.5900436f * (direction.x * t5 - direction.y * t3);
  let t23 = sh[2].x * t14 + sh[6].x * t15 + sh[10].x * t17 + sh[14].x * t18 + (sh[3].x * t19 + sh[7].x * t20 + sh[11].x * t21 + sh[15].x * t22);
  let t24 = sh[0].y * 0.2820948f + sh[12].y * t1 + sh[4].y * t4 + sh[8].y * t6 + (sh[1].y * t7 + sh[5].y * t9 + sh[13].y * t11 + sh[9].y * t12);
  let t25 = sh[2].y * t14 + sh[6].y * t15 + sh[10].y * t17 + sh[14].y * t18 + (sh[3].y * t19 + sh[7].y * t20 + sh[11].y * t21 + sh[15].y * t22);
  let t26 = sh[0].z * 0.2820948f + sh[12].z * t1 + sh[4].z * t4 + sh[8].z * t6 + (sh[1].z * t7 + sh[5].z * t9 + sh[13].z * t11 + sh[9].z * t12);
  let t27 = sh[2].z * t14 + sh[6].z * t15 + sh[10].z * t17 + sh[14].z * t18 + (sh[3].z * t19 + sh[7].z * t20 + sh[11].z * t21 + sh[15].z * t22);
  let value = vec3<f32>(t13 + t23, t24 + t25, t26 + t27);
  return value;
}

// A function's value in a direction: basis and sum fused. For colours.
// 205 operations: 84 additions, 121 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_colour_5(sh: array<vec3<f32>, 25>, direction: vec3<f32>) -> vec3<f32> {
  let t0 = direction.z * direction.z;
  let t1 = direction.z * (1.8658817f * t0 + -1.119529f);
  let t2 = 0.9461747f * t0 + -0.31539157f;
  let t3 = 1.9843135f * direction.z * t1 - 1.0062306f * t2;
  let t4 = direction.y * direction.x;
  let t5 = t4 + t4;
  let t6 = 0.54627424f * t5;
  let t7 = direction.x * direction.x - direction.y * direction.y;
  let t8 = 0.54627424f * t7;
  let t9 = sh[0].x * 0.2820948f + sh[12].x * t1 + sh[20].x * t3 + sh[4].x * t6 + sh[8].x * t8;
  let t10 = direction.x * t5 + direction.y * t7;
  let t11 = direction.x * t7 - direction.y * t5;
  let t12 = 0.6258357f * (direction.x * t10 + direction.y * t11);
  let t13 = 0.6258357f * (direction.x * t11 - direction.y * t10);
  let t14 = -0.48860252f * direction.y;
  let t15 = -1.0925485f * direction.z;
  let t16 = t15 * direction.y;
  let t17 = -2.285229f * t0 + 0.4570458f;
  let t18 = t17 * direction.x;
  let t19 = direction.z * (-4.683326f * t0 + 2.0071397f);
  let t20 = t19 * direction.x;
  let t21 = -0.5900436f * t10;
  let t22 = sh[1].x * t14 + sh[5].x * t16 + sh[13].x * t18 + sh[21].x * t20 + sh[9].x * t21;
  let t23 = -1.7701308f * direction.z;
  let t24 = t23 * t10;
  let t25 = 0.48860252f * direction.z;
  let t26 = 1.4453057f * direction.z;
  let t27 = t26 * t5;
  let t28 = t26 * t7;
  let t29 = 3.3116114f * t0 + -0.47308734f;
  let t30 = t29 * t5;
  let t31 = sh[2].x * t25 + sh[6].x * t2 + sh[10].x * t27 + sh[14].x * t28 + sh[18].x * t30;
  let t32 = t29 * t7;
  let t33 = -0.48860252f * direction.x;
  let t34 = t15 * direction.x;
  let t35 = t17 * direction.y;
  let t36 = t19 * direction.y;
  let t37 = -0.5900436f * t11;
  let t38 = sh[3].x * t33 + sh[7].x * t34 + sh[11].x * t35 + sh[19].x * t36 + sh[15].x * t37;
  let t39 = t23 * t11;
  let t40 = t9 + sh[16].x * t12 + sh[24].x * t13 + (t22 + sh[17].x * t24) + (t31 + sh[22].x * t32 + (t38 + sh[23].x * t39));
  let t41 = sh[0].y * 0.2820948f + sh[12].y * t1 + sh[20].y * t3 + sh[4].y * t6 + sh[8].y * t8;
  let t42 = sh[1].y * t14 + sh[5].y * t16 + sh[13].y * t18 + sh[21].y * t20 + sh[9].y * t21;
  let t43 = sh[2].y * t25 + sh[6].y * t2 + sh[10].y * t27 + sh[14].y * t28 + sh[18].y * t30;
  let t44 = sh[3].y * t33 + sh[7].y * t34 + sh[11].y * t35 + sh[19].y * t36 + sh[15].y * t37;
  let t45 = t41 + sh[16].y * t12 + sh[24].y * t13 + (t42 + sh[17].y * t24) + (t43 + sh[22].y * t32 + (t44 + sh[23].y * t39));
  let t46 = sh[0].z * 0.2820948f + sh[12].z * t1 + sh[20].z * t3 + sh[4].z * t6 + sh[8].z * t8;
  let t47 = sh[1].z * t14 + sh[5].z * t16 + sh[13].z * t18 + sh[21].z * t20 + sh[9].z * t21;
  let t48 = sh[2].z * t25 + sh[6].z * t2 + sh[10].z * t27 + sh[14].z * t28 + sh[18].z * t30;
  let t49 = sh[3].z * t33 + sh[7].z * t34 + sh[11].z * t35 + sh[19].z * t36 + sh[15].z * t37;
  let t50 = t46 + sh[16].z * t12 + sh[24].z * t13 + (t47 + sh[17].z * t24) + (t48 + sh[22].z * t32 + (t49 + sh[23].z * t39));
  let value = vec3<f32>(t40, t45, t50);
  return value;
}

// Radiance convolved with the clamped cosine: irradiance over pi at a normal.
// 11 operations: 3 additions, 8 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_lambert_2(radiance: array<f32, 4>, normal: vec3<f32>) -> f32 {
  let t0 = radiance[2] * (0.48860252f * normal.z) + radiance[1] * (-0.48860252f * normal.y);
  let t1 = radiance[0] * 0.2820948f + (t0 + radiance[3] * (-0.48860252f * normal.x)) * 0.6666667f;
  let value = t1;
  return value;
}

// Radiance convolved with the clamped cosine: irradiance over pi at a normal.
// 35 operations: 11 additions, 24 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_lambert_3(radiance: array<f32, 9>, normal: vec3<f32>) -> f32 {
  let t0 = radiance[2] * (0.48860252f * normal.z) + radiance[1] * (-0.48860252f * normal.y);
  let t1 = radiance[0] * 0.2820948f + (t0 + radiance[3] * (-0.48860252f * normal.x)) * 0.6666667f;
  let t2 = -1.0925485f * normal.z;
  let t3 = radiance[6] * (0.9461747f * (normal.z * normal.z) + -0.31539157f) + radiance[5] * (t2 * normal.y);
  let t4 = normal.y * normal.x;
  let t5 = t3 + radiance[7] * (t2 * normal.x) + radiance[4] * (0.54627424f * (t4 + t4));
  let t6 = radiance[8] * (0.54627424f * (normal.x * normal.x - normal.y * normal.y));
  let value = t1 + (t5 + t6) * 0.25f;
  return value;
}

// Radiance convolved with the clamped cosine: irradiance over pi at a normal.
// 35 operations: 11 additions, 24 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_lambert_4(radiance: array<f32, 16>, normal: vec3<f32>) -> f32 {
  let t0 = radiance[2] * (0.48860252f * normal.z) + radiance[1] * (-0.48860252f * normal.y);
  let t1 = radiance[0] * 0.2820948f + (t0 + radiance[3] * (-0.48860252f * normal.x)) * 0.6666667f;
  let t2 = -1.0925485f * normal.z;
  let t3 = radiance[6] * (0.9461747f * (normal.z * normal.z) + -0.31539157f) + radiance[5] * (t2 * normal.y);
  let t4 = normal.y * normal.x;
  let t5 = t3 + radiance[7] * (t2 * normal.x) + radiance[4] * (0.54627424f * (t4 + t4));
  let t6 = radiance[8] * (0.54627424f * (normal.x * normal.x - normal.y * normal.y));
  let value = t1 + (t5 + t6) * 0.25f;
  return value;
}

// Radiance convolved with the clamped cosine: irradiance over pi at a normal.
// 87 operations: 28 additions, 59 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_lambert_5(radiance: array<f32, 25>, normal: vec3<f32>) -> f32 {
  let t0 = normal.z * normal.z;
  let t1 = 0.9461747f * t0 + -0.31539157f;
  let t2 = 1.9843135f * normal.z * (normal.z * (1.8658817f * t0 + -1.119529f)) - 1.0062306f * t1;
  let t3 = normal.z * (-4.683326f * t0 + 2.0071397f);
  let t4 = radiance[20] * t2 + radiance[19] * (t3 * normal.y) + radiance[21] * (t3 * normal.x);
  let t5 = 3.3116114f * t0 + -0.47308734f;
  let t6 = normal.y * normal.x;
  let t7 = t6 + t6;
  let t8 = normal.x * normal.x - normal.y * normal.y;
  let t9 = -1.7701308f * normal.z;
  let t10 = normal.x * t7 + normal.y * t8;
  let t11 = t4 + radiance[18] * (t5 * t7) + radiance[22] * (t5 * t8) + radiance[17] * (t9 * t10);
  let t12 = normal.x * t8 - normal.y * t7;
  let t13 = t11 + radiance[23] * (t9 * t12) + radiance[16] * (0.6258357f * (normal.x * t10 + normal.y * t12));
  let t14 = (t13 + radiance[24] * (0.6258357f * (normal.x * t12 - normal.y * t10))) * -0.041666668f;
  let t15 = radiance[2] * (0.48860252f * normal.z) + radiance[1] * (-0.48860252f * normal.y);
  let t16 = radiance[0] * 0.2820948f + t14 + (t15 + radiance[3] * (-0.48860252f * normal.x)) * 0.6666667f;
  let t17 = -1.0925485f * normal.z;
  let t18 = radiance[6] * t1 + radiance[5] * (t17 * normal.y) + radiance[7] * (t17 * normal.x);
  let t19 = t18 + radiance[4] * (0.54627424f * t7) + radiance[8] * (0.54627424f * t8);
  let value = t16 + t19 * 0.25f;
  return value;
}

// Radiance convolved with the clamped cosine: irradiance over pi at a normal. For colours.
// 27 operations: 9 additions, 18 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_lambert_colour_2(radiance: array<vec3<f32>, 4>, normal: vec3<f32>) -> vec3<f32> {
  let t0 = 0.48860252f * normal.z;
  let t1 = -0.48860252f * normal.y;
  let t2 = -0.48860252f * normal.x;
  let t3 = (radiance[2].x * t0 + radiance[1].x * t1 + radiance[3].x * t2) * 0.6666667f;
  let t4 = (radiance[2].y * t0 + radiance[1].y * t1 + radiance[3].y * t2) * 0.6666667f;
  let t5 = (radiance[2].z * t0 + radiance[1].z * t1 + radiance[3].z * t2) * 0.6666667f;
  let value = vec3<f32>(radiance[0].x * 0.2820948f + t3,
      radiance[0].y * 0.2820948f + t4,
      radiance[0].z * 0.2820948f + t5);
  return value;
}

// Radiance convolved with the clamped cosine: irradiance over pi at a normal. For colours.
// 73 operations: 27 additions, 46 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_lambert_colour_3(radiance: array<vec3<f32>, 9>, normal: vec3<f32>) -> vec3<f32> {
  let t0 = 0.48860252f * normal.z;
  let t1 = -0.48860252f * normal.y;
  let t2 = -0.48860252f * normal.x;
  let t3 = (radiance[2].x * t0 + radiance[1].x * t1 + radiance[3].x * t2) * 0.6666667f;
  let t4 = 0.9461747f * (normal.z * normal.z) + -0.31539157f;
  let t5 = -1.0925485f * normal.z;
  let t6 = t5 * normal.y;
  let t7 = t5 * normal.x;
  let t8 = normal.y * normal.x;
  let t9 = 0.54627424f * (t8 + t8);
  let t10 = radiance[6].x * t4 + radiance[5].x * t6 + radiance[7].x * t7 + radiance[4].x * t9;
  let t11 = 0.54627424f * (normal.x * normal.x - normal.y * normal.y);
  let t12 = (radiance[2].y * t0 + radiance[1].y * t1 + radiance[3].y * t2) * 0.6666667f;
  let t13 = radiance[6].y * t4 + radiance[5].y * t6 + radiance[7].y * t7 + radiance[4].y * t9;
  let t14 = (radiance[2].z * t0 + radiance[1].z * t1 + radiance[3].z * t2) * 0.6666667f;
  let t15 = radiance[6].z * t4 + radiance[5].z * t6 + radiance[7].z * t7 + radiance[4].z * t9;
  let value = vec3<f32>(radiance[0].x * 0.2820948f + t3 + (t10 + radiance[8].x * t11) * 0.25f,
      radiance[0].y * 0.2820948f + t12 + (t13 + radiance[8].y * t11) * 0.25f,
      radiance[0].z * 0.2820948f + t14 + (t15 + radiance[8].z * t11) * 0.25f);
  return value;
}

// Radiance convolved with the clamped cosine: irradiance over pi at a normal. For colours.
// 73 operations: 27 additions, 46 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_lambert_colour_4(radiance: array<vec3<f32>, 16>, normal: vec3<f32>) -> vec3<f32> {
  let t0 = 0.48860252f * normal.z;
  let t1 = -0.48860252f * normal.y;
  let t2 = -0.48860252f * normal.x;
  let t3 = (radiance[2].x * t0 + radiance[1].x * t1 + radiance[3].x * t2) * 0.6666667f;
  let t4 = 0.9461747f * (normal.z * normal.z) + -0.31539157f;
  let t5 = -1.0925485f * normal.z;
  let t6 = t5 * normal.y;
  let t7 = t5 * normal.x;
  let t8 = normal.y * normal.x;
  let t9 = 0.54627424f * (t8 + t8);
  let t10 = radiance[6].x * t4 + radiance[5].x * t6 + radiance[7].x * t7 + radiance[4].x * t9;
  let t11 = 0.54627424f * (normal.x * normal.x - normal.y * normal.y);
  let t12 = (radiance[2].y * t0 + radiance[1].y * t1 + radiance[3].y * t2) * 0.6666667f;
  let t13 = radiance[6].y * t4 + radiance[5].y * t6 + radiance[7].y * t7 + radiance[4].y * t9;
  let t14 = (radiance[2].z * t0 + radiance[1].z * t1 + radiance[3].z * t2) * 0.6666667f;
  let t15 = radiance[6].z * t4 + radiance[5].z * t6 + radiance[7].z * t7 + radiance[4].z * t9;
  let value = vec3<f32>(radiance[0].x * 0.2820948f + t3 + (t10 + radiance[8].x * t11) * 0.25f,
      radiance[0].y * 0.2820948f + t12 + (t13 + radiance[8].y * t11) * 0.25f,
      radiance[0].z * 0.2820948f + t14 + (t15 + radiance[8].z * t11) * 0.25f);
  return value;
}

// Radiance convolved with the clamped cosine: irradiance over pi at a normal. For colours.
// 163 operations: 62 additions, 101 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_lambert_colour_5(radiance: array<vec3<f32>, 25>, normal: vec3<f32>) -> vec3<f32> {
  let t0 = normal.z * normal.z;
  let t1 = 0.9461747f * t0 + -0.31539157f;
  let t2 = 1.9843135f * normal.z * (normal.z * (1.8658817f * t0 + -1.119529f)) - 1.0062306f * t1;
  let t3 = normal.z * (-4.683326f * t0 + 2.0071397f);
  let t4 = t3 * normal.y;
  let t5 = t3 * normal.x;
  let t6 = 3.3116114f * t0 + -0.47308734f;
  let t7 = normal.y * normal.x;
  let t8 = t7 + t7;
  let t9 = t6 * t8;
  let t10 = radiance[20].x * t2 + radiance[19].x * t4 + radiance[21].x * t5 + radiance[18].x * t9;
  let t11 = normal.x * normal.x - normal.y * normal.y;
  let t12 = t6 * t11;
  let t13 = -1.7701308f * normal.z;
  let t14 = normal.x * t8 + normal.y * t11;
  let t15 = t13 * t14;
  let t16 = normal.x * t11 - normal.y * t8;
  let t17 = t13 * t16;
  let t18 = t10 + radiance[22].x * t12 + radiance[17].x * t15 + radiance[23].x * t17;
  let t19 = 0.6258357f * (normal.x * t14 + normal.y * t16);
  let t20 = 0.6258357f * (normal.x * t16 - normal.y * t14);
  let t21 = radiance[0].x * 0.2820948f + (t18 + radiance[16].x * t19 + radiance[24].x * t20) * -0.041666668f;
  let t22 = 0.48860252f * normal.z;
  let t23 = -0.48860252f * normal.y;
  let t24 = -0.48860252f * normal.x;
  let t25 = (radiance[2].x * t22 + radiance[1].x * t23 + radiance[3].x * t24) * 0.6666667f;
  let t26 = -1.0925485f * normal.z;
  let t27 = t26 * normal.y;
  let t28 = t26 * normal.x;
  let t29 = 0.54627424f * t8;
  let t30 = radiance[6].x * t1 + radiance[5].x * t27 + radiance[7].x * t28 + radiance[4].x * t29;
  let t31 = 0.54627424f * t11;
  let t32 = radiance[20].y * t2 + radiance[19].y * t4 + radiance[21].y * t5 + radiance[18].y * t9;
  let t33 = t32 + radiance[22].y * t12 + radiance[17].y * t15 + radiance[23].y * t17;
  let t34 = radiance[0].y * 0.2820948f + (t33 + radiance[16].y * t19 + radiance[24].y * t20) * -0.041666668f;
  let t35 = (radiance[2].y * t22 + radiance[1].y * t23 + radiance[3].y * t24) * 0.6666667f;
  let t36 = radiance[6].y * t1 + radiance[5].y * t27 + radiance[7].y * t28 + radiance[4].y * t29;
  let t37 = radiance[20].z * t2 + radiance[19].z * t4 + radiance[21].z * t5 + radiance[18].z * t9;
  let t38 = t37 + radiance[22].z * t12 + radiance[17].z * t15 + radiance[23].z * t17;
  let t39 = radiance[0].z * 0.2820948f + (t38 + radiance[16].z * t19 + radiance[24].z * t20) * -0.041666668f;
  let t40 = (radiance[2].z * t22 + radiance[1].z * t23 + radiance[3].z * t24) * 0.6666667f;
  let t41 = radiance[6].z * t1 + radiance[5].z * t27 + radiance[7].z * t28 + radiance[4].z * t29;
  let value = vec3<f32>(t21 + t25 + (t30 + radiance[8].x * t31) * 0.25f,
      t34 + t35 + (t36 + radiance[8].y * t31) * 0.25f,
      t39 + t40 + (t41 + radiance[8].z * t31) * 0.25f);
  return value;
}

// A zonal lobe turned to an axis, a unit vector.
// 9 operations: 0 additions, 9 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_orient_2(zh: array<f32, 2>, axis: vec3<f32>, sh: ptr<function, array<f32, 4>>) {
  (*sh)[0] = 3.5449078f * zh[0] * 0.2820948f;
  let t0 = 2.0466535f * zh[1];
  (*sh)[1] = t0 * (-0.48860252f * axis.y);
  (*sh)[2] = t0 * (0.48860252f * axis.z);
  (*sh)[3] = t0 * (-0.48860252f * axis.x);
}

// A zonal lobe turned to an axis, a unit vector.
// 28 operations: 3 additions, 25 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_orient_3(zh: array<f32, 3>, axis: vec3<f32>, sh: ptr<function, array<f32, 9>>) {
  (*sh)[0] = 3.5449078f * zh[0] * 0.2820948f;
  let t0 = 2.0466535f * zh[1];
  (*sh)[1] = t0 * (-0.48860252f * axis.y);
  (*sh)[2] = t0 * (0.48860252f * axis.z);
  (*sh)[3] = t0 * (-0.48860252f * axis.x);
  let t1 = 1.585331f * zh[2];
  let t2 = axis.y * axis.x;
  (*sh)[4] = t1 * (0.54627424f * (t2 + t2));
  let t3 = -1.0925485f * axis.z;
  (*sh)[5] = t1 * (t3 * axis.y);
  (*sh)[6] = t1 * (0.9461747f * (axis.z * axis.z) + -0.31539157f);
  (*sh)[7] = t1 * (t3 * axis.x);
  (*sh)[8] = t1 * (0.54627424f * (axis.x * axis.x - axis.y * axis.y));
}

// A zonal lobe turned to an axis, a unit vector.
// 54 operations: 7 additions, 47 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_orient_4(zh: array<f32, 4>, axis: vec3<f32>, sh: ptr<function, array<f32, 16>>) {
  (*sh)[0] = 3.5449078f * zh[0] * 0.2820948f;
  let t0 = 2.0466535f * zh[1];
  (*sh)[1] = t0 * (-0.48860252f * axis.y);
  (*sh)[2] = t0 * (0.48860252f * axis.z);
  (*sh)[3] = t0 * (-0.48860252f * axis.x);
  let t1 = 1.585331f * zh[2];
  let t2 = axis.y * axis.x;
  let t3 = t2 + t2;
  (*sh)[4] = t1 * (0.54627424f * t3);
  let t4 = -1.0925485f * axis.z;
  (*sh)[5] = t1 * (t4 * axis.y);
  let t5 = axis.z * axis.z;
  (*sh)[6] = t1 * (0.9461747f * t5 + -0.31539157f);
  (*sh)[7] = t1 * (t4 * axis.x);
  let t6 = axis.x * axis.x - axis.y * axis.y;
  (*sh)[8] = t1 * (0.54627424f * t6);
  let t7 = 1.3398491f * zh[3];
  (*sh)[9] = t7 * (-0.5900436f * (axis.x * t3 + axis.y * t6));
  let t8 = 1.4453057f * axis.z;
  (*sh)[10] = t7 * (t8 * t3);
  let t9 = -2.285229f * t5 + 0.4570458f;
  (*sh)[11] = t7 * (t9 * axis.y);
  (*sh)[12] = t7 * (axis.z * (1.8658817f * t5 + -1.119529f));
  (*sh)[13] = t7 * (t9 * axis.x);
  (*sh)[14] = t7 * (t8 * t6);
  (*sh)[15] = t7 * (-0.5900436f * (axis.x * t6 - axis.y * t3));
}

// A zonal lobe turned to an axis, a unit vector.
// 88 operations: 12 additions, 76 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_orient_5(zh: array<f32, 5>, axis: vec3<f32>, sh: ptr<function, array<f32, 25>>) {
  (*sh)[0] = 3.5449078f * zh[0] * 0.2820948f;
  let t0 = 2.0466535f * zh[1];
  (*sh)[1] = t0 * (-0.48860252f * axis.y);
  (*sh)[2] = t0 * (0.48860252f * axis.z);
  (*sh)[3] = t0 * (-0.48860252f * axis.x);
  let t1 = 1.585331f * zh[2];
  let t2 = axis.y * axis.x;
  let t3 = t2 + t2;
  (*sh)[4] = t1 * (0.54627424f * t3);
  let t4 = -1.0925485f * axis.z;
  (*sh)[5] = t1 * (t4 * axis.y);
  let t5 = axis.z * axis.z;
  let t6 = 0.9461747f * t5 + -0.31539157f;
  (*sh)[6] = t1 * t6;
  (*sh)[7] = t1 * (t4 * axis.x);
  let t7 = axis.x * axis.x - axis.y * axis.y;
  (*sh)[8] = t1 * (0.54627424f * t7);
  let t8 = 1.3398491f * zh[3];
  let t9 = axis.x * t3 + axis.y * t7;
  (*sh)[9] = t8 * (-0.5900436f * t9);
  let t10 = 1.4453057f * axis.z;
  (*sh)[10] = t8 * (t10 * t3);
  let t11 = -2.285229f * t5 + 0.4570458f;
  (*sh)[11] = t8 * (t11 * axis.y);
  let t12 = axis.z * (1.8658817f * t5 + -1.119529f);
  (*sh)[12] = t8 * t12;
  (*sh)[13] = t8 * (t11 * axis.x);
  (*sh)[14] = t8 * (t10 * t7);
  let t13 = axis.x * t7 - axis.y * t3;
  (*sh)[15] = t8 * (-0.5900436f * t13);
  let t14 = 1.1816359f * zh[4];
  (*sh)[16] = t14 * (0.6258357f * (axis.x * t9 + axis.y * t13));
  let t15 = -1.7701308f * axis.z;
  (*sh)[17] = t14 * (t15 * t9);
  let t16 = 3.3116114f * t5 + -0.47308734f;
  (*sh)[18] = t14 * (t16 * t3);
  let t17 = axis.z * (-4.683326f * t5 + 2.0071397f);
  (*sh)[19] = t14 * (t17 * axis.y);
  (*sh)[20] = t14 * (1.9843135f * axis.z * t12 - 1.0062306f * t6);
  (*sh)[21] = t14 * (t17 * axis.x);
  (*sh)[22] = t14 * (t16 * t7);
  (*sh)[23] = t14 * (t15 * t13);
  (*sh)[24] = t14 * (0.6258357f * (axis.x * t13 - axis.y * t9));
}

// A zonal lobe turned to an axis, a unit vector. For colours.
// 21 operations: 0 additions, 21 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_orient_colour_2(zh: array<vec3<f32>, 2>, axis: vec3<f32>, sh: ptr<function, array<vec3<f32>, 4>>) {
  (*sh)[0].x = 3.5449078f * zh[0].x * 0.2820948f;
  (*sh)[0].y = 3.5449078f * zh[0].y * 0.2820948f;
  (*sh)[0].z = 3.5449078f * zh[0].z * 0.2820948f;
  let t0 = 2.0466535f * zh[1].x;
  let t1 = -0.48860252f * axis.y;
  (*sh)[1].x = t0 * t1;
  let t2 = 2.0466535f * zh[1].y;
  (*sh)[1].y = t2 * t1;
  let t3 = 2.0466535f * zh[1].z;
  (*sh)[1].z = t3 * t1;
  let t4 = 0.48860252f * axis.z;
  (*sh)[2].x = t0 * t4;
  (*sh)[2].y = t2 * t4;
  (*sh)[2].z = t3 * t4;
  let t5 = -0.48860252f * axis.x;
  (*sh)[3].x = t0 * t5;
  (*sh)[3].y = t2 * t5;
  (*sh)[3].z = t3 * t5;
}

// A zonal lobe turned to an axis, a unit vector. For colours.
// 52 operations: 3 additions, 49 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_orient_colour_3(zh: array<vec3<f32>, 3>, axis: vec3<f32>, sh: ptr<function, array<vec3<f32>, 9>>) {
  (*sh)[0].x = 3.5449078f * zh[0].x * 0.2820948f;
  (*sh)[0].y = 3.5449078f * zh[0].y * 0.2820948f;
  (*sh)[0].z = 3.5449078f * zh[0].z * 0.2820948f;
  let t0 = 2.0466535f * zh[1].x;
  let t1 = -0.48860252f * axis.y;
  (*sh)[1].x = t0 * t1;
  let t2 = 2.0466535f * zh[1].y;
  (*sh)[1].y = t2 * t1;
  let t3 = 2.0466535f * zh[1].z;
  (*sh)[1].z = t3 * t1;
  let t4 = 0.48860252f * axis.z;
  (*sh)[2].x = t0 * t4;
  (*sh)[2].y = t2 * t4;
  (*sh)[2].z = t3 * t4;
  let t5 = -0.48860252f * axis.x;
  (*sh)[3].x = t0 * t5;
  (*sh)[3].y = t2 * t5;
  (*sh)[3].z = t3 * t5;
  let t6 = 1.585331f * zh[2].x;
  let t7 = axis.y * axis.x;
  let t8 = 0.54627424f * (t7 + t7);
  (*sh)[4].x = t6 * t8;
  let t9 = 1.585331f * zh[2].y;
  (*sh)[4].y = t9 * t8;
  let t10 = 1.585331f * zh[2].z;
  (*sh)[4].z = t10 * t8;
  let t11 = -1.0925485f * axis.z;
  let t12 = t11 * axis.y;
  (*sh)[5].x = t6 * t12;
  (*sh)[5].y = t9 * t12;
  (*sh)[5].z = t10 * t12;
  let t13 = 0.9461747f * (axis.z * axis.z) + -0.31539157f;
  (*sh)[6].x = t6 * t13;
  (*sh)[6].y = t9 * t13;
  (*sh)[6].z = t10 * t13;
  let t14 = t11 * axis.x;
  (*sh)[7].x = t6 * t14;
  (*sh)[7].y = t9 * t14;
  (*sh)[7].z = t10 * t14;
  let t15 = 0.54627424f * (axis.x * axis.x - axis.y * axis.y);
  (*sh)[8].x = t6 * t15;
  (*sh)[8].y = t9 * t15;
  (*sh)[8].z = t10 * t15;
}

// A zonal lobe turned to an axis, a unit vector. For colours.
// 94 operations: 7 additions, 87 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_orient_colour_4(zh: array<vec3<f32>, 4>, axis: vec3<f32>, sh: ptr<function, array<vec3<f32>, 16>>) {
  (*sh)[0].x = 3.5449078f * zh[0].x * 0.2820948f;
  (*sh)[0].y = 3.5449078f * zh[0].y * 0.2820948f;
  (*sh)[0].z = 3.5449078f * zh[0].z * 0.2820948f;
  let t0 = 2.0466535f * zh[1].x;
  let t1 = -0.48860252f * axis.y;
  (*sh)[1].x = t0 * t1;
  let t2 = 2.0466535f * zh[1].y;
  (*sh)[1].y = t2 * t1;
  let t3 = 2.0466535f * zh[1].z;
  (*sh)[1].z = t3 * t1;
  let t4 = 0.48860252f * axis.z;
  (*sh)[2].x = t0 * t4;
  (*sh)[2].y = t2 * t4;
  (*sh)[2].z = t3 * t4;
  let t5 = -0.48860252f * axis.x;
  (*sh)[3].x = t0 * t5;
  (*sh)[3].y = t2 * t5;
  (*sh)[3].z = t3 * t5;
  let t6 = 1.585331f * zh[2].x;
  let t7 = axis.y * axis.x;
  let t8 = t7 + t7;
  let t9 = 0.54627424f * t8;
  (*sh)[4].x = t6 * t9;
  let t10 = 1.585331f * zh[2].y;
  (*sh)[4].y = t10 * t9;
  let t11 = 1.585331f * zh[2].z;
  (*sh)[4].z = t11 * t9;
  let t12 = -1.0925485f * axis.z;
  let t13 = t12 * axis.y;
  (*sh)[5].x = t6 * t13;
  (*sh)[5].y = t10 * t13;
  (*sh)[5].z = t11 * t13;
  let t14 = axis.z * axis.z;
  let t15 = 0.9461747f * t14 + -0.31539157f;
  (*sh)[6].x = t6 * t15;
  (*sh)[6].y = t10 * t15;
  (*sh)[6].z = t11 * t15;
  let t16 = t12 * axis.x;
  (*sh)[7].x = t6 * t16;
  (*sh)[7].y = t10 * t16;
  (*sh)[7].z = t11 * t16;
  let t17 = axis.x * axis.x - axis.y * axis.y;
  let t18 = 0.54627424f * t17;
  (*sh)[8].x = t6 * t18;
  (*sh)[8].y = t10 * t18;
  (*sh)[8].z = t11 * t18;
  let t19 = 1.3398491f * zh[3].x;
  let t20 = -0.5900436f * (axis.x * t8 + axis.y * t17);
  (*sh)[9].x = t19 * t20;
  let t21 = 1.3398491f * zh[3].y;
  (*sh)[9].y = t21 * t20;
  let t22 = 1.3398491f * zh[3].z;
  (*sh)[9].z = t22 * t20;
  let t23 = 1.4453057f * axis.z;
  let t24 = t23 * t8;
  (*sh)[10].x = t19 * t24;
  (*sh)[10].y = t21 * t24;
  (*sh)[10].z = t22 * t24;
  let t25 = -2.285229f * t14 + 0.4570458f;
  let t26 = t25 * axis.y;
  (*sh)[11].x = t19 * t26;
  (*sh)[11].y = t21 * t26;
  (*sh)[11].z = t22 * t26;
  let t27 = axis.z * (1.8658817f * t14 + -1.119529f);
  (*sh)[12].x = t19 * t27;
  (*sh)[12].y = t21 * t27;
  (*sh)[12].z = t22 * t27;
  let t28 = t25 * axis.x;
  (*sh)[13].x = t19 * t28;
  (*sh)[13].y = t21 * t28;
  (*sh)[13].z = t22 * t28;
  let t29 = t23 * t17;
  (*sh)[14].x = t19 * t29;
  (*sh)[14].y = t21 * t29;
  (*sh)[14].z = t22 * t29;
  let t30 = -0.5900436f * (axis.x * t17 - axis.y * t8);
  (*sh)[15].x = t19 * t30;
  (*sh)[15].y = t21 * t30;
  (*sh)[15].z = t22 * t30;
}

// A zonal lobe turned to an axis, a unit vector. For colours.
// 148 operations: 12 additions, 136 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_orient_colour_5(zh: array<vec3<f32>, 5>, axis: vec3<f32>, sh: ptr<function, array<vec3<f32>, 25>>) {
  (*sh)[0].x = 3.5449078f * zh[0].x * 0.2820948f;
  (*sh)[0].y = 3.5449078f * zh[0].y * 0.2820948f;
  (*sh)[0].z = 3.5449078f * zh[0].z * 0.2820948f;
  let t0 = 2.0466535f * zh[1].x;
  let t1 = -0.48860252f * axis.y;
  (*sh)[1].x = t0 * t1;
  let t2 = 2.0466535f * zh[1].y;
  (*sh)[1].y = t2 * t1;
  let t3 = 2.0466535f * zh[1].z;
  (*sh)[1].z = t3 * t1;
  let t4 = 0.48860252f * axis.z;
  (*sh)[2].x = t0 * t4;
  (*sh)[2].y = t2 * t4;
  (*sh)[2].z = t3 * t4;
  let t5 = -0.48860252f * axis.x;
  (*sh)[3].x = t0 * t5;
  (*sh)[3].y = t2 * t5;
  (*sh)[3].z = t3 * t5;
  let t6 = 1.585331f * zh[2].x;
  let t7 = axis.y * axis.x;
  let t8 = t7 + t7;
  let t9 = 0.54627424f * t8;
  (*sh)[4].x = t6 * t9;
  let t10 = 1.585331f * zh[2].y;
  (*sh)[4].y = t10 * t9;
  let t11 = 1.585331f * zh[2].z;
  (*sh)[4].z = t11 * t9;
  let t12 = -1.0925485f * axis.z;
  let t13 = t12 * axis.y;
  (*sh)[5].x = t6 * t13;
  (*sh)[5].y = t10 * t13;
  (*sh)[5].z = t11 * t13;
  let t14 = axis.z * axis.z;
  let t15 = 0.9461747f * t14 + -0.31539157f;
  (*sh)[6].x = t6 * t15;
  (*sh)[6].y = t10 * t15;
  (*sh)[6].z = t11 * t15;
  let t16 = t12 * axis.x;
  (*sh)[7].x = t6 * t16;
  (*sh)[7].y = t10 * t16;
  (*sh)[7].z = t11 * t16;
  let t17 = axis.x * axis.x - axis.y * axis.y;
  let t18 = 0.54627424f * t17;
  (*sh)[8].x = t6 * t18;
  (*sh)[8].y = t10 * t18;
  (*sh)[8].z = t11 * t18;
  let t19 = 1.3398491f * zh[3].x;
  let t20 = axis.x * t8 + axis.y * t17;
  let t21 = -0.5900436f * t20;
  (*sh)[9].x = t19 * t21;
  let t22 = 1.3398491f * zh[3].y;
  (*sh)[9].y = t22 * t21;
  let t23 = 1.3398491f * zh[3].z;
  (*sh)[9].z = t23 * t21;
  let t24 = 1.4453057f * axis.z;
  let t25 = t24 * t8;
  (*sh)[10].x = t19 * t25;
  (*sh)[10].y = t22 * t25;
  (*sh)[10].z = t23 * t25;
  let t26 = -2.285229f * t14 + 0.4570458f;
  let t27 = t26 * axis.y;
  (*sh)[11].x = t19 * t27;
  (*sh)[11].y = t22 * t27;
  (*sh)[11].z = t23 * t27;
  let t28 = axis.z * (1.8658817f * t14 + -1.119529f);
  (*sh)[12].x = t19 * t28;
  (*sh)[12].y = t22 * t28;
  (*sh)[12].z = t23 * t28;
  let t29 = t26 * axis.x;
  (*sh)[13].x = t19 * t29;
  (*sh)[13].y = t22 * t29;
  (*sh)[13].z = t23 * t29;
  let t30 = t24 * t17;
  (*sh)[14].x = t19 * t30;
  (*sh)[14].y = t22 * t30;
  (*sh)[14].z = t23 * t30;
  let t31 = axis.x * t17 - axis.y * t8;
  let t32 = -0.5900436f * t31;
  (*sh)[15].x = t19 * t32;
  (*sh)[15].y = t22 * t32;
  (*sh)[15].z = t23 * t32;
  let t33 = 1.1816359f * zh[4].x;
  let t34 = 0.6258357f * (axis.x * t20 + axis.y * t31);
  (*sh)[16].x = t33 * t34;
  let t35 = 1.1816359f * zh[4].y;
  (*sh)[16].y = t35 * t34;
  let t36 = 1.1816359f * zh[4].z;
  (*sh)[16].z = t36 * t34;
  let t37 = -1.7701308f * axis.z;
  let t38 = t37 * t20;
  (*sh)[17].x = t33 * t38;
  (*sh)[17].y = t35 * t38;
  (*sh)[17].z = t36 * t38;
  let t39 = 3.3116114f * t14 + -0.47308734f;
  let t40 = t39 * t8;
  (*sh)[18].x = t33 * t40;
  (*sh)[18].y = t35 * t40;
  (*sh)[18].z = t36 * t40;
  let t41 = axis.z * (-4.683326f * t14 + 2.0071397f);
  let t42 = t41 * axis.y;
  (*sh)[19].x = t33 * t42;
  (*sh)[19].y = t35 * t42;
  (*sh)[19].z = t36 * t42;
  let t43 = 1.9843135f * axis.z * t28 - 1.0062306f * t15;
  (*sh)[20].x = t33 * t43;
  (*sh)[20].y = t35 * t43;
  (*sh)[20].z = t36 * t43;
  let t44 = t41 * axis.x;
  (*sh)[21].x = t33 * t44;
  (*sh)[21].y = t35 * t44;
  (*sh)[21].z = t36 * t44;
  let t45 = t39 * t17;
  (*sh)[22].x = t33 * t45;
  (*sh)[22].y = t35 * t45;
  (*sh)[22].z = t36 * t45;
  let t46 = t37 * t31;
  (*sh)[23].x = t33 * t46;
  (*sh)[23].y = t35 * t46;
  (*sh)[23].z = t36 * t46;
  let t47 = 0.6258357f * (axis.x * t31 - axis.y * t20);
  (*sh)[24].x = t33 * t47;
  (*sh)[24].y = t35 * t47;
  (*sh)[24].z = t36 * t47;
}

// The integral of a product: the sum of the products of coefficients.
// 7 operations: 3 additions, 4 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_dot_2(a: array<f32, 4>, b: array<f32, 4>) -> f32 {
  let value = a[0] * b[0] + a[1] * b[1] + (a[2] * b[2] + a[3] * b[3]);
  return value;
}

// The integral of a product: the sum of the products of coefficients.
// 17 operations: 8 additions, 9 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_dot_3(a: array<f32, 9>, b: array<f32, 9>) -> f32 {
  let t0 = a[0] * b[0] + a[4] * b[4] + a[8] * b[8] + (a[1] * b[1] + a[5] * b[5]) + (a[2] * b[2] + a[6] * b[6] + (a[3] * b[3] + a[7] * b[7]));
  let value = t0;
  return value;
}

// The integral of a product: the sum of the products of coefficients.
// 31 operations: 15 additions, 16 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_dot_4(a: array<f32, 16>, b: array<f32, 16>) -> f32 {
  let t0 = a[0] * b[0] + a[4] * b[4] + a[8] * b[8] + a[12] * b[12] + (a[1] * b[1] + a[5] * b[5] + a[9] * b[9] + a[13] * b[13]);
  let t1 = a[2] * b[2] + a[6] * b[6] + a[10] * b[10] + a[14] * b[14] + (a[3] * b[3] + a[7] * b[7] + a[11] * b[11] + a[15] * b[15]);
  let value = t0 + t1;
  return value;
}

// The integral of a product: the sum of the products of coefficients.
// 49 operations: 24 additions, 25 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_dot_5(a: array<f32, 25>, b: array<f32, 25>) -> f32 {
  let t0 = a[0] * b[0] + a[4] * b[4] + a[8] * b[8] + a[12] * b[12] + a[16] * b[16] + a[20] * b[20];
  let t1 = a[1] * b[1] + a[5] * b[5] + a[9] * b[9] + a[13] * b[13] + a[17] * b[17] + a[21] * b[21];
  let t2 = a[2] * b[2] + a[6] * b[6] + a[10] * b[10] + a[14] * b[14] + a[18] * b[18];
  let t3 = a[3] * b[3] + a[7] * b[7] + a[11] * b[11] + a[15] * b[15] + a[19] * b[19];
  let value = t0 + a[24] * b[24] + t1 + (t2 + a[22] * b[22] + (t3 + a[23] * b[23]));
  return value;
}

// The integral of a product: the sum of the products of coefficients. For colours.
// 21 operations: 9 additions, 12 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_dot_colour_2(a: array<vec3<f32>, 4>, b: array<f32, 4>) -> vec3<f32> {
  let value = vec3<f32>(a[0].x * b[0] + a[1].x * b[1] + (a[2].x * b[2] + a[3].x * b[3]),
      a[0].y * b[0] + a[1].y * b[1] + (a[2].y * b[2] + a[3].y * b[3]),
      a[0].z * b[0] + a[1].z * b[1] + (a[2].z * b[2] + a[3].z * b[3]));
  return value;
}

// The integral of a product: the sum of the products of coefficients. For colours.
// 51 operations: 24 additions, 27 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_dot_colour_3(a: array<vec3<f32>, 9>, b: array<f32, 9>) -> vec3<f32> {
  let t0 = a[0].x * b[0] + a[4].x * b[4] + a[8].x * b[8] + (a[1].x * b[1] + a[5].x * b[5]);
  let t1 = a[0].y * b[0] + a[4].y * b[4] + a[8].y * b[8] + (a[1].y * b[1] + a[5].y * b[5]);
  let t2 = a[0].z * b[0] + a[4].z * b[4] + a[8].z * b[8] + (a[1].z * b[1] + a[5].z * b[5]);
  let value = vec3<f32>(t0 + (a[2].x * b[2] + a[6].x * b[6] + (a[3].x * b[3] + a[7].x * b[7])),
      t1 + (a[2].y * b[2] + a[6].y * b[6] + (a[3].y * b[3] + a[7].y * b[7])),
      t2 + (a[2].z * b[2] + a[6].z * b[6] + (a[3].z * b[3] + a[7].z * b[7])));
  return value;
}

// The integral of a product: the sum of the products of coefficients. For colours.
// 93 operations: 45 additions, 48 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_dot_colour_4(a: array<vec3<f32>, 16>, b: array<f32, 16>) -> vec3<f32> {
  let t0 = a[0].x * b[0] + a[4].x * b[4] + a[8].x * b[8] + a[12].x * b[12] + (a[1].x * b[1] + a[5].x * b[5] + a[9].x * b[9] + a[13].x * b[13]);
  let t1 = a[2].x * b[2] + a[6].x * b[6] + a[10].x * b[10] + a[14].x * b[14] + (a[3].x * b[3] + a[7].x * b[7] + a[11].x * b[11] + a[15].x * b[15]);
  let t2 = a[0].y * b[0] + a[4].y * b[4] + a[8].y * b[8] + a[12].y * b[12] + (a[1].y * b[1] + a[5].y * b[5] + a[9].y * b[9] + a[13].y * b[13]);
  let t3 = a[2].y * b[2] + a[6].y * b[6] + a[10].y * b[10] + a[14].y * b[14] + (a[3].y * b[3] + a[7].y * b[7] + a[11].y * b[11] + a[15].y * b[15]);
  let t4 = a[0].z * b[0] + a[4].z * b[4] + a[8].z * b[8] + a[12].z * b[12] + (a[1].z * b[1] + a[5].z * b[5] + a[9].z * b[9] + a[13].z * b[13]);
  let t5 = a[2].z * b[2] + a[6].z * b[6] + a[10].z * b[10] + a[14].z * b[14] + (a[3].z * b[3] + a[7].z * b[7] + a[11].z * b[11] + a[15].z * b[15]);
  let value = vec3<f32>(t0 + t1, t2 + t3, t4 + t5);
  return value;
}

// The integral of a product: the sum of the products of coefficients. For colours.
// 147 operations: 72 additions, 75 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_dot_colour_5(a: array<vec3<f32>, 25>, b: array<f32, 25>) -> vec3<f32> {
  let t0 = a[0].x * b[0] + a[4].x * b[4] + a[8].x * b[8] + a[12].x * b[12] + a[16].x * b[16];
  let t1 = a[1].x * b[1] + a[5].x * b[5] + a[9].x * b[9] + a[13].x * b[13] + a[17].x * b[17];
  let t2 = a[2].x * b[2] + a[6].x * b[6] + a[10].x * b[10] + a[14].x * b[14] + a[18].x * b[18];
  let t3 = a[3].x * b[3] + a[7].x * b[7] + a[11].x * b[11] + a[15].x * b[15] + a[19].x * b[19];
  let t4 = t0 + a[20].x * b[20] + a[24].x * b[24] + (t1 + a[21].x * b[21]) + (t2 + a[22].x * b[22] + (t3 + a[23].x * b[23]));
  let t5 = a[0].y * b[0] + a[4].y * b[4] + a[8].y * b[8] + a[12].y * b[12] + a[16].y * b[16];
  let t6 = a[1].y * b[1] + a[5].y * b[5] + a[9].y * b[9] + a[13].y * b[13] + a[17].y * b[17];
  let t7 = a[2].y * b[2] + a[6].y * b[6] + a[10].y * b[10] + a[14].y * b[14] + a[18].y * b[18];
  let t8 = a[3].y * b[3] + a[7].y * b[7] + a[11].y * b[11] + a[15].y * b[15] + a[19].y * b[19];
  let t9 = t5 + a[20].y * b[20] + a[24].y * b[24] + (t6 + a[21].y * b[21]) + (t7 + a[22].y * b[22] + (t8 + a[23].y * b[23]));
  let t10 = a[0].z * b[0] + a[4].z * b[4] + a[8].z * b[8] + a[12].z * b[12] + a[16].z * b[16];
  let t11 = a[1].z * b[1] + a[5].z * b[5] + a[9].z * b[9] + a[13].z * b[13] + a[17].z * b[17];
  let t12 = a[2].z * b[2] + a[6].z * b[6] + a[10].z * b[10] + a[14].z * b[14] + a[18].z * b[18];
  let t13 = a[3].z * b[3] + a[7].z * b[7] + a[11].z * b[11] + a[15].z * b[15] + a[19].z * b[19];
  let t14 = t10 + a[20].z * b[20] + a[24].z * b[24] + (t11 + a[21].z * b[21]) + (t12 + a[22].z * b[22] + (t13 + a[23].z * b[23]));
  let value = vec3<f32>(t4, t9, t14);
  return value;
}

// The integral of a product: the sum of the products of coefficients. For colours by colours.
// 21 operations: 9 additions, 12 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_dot_colours_2(a: array<vec3<f32>, 4>, b: array<vec3<f32>, 4>) -> vec3<f32> {
  let value = vec3<f32>(a[0].x * b[0].x + a[1].x * b[1].x + (a[2].x * b[2].x + a[3].x * b[3].x),
      a[0].y * b[0].y + a[1].y * b[1].y + (a[2].y * b[2].y + a[3].y * b[3].y),
      a[0].z * b[0].z + a[1].z * b[1].z + (a[2].z * b[2].z + a[3].z * b[3].z));
  return value;
}

// The integral of a product: the sum of the products of coefficients. For colours by colours.
// 51 operations: 24 additions, 27 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_dot_colours_3(a: array<vec3<f32>, 9>, b: array<vec3<f32>, 9>) -> vec3<f32> {
  let t0 = a[0].x * b[0].x + a[4].x * b[4].x + a[8].x * b[8].x + (a[1].x * b[1].x + a[5].x * b[5].x);
  let t1 = t0 + (a[2].x * b[2].x + a[6].x * b[6].x + (a[3].x * b[3].x + a[7].x * b[7].x));
  let t2 = a[0].y * b[0].y + a[4].y * b[4].y + a[8].y * b[8].y + (a[1].y * b[1].y + a[5].y * b[5].y);
  let t3 = t2 + (a[2].y * b[2].y + a[6].y * b[6].y + (a[3].y * b[3].y + a[7].y * b[7].y));
  let t4 = a[0].z * b[0].z + a[4].z * b[4].z + a[8].z * b[8].z + (a[1].z * b[1].z + a[5].z * b[5].z);
  let t5 = t4 + (a[2].z * b[2].z + a[6].z * b[6].z + (a[3].z * b[3].z + a[7].z * b[7].z));
  let value = vec3<f32>(t1, t3, t5);
  return value;
}

// The integral of a product: the sum of the products of coefficients. For colours by colours.
// 93 operations: 45 additions, 48 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_dot_colours_4(a: array<vec3<f32>, 16>, b: array<vec3<f32>, 16>) -> vec3<f32> {
  let t0 = a[0].x * b[0].x + a[4].x * b[4].x + a[8].x * b[8].x + a[12].x * b[12].x + (a[1].x * b[1].x + a[5].x * b[5].x + a[9].x * b[9].x + a[13].x * b[13].x);
  let t1 = a[2].x * b[2].x + a[6].x * b[6].x + a[10].x * b[10].x + a[14].x * b[14].x;
  let t2 = a[3].x * b[3].x + a[7].x * b[7].x + a[11].x * b[11].x + a[15].x * b[15].x;
  let t3 = a[0].y * b[0].y + a[4].y * b[4].y + a[8].y * b[8].y + a[12].y * b[12].y + (a[1].y * b[1].y + a[5].y * b[5].y + a[9].y * b[9].y + a[13].y * b[13].y);
  let t4 = a[2].y * b[2].y + a[6].y * b[6].y + a[10].y * b[10].y + a[14].y * b[14].y;
  let t5 = a[3].y * b[3].y + a[7].y * b[7].y + a[11].y * b[11].y + a[15].y * b[15].y;
  let t6 = a[0].z * b[0].z + a[4].z * b[4].z + a[8].z * b[8].z + a[12].z * b[12].z + (a[1].z * b[1].z + a[5].z * b[5].z + a[9].z * b[9].z + a[13].z * b[13].z);
  let t7 = a[2].z * b[2].z + a[6].z * b[6].z + a[10].z * b[10].z + a[14].z * b[14].z;
  let t8 = a[3].z * b[3].z + a[7].z * b[7].z + a[11].z * b[11].z + a[15].z * b[15].z;
  let value = vec3<f32>(t0 + (t1 + t2), t3 + (t4 + t5), t6 + (t7 + t8));
  return value;
}

// The integral of a product: the sum of the products of coefficients. For colours by colours.
// 147 operations: 72 additions, 75 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_dot_colours_5(a: array<vec3<f32>, 25>, b: array<vec3<f32>, 25>) -> vec3<f32> {
  let t0 = a[0].x * b[0].x + a[4].x * b[4].x + a[8].x * b[8].x + a[12].x * b[12].x + a[16].x * b[16].x;
  let t1 = a[1].x * b[1].x + a[5].x * b[5].x + a[9].x * b[9].x + a[13].x * b[13].x + a[17].x * b[17].x;
  let t2 = a[2].x * b[2].x + a[6].x * b[6].x + a[10].x * b[10].x + a[14].x * b[14].x;
  let t3 = a[3].x * b[3].x + a[7].x * b[7].x + a[11].x * b[11].x + a[15].x * b[15].x;
  let t4 = t2 + a[18].x * b[18].x + a[22].x * b[22].x + (t3 + a[19].x * b[19].x + a[23].x * b[23].x);
  let t5 = t0 + a[20].x * b[20].x + a[24].x * b[24].x + (t1 + a[21].x * b[21].x) + t4;
  let t6 = a[0].y * b[0].y + a[4].y * b[4].y + a[8].y * b[8].y + a[12].y * b[12].y + a[16].y * b[16].y;
  let t7 = a[1].y * b[1].y + a[5].y * b[5].y + a[9].y * b[9].y + a[13].y * b[13].y + a[17].y * b[17].y;
  let t8 = a[2].y * b[2].y + a[6].y * b[6].y + a[10].y * b[10].y + a[14].y * b[14].y;
  let t9 = a[3].y * b[3].y + a[7].y * b[7].y + a[11].y * b[11].y + a[15].y * b[15].y;
  let t10 = t8 + a[18].y * b[18].y + a[22].y * b[22].y + (t9 + a[19].y * b[19].y + a[23].y * b[23].y);
  let t11 = t6 + a[20].y * b[20].y + a[24].y * b[24].y + (t7 + a[21].y * b[21].y) + t10;
  let t12 = a[0].z * b[0].z + a[4].z * b[4].z + a[8].z * b[8].z + a[12].z * b[12].z + a[16].z * b[16].z;
  let t13 = a[1].z * b[1].z + a[5].z * b[5].z + a[9].z * b[9].z + a[13].z * b[13].z + a[17].z * b[17].z;
  let t14 = a[2].z * b[2].z + a[6].z * b[6].z + a[10].z * b[10].z + a[14].z * b[14].z;
  let t15 = a[3].z * b[3].z + a[7].z * b[7].z + a[11].z * b[11].z + a[15].z * b[15].z;
  let t16 = t14 + a[18].z * b[18].z + a[22].z * b[22].z + (t15 + a[19].z * b[19].z + a[23].z * b[23].z);
  let t17 = t12 + a[20].z * b[20].z + a[24].z * b[24].z + (t13 + a[21].z * b[21].z) + t16;
  let value = vec3<f32>(t5, t11, t17);
  return value;
}

// Convolution with a zonal kernel.
// 6 operations: 0 additions, 6 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_convolve_2(sh: array<f32, 4>, kernel: array<f32, 2>, result: ptr<function, array<f32, 4>>) {
  (*result)[0] = sh[0] * (3.5449078f * kernel[0]);
  let t0 = 2.0466535f * kernel[1];
  (*result)[1] = sh[1] * t0;
  (*result)[2] = sh[2] * t0;
  (*result)[3] = sh[3] * t0;
}

// Convolution with a zonal kernel.
// 12 operations: 0 additions, 12 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_convolve_3(sh: array<f32, 9>, kernel: array<f32, 3>, result: ptr<function, array<f32, 9>>) {
  (*result)[0] = sh[0] * (3.5449078f * kernel[0]);
  let t0 = 2.0466535f * kernel[1];
  (*result)[1] = sh[1] * t0;
  (*result)[2] = sh[2] * t0;
  (*result)[3] = sh[3] * t0;
  let t1 = 1.585331f * kernel[2];
  (*result)[4] = sh[4] * t1;
  (*result)[5] = sh[5] * t1;
  (*result)[6] = sh[6] * t1;
  (*result)[7] = sh[7] * t1;
  (*result)[8] = sh[8] * t1;
}

// Convolution with a zonal kernel.
// 20 operations: 0 additions, 20 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_convolve_4(sh: array<f32, 16>, kernel: array<f32, 4>, result: ptr<function, array<f32, 16>>) {
  (*result)[0] = sh[0] * (3.5449078f * kernel[0]);
  let t0 = 2.0466535f * kernel[1];
  (*result)[1] = sh[1] * t0;
  (*result)[2] = sh[2] * t0;
  (*result)[3] = sh[3] * t0;
  let t1 = 1.585331f * kernel[2];
  (*result)[4] = sh[4] * t1;
  (*result)[5] = sh[5] * t1;
  (*result)[6] = sh[6] * t1;
  (*result)[7] = sh[7] * t1;
  (*result)[8] = sh[8] * t1;
  let t2 = 1.3398491f * kernel[3];
  (*result)[9] = sh[9] * t2;
  (*result)[10] = sh[10] * t2;
  (*result)[11] = sh[11] * t2;
  (*result)[12] = sh[12] * t2;
  (*result)[13] = sh[13] * t2;
  (*result)[14] = sh[14] * t2;
  (*result)[15] = sh[15] * t2;
}

// Convolution with a zonal kernel.
// 30 operations: 0 additions, 30 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_convolve_5(sh: array<f32, 25>, kernel: array<f32, 5>, result: ptr<function, array<f32, 25>>) {
  (*result)[0] = sh[0] * (3.5449078f * kernel[0]);
  let t0 = 2.0466535f * kernel[1];
  (*result)[1] = sh[1] * t0;
  (*result)[2] = sh[2] * t0;
  (*result)[3] = sh[3] * t0;
  let t1 = 1.585331f * kernel[2];
  (*result)[4] = sh[4] * t1;
  (*result)[5] = sh[5] * t1;
  (*result)[6] = sh[6] * t1;
  (*result)[7] = sh[7] * t1;
  (*result)[8] = sh[8] * t1;
  let t2 = 1.3398491f * kernel[3];
  (*result)[9] = sh[9] * t2;
  (*result)[10] = sh[10] * t2;
  (*result)[11] = sh[11] * t2;
  (*result)[12] = sh[12] * t2;
  (*result)[13] = sh[13] * t2;
  (*result)[14] = sh[14] * t2;
  (*result)[15] = sh[15] * t2;
  let t3 = 1.1816359f * kernel[4];
  (*result)[16] = sh[16] * t3;
  (*result)[17] = sh[17] * t3;
  (*result)[18] = sh[18] * t3;
  (*result)[19] = sh[19] * t3;
  (*result)[20] = sh[20] * t3;
  (*result)[21] = sh[21] * t3;
  (*result)[22] = sh[22] * t3;
  (*result)[23] = sh[23] * t3;
  (*result)[24] = sh[24] * t3;
}

// Convolution with a zonal kernel. For colours.
// 14 operations: 0 additions, 14 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_convolve_colour_2(sh: array<vec3<f32>, 4>, kernel: array<f32, 2>,
    result: ptr<function, array<vec3<f32>, 4>>) {
  let t0 = 3.5449078f * kernel[0];
  (*result)[0].x = sh[0].x * t0;
  (*result)[0].y = sh[0].y * t0;
  (*result)[0].z = sh[0].z * t0;
  let t1 = 2.0466535f * kernel[1];
  (*result)[1].x = sh[1].x * t1;
  (*result)[1].y = sh[1].y * t1;
  (*result)[1].z = sh[1].z * t1;
  (*result)[2].x = sh[2].x * t1;
  (*result)[2].y = sh[2].y * t1;
  (*result)[2].z = sh[2].z * t1;
  (*result)[3].x = sh[3].x * t1;
  (*result)[3].y = sh[3].y * t1;
  (*result)[3].z = sh[3].z * t1;
}

// Convolution with a zonal kernel. For colours.
// 30 operations: 0 additions, 30 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_convolve_colour_3(sh: array<vec3<f32>, 9>, kernel: array<f32, 3>,
    result: ptr<function, array<vec3<f32>, 9>>) {
  let t0 = 3.5449078f * kernel[0];
  (*result)[0].x = sh[0].x * t0;
  (*result)[0].y = sh[0].y * t0;
  (*result)[0].z = sh[0].z * t0;
  let t1 = 2.0466535f * kernel[1];
  (*result)[1].x = sh[1].x * t1;
  (*result)[1].y = sh[1].y * t1;
  (*result)[1].z = sh[1].z * t1;
  (*result)[2].x = sh[2].x * t1;
  (*result)[2].y = sh[2].y * t1;
  (*result)[2].z = sh[2].z * t1;
  (*result)[3].x = sh[3].x * t1;
  (*result)[3].y = sh[3].y * t1;
  (*result)[3].z = sh[3].z * t1;
  let t2 = 1.585331f * kernel[2];
  (*result)[4].x = sh[4].x * t2;
  (*result)[4].y = sh[4].y * t2;
  (*result)[4].z = sh[4].z * t2;
  (*result)[5].x = sh[5].x * t2;
  (*result)[5].y = sh[5].y * t2;
  (*result)[5].z = sh[5].z * t2;
  (*result)[6].x = sh[6].x * t2;
  (*result)[6].y = sh[6].y * t2;
  (*result)[6].z = sh[6].z * t2;
  (*result)[7].x = sh[7].x * t2;
  (*result)[7].y = sh[7].y * t2;
  (*result)[7].z = sh[7].z * t2;
  (*result)[8].x = sh[8].x * t2;
  (*result)[8].y = sh[8].y * t2;
  (*result)[8].z = sh[8].z * t2;
}

// Convolution with a zonal kernel. For colours.
// 52 operations: 0 additions, 52 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_convolve_colour_4(sh: array<vec3<f32>, 16>, kernel: array<f32, 4>,
    result: ptr<function, array<vec3<f32>, 16>>) {
  let t0 = 3.5449078f * kernel[0];
  (*result)[0].x = sh[0].x * t0;
  (*result)[0].y = sh[0].y * t0;
  (*result)[0].z = sh[0].z * t0;
  let t1 = 2.0466535f * kernel[1];
  (*result)[1].x = sh[1].x * t1;
  (*result)[1].y = sh[1].y * t1;
  (*result)[1].z = sh[1].z * t1;
  (*result)[2].x = sh[2].x * t1;
  (*result)[2].y = sh[2].y * t1;
  (*result)[2].z = sh[2].z * t1;
  (*result)[3].x = sh[3].x * t1;
  (*result)[3].y = sh[3].y * t1;
  (*result)[3].z = sh[3].z * t1;
  let t2 = 1.585331f * kernel[2];
  (*result)[4].x = sh[4].x * t2;
  (*result)[4].y = sh[4].y * t2;
  (*result)[4].z = sh[4].z * t2;
  (*result)[5].x = sh[5].x * t2;
  (*result)[5].y = sh[5].y * t2;
  (*result)[5].z = sh[5].z * t2;
  (*result)[6].x = sh[6].x * t2;
  (*result)[6].y = sh[6].y * t2;
  (*result)[6].z = sh[6].z * t2;
  (*result)[7].x = sh[7].x * t2;
  (*result)[7].y = sh[7].y * t2;
  (*result)[7].z = sh[7].z * t2;
  (*result)[8].x = sh[8].x * t2;
  (*result)[8].y = sh[8].y * t2;
  (*result)[8].z = sh[8].z * t2;
  let t3 = 1.3398491f * kernel[3];
  (*result)[9].x = sh[9].x * t3;
  (*result)[9].y = sh[9].y * t3;
  (*result)[9].z = sh[9].z * t3;
  (*result)[10].x = sh[10].x * t3;
  (*result)[10].y = sh[10].y * t3;
  (*result)[10].z = sh[10].z * t3;
  (*result)[11].x = sh[11].x * t3;
  (*result)[11].y = sh[11].y * t3;
  (*result)[11].z = sh[11].z * t3;
  (*result)[12].x = sh[12].x * t3;
  (*result)[12].y = sh[12].y * t3;
  (*result)[12].z = sh[12].z * t3;
  (*result)[13].x = sh[13].x * t3;
  (*result)[13].y = sh[13].y * t3;
  (*result)[13].z = sh[13].z * t3;
  (*result)[14].x = sh[14].x * t3;
  (*result)[14].y = sh[14].y * t3;
  (*result)[14].z = sh[14].z * t3;
  (*result)[15].x = sh[15].x * t3;
  (*result)[15].y = sh[15].y * t3;
  (*result)[15].z = sh[15].z * t3;
}

// Convolution with a zonal kernel. For colours.
// 80 operations: 0 additions, 80 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_convolve_colour_5(sh: array<vec3<f32>, 25>, kernel: array<f32, 5>,
    result: ptr<function, array<vec3<f32>, 25>>) {
  let t0 = 3.5449078f * kernel[0];
  (*result)[0].x = sh[0].x * t0;
  (*result)[0].y = sh[0].y * t0;
  (*result)[0].z = sh[0].z * t0;
  let t1 = 2.0466535f * kernel[1];
  (*result)[1].x = sh[1].x * t1;
  (*result)[1].y = sh[1].y * t1;
  (*result)[1].z = sh[1].z * t1;
  (*result)[2].x = sh[2].x * t1;
  (*result)[2].y = sh[2].y * t1;
  (*result)[2].z = sh[2].z * t1;
  (*result)[3].x = sh[3].x * t1;
  (*result)[3].y = sh[3].y * t1;
  (*result)[3].z = sh[3].z * t1;
  let t2 = 1.585331f * kernel[2];
  (*result)[4].x = sh[4].x * t2;
  (*result)[4].y = sh[4].y * t2;
  (*result)[4].z = sh[4].z * t2;
  (*result)[5].x = sh[5].x * t2;
  (*result)[5].y = sh[5].y * t2;
  (*result)[5].z = sh[5].z * t2;
  (*result)[6].x = sh[6].x * t2;
  (*result)[6].y = sh[6].y * t2;
  (*result)[6].z = sh[6].z * t2;
  (*result)[7].x = sh[7].x * t2;
  (*result)[7].y = sh[7].y * t2;
  (*result)[7].z = sh[7].z * t2;
  (*result)[8].x = sh[8].x * t2;
  (*result)[8].y = sh[8].y * t2;
  (*result)[8].z = sh[8].z * t2;
  let t3 = 1.3398491f * kernel[3];
  (*result)[9].x = sh[9].x * t3;
  (*result)[9].y = sh[9].y * t3;
  (*result)[9].z = sh[9].z * t3;
  (*result)[10].x = sh[10].x * t3;
  (*result)[10].y = sh[10].y * t3;
  (*result)[10].z = sh[10].z * t3;
  (*result)[11].x = sh[11].x * t3;
  (*result)[11].y = sh[11].y * t3;
  (*result)[11].z = sh[11].z * t3;
  (*result)[12].x = sh[12].x * t3;
  (*result)[12].y = sh[12].y * t3;
  (*result)[12].z = sh[12].z * t3;
  (*result)[13].x = sh[13].x * t3;
  (*result)[13].y = sh[13].y * t3;
  (*result)[13].z = sh[13].z * t3;
  (*result)[14].x = sh[14].x * t3;
  (*result)[14].y = sh[14].y * t3;
  (*result)[14].z = sh[14].z * t3;
  (*result)[15].x = sh[15].x * t3;
  (*result)[15].y = sh[15].y * t3;
  (*result)[15].z = sh[15].z * t3;
  let t4 = 1.1816359f * kernel[4];
  (*result)[16].x = sh[16].x * t4;
  (*result)[16].y = sh[16].y * t4;
  (*result)[16].z = sh[16].z * t4;
  (*result)[17].x = sh[17].x * t4;
  (*result)[17].y = sh[17].y * t4;
  (*result)[17].z = sh[17].z * t4;
  (*result)[18].x = sh[18].x * t4;
  (*result)[18].y = sh[18].y * t4;
  (*result)[18].z = sh[18].z * t4;
  (*result)[19].x = sh[19].x * t4;
  (*result)[19].y = sh[19].y * t4;
  (*result)[19].z = sh[19].z * t4;
  (*result)[20].x = sh[20].x * t4;
  (*result)[20].y = sh[20].y * t4;
  (*result)[20].z = sh[20].z * t4;
  (*result)[21].x = sh[21].x * t4;
  (*result)[21].y = sh[21].y * t4;
  (*result)[21].z = sh[21].z * t4;
  (*result)[22].x = sh[22].x * t4;
  (*result)[22].y = sh[22].y * t4;
  (*result)[22].z = sh[22].z * t4;
  (*result)[23].x = sh[23].x * t4;
  (*result)[23].y = sh[23].y * t4;
  (*result)[23].z = sh[23].z * t4;
  (*result)[24].x = sh[24].x * t4;
  (*result)[24].y = sh[24].y * t4;
  (*result)[24].z = sh[24].z * t4;
}

// Zonal coefficients of the clamped cosine over pi.
// 0 operations: 0 additions, 0 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_lambert_2(z: ptr<function, array<f32, 2>>) {
  (*z)[0] = 0.2820948f;
  (*z)[1] = 0.325735f;
}

// Zonal coefficients of the clamped cosine over pi.
// 0 operations: 0 additions, 0 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_lambert_3(z: ptr<function, array<f32, 3>>) {
  (*z)[0] = 0.2820948f;
  (*z)[1] = 0.325735f;
  (*z)[2] = 0.15769579f;
}

// Zonal coefficients of the clamped cosine over pi.
// 0 operations: 0 additions, 0 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_lambert_4(z: ptr<function, array<f32, 4>>) {
  (*z)[0] = 0.2820948f;
  (*z)[1] = 0.325735f;
  (*z)[2] = 0.15769579f;
  (*z)[3] = 0.0f;
}

// Zonal coefficients of the clamped cosine over pi.
// 0 operations: 0 additions, 0 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_lambert_5(z: ptr<function, array<f32, 5>>) {
  (*z)[0] = 0.2820948f;
  (*z)[1] = 0.325735f;
  (*z)[2] = 0.15769579f;
  (*z)[3] = 0.0f;
  (*z)[4] = -0.03526185f;
}

// Zonal coefficients of a spherical cap, by cosine and sine of its half angle.
// 12 operations: 2 additions, 4 multiplications, 1 divisions, 0 square roots, 5 comparisons and choices.
fn zonal_cap_2(cap: vec2<f32>, z: ptr<function, array<f32, 2>>) {
  let t0 = abs(cap.x);
  let t1 = cap.y * cap.y;
  let t2 = 1.0f + t0;
  let t3 = 0.88622695f * (2.0f * select(t2, select(t1 / t2, 1.0f - t0, t0 < 0.5f), 0.0f < cap.x));
  (*z)[0] = t3;
  (*z)[1] = 1.5349901f * t1;
}

// Zonal coefficients of a spherical cap, by cosine and sine of its half angle.
// 22 operations: 6 additions, 7 multiplications, 1 divisions, 0 square roots, 8 comparisons and choices.
fn zonal_cap_3(cap: vec2<f32>, z: ptr<function, array<f32, 3>>) {
  let is_0 = 0.0f < cap.x;
  let t1 = abs(cap.x);
  let t2 = cap.y * cap.y;
  let t3 = 1.0f + t1;
  let t4 = select(t2 / t3, 1.0f - t1, t1 < 0.5f);
  (*z)[0] = 0.88622695f * (2.0f * select(t3, t4, is_0));
  (*z)[1] = 1.5349901f * t2;
  let t5 = select(0.0f, t2, 0.33333334f < t1);
  let t6 = 1.9816637f * (select(-1.0f, 1.0f, is_0) * (t5 + (t2 - t5 + -(t4 * t2))));
  (*z)[2] = t6;
}

// Zonal coefficients of a spherical cap, by cosine and sine of its half angle.
// 29 operations: 9 additions, 11 multiplications, 1 divisions, 0 square roots, 8 comparisons and choices.
fn zonal_cap_4(cap: vec2<f32>, z: ptr<function, array<f32, 4>>) {
  let is_0 = 0.0f < cap.x;
  let t1 = abs(cap.x);
  let t2 = cap.y * cap.y;
  let t3 = 1.0f + t1;
  let t4 = select(t2 / t3, 1.0f - t1, t1 < 0.5f);
  (*z)[0] = 0.88622695f * (2.0f * select(t3, t4, is_0));
  (*z)[1] = 1.5349901f * t2;
  let t5 = select(0.0f, t2, 0.625f < t1);
  let t6 = -(t4 * t2);
  let t7 = t2 - t5 + t6;
  let t8 = t5 + t7;
  (*z)[2] = 1.9816637f * (select(-1.0f, 1.0f, is_0) * t8);
  (*z)[3] = 2.344736f * (t5 + (t7 + (0.25f * t6 - 1.25f * (t4 * t8))));
}

// Zonal coefficients of a spherical cap, by cosine and sine of its half angle.
// 37 operations: 12 additions, 16 multiplications, 1 divisions, 0 square roots, 8 comparisons and choices.
fn zonal_cap_5(cap: vec2<f32>, z: ptr<function, array<f32, 5>>) {
  let is_0 = 0.0f < cap.x;
  let t1 = abs(cap.x);
  let t2 = cap.y * cap.y;
  let t3 = 1.0f + t1;
  let t4 = select(t2 / t3, 1.0f - t1, t1 < 0.5f);
  (*z)[0] = 0.88622695f * (2.0f * select(t3, t4, is_0));
  (*z)[1] = 1.5349901f * t2;
  let t5 = select(-1.0f, 1.0f, is_0);
  let t6 = select(0.0f, t2, 0.76f < t1);
  let t7 = -(t4 * t2);
  let t8 = t2 - t6 + t7;
  let t9 = t6 + t8;
  (*z)[2] = 1.9816637f * (t5 * t9);
  let t10 = 0.25f * t7 - 1.25f * (t4 * t9);
  let t11 = t8 + t10;
  let t12 = t6 + t11;
  (*z)[3] = 2.344736f * t12;
  (*z)[4] = 2.6586807f * (t5 * (t6 + (t11 + (0.4f * t10 - 1.4f * (t4 * t12)))));
}

// The same up to the hemisphere, in fewer operations.
// 6 operations: 2 additions, 3 multiplications, 1 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_cap_up_to_hemisphere_2(cap: vec2<f32>, z: ptr<function, array<f32, 2>>) {
  let t0 = cap.y * cap.y;
  let t1 = t0 / (1.0f + cap.x);
  (*z)[0] = 0.88622695f * (t1 + t1);
  (*z)[1] = 1.5349901f * t0;
}

// The same up to the hemisphere, in fewer operations.
// 10 operations: 4 additions, 5 multiplications, 1 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_cap_up_to_hemisphere_3(cap: vec2<f32>, z: ptr<function, array<f32, 3>>) {
  let t0 = cap.y * cap.y;
  let t1 = t0 / (1.0f + cap.x);
  (*z)[0] = 0.88622695f * (t1 + t1);
  (*z)[1] = 1.5349901f * t0;
  (*z)[2] = 1.9816637f * (t0 + -(t1 * t0));
}

// The same up to the hemisphere, in fewer operations.
// 16 operations: 6 additions, 9 multiplications, 1 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_cap_up_to_hemisphere_4(cap: vec2<f32>, z: ptr<function, array<f32, 4>>) {
  let t0 = cap.y * cap.y;
  let t1 = t0 / (1.0f + cap.x);
  (*z)[0] = 0.88622695f * (t1 + t1);
  (*z)[1] = 1.5349901f * t0;
  let t2 = -(t1 * t0);
  let t3 = t0 + t2;
  (*z)[2] = 1.9816637f * t3;
  (*z)[3] = 2.344736f * (t3 + (0.25f * t2 - 1.25f * (t1 * t3)));
}

// The same up to the hemisphere, in fewer operations.
// 22 operations: 8 additions, 13 multiplications, 1 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_cap_up_to_hemisphere_5(cap: vec2<f32>, z: ptr<function, array<f32, 5>>) {
  let t0 = cap.y * cap.y;
  let t1 = t0 / (1.0f + cap.x);
  (*z)[0] = 0.88622695f * (t1 + t1);
  (*z)[1] = 1.5349901f * t0;
  let t2 = -(t1 * t0);
  let t3 = t0 + t2;
  (*z)[2] = 1.9816637f * t3;
  let t4 = 0.25f * t2 - 1.25f * (t1 * t3);
  let t5 = t3 + t4;
  (*z)[3] = 2.344736f * t5;
  (*z)[4] = 2.6586807f * (t5 + (0.4f * t4 - 1.4f * (t1 * t5)));
}

// Zonal coefficients of the cap that a sphere covers, seen from a distance.
// 15 operations: 4 additions, 6 multiplications, 2 divisions, 1 square roots, 2 comparisons and choices.
fn zonal_sphere_cap_2(distance: f32, radius: f32, z: ptr<function, array<f32, 2>>) {
  let t0 = 1.0f / distance;
  let t1 = min(radius * t0, 1.0f);
  let t2 = t1 * t1;
  let t3 = t2 / (1.0f + sqrt(max(distance - radius, 0.0f) * t0 * (1.0f + t1)));
  (*z)[0] = 0.88622695f * (t3 + t3);
  (*z)[1] = 1.5349901f * t2;
}

// Zonal coefficients of the cap that a sphere covers, seen from a distance.
// 19 operations: 6 additions, 8 multiplications, 2 divisions, 1 square roots, 2 comparisons and choices.
fn zonal_sphere_cap_3(distance: f32, radius: f32, z: ptr<function, array<f32, 3>>) {
  let t0 = 1.0f / distance;
  let t1 = min(radius * t0, 1.0f);
  let t2 = t1 * t1;
  let t3 = t2 / (1.0f + sqrt(max(distance - radius, 0.0f) * t0 * (1.0f + t1)));
  (*z)[0] = 0.88622695f * (t3 + t3);
  (*z)[1] = 1.5349901f * t2;
  (*z)[2] = 1.9816637f * (t2 + -(t3 * t2));
}

// Zonal coefficients of the cap that a sphere covers, seen from a distance.
// 25 operations: 8 additions, 12 multiplications, 2 divisions, 1 square roots, 2 comparisons and choices.
fn zonal_sphere_cap_4(distance: f32, radius: f32, z: ptr<function, array<f32, 4>>) {
  let t0 = 1.0f / distance;
  let t1 = min(radius * t0, 1.0f);
  let t2 = t1 * t1;
  let t3 = t2 / (1.0f + sqrt(max(distance - radius, 0.0f) * t0 * (1.0f + t1)));
  (*z)[0] = 0.88622695f * (t3 + t3);
  (*z)[1] = 1.5349901f * t2;
  let t4 = -(t3 * t2);
  let t5 = t2 + t4;
  (*z)[2] = 1.9816637f * t5;
  (*z)[3] = 2.344736f * (t5 + (0.25f * t4 - 1.25f * (t3 * t5)));
}

// Zonal coefficients of the cap that a sphere covers, seen from a distance.
// 31 operations: 10 additions, 16 multiplications, 2 divisions, 1 square roots, 2 comparisons and choices.
fn zonal_sphere_cap_5(distance: f32, radius: f32, z: ptr<function, array<f32, 5>>) {
  let t0 = 1.0f / distance;
  let t1 = min(radius * t0, 1.0f);
  let t2 = t1 * t1;
  let t3 = t2 / (1.0f + sqrt(max(distance - radius, 0.0f) * t0 * (1.0f + t1)));
  (*z)[0] = 0.88622695f * (t3 + t3);
  (*z)[1] = 1.5349901f * t2;
  let t4 = -(t3 * t2);
  let t5 = t2 + t4;
  (*z)[2] = 1.9816637f * t5;
  let t6 = 0.25f * t4 - 1.25f * (t3 * t5);
  let t7 = t5 + t6;
  (*z)[3] = 2.344736f * t7;
  (*z)[4] = 2.6586807f * (t7 + (0.4f * t6 - 1.4f * (t3 * t7)));
}

// Zonal coefficients of the cosine power that integrates to 1.
// 4 operations: 2 additions, 1 multiplications, 1 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_phong_2(exponent: f32, z: ptr<function, array<f32, 2>>) {
  (*z)[0] = 0.2820948f;
  (*z)[1] = 0.48860252f * ((exponent + 1.0f) / (exponent + 2.0f));
}

// Zonal coefficients of the cosine power that integrates to 1.
// 7 operations: 3 additions, 2 multiplications, 2 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_phong_3(exponent: f32, z: ptr<function, array<f32, 3>>) {
  (*z)[0] = 0.2820948f;
  (*z)[1] = 0.48860252f * ((exponent + 1.0f) / (exponent + 2.0f));
  (*z)[2] = 0.63078314f * (exponent / (exponent + 3.0f));
}

// Zonal coefficients of the cosine power that integrates to 1.
// 12 operations: 5 additions, 4 multiplications, 3 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_phong_4(exponent: f32, z: ptr<function, array<f32, 4>>) {
  (*z)[0] = 0.2820948f;
  let t0 = (exponent + 1.0f) / (exponent + 2.0f);
  (*z)[1] = 0.48860252f * t0;
  (*z)[2] = 0.63078314f * (exponent / (exponent + 3.0f));
  (*z)[3] = 0.7463527f * (t0 * ((exponent - 1.0f) / (exponent + 4.0f)));
}

// Zonal coefficients of the cosine power that integrates to 1.
// 17 operations: 7 additions, 6 multiplications, 4 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_phong_5(exponent: f32, z: ptr<function, array<f32, 5>>) {
  (*z)[0] = 0.2820948f;
  let t0 = (exponent + 1.0f) / (exponent + 2.0f);
  (*z)[1] = 0.48860252f * t0;
  let t1 = exponent / (exponent + 3.0f);
  (*z)[2] = 0.63078314f * t1;
  (*z)[3] = 0.7463527f * (t0 * ((exponent - 1.0f) / (exponent + 4.0f)));
  (*z)[4] = 0.8462844f * (t1 * ((exponent - 2.0f) / (exponent + 5.0f)));
}

// Zonal coefficients of exp(sharpness (cos theta - 1)).
// 162 operations: 52 additions, 52 multiplications, 20 divisions, 1 square roots, 37 comparisons and choices.
fn zonal_spherical_gaussian_2(sharpness: f32, z: ptr<function, array<f32, 2>>) {
  let t0 = sharpness / (16.0f + sqrt(272.0f + sharpness * sharpness));
  let t1 = sharpness / (31.0f + sharpness * t0);
  let t2 = sharpness / (29.0f + sharpness * t1);
  let t3 = sharpness / (27.0f + sharpness * t2);
  let t4 = sharpness / (25.0f + sharpness * t3);
  let t5 = sharpness / (23.0f + sharpness * t4);
  let t6 = sharpness / (21.0f + sharpness * t5);
  let t7 = sharpness / (19.0f + sharpness * t6);
  let t8 = sharpness / (17.0f + sharpness * t7);
  let t9 = sharpness / (15.0f + sharpness * t8);
  let t10 = sharpness / (13.0f + sharpness * t9);
  let t11 = sharpness / (11.0f + sharpness * t10);
  let t12 = sharpness / (9.0f + sharpness * t11);
  let t13 = sharpness / (7.0f + sharpness * t12);
  let t14 = sharpness / (5.0f + sharpness * t13);
  let t15 = sharpness / (3.0f + sharpness * t14);
  let t16 = 23.0f + t4 * (25.0f + t3 * (27.0f + t2 * (29.0f + t1 * (31.0f + t0 * 33.0f))));
  let t17 = 13.0f + t9 * (15.0f + t8 * (17.0f + t7 * (19.0f + t6 * (21.0f + t5 * t16))));
  let t18 = 3.0f + t14 * (5.0f + t13 * (7.0f + t12 * (9.0f + t11 * (11.0f + t10 * t17))));
  let t19 = max(sharpness, 1.0f);
  let t20 = -2.0f * t19;
  let t21 = min(abs(t20), 105.35837f);
  let is_22 = 64.0f <= t21;
  let is_23 = t20 < 0.0f;
  let t24 = select(t21, t21 - 64.0f, is_22);
  let is_25 = 32.0f <= t24;
  let t26 = select(t24, t24 - 32.0f, is_25);
  let is_27 = 16.0f <= t26;
  let t28 = select(t26, t26 - 16.0f, is_27);
  let is_29 = 8.0f <= t28;
  let t30 = select(t28, t28 - 8.0f, is_29);
  let is_31 = 4.0f <= t30;
  let t32 = select(t30, t30 - 4.0f, is_31);
  let is_33 = 2.0f <= t32;
  let t34 = select(t32, t32 - 2.0f, is_33);
  let is_35 = 1.0f <= t34;
  let t36 = select(t34, t34 - 1.0f, is_35);
  let is_37 = 0.5f <= t36;
  let t38 = select(t36, t36 - 0.5f, is_37);
  let is_39 = 0.25f <= t38;
  let t40 = select(1.0f, 1.2664166e-14f, is_25);
  let t41 = select(t40, t40 * 1.12535176e-07f, is_27);
  let t42 = select(t41, t41 * 0.00033546262f, is_29);
  let t43 = select(t42, t42 * 0.01831564f, is_31);
  let t44 = select(t43, t43 * 0.13533528f, is_33);
  let t45 = select(t44, t44 * 0.36787945f, is_35);
  let t46 = select(t45, t45 * 0.60653067f, is_37);
  let t47 = select(t38, t38 - 0.25f, is_39);
  let t48 = 0.16666667f - t47 * (0.041666668f - t47 * (0.008333334f - t47 * 0.0013888889f));
  let t49 = select(t46, t46 * 0.7788008f, is_39) * (1.0f - t47 * (1.0f - t47 * (0.5f - t47 * t48)));
  let t50 = select(1.0f / t49, t49, is_23);
  let t51 = select(t50, t50 * select(6.235149e+27f, 1.6038109e-28f, is_23), is_22);
  let t52 = select((1.0f - t51) / (t19 + t19), 1.0f / (1.0f + t15 * t18), sharpness < 1.0f);
  (*z)[0] = 3.5449078f * t52;
  let t53 = 6.1399603f * select(t52 * t15, ((1.0f + t51) * 0.5f - t52) / t19, 2.0f < sharpness);
  (*z)[1] = t53;
}

// Zonal coefficients of exp(sharpness (cos theta - 1)).
// 188 operations: 61 additions, 63 multiplications, 25 divisions, 1 square roots, 38 comparisons and choices.
fn zonal_spherical_gaussian_3(sharpness: f32, z: ptr<function, array<f32, 3>>) {
  let t0 = sharpness / (20.0f + sqrt(420.0f + sharpness * sharpness));
  let t1 = sharpness / (39.0f + sharpness * t0);
  let t2 = sharpness / (37.0f + sharpness * t1);
  let t3 = sharpness / (35.0f + sharpness * t2);
  let t4 = sharpness / (33.0f + sharpness * t3);
  let t5 = sharpness / (31.0f + sharpness * t4);
  let t6 = sharpness / (29.0f + sharpness * t5);
  let t7 = sharpness / (27.0f + sharpness * t6);
  let t8 = sharpness / (25.0f + sharpness * t7);
  let t9 = sharpness / (23.0f + sharpness * t8);
  let t10 = sharpness / (21.0f + sharpness * t9);
  let t11 = sharpness / (19.0f + sharpness * t10);
  let t12 = sharpness / (17.0f + sharpness * t11);
  let t13 = sharpness / (15.0f + sharpness * t12);
  let t14 = sharpness / (13.0f + sharpness * t13);
  let t15 = sharpness / (11.0f + sharpness * t14);
  let t16 = sharpness / (9.0f + sharpness * t15);
  let t17 = sharpness / (7.0f + sharpness * t16);
  let t18 = sharpness / (5.0f + sharpness * t17);
  let t19 = sharpness / (3.0f + sharpness * t18);
  let t20 = 31.0f + t4 * (33.0f + t3 * (35.0f + t2 * (37.0f + t1 * (39.0f + t0 * 41.0f))));
  let t21 = 21.0f + t9 * (23.0f + t8 * (25.0f + t7 * (27.0f + t6 * (29.0f + t5 * t20))));
  let t22 = t14 * (13.0f + t13 * (15.0f + t12 * (17.0f + t11 * (19.0f + t10 * t21))));
  let t23 = t19 * (3.0f + t18 * (5.0f + t17 * (7.0f + t16 * (9.0f + t15 * (11.0f + t22)))));
  let t24 = max(sharpness, 1.0f);
  let t25 = -2.0f * t24;
  let t26 = min(abs(t25), 105.35837f);
  let is_27 = 64.0f <= t26;
  let is_28 = t25 < 0.0f;
  let t29 = select(t26, t26 - 64.0f, is_27);
  let is_30 = 32.0f <= t29;
  let t31 = select(t29, t29 - 32.0f, is_30);
  let is_32 = 16.0f <= t31;
  let t33 = select(t31, t31 - 16.0f, is_32);
  let is_34 = 8.0f <= t33;
  let t35 = select(t33, t33 - 8.0f, is_34);
  let is_36 = 4.0f <= t35;
  let t37 = select(t35, t35 - 4.0f, is_36);
  let is_38 = 2.0f <= t37;
  let t39 = select(t37, t37 - 2.0f, is_38);
  let is_40 = 1.0f <= t39;
  let t41 = select(t39, t39 - 1.0f, is_40);
  let is_42 = 0.5f <= t41;
  let t43 = select(t41, t41 - 0.5f, is_42);
  let is_44 = 0.25f <= t43;
  let t45 = select(1.0f, 1.2664166e-14f, is_30);
  let t46 = select(t45, t45 * 1.12535176e-07f, is_32);
  let t47 = select(t46, t46 * 0.00033546262f, is_34);
  let t48 = select(t47, t47 * 0.01831564f, is_36);
  let t49 = select(t48, t48 * 0.13533528f, is_38);
  let t50 = select(t49, t49 * 0.36787945f, is_40);
  let t51 = select(t50, t50 * 0.60653067f, is_42);
  let t52 = select(t43, t43 - 0.25f, is_44);
  let t53 = 0.16666667f - t52 * (0.041666668f - t52 * (0.008333334f - t52 * 0.0013888889f));
  let t54 = select(t51, t51 * 0.7788008f, is_44) * (1.0f - t52 * (1.0f - t52 * (0.5f - t52 * t53)));
  let t55 = select(1.0f / t54, t54, is_28);
  let t56 = select(t55, t55 * select(6.235149e+27f, 1.6038109e-28f, is_28), is_27);
  let t57 = select((1.0f - t56) / (t24 + t24), 1.0f / (1.0f + t23), sharpness < 1.0f);
  (*z)[0] = 3.5449078f * t57;
  let is_58 = 4.5f < sharpness;
  let t59 = ((1.0f + t56) * 0.5f - t57) / t24;
  let t60 = t57 * t19;
  (*z)[1] = 6.1399603f * select(t60, t59, is_58);
  (*z)[2] = 7.926655f * select(t60 * t18, t57 - 3.0f / t24 * t59, is_58);
}

// Zonal coefficients of exp(sharpness (cos theta - 1)).
// 214 operations: 70 additions, 74 multiplications, 30 divisions, 1 square roots, 39 comparisons and choices.
fn zonal_spherical_gaussian_4(sharpness: f32, z: ptr<function, array<f32, 4>>) {
  let t0 = sharpness / (24.0f + sqrt(600.0f + sharpness * sharpness));
  let t1 = sharpness / (47.0f + sharpness * t0);
  let t2 = sharpness / (45.0f + sharpness * t1);
  let t3 = sharpness / (43.0f + sharpness * t2);
  let t4 = sharpness / (41.0f + sharpness * t3);
  let t5 = sharpness / (39.0f + sharpness * t4);
  let t6 = sharpness / (37.0f + sharpness * t5);
  let t7 = sharpness / (35.0f + sharpness * t6);
  let t8 = sharpness / (33.0f + sharpness * t7);
  let t9 = sharpness / (31.0f + sharpness * t8);
  let t10 = sharpness / (29.0f + sharpness * t9);
  let t11 = sharpness / (27.0f + sharpness * t10);
  let t12 = sharpness / (25.0f + sharpness * t11);
  let t13 = sharpness / (23.0f + sharpness * t12);
  let t14 = sharpness / (21.0f + sharpness * t13);
  let t15 = sharpness / (19.0f + sharpness * t14);
  let t16 = sharpness / (17.0f + sharpness * t15);
  let t17 = sharpness / (15.0f + sharpness * t16);
  let t18 = sharpness / (13.0f + sharpness * t17);
  let t19 = sharpness / (11.0f + sharpness * t18);
  let t20 = sharpness / (9.0f + sharpness * t19);
  let t21 = sharpness / (7.0f + sharpness * t20);
  let t22 = sharpness / (5.0f + sharpness * t21);
  let t23 = sharpness / (3.0f + sharpness * t22);
  let t24 = 39.0f + t4 * (41.0f + t3 * (43.0f + t2 * (45.0f + t1 * (47.0f + t0 * 49.0f))));
  let t25 = 29.0f + t9 * (31.0f + t8 * (33.0f + t7 * (35.0f + t6 * (37.0f + t5 * t24))));
  let t26 = t14 * (21.0f + t13 * (23.0f + t12 * (25.0f + t11 * (27.0f + t10 * t25))));
  let t27 = 11.0f + t18 * (13.0f + t17 * (15.0f + t16 * (17.0f + t15 * (19.0f + t26))));
  let t28 = 1.0f + t23 * (3.0f + t22 * (5.0f + t21 * (7.0f + t20 * (9.0f + t19 * t27))));
  let t29 = max(sharpness, 1.0f);
  let t30 = -2.0f * t29;
  let t31 = min(abs(t30), 105.35837f);
  let is_32 = 64.0f <= t31;
  let is_33 = t30 < 0.0f;
  let t34 = select(t31, t31 - 64.0f, is_32);
  let is_35 = 32.0f <= t34;
  let t36 = select(t34, t34 - 32.0f, is_35);
  let is_37 = 16.0f <= t36;
  let t38 = select(t36, t36 - 16.0f, is_37);
  let is_39 = 8.0f <= t38;
  let t40 = select(t38, t38 - 8.0f, is_39);
  let is_41 = 4.0f <= t40;
  let t42 = select(t40, t40 - 4.0f, is_41);
  let is_43 = 2.0f <= t42;
  let t44 = select(t42, t42 - 2.0f, is_43);
  let is_45 = 1.0f <= t44;
  let t46 = select(t44, t44 - 1.0f, is_45);
  let is_47 = 0.5f <= t46;
  let t48 = select(t46, t46 - 0.5f, is_47);
  let is_49 = 0.25f <= t48;
  let t50 = select(1.0f, 1.2664166e-14f, is_35);
  let t51 = select(t50, t50 * 1.12535176e-07f, is_37);
  let t52 = select(t51, t51 * 0.00033546262f, is_39);
  let t53 = select(t52, t52 * 0.01831564f, is_41);
  let t54 = select(t53, t53 * 0.13533528f, is_43);
  let t55 = select(t54, t54 * 0.36787945f, is_45);
  let t56 = select(t55, t55 * 0.60653067f, is_47);
  let t57 = select(t48, t48 - 0.25f, is_49);
  let t58 = 0.16666667f - t57 * (0.041666668f - t57 * (0.008333334f - t57 * 0.0013888889f));
  let t59 = select(t56, t56 * 0.7788008f, is_49) * (1.0f - t57 * (1.0f - t57 * (0.5f - t57 * t58)));
  let t60 = select(1.0f / t59, t59, is_33);
  let t61 = select(t60, t60 * select(6.235149e+27f, 1.6038109e-28f, is_33), is_32);
  let t62 = select((1.0f - t61) / (t29 + t29), 1.0f / t28, sharpness < 1.0f);
  (*z)[0] = 3.5449078f * t62;
  let is_63 = 8.0f < sharpness;
  let t64 = ((1.0f + t61) * 0.5f - t62) / t29;
  let t65 = t62 * t23;
  (*z)[1] = 6.1399603f * select(t65, t64, is_63);
  let t66 = t62 - 3.0f / t29 * t64;
  let t67 = t65 * t22;
  (*z)[2] = 7.926655f * select(t67, t66, is_63);
  (*z)[3] = 9.378944f * select(t67 * t21, t64 - 5.0f / t29 * t66, is_63);
}

// Zonal coefficients of exp(sharpness (cos theta - 1)).
// 240 operations: 79 additions, 85 multiplications, 35 divisions, 1 square roots, 40 comparisons and choices.
fn zonal_spherical_gaussian_5(sharpness: f32, z: ptr<function, array<f32, 5>>) {
  let t0 = sharpness / (28.0f + sqrt(812.0f + sharpness * sharpness));
  let t1 = sharpness / (55.0f + sharpness * t0);
  let t2 = sharpness / (53.0f + sharpness * t1);
  let t3 = sharpness / (51.0f + sharpness * t2);
  let t4 = sharpness / (49.0f + sharpness * t3);
  let t5 = sharpness / (47.0f + sharpness * t4);
  let t6 = sharpness / (45.0f + sharpness * t5);
  let t7 = sharpness / (43.0f + sharpness * t6);
  let t8 = sharpness / (41.0f + sharpness * t7);
  let t9 = sharpness / (39.0f + sharpness * t8);
  let t10 = sharpness / (37.0f + sharpness * t9);
  let t11 = sharpness / (35.0f + sharpness * t10);
  let t12 = sharpness / (33.0f + sharpness * t11);
  let t13 = sharpness / (31.0f + sharpness * t12);
  let t14 = sharpness / (29.0f + sharpness * t13);
  let t15 = sharpness / (27.0f + sharpness * t14);
  let t16 = sharpness / (25.0f + sharpness * t15);
  let t17 = sharpness / (23.0f + sharpness * t16);
  let t18 = sharpness / (21.0f + sharpness * t17);
  let t19 = sharpness / (19.0f + sharpness * t18);
  let t20 = sharpness / (17.0f + sharpness * t19);
  let t21 = sharpness / (15.0f + sharpness * t20);
  let t22 = sharpness / (13.0f + sharpness * t21);
  let t23 = sharpness / (11.0f + sharpness * t22);
  let t24 = sharpness / (9.0f + sharpness * t23);
  let t25 = sharpness / (7.0f + sharpness * t24);
  let t26 = sharpness / (5.0f + sharpness * t25);
  let t27 = sharpness / (3.0f + sharpness * t26);
  let t28 = 47.0f + t4 * (49.0f + t3 * (51.0f + t2 * (53.0f + t1 * (55.0f + t0 * 57.0f))));
  let t29 = 37.0f + t9 * (39.0f + t8 * (41.0f + t7 * (43.0f + t6 * (45.0f + t5 * t28))));
  let t30 = t14 * (29.0f + t13 * (31.0f + t12 * (33.0f + t11 * (35.0f + t10 * t29))));
  let t31 = 19.0f + t18 * (21.0f + t17 * (23.0f + t16 * (25.0f + t15 * (27.0f + t30))));
  let t32 = t23 * (11.0f + t22 * (13.0f + t21 * (15.0f + t20 * (17.0f + t19 * t31))));
  let t33 = 1.0f / (1.0f + t27 * (3.0f + t26 * (5.0f + t25 * (7.0f + t24 * (9.0f + t32)))));
  let t34 = max(sharpness, 1.0f);
  let t35 = -2.0f * t34;
  let t36 = min(abs(t35), 105.35837f);
  let is_37 = 64.0f <= t36;
  let is_38 = t35 < 0.0f;
  let t39 = select(t36, t36 - 64.0f, is_37);
  let is_40 = 32.0f <= t39;
  let t41 = select(t39, t39 - 32.0f, is_40);
  let is_42 = 16.0f <= t41;
  let t43 = select(t41, t41 - 16.0f, is_42);
  let is_44 = 8.0f <= t43;
  let t45 = select(t43, t43 - 8.0f, is_44);
  let is_46 = 4.0f <= t45;
  let t47 = select(t45, t45 - 4.0f, is_46);
  let is_48 = 2.0f <= t47;
  let t49 = select(t47, t47 - 2.0f, is_48);
  let is_50 = 1.0f <= t49;
  let t51 = select(t49, t49 - 1.0f, is_50);
  let is_52 = 0.5f <= t51;
  let t53 = select(t51, t51 - 0.5f, is_52);
  let is_54 = 0.25f <= t53;
  let t55 = select(1.0f, 1.2664166e-14f, is_40);
  let t56 = select(t55, t55 * 1.12535176e-07f, is_42);
  let t57 = select(t56, t56 * 0.00033546262f, is_44);
  let t58 = select(t57, t57 * 0.01831564f, is_46);
  let t59 = select(t58, t58 * 0.13533528f, is_48);
  let t60 = select(t59, t59 * 0.36787945f, is_50);
  let t61 = select(t60, t60 * 0.60653067f, is_52);
  let t62 = select(t53, t53 - 0.25f, is_54);
  let t63 = 0.16666667f - t62 * (0.041666668f - t62 * (0.008333334f - t62 * 0.0013888889f));
  let t64 = select(t61, t61 * 0.7788008f, is_54) * (1.0f - t62 * (1.0f - t62 * (0.5f - t62 * t63)));
  let t65 = select(1.0f / t64, t64, is_38);
  let t66 = select(t65, t65 * select(6.235149e+27f, 1.6038109e-28f, is_38), is_37);
  let t67 = select((1.0f - t66) / (t34 + t34), t33, sharpness < 1.0f);
  (*z)[0] = 3.5449078f * t67;
  let is_68 = 12.5f < sharpness;
  let t69 = ((1.0f + t66) * 0.5f - t67) / t34;
  let t70 = t67 * t27;
  (*z)[1] = 6.1399603f * select(t70, t69, is_68);
  let t71 = t67 - 3.0f / t34 * t69;
  let t72 = t70 * t26;
  (*z)[2] = 7.926655f * select(t72, t71, is_68);
  let t73 = t69 - 5.0f / t34 * t71;
  let t74 = t72 * t25;
  (*z)[3] = 9.378944f * select(t74, t73, is_68);
  (*z)[4] = 10.634723f * select(t74 * t24, t71 - 7.0f / t34 * t73, is_68);
}

// A sphere light of radiance 1, seen from a receiver.
// 51 operations: 9 additions, 20 multiplications, 2 divisions, 2 square roots, 18 comparisons and choices.
fn zonal_project_sphere_2(center: vec3<f32>, radius: f32, receiver: vec3<f32>, sh: ptr<function, array<f32, 4>>) {
  let t0 = min(max(center.x - receiver.x, -4.611686e+18f), 4.611686e+18f);
  let t1 = min(max(center.y - receiver.y, -4.611686e+18f), 4.611686e+18f);
  let t2 = min(max(center.z - receiver.z, -4.611686e+18f), 4.611686e+18f);
  let t3 = t0 * t0 + t1 * t1 + t2 * t2;
  let t4 = sqrt(max(t3, 5.421011e-20f));
  let t5 = 1.0f / t4;
  let t6 = min(radius * t5, 1.0f);
  let t7 = sqrt(max(t4 - radius, 0.0f) * t5 * (1.0f + t6));
  let t8 = abs(t7);
  let t9 = t6 * t6;
  let t10 = 1.0f + t8;
  let t11 = 3.1415927f * (2.0f * select(t10, select(t9 / t10, 1.0f - t8, t8 < 0.5f), 0.0f < t7));
  (*sh)[0] = t11 * 0.2820948f;
  let t12 = 3.1415927f * t9;
  let is_13 = t3 < 5.421011e-20f;
  (*sh)[1] = t12 * (-0.48860252f * select(t1 * t5, 0.0f, is_13));
  (*sh)[2] = t12 * (0.48860252f * select(t2 * t5, 1.0f, is_13));
  (*sh)[3] = t12 * (-0.48860252f * select(t0 * t5, 0.0f, is_13));
}

// A sphere light of radiance 1, seen from a receiver.
// 79 operations: 16 additions, 38 multiplications, 2 divisions, 2 square roots, 21 comparisons and choices.
fn zonal_project_sphere_3(center: vec3<f32>, radius: f32, receiver: vec3<f32>, sh: ptr<function, array<f32, 9>>) {
  let t0 = min(max(center.x - receiver.x, -4.611686e+18f), 4.611686e+18f);
  let t1 = min(max(center.y - receiver.y, -4.611686e+18f), 4.611686e+18f);
  let t2 = min(max(center.z - receiver.z, -4.611686e+18f), 4.611686e+18f);
  let t3 = t0 * t0 + t1 * t1 + t2 * t2;
  let t4 = sqrt(max(t3, 5.421011e-20f));
  let t5 = 1.0f / t4;
  let t6 = min(radius * t5, 1.0f);
  let t7 = sqrt(max(t4 - radius, 0.0f) * t5 * (1.0f + t6));
  let is_8 = 0.0f < t7;
  let t9 = abs(t7);
  let t10 = t6 * t6;
  let t11 = 1.0f + t9;
  let t12 = select(t10 / t11, 1.0f - t9, t9 < 0.5f);
  (*sh)[0] = 3.1415927f * (2.0f * select(t11, t12, is_8)) * 0.2820948f;
  let t13 = 3.1415927f * t10;
  let is_14 = t3 < 5.421011e-20f;
  let t15 = select(t1 * t5, 0.0f, is_14);
  (*sh)[1] = t13 * (-0.48860252f * t15);
  let t16 = select(t2 * t5, 1.0f, is_14);
  (*sh)[2] = t13 * (0.48860252f * t16);
  let t17 = select(t0 * t5, 0.0f, is_14);
  (*sh)[3] = t13 * (-0.48860252f * t17);
  let t18 = select(0.0f, t10, 0.33333334f < t9);
  let t19 = 3.1415927f * (select(-1.0f, 1.0f, is_8) * (t18 + (t10 - t18 + -(t12 * t10))));
  let t20 = t15 * t17;
  (*sh)[4] = t19 * (0.54627424f * (t20 + t20));
  let t21 = -1.0925485f * t16;
  (*sh)[5] = t19 * (t21 * t15);
  (*sh)[6] = t19 * (0.9461747f * (t16 * t16) + -0.31539157f);
  (*sh)[7] = t19 * (t21 * t17);
  (*sh)[8] = t19 * (0.54627424f * (t17 * t17 - t15 * t15));
}

// A sphere light of radiance 1, seen from a receiver.
// 111 operations: 23 additions, 63 multiplications, 2 divisions, 2 square roots, 21 comparisons and choices.
fn zonal_project_sphere_4(center: vec3<f32>, radius: f32, receiver: vec3<f32>, sh: ptr<function, array<f32, 16>>) {
  let t0 = min(max(center.x - receiver.x, -4.611686e+18f), 4.611686e+18f);
  let t1 = min(max(center.y - receiver.y, -4.611686e+18f), 4.611686e+18f);
  let t2 = min(max(center.z - receiver.z, -4.611686e+18f), 4.611686e+18f);
  let t3 = t0 * t0 + t1 * t1 + t2 * t2;
  let t4 = sqrt(max(t3, 5.421011e-20f));
  let t5 = 1.0f / t4;
  let t6 = min(radius * t5, 1.0f);
  let t7 = sqrt(max(t4 - radius, 0.0f) * t5 * (1.0f + t6));
  let is_8 = 0.0f < t7;
  let t9 = abs(t7);
  let t10 = t6 * t6;
  let t11 = 1.0f + t9;
  let t12 = select(t10 / t11, 1.0f - t9, t9 < 0.5f);
  (*sh)[0] = 3.1415927f * (2.0f * select(t11, t12, is_8)) * 0.2820948f;
  let t13 = 3.1415927f * t10;
  let is_14 = t3 < 5.421011e-20f;
  let t15 = select(t1 * t5, 0.0f, is_14);
  (*sh)[1] = t13 * (-0.48860252f * t15);
  let t16 = select(t2 * t5, 1.0f, is_14);
  (*sh)[2] = t13 * (0.48860252f * t16);
  let t17 = select(t0 * t5, 0.0f, is_14);
  (*sh)[3] = t13 * (-0.48860252f * t17);
  let t18 = select(0.0f, t10, 0.625f < t9);
  let t19 = -(t12 * t10);
  let t20 = t10 - t18 + t19;
  let t21 = t18 + t20;
  let t22 = 3.1415927f * (select(-1.0f, 1.0f, is_8) * t21);
  let t23 = t15 * t17;
  let t24 = t23 + t23;
  (*sh)[4] = t22 * (0.54627424f * t24);
  let t25 = -1.0925485f * t16;
  (*sh)[5] = t22 * (t25 * t15);
  let t26 = t16 * t16;
  (*sh)[6] = t22 * (0.9461747f * t26 + -0.31539157f);
  (*sh)[7] = t22 * (t25 * t17);
  let t27 = t17 * t17 - t15 * t15;
  (*sh)[8] = t22 * (0.54627424f * t27);
  let t28 = 3.1415927f * (t18 + (t20 + (0.25f * t19 - 1.25f * (t12 * t21))));
  (*sh)[9] = t28 * (-0.5900436f * (t17 * t24 + t15 * t27));
  let t29 = 1.4453057f * t16;
  (*sh)[10] = t28 * (t29 * t24);
  let t30 = -2.285229f * t26 + 0.4570458f;
  (*sh)[11] = t28 * (t30 * t15);
  (*sh)[12] = t28 * (t16 * (1.8658817f * t26 + -1.119529f));
  (*sh)[13] = t28 * (t30 * t17);
  (*sh)[14] = t28 * (t29 * t27);
  (*sh)[15] = t28 * (-0.5900436f * (t17 * t27 - t15 * t24));
}

// A sphere light of radiance 1, seen from a receiver.
// 152 operations: 31 additions, 96 multiplications, 2 divisions, 2 square roots, 21 comparisons and choices.
fn zonal_project_sphere_5(center: vec3<f32>, radius: f32, receiver: vec3<f32>, sh: ptr<function, array<f32, 25>>) {
  let t0 = min(max(center.x - receiver.x, -4.611686e+18f), 4.611686e+18f);
  let t1 = min(max(center.y - receiver.y, -4.611686e+18f), 4.611686e+18f);
  let t2 = min(max(center.z - receiver.z, -4.611686e+18f), 4.611686e+18f);
  let t3 = t0 * t0 + t1 * t1 + t2 * t2;
  let t4 = sqrt(max(t3, 5.421011e-20f));
  let t5 = 1.0f / t4;
  let t6 = min(radius * t5, 1.0f);
  let t7 = sqrt(max(t4 - radius, 0.0f) * t5 * (1.0f + t6));
  let is_8 = 0.0f < t7;
  let t9 = abs(t7);
  let t10 = t6 * t6;
  let t11 = 1.0f + t9;
  let t12 = select(t10 / t11, 1.0f - t9, t9 < 0.5f);
  (*sh)[0] = 3.1415927f * (2.0f * select(t11, t12, is_8)) * 0.2820948f;
  let t13 = 3.1415927f * t10;
  let is_14 = t3 < 5.421011e-20f;
  let t15 = select(t1 * t5, 0.0f, is_14);
  (*sh)[1] = t13 * (-0.48860252f * t15);
  let t16 = select(t2 * t5, 1.0f, is_14);
  (*sh)[2] = t13 * (0.48860252f * t16);
  let t17 = select(t0 * t5, 0.0f, is_14);
  (*sh)[3] = t13 * (-0.48860252f * t17);
  let t18 = select(-1.0f, 1.0f, is_8);
  let t19 = select(0.0f, t10, 0.76f < t9);
  let t20 = -(t12 * t10);
  let t21 = t10 - t19 + t20;
  let t22 = t19 + t21;
  let t23 = 3.1415927f * (t18 * t22);
  let t24 = t15 * t17;
  let t25 = t24 + t24;
  (*sh)[4] = t23 * (0.54627424f * t25);
  let t26 = -1.0925485f * t16;
  (*sh)[5] = t23 * (t26 * t15);
  let t27 = t16 * t16;
  let t28 = 0.9461747f * t27 + -0.31539157f;
  (*sh)[6] = t23 * t28;
  (*sh)[7] = t23 * (t26 * t17);
  let t29 = t17 * t17 - t15 * t15;
  (*sh)[8] = t23 * (0.54627424f * t29);
  let t30 = 0.25f * t20 - 1.25f * (t12 * t22);
  let t31 = t21 + t30;
  let t32 = t19 + t31;
  let t33 = 3.1415927f * t32;
  let t34 = t17 * t25 + t15 * t29;
  (*sh)[9] = t33 * (-0.5900436f * t34);
  let t35 = 1.4453057f * t16;
  (*sh)[10] = t33 * (t35 * t25);
  let t36 = -2.285229f * t27 + 0.4570458f;
  (*sh)[11] = t33 * (t36 * t15);
  let t37 = t16 * (1.8658817f * t27 + -1.119529f);
  (*sh)[12] = t33 * t37;
  (*sh)[13] = t33 * (t36 * t17);
  (*sh)[14] = t33 * (t35 * t29);
  let t38 = t17 * t29 - t15 * t25;
  (*sh)[15] = t33 * (-0.5900436f * t38);
  let t39 = 3.1415927f * (t18 * (t19 + (t31 + (0.4f * t30 - 1.4f * (t12 * t32)))));
  (*sh)[16] = t39 * (0.6258357f * (t17 * t34 + t15 * t38));
  let t40 = -1.7701308f * t16;
  (*sh)[17] = t39 * (t40 * t34);
  let t41 = 3.3116114f * t27 + -0.47308734f;
  (*sh)[18] = t39 * (t41 * t25);
  let t42 = t16 * (-4.683326f * t27 + 2.0071397f);
  (*sh)[19] = t39 * (t42 * t15);
  (*sh)[20] = t39 * (1.9843135f * t16 * t37 - 1.0062306f * t28);
  (*sh)[21] = t39 * (t42 * t17);
  (*sh)[22] = t39 * (t41 * t29);
  (*sh)[23] = t39 * (t40 * t38);
  (*sh)[24] = t39 * (0.6258357f * (t17 * t38 - t15 * t34));
}

// A colour in a direction of any length but 0, and a loss's derivatives, given those by the colour.
// 184 operations: 59 additions, 123 multiplications, 1 divisions, 1 square roots, 0 comparisons and choices.
fn zonal_reconstruct_with_adjoint_3(sh: array<vec3<f32>, 9>, direction: vec3<f32>, by_value: vec3<f32>,
    value: ptr<function, vec3<f32>>, by_sh: ptr<function, array<vec3<f32>, 9>>,
    by_direction: ptr<function, vec3<f32>>) {
  let t0 = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
  let t1 = 1.0f / sqrt(t0);
  let t2 = direction.y * t1;
  let t3 = direction.x * t1;
  let t4 = t2 * t3;
  let t5 = 0.54627424f * (t4 + t4);
  let t6 = 0.54627424f * (t3 * t3 - t2 * t2);
  let t7 = -0.48860252f * t2;
  let t8 = direction.z * t1;
  let t9 = -1.0925485f * t8;
  let t10 = t9 * t2;
  let t11 = sh[0].x * 0.2820948f + sh[4].x * t5 + sh[8].x * t6 + (sh[1].x * t7 + sh[5].x * t10);
  let t12 = 0.48860252f * t8;
  let t13 = 0.9461747f * (t8 * t8) + -0.31539157f;
  let t14 = -0.48860252f * t3;
  let t15 = t9 * t3;
  (*value).x = t11 + (sh[2].x * t12 + sh[6].x * t13 + (sh[3].x * t14 + sh[7].x * t15));
  let t16 = sh[0].y * 0.2820948f + sh[4].y * t5 + sh[8].y * t6 + (sh[1].y * t7 + sh[5].y * t10);
  (*value).y = t16 + (sh[2].y * t12 + sh[6].y * t13 + (sh[3].y * t14 + sh[7].y * t15));
  let t17 = sh[0].z * 0.2820948f + sh[4].z * t5 + sh[8].z * t6 + (sh[1].z * t7 + sh[5].z * t10);
  (*value).z = t17 + (sh[2].z * t12 + sh[6].z * t13 + (sh[3].z * t14 + sh[7].z * t15));
  (*by_sh)[0].x = by_value.x * 0.2820948f;
  (*by_sh)[0].y = by_value.y * 0.2820948f;
  (*by_sh)[0].z = by_value.z * 0.2820948f;
  (*by_sh)[1].x = by_value.x * t7;
  (*by_sh)[1].y = by_value.y * t7;
  (*by_sh)[1].z = by_value.z * t7;
  (*by_sh)[2].x = by_value.x * t12;
  (*by_sh)[2].y = by_value.y * t12;
  (*by_sh)[2].z = by_value.z * t12;
  (*by_sh)[3].x = by_value.x * t14;
  (*by_sh)[3].y = by_value.y * t14;
  (*by_sh)[3].z = by_value.z * t14;
  (*by_sh)[4].x = by_value.x * t5;
  (*by_sh)[4].y = by_value.y * t5;
  (*by_sh)[4].z = by_value.z * t5;
  (*by_sh)[5].x = by_value.x * t10;
  (*by_sh)[5].y = by_value.y * t10;
  (*by_sh)[5].z = by_value.z * t10;
  (*by_sh)[6].x = by_value.x * t13;
  (*by_sh)[6].y = by_value.y * t13;
  (*by_sh)[6].z = by_value.z * t13;
  (*by_sh)[7].x = by_value.x * t15;
  (*by_sh)[7].y = by_value.y * t15;
  (*by_sh)[7].z = by_value.z * t15;
  (*by_sh)[8].x = by_value.x * t6;
  (*by_sh)[8].y = by_value.y * t6;
  (*by_sh)[8].z = by_value.z * t6;
  let t18 = -0.48860252f * (by_value.x * sh[3].x + by_value.y * sh[3].y + by_value.z * sh[3].z);
  let t19 = by_value.x * sh[7].x + by_value.y * sh[7].y + by_value.z * sh[7].z;
  let t20 = 1.0925485f * (by_value.x * sh[8].x + by_value.y * sh[8].y + by_value.z * sh[8].z);
  let t21 = 1.0925485f * (by_value.x * sh[4].x + by_value.y * sh[4].y + by_value.z * sh[4].z);
  let t22 = t18 + t9 * t19 + (t20 * t3 + t21 * t2);
  let t23 = -0.48860252f * (by_value.x * sh[1].x + by_value.y * sh[1].y + by_value.z * sh[1].z);
  let t24 = by_value.x * sh[5].x + by_value.y * sh[5].y + by_value.z * sh[5].z;
  let t25 = t23 + t9 * t24 + (t21 * t3 - t20 * t2);
  let t26 = 0.48860252f * (by_value.x * sh[2].x + by_value.y * sh[2].y + by_value.z * sh[2].z);
  let t27 = -1.7320508f * t9 * (by_value.x * sh[6].x + by_value.y * sh[6].y + by_value.z * sh[6].z);
  let t28 = t26 + t27 + (-1.0925485f * t19 * t3 + -1.0925485f * t24 * t2);
  let t29 = t22 * t3 + t25 * t2 + t28 * t8;
  (*by_direction).x = (t22 - t3 * t29) * t1;
  (*by_direction).y = (t25 - t2 * t29) * t1;
  (*by_direction).z = (t28 - t8 * t29) * t1;
}

// A colour in a direction of any length but 0, and a loss's derivatives, given those by the colour.
// 333 operations: 111 additions, 220 multiplications, 1 divisions, 1 square roots, 0 comparisons and choices.
fn zonal_reconstruct_with_adjoint_4(sh: array<vec3<f32>, 16>, direction: vec3<f32>, by_value: vec3<f32>,
    value: ptr<function, vec3<f32>>, by_sh: ptr<function, array<vec3<f32>, 16>>,
    by_direction: ptr<function, vec3<f32>>) {
  let t0 = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
  let t1 = 1.0f / sqrt(t0);
  let t2 = direction.z * t1;
  let t3 = t2 * t2;
  let t4 = t2 * (1.8658817f * t3 + -1.119529f);
  let t5 = direction.y * t1;
  let t6 = direction.x * t1;
  let t7 = t5 * t6;
  let t8 = t7 + t7;
  let t9 = 0.54627424f * t8;
  let t10 = t6 * t6 - t5 * t5;
  let t11 = 0.54627424f * t10;
  let t12 = -0.48860252f * t5;
  let t13 = -1.0925485f * t2;
  let t14 = t13 * t5;
  let t15 = -2.285229f * t3 + 0.4570458f;
  let t16 = t15 * t6;
  let t17 = -0.5900436f * (t6 * t8 + t5 * t10);
  let t18 = sh[0].x * 0.2820948f + sh[12].x * t4 + sh[4].x * t9 + sh[8].x * t11 + (sh[1].x * t12 + sh[5].x * t14 + sh[13].x * t16 + sh[9].x * t17);
  let t19 = 0.48860252f * t2;
  let t20 = 0.9461747f * t3 + -0.31539157f;
  let t21 = 1.4453057f * t2;
  let t22 = t21 * t8;
  let t23 = t21 * t10;
  let t24 = -0.48860252f * t6;
  let t25 = t13 * t6;
  let t26 = t15 * t5;
  let t27 = -0.5900436f * (t6 * t10 - t5 * t8);
  let t28 = sh[2].x * t19 + sh[6].x * t20 + sh[10].x * t22 + sh[14].x * t23 + (sh[3].x * t24 + sh[7].x * t25 + sh[11].x * t26 + sh[15].x * t27);
  (*value).x = t18 + t28;
  let t29 = sh[0].y * 0.2820948f + sh[12].y * t4 + sh[4].y * t9 + sh[8].y * t11 + (sh[1].y * t12 + sh[5].y * t14 + sh[13].y * t16 + sh[9].y * t17);
  let t30 = sh[2].y * t19 + sh[6].y * t20 + sh[10].y * t22 + sh[14].y * t23 + (sh[3].y * t24 + sh[7].y * t25 + sh[11].y * t26 + sh[15].y * t27);
  (*value).y = t29 + t30;
  let t31 = sh[0].z * 0.2820948f + sh[12].z * t4 + sh[4].z * t9 + sh[8].z * t11 + (sh[1].z * t12 + sh[5].z * t14 + sh[13].z * t16 + sh[9].z * t17);
  let t32 = sh[2].z * t19 + sh[6].z * t20 + sh[10].z * t22 + sh[14].z * t23 + (sh[3].z * t24 + sh[7].z * t25 + sh[11].z * t26 + sh[15].z * t27);
  (*value).z = t31 + t32;
  (*by_sh)[0].x = by_value.x * 0.2820948f;
  (*by_sh)[0].y = by_value.y * 0.2820948f;
  (*by_sh)[0].z = by_value.z * 0.2820948f;
  (*by_sh)[1].x = by_value.x * t12;
  (*by_sh)[1].y = by_value.y * t12;
  (*by_sh)[1].z = by_value.z * t12;
  (*by_sh)[2].x = by_value.x * t19;
  (*by_sh)[2].y = by_value.y * t19;
  (*by_sh)[2].z = by_value.z * t19;
  (*by_sh)[3].x = by_value.x * t24;
  (*by_sh)[3].y = by_value.y * t24;
  (*by_sh)[3].z = by_value.z * t24;
  (*by_sh)[4].x = by_value.x * t9;
  (*by_sh)[4].y = by_value.y * t9;
  (*by_sh)[4].z = by_value.z * t9;
  (*by_sh)[5].x = by_value.x * t14;
  (*by_sh)[5].y = by_value.y * t14;
  (*by_sh)[5].z = by_value.z * t14;
  (*by_sh)[6].x = by_value.x * t20;
  (*by_sh)[6].y = by_value.y * t20;
  (*by_sh)[6].z = by_value.z * t20;
  (*by_sh)[7].x = by_value.x * t25;
  (*by_sh)[7].y = by_value.y * t25;
  (*by_sh)[7].z = by_value.z * t25;
  (*by_sh)[8].x = by_value.x * t11;
  (*by_sh)[8].y = by_value.y * t11;
  (*by_sh)[8].z = by_value.z * t11;
  (*by_sh)[9].x = by_value.x * t17;
  (*by_sh)[9].y = by_value.y * t17;
  (*by_sh)[9].z = by_value.z * t17;
  (*by_sh)[10].x = by_value.x * t22;
  (*by_sh)[10].y = by_value.y * t22;
  (*by_sh)[10].z = by_value.z * t22;
  (*by_sh)[11].x = by_value.x * t26;
  (*by_sh)[11].y = by_value.y * t26;
  (*by_sh)[11].z = by_value.z * t26;
  (*by_sh)[12].x = by_value.x * t4;
  (*by_sh)[12].y = by_value.y * t4;
  (*by_sh)[12].z = by_value.z * t4;
  (*by_sh)[13].x = by_value.x * t16;
  (*by_sh)[13].y = by_value.y * t16;
  (*by_sh)[13].z = by_value.z * t16;
  (*by_sh)[14].x = by_value.x * t23;
  (*by_sh)[14].y = by_value.y * t23;
  (*by_sh)[14].z = by_value.z * t23;
  (*by_sh)[15].x = by_value.x * t27;
  (*by_sh)[15].y = by_value.y * t27;
  (*by_sh)[15].z = by_value.z * t27;
  let t33 = -0.48860252f * (by_value.x * sh[3].x + by_value.y * sh[3].y + by_value.z * sh[3].z);
  let t34 = by_value.x * sh[7].x + by_value.y * sh[7].y + by_value.z * sh[7].z;
  let t35 = by_value.x * sh[13].x + by_value.y * sh[13].y + by_value.z * sh[13].z;
  let t36 = 1.0925485f * (by_value.x * sh[8].x + by_value.y * sh[8].y + by_value.z * sh[8].z);
  let t37 = 2.0f * t21;
  let t38 = by_value.x * sh[14].x + by_value.y * sh[14].y + by_value.z * sh[14].z;
  let t39 = t36 + t37 * t38;
  let t40 = 1.0925485f * (by_value.x * sh[4].x + by_value.y * sh[4].y + by_value.z * sh[4].z);
  let t41 = by_value.x * sh[10].x + by_value.y * sh[10].y + by_value.z * sh[10].z;
  let t42 = t40 + t37 * t41;
  let t43 = -1.7701309f * (by_value.x * sh[15].x + by_value.y * sh[15].y + by_value.z * sh[15].z);
  let t44 = -1.7701309f * (by_value.x * sh[9].x + by_value.y * sh[9].y + by_value.z * sh[9].z);
  let t45 = t33 + t13 * t34 + t15 * t35 + (t39 * t6 + t42 * t5) + (t43 * t10 + t44 * t8);
  let t46 = -0.48860252f * (by_value.x * sh[1].x + by_value.y * sh[1].y + by_value.z * sh[1].z);
  let t47 = by_value.x * sh[5].x + by_value.y * sh[5].y + by_value.z * sh[5].z;
  let t48 = by_value.x * sh[11].x + by_value.y * sh[11].y + by_value.z * sh[11].z;
  let t49 = t46 + t13 * t47 + t15 * t48 + (t42 * t6 - t39 * t5) + (t44 * t10 - t43 * t8);
  let t50 = 0.48860252f * (by_value.x * sh[2].x + by_value.y * sh[2].y + by_value.z * sh[2].z);
  let t51 = -1.7320508f * t13 * (by_value.x * sh[6].x + by_value.y * sh[6].y + by_value.z * sh[6].z);
  let t52 = -2.4494898f * t15 * (by_value.x * sh[12].x + by_value.y * sh[12].y + by_value.z * sh[12].z);
  let t53 = -3.1622777f * t21;
  let t54 = (-1.0925485f * t34 + t53 * t35) * t6 + (-1.0925485f * t47 + t53 * t48) * t5;
  let t55 = t50 + t51 + t52 + t54 + (1.4453058f * t38 * t10 + 1.4453058f * t41 * t8);
  let t56 = t45 * t6 + t49 * t5 + t55 * t2;
  (*by_direction).x = (t45 - t6 * t56) * t1;
  (*by_direction).y = (t49 - t5 * t56) * t1;
  (*by_direction).z = (t55 - t2 * t56) * t1;
}

// A splat's colour as a camera sees it: the value, and half more, and at least 0 [Kerbl et al. 2023]. For colours.
// 86 operations: 35 additions, 46 multiplications, 1 divisions, 1 square roots, 3 comparisons and choices.
fn zonal_splat_colour_3(sh: array<vec3<f32>, 9>, position: vec3<f32>, camera: vec3<f32>) -> vec3<f32> {
  let t0 = position.y - camera.y;
  let t1 = position.x - camera.x;
  let t2 = position.z - camera.z;
  let t3 = 1.0f / sqrt(t1 * t1 + t0 * t0 + t2 * t2);
  let t4 = t0 * t3;
  let t5 = t1 * t3;
  let t6 = t4 * t5;
  let t7 = 0.54627424f * (t6 + t6);
  let t8 = 0.54627424f * (t5 * t5 - t4 * t4);
  let t9 = -0.48860252f * t4;
  let t10 = t2 * t3;
  let t11 = -1.0925485f * t10;
  let t12 = t11 * t4;
  let t13 = sh[0].x * 0.2820948f + sh[4].x * t7 + sh[8].x * t8 + (sh[1].x * t9 + sh[5].x * t12);
  let t14 = 0.48860252f * t10;
  let t15 = 0.9461747f * (t10 * t10) + -0.31539157f;
  let t16 = -0.48860252f * t5;
  let t17 = t11 * t5;
  let t18 = t13 + (sh[2].x * t14 + sh[6].x * t15 + (sh[3].x * t16 + sh[7].x * t17)) + 0.5f;
  let t19 = sh[0].y * 0.2820948f + sh[4].y * t7 + sh[8].y * t8 + (sh[1].y * t9 + sh[5].y * t12);
  let t20 = t19 + (sh[2].y * t14 + sh[6].y * t15 + (sh[3].y * t16 + sh[7].y * t17)) + 0.5f;
  let t21 = sh[0].z * 0.2820948f + sh[4].z * t7 + sh[8].z * t8 + (sh[1].z * t9 + sh[5].z * t12);
  let t22 = t21 + (sh[2].z * t14 + sh[6].z * t15 + (sh[3].z * t16 + sh[7].z * t17)) + 0.5f;
  let value = vec3<f32>(max(t18, 0.0f), max(t20, 0.0f), max(t22, 0.0f));
  return value;
}

// A splat's colour as a camera sees it: the value, and half more, and at least 0 [Kerbl et al. 2023]. For colours.
// 146 operations: 60 additions, 81 multiplications, 1 divisions, 1 square roots, 3 comparisons and choices.
fn zonal_splat_colour_4(sh: array<vec3<f32>, 16>, position: vec3<f32>, camera: vec3<f32>) -> vec3<f32> {
  let t0 = position.z - camera.z;
  let t1 = position.x - camera.x;
  let t2 = position.y - camera.y;
  let t3 = 1.0f / sqrt(t1 * t1 + t2 * t2 + t0 * t0);
  let t4 = t0 * t3;
  let t5 = t4 * t4;
  let t6 = t4 * (1.8658817f * t5 + -1.119529f);
  let t7 = t2 * t3;
  let t8 = t1 * t3;
  let t9 = t7 * t8;
  let t10 = t9 + t9;
  let t11 = 0.54627424f * t10;
  let t12 = t8 * t8 - t7 * t7;
  let t13 = 0.54627424f * t12;
  let t14 = -0.48860252f * t7;
  let t15 = -1.0925485f * t4;
  let t16 = t15 * t7;
  let t17 = -2.285229f * t5 + 0.4570458f;
  let t18 = t17 * t8;
  let t19 = -0.5900436f * (t8 * t10 + t7 * t12);
  let t20 = sh[0].x * 0.2820948f + sh[12].x * t6 + sh[4].x * t11 + sh[8].x * t13 + (sh[1].x * t14 + sh[5].x * t16 + sh[13].x * t18 + sh[9].x * t19);
  let t21 = 0.48860252f * t4;
  let t22 = 0.9461747f * t5 + -0.31539157f;
  let t23 = 1.4453057f * t4;
  let t24 = t23 * t10;
  let t25 = t23 * t12;
  let t26 = -0.48860252f * t8;
  let t27 = t15 * t8;
  let t28 = t17 * t7;
  let t29 = -0.5900436f * (t8 * t12 - t7 * t10);
  let t30 = sh[2].x * t21 + sh[6].x * t22 + sh[10].x * t24 + sh[14].x * t25 + (sh[3].x * t26 + sh[7].x * t27 + sh[11].x * t28 + sh[15].x * t29);
  let t31 = sh[0].y * 0.2820948f + sh[12].y * t6 + sh[4].y * t11 + sh[8].y * t13 + (sh[1].y * t14 + sh[5].y * t16 + sh[13].y * t18 + sh[9].y * t19);
  let t32 = sh[2].y * t21 + sh[6].y * t22 + sh[10].y * t24 + sh[14].y * t25 + (sh[3].y * t26 + sh[7].y * t27 + sh[11].y * t28 + sh[15].y * t29);
  let t33 = sh[0].z * 0.2820948f + sh[12].z * t6 + sh[4].z * t11 + sh[8].z * t13 + (sh[1].z * t14 + sh[5].z * t16 + sh[13].z * t18 + sh[9].z * t19);
  let t34 = sh[2].z * t21 + sh[6].z * t22 + sh[10].z * t24 + sh[14].z * t25 + (sh[3].z * t26 + sh[7].z * t27 + sh[11].z * t28 + sh[15].z * t29);
  let value = vec3<f32>(max(t20 + t30 + 0.5f, 0.0f),
      max(t31 + t32 + 0.5f, 0.0f),
      max(t33 + t34 + 0.5f, 0.0f));
  return value;
}

// A splat's colour in the direction from the camera, and a loss's derivatives, given those by the colour.
// 196 operations: 62 additions, 123 multiplications, 1 divisions, 1 square roots, 9 comparisons and choices.
fn zonal_splat_with_adjoint_3(sh: array<vec3<f32>, 9>, direction: vec3<f32>, by_value: vec3<f32>,
    value: ptr<function, vec3<f32>>, by_sh: ptr<function, array<vec3<f32>, 9>>,
    by_direction: ptr<function, vec3<f32>>) {
  let t0 = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
  let t1 = 1.0f / sqrt(t0);
  let t2 = direction.y * t1;
  let t3 = direction.x * t1;
  let t4 = t2 * t3;
  let t5 = 0.54627424f * (t4 + t4);
  let t6 = 0.54627424f * (t3 * t3 - t2 * t2);
  let t7 = -0.48860252f * t2;
  let t8 = direction.z * t1;
  let t9 = -1.0925485f * t8;
  let t10 = t9 * t2;
  let t11 = sh[0].x * 0.2820948f + sh[4].x * t5 + sh[8].x * t6 + (sh[1].x * t7 + sh[5].x * t10);
  let t12 = 0.48860252f * t8;
  let t13 = 0.9461747f * (t8 * t8) + -0.31539157f;
  let t14 = -0.48860252f * t3;
  let t15 = t9 * t3;
  let t16 = t11 + (sh[2].x * t12 + sh[6].x * t13 + (sh[3].x * t14 + sh[7].x * t15)) + 0.5f;
  (*value).x = max(t16, 0.0f);
  let t17 = sh[0].y * 0.2820948f + sh[4].y * t5 + sh[8].y * t6 + (sh[1].y * t7 + sh[5].y * t10);
  let t18 = t17 + (sh[2].y * t12 + sh[6].y * t13 + (sh[3].y * t14 + sh[7].y * t15)) + 0.5f;
  (*value).y = max(t18, 0.0f);
  let t19 = sh[0].z * 0.2820948f + sh[4].z * t5 + sh[8].z * t6 + (sh[1].z * t7 + sh[5].z * t10);
  let t20 = t19 + (sh[2].z * t12 + sh[6].z * t13 + (sh[3].z * t14 + sh[7].z * t15)) + 0.5f;
  (*value).z = max(t20, 0.0f);
  let t21 = select(by_value.x, 0.0f, t16 < 0.0f);
  (*by_sh)[0].x = t21 * 0.2820948f;
  let t22 = select(by_value.y, 0.0f, t18 < 0.0f);
  (*by_sh)[0].y = t22 * 0.2820948f;
  let t23 = select(by_value.z, 0.0f, t20 < 0.0f);
  (*by_sh)[0].z = t23 * 0.2820948f;
  (*by_sh)[1].x = t21 * t7;
  (*by_sh)[1].y = t22 * t7;
  (*by_sh)[1].z = t23 * t7;
  (*by_sh)[2].x = t21 * t12;
  (*by_sh)[2].y = t22 * t12;
  (*by_sh)[2].z = t23 * t12;
  (*by_sh)[3].x = t21 * t14;
  (*by_sh)[3].y = t22 * t14;
  (*by_sh)[3].z = t23 * t14;
  (*by_sh)[4].x = t21 * t5;
  (*by_sh)[4].y = t22 * t5;
  (*by_sh)[4].z = t23 * t5;
  (*by_sh)[5].x = t21 * t10;
  (*by_sh)[5].y = t22 * t10;
  (*by_sh)[5].z = t23 * t10;
  (*by_sh)[6].x = t21 * t13;
  (*by_sh)[6].y = t22 * t13;
  (*by_sh)[6].z = t23 * t13;
  (*by_sh)[7].x = t21 * t15;
  (*by_sh)[7].y = t22 * t15;
  (*by_sh)[7].z = t23 * t15;
  (*by_sh)[8].x = t21 * t6;
  (*by_sh)[8].y = t22 * t6;
  (*by_sh)[8].z = t23 * t6;
  let t24 = t21 * sh[7].x + t22 * sh[7].y + t23 * sh[7].z;
  let t25 = -0.48860252f * (t21 * sh[3].x + t22 * sh[3].y + t23 * sh[3].z) + t9 * t24;
  let t26 = 1.0925485f * (t21 * sh[8].x + t22 * sh[8].y + t23 * sh[8].z);
  let t27 = 1.0925485f * (t21 * sh[4].x + t22 * sh[4].y + t23 * sh[4].z);
  let t28 = t25 + (t26 * t3 + t27 * t2);
  let t29 = t21 * sh[5].x + t22 * sh[5].y + t23 * sh[5].z;
  let t30 = -0.48860252f * (t21 * sh[1].x + t22 * sh[1].y + t23 * sh[1].z) + t9 * t29;
  let t31 = t30 + (t27 * t3 - t26 * t2);
  let t32 = 0.48860252f * (t21 * sh[2].x + t22 * sh[2].y + t23 * sh[2].z) + -1.7320508f * t9 * (t21 * sh[6].x + t22 * sh[6].y + t23 * sh[6].z);
  let t33 = t32 + (-1.0925485f * t24 * t3 + -1.0925485f * t29 * t2);
  let t34 = t28 * t3 + t31 * t2 + t33 * t8;
  (*by_direction).x = (t28 - t3 * t34) * t1;
  (*by_direction).y = (t31 - t2 * t34) * t1;
  (*by_direction).z = (t33 - t8 * t34) * t1;
}

// A splat's colour in the direction from the camera, and a loss's derivatives, given those by the colour.
// 345 operations: 114 additions, 220 multiplications, 1 divisions, 1 square roots, 9 comparisons and choices.
fn zonal_splat_with_adjoint_4(sh: array<vec3<f32>, 16>, direction: vec3<f32>, by_value: vec3<f32>,
    value: ptr<function, vec3<f32>>, by_sh: ptr<function, array<vec3<f32>, 16>>,
    by_direction: ptr<function, vec3<f32>>) {
  let t0 = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
  let t1 = 1.0f / sqrt(t0);
  let t2 = direction.z * t1;
  let t3 = t2 * t2;
  let t4 = t2 * (1.8658817f * t3 + -1.119529f);
  let t5 = direction.y * t1;
  let t6 = direction.x * t1;
  let t7 = t5 * t6;
  let t8 = t7 + t7;
  let t9 = 0.54627424f * t8;
  let t10 = t6 * t6 - t5 * t5;
  let t11 = 0.54627424f * t10;
  let t12 = -0.48860252f * t5;
  let t13 = -1.0925485f * t2;
  let t14 = t13 * t5;
  let t15 = -2.285229f * t3 + 0.4570458f;
  let t16 = t15 * t6;
  let t17 = -0.5900436f * (t6 * t8 + t5 * t10);
  let t18 = sh[0].x * 0.2820948f + sh[12].x * t4 + sh[4].x * t9 + sh[8].x * t11 + (sh[1].x * t12 + sh[5].x * t14 + sh[13].x * t16 + sh[9].x * t17);
  let t19 = 0.48860252f * t2;
  let t20 = 0.9461747f * t3 + -0.31539157f;
  let t21 = 1.4453057f * t2;
  let t22 = t21 * t8;
  let t23 = t21 * t10;
  let t24 = -0.48860252f * t6;
  let t25 = t13 * t6;
  let t26 = t15 * t5;
  let t27 = -0.5900436f * (t6 * t10 - t5 * t8);
  let t28 = sh[2].x * t19 + sh[6].x * t20 + sh[10].x * t22 + sh[14].x * t23 + (sh[3].x * t24 + sh[7].x * t25 + sh[11].x * t26 + sh[15].x * t27);
  let t29 = t18 + t28 + 0.5f;
  (*value).x = max(t29, 0.0f);
  let t30 = sh[0].y * 0.2820948f + sh[12].y * t4 + sh[4].y * t9 + sh[8].y * t11 + (sh[1].y * t12 + sh[5].y * t14 + sh[13].y * t16 + sh[9].y * t17);
  let t31 = sh[2].y * t19 + sh[6].y * t20 + sh[10].y * t22 + sh[14].y * t23 + (sh[3].y * t24 + sh[7].y * t25 + sh[11].y * t26 + sh[15].y * t27);
  let t32 = t30 + t31 + 0.5f;
  (*value).y = max(t32, 0.0f);
  let t33 = sh[0].z * 0.2820948f + sh[12].z * t4 + sh[4].z * t9 + sh[8].z * t11 + (sh[1].z * t12 + sh[5].z * t14 + sh[13].z * t16 + sh[9].z * t17);
  let t34 = sh[2].z * t19 + sh[6].z * t20 + sh[10].z * t22 + sh[14].z * t23 + (sh[3].z * t24 + sh[7].z * t25 + sh[11].z * t26 + sh[15].z * t27);
  let t35 = t33 + t34 + 0.5f;
  (*value).z = max(t35, 0.0f);
  let t36 = select(by_value.x, 0.0f, t29 < 0.0f);
  (*by_sh)[0].x = t36 * 0.2820948f;
  let t37 = select(by_value.y, 0.0f, t32 < 0.0f);
  (*by_sh)[0].y = t37 * 0.2820948f;
  let t38 = select(by_value.z, 0.0f, t35 < 0.0f);
  (*by_sh)[0].z = t38 * 0.2820948f;
  (*by_sh)[1].x = t36 * t12;
  (*by_sh)[1].y = t37 * t12;
  (*by_sh)[1].z = t38 * t12;
  (*by_sh)[2].x = t36 * t19;
  (*by_sh)[2].y = t37 * t19;
  (*by_sh)[2].z = t38 * t19;
  (*by_sh)[3].x = t36 * t24;
  (*by_sh)[3].y = t37 * t24;
  (*by_sh)[3].z = t38 * t24;
  (*by_sh)[4].x = t36 * t9;
  (*by_sh)[4].y = t37 * t9;
  (*by_sh)[4].z = t38 * t9;
  (*by_sh)[5].x = t36 * t14;
  (*by_sh)[5].y = t37 * t14;
  (*by_sh)[5].z = t38 * t14;
  (*by_sh)[6].x = t36 * t20;
  (*by_sh)[6].y = t37 * t20;
  (*by_sh)[6].z = t38 * t20;
  (*by_sh)[7].x = t36 * t25;
  (*by_sh)[7].y = t37 * t25;
  (*by_sh)[7].z = t38 * t25;
  (*by_sh)[8].x = t36 * t11;
  (*by_sh)[8].y = t37 * t11;
  (*by_sh)[8].z = t38 * t11;
  (*by_sh)[9].x = t36 * t17;
  (*by_sh)[9].y = t37 * t17;
  (*by_sh)[9].z = t38 * t17;
  (*by_sh)[10].x = t36 * t22;
  (*by_sh)[10].y = t37 * t22;
  (*by_sh)[10].z = t38 * t22;
  (*by_sh)[11].x = t36 * t26;
  (*by_sh)[11].y = t37 * t26;
  (*by_sh)[11].z = t38 * t26;
  (*by_sh)[12].x = t36 * t4;
  (*by_sh)[12].y = t37 * t4;
  (*by_sh)[12].z = t38 * t4;
  (*by_sh)[13].x = t36 * t16;
  (*by_sh)[13].y = t37 * t16;
  (*by_sh)[13].z = t38 * t16;
  (*by_sh)[14].x = t36 * t23;
  (*by_sh)[14].y = t37 * t23;
  (*by_sh)[14].z = t38 * t23;
  (*by_sh)[15].x = t36 * t27;
  (*by_sh)[15].y = t37 * t27;
  (*by_sh)[15].z = t38 * t27;
  let t39 = t36 * sh[7].x + t37 * sh[7].y + t38 * sh[7].z;
  let t40 = -0.48860252f * (t36 * sh[3].x + t37 * sh[3].y + t38 * sh[3].z) + t13 * t39;
  let t41 = t36 * sh[13].x + t37 * sh[13].y + t38 * sh[13].z;
  let t42 = 2.0f * t21;
  let t43 = t36 * sh[14].x + t37 * sh[14].y + t38 * sh[14].z;
  let t44 = 1.0925485f * (t36 * sh[8].x + t37 * sh[8].y + t38 * sh[8].z) + t42 * t43;
  let t45 = t36 * sh[10].x + t37 * sh[10].y + t38 * sh[10].z;
  let t46 = 1.0925485f * (t36 * sh[4].x + t37 * sh[4].y + t38 * sh[4].z) + t42 * t45;
  let t47 = -1.7701309f * (t36 * sh[15].x + t37 * sh[15].y + t38 * sh[15].z);
  let t48 = -1.7701309f * (t36 * sh[9].x + t37 * sh[9].y + t38 * sh[9].z);
  let t49 = t40 + t15 * t41 + (t44 * t6 + t46 * t5) + (t47 * t10 + t48 * t8);
  let t50 = t36 * sh[5].x + t37 * sh[5].y + t38 * sh[5].z;
  let t51 = -0.48860252f * (t36 * sh[1].x + t37 * sh[1].y + t38 * sh[1].z) + t13 * t50;
  let t52 = t36 * sh[11].x + t37 * sh[11].y + t38 * sh[11].z;
  let t53 = t51 + t15 * t52 + (t46 * t6 - t44 * t5) + (t48 * t10 - t47 * t8);
  let t54 = 0.48860252f * (t36 * sh[2].x + t37 * sh[2].y + t38 * sh[2].z) + -1.7320508f * t13 * (t36 * sh[6].x + t37 * sh[6].y + t38 * sh[6].z);
  let t55 = t54 + -2.4494898f * t15 * (t36 * sh[12].x + t37 * sh[12].y + t38 * sh[12].z);
  let t56 = -3.1622777f * t21;
  let t57 = (-1.0925485f * t39 + t56 * t41) * t6 + (-1.0925485f * t50 + t56 * t52) * t5;
  let t58 = t55 + t57 + (1.4453058f * t43 * t10 + 1.4453058f * t45 * t8);
  let t59 = t49 * t6 + t53 * t5 + t58 * t2;
  (*by_direction).x = (t49 - t6 * t59) * t1;
  (*by_direction).y = (t53 - t5 * t59) * t1;
  (*by_direction).z = (t58 - t2 * t59) * t1;
}

// A function turned about z, from x towards y.
// 6 operations: 2 additions, 4 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_rotate_about_z_2(sh: array<f32, 4>, angle: vec2<f32>, result: ptr<function, array<f32, 4>>) {
  (*result)[0] = sh[0];
  (*result)[1] = angle.x * sh[1] + angle.y * sh[3];
  (*result)[2] = sh[2];
  (*result)[3] = angle.x * sh[3] - angle.y * sh[1];
}

// A function turned about z, from x towards y.
// 23 operations: 8 additions, 15 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_rotate_about_z_3(sh: array<f32, 9>, angle: vec2<f32>, result: ptr<function, array<f32, 9>>) {
  (*result)[0] = sh[0];
  (*result)[1] = angle.x * sh[1] + angle.y * sh[3];
  (*result)[2] = sh[2];
  (*result)[3] = angle.x * sh[3] - angle.y * sh[1];
  let t0 = angle.x * angle.x - angle.y * angle.y;
  let t1 = angle.x * angle.y;
  let t2 = t1 + t1;
  (*result)[4] = t0 * sh[4] + t2 * sh[8];
  (*result)[5] = angle.x * sh[5] + angle.y * sh[7];
  (*result)[6] = sh[6];
  (*result)[7] = angle.x * sh[7] - angle.y * sh[5];
  (*result)[8] = t0 * sh[8] - t2 * sh[4];
}

// What rotate takes: cosines and sines of m = 1, 2, ... of three turns. By a quaternion, w first, of any length but 0.
// 45 operations: 10 additions, 18 multiplications, 3 divisions, 2 square roots, 12 comparisons and choices.
fn zonal_prepare_rotation_2(quaternion: array<f32, 4>, turns: ptr<function, array<f32, 6>>) {
  let t0 = quaternion[0] * quaternion[0] + quaternion[3] * quaternion[3];
  let is_1 = 1.1754944e-38f < t0;
  let t2 = select(0.0f, 1.0f / sqrt(select(1.0f, t0, is_1)), is_1);
  let is_3 = 0.0f < t2;
  let t4 = select(1.0f, quaternion[0] * t2, is_3);
  let t5 = quaternion[1] * quaternion[1] + quaternion[2] * quaternion[2];
  let is_6 = 1.1754944e-38f < t5;
  let t7 = select(0.0f, 1.0f / sqrt(select(1.0f, t5, is_6)), is_6);
  let is_8 = 0.0f < t7;
  let t9 = select(1.0f, quaternion[2] * t7, is_8);
  let t10 = t4 * t9;
  let t11 = select(0.0f, quaternion[3] * t2, is_3);
  let t12 = select(0.0f, -(quaternion[1] * t7), is_8);
  let t13 = t11 * t12;
  (*turns)[0] = t10 + t13;
  let t14 = t11 * t9;
  let t15 = t4 * t12;
  (*turns)[1] = t14 - t15;
  let t16 = 1.0f / (t0 + t5);
  (*turns)[2] = (t0 - t5) * t16;
  (*turns)[3] = -(2.0f * (t0 * t2) * (t5 * t7) * t16);
  (*turns)[4] = t10 - t13;
  (*turns)[5] = t14 + t15;
}

// What rotate takes: cosines and sines of m = 1, 2, ... of three turns. By a quaternion, w first, of any length but 0.
// 60 operations: 16 additions, 27 multiplications, 3 divisions, 2 square roots, 12 comparisons and choices.
fn zonal_prepare_rotation_3(quaternion: array<f32, 4>, turns: ptr<function, array<f32, 12>>) {
  let t0 = quaternion[0] * quaternion[0] + quaternion[3] * quaternion[3];
  let is_1 = 1.1754944e-38f < t0;
  let t2 = select(0.0f, 1.0f / sqrt(select(1.0f, t0, is_1)), is_1);
  let is_3 = 0.0f < t2;
  let t4 = select(1.0f, quaternion[0] * t2, is_3);
  let t5 = quaternion[1] * quaternion[1] + quaternion[2] * quaternion[2];
  let is_6 = 1.1754944e-38f < t5;
  let t7 = select(0.0f, 1.0f / sqrt(select(1.0f, t5, is_6)), is_6);
  let is_8 = 0.0f < t7;
  let t9 = select(1.0f, quaternion[2] * t7, is_8);
  let t10 = t4 * t9;
  let t11 = select(0.0f, quaternion[3] * t2, is_3);
  let t12 = select(0.0f, -(quaternion[1] * t7), is_8);
  let t13 = t11 * t12;
  let t14 = t10 + t13;
  (*turns)[0] = t14;
  let t15 = t11 * t9;
  let t16 = t4 * t12;
  let t17 = t15 - t16;
  (*turns)[1] = t17;
  (*turns)[2] = t14 * t14 - t17 * t17;
  let t18 = t14 * t17;
  (*turns)[3] = t18 + t18;
  let t19 = 1.0f / (t0 + t5);
  let t20 = (t0 - t5) * t19;
  (*turns)[4] = t20;
  let t21 = -(2.0f * (t0 * t2) * (t5 * t7) * t19);
  (*turns)[5] = t21;
  (*turns)[6] = t20 * t20 - t21 * t21;
  let t22 = t20 * t21;
  (*turns)[7] = t22 + t22;
  let t23 = t10 - t13;
  (*turns)[8] = t23;
  let t24 = t15 + t16;
  (*turns)[9] = t24;
  (*turns)[10] = t23 * t23 - t24 * t24;
  let t25 = t23 * t24;
  (*turns)[11] = t25 + t25;
}

// A function rotated, as prepare_rotation prepares it.
// 22 operations: 10 additions, 12 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_rotate_2(sh: array<f32, 4>, turns: array<f32, 6>, result: ptr<function, array<f32, 4>>) {
  (*result)[0] = sh[0];
  let t0 = -(-(turns[0] * sh[1] + turns[1] * sh[3]));
  let t1 = turns[0] * sh[3] - turns[1] * sh[1];
  let t2 = -sh[2];
  let t3 = turns[2] * t1 - turns[3] * t2;
  (*result)[1] = turns[4] * t0 + turns[5] * t3;
  (*result)[2] = -(turns[2] * t2 + turns[3] * t1);
  (*result)[3] = turns[4] * t3 - turns[5] * t0;
}

// A function rotated, as prepare_rotation prepares it.
// 74 operations: 26 additions, 48 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_rotate_3(sh: array<f32, 9>, turns: array<f32, 12>, result: ptr<function, array<f32, 9>>) {
  (*result)[0] = sh[0];
  let t0 = -(-(turns[0] * sh[1] + turns[1] * sh[3]));
  let t1 = turns[0] * sh[3] - turns[1] * sh[1];
  let t2 = -sh[2];
  let t3 = turns[4] * t1 - turns[5] * t2;
  (*result)[1] = turns[8] * t0 + turns[9] * t3;
  (*result)[2] = -(turns[4] * t2 + turns[5] * t1);
  (*result)[3] = turns[8] * t3 - turns[9] * t0;
  let t4 = -1.0f * (turns[2] * sh[4] + turns[3] * sh[8]);
  let t5 = turns[0] * sh[5] + turns[1] * sh[7];
  let t6 = -1.0f * (turns[4] * t4 - turns[5] * t5);
  let t7 = turns[2] * sh[8] - turns[3] * sh[4];
  let t8 = -0.5f * sh[6] + -0.8660254f * t7;
  let t9 = -0.8660254f * sh[6] + 0.5f * t7;
  let t10 = -1.0f * (turns[0] * sh[7] - turns[1] * sh[5]);
  let t11 = turns[6] * t9 - turns[7] * t10;
  let t12 = -0.8660254f * t8 + 0.5f * t11;
  (*result)[4] = turns[10] * t6 + turns[11] * t12;
  let t13 = turns[4] * t5 + turns[5] * t4;
  let t14 = -1.0f * (turns[6] * t10 + turns[7] * t9);
  (*result)[5] = turns[8] * t13 + turns[9] * t14;
  (*result)[6] = -0.5f * t8 + -0.8660254f * t11;
  (*result)[7] = turns[8] * t14 - turns[9] * t13;
  (*result)[8] = turns[10] * t12 - turns[11] * t6;
}

// A function rotated, as prepare_rotation prepares it. For colours.
// 66 operations: 30 additions, 36 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_rotate_colour_2(sh: array<vec3<f32>, 4>, turns: array<f32, 6>, result: ptr<function, array<vec3<f32>, 4>>) {
  (*result)[0].x = sh[0].x;
  (*result)[0].y = sh[0].y;
  (*result)[0].z = sh[0].z;
  let t0 = -(-(turns[0] * sh[1].x + turns[1] * sh[3].x));
  let t1 = turns[0] * sh[3].x - turns[1] * sh[1].x;
  let t2 = -sh[2].x;
  let t3 = turns[2] * t1 - turns[3] * t2;
  (*result)[1].x = turns[4] * t0 + turns[5] * t3;
  let t4 = -(-(turns[0] * sh[1].y + turns[1] * sh[3].y));
  let t5 = turns[0] * sh[3].y - turns[1] * sh[1].y;
  let t6 = -sh[2].y;
  let t7 = turns[2] * t5 - turns[3] * t6;
  (*result)[1].y = turns[4] * t4 + turns[5] * t7;
  let t8 = -(-(turns[0] * sh[1].z + turns[1] * sh[3].z));
  let t9 = turns[0] * sh[3].z - turns[1] * sh[1].z;
  let t10 = -sh[2].z;
  let t11 = turns[2] * t9 - turns[3] * t10;
  (*result)[1].z = turns[4] * t8 + turns[5] * t11;
  (*result)[2].x = -(turns[2] * t2 + turns[3] * t1);
  (*result)[2].y = -(turns[2] * t6 + turns[3] * t5);
  (*result)[2].z = -(turns[2] * t10 + turns[3] * t9);
  (*result)[3].x = turns[4] * t3 - turns[5] * t0;
  (*result)[3].y = turns[4] * t7 - turns[5] * t4;
  (*result)[3].z = turns[4] * t11 - turns[5] * t8;
}

// A function rotated, as prepare_rotation prepares it. For colours.
// 222 operations: 78 additions, 144 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_rotate_colour_3(sh: array<vec3<f32>, 9>, turns: array<f32, 12>, result: ptr<function, array<vec3<f32>, 9>>) {
  (*result)[0].x = sh[0].x;
  (*result)[0].y = sh[0].y;
  (*result)[0].z = sh[0].z;
  let t0 = -(-(turns[0] * sh[1].x + turns[1] * sh[3].x));
  let t1 = turns[0] * sh[3].x - turns[1] * sh[1].x;
  let t2 = -sh[2].x;
  let t3 = turns[4] * t1 - turns[5] * t2;
  (*result)[1].x = turns[8] * t0 + turns[9] * t3;
  let t4 = -(-(turns[0] * sh[1].y + turns[1] * sh[3].y));
  let t5 = turns[0] * sh[3].y - turns[1] * sh[1].y;
  let t6 = -sh[2].y;
  let t7 = turns[4] * t5 - turns[5] * t6;
  (*result)[1].y = turns[8] * t4 + turns[9] * t7;
  let t8 = -(-(turns[0] * sh[1].z + turns[1] * sh[3].z));
  let t9 = turns[0] * sh[3].z - turns[1] * sh[1].z;
  let t10 = -sh[2].z;
  let t11 = turns[4] * t9 - turns[5] * t10;
  (*result)[1].z = turns[8] * t8 + turns[9] * t11;
  (*result)[2].x = -(turns[4] * t2 + turns[5] * t1);
  (*result)[2].y = -(turns[4] * t6 + turns[5] * t5);
  (*result)[2].z = -(turns[4] * t10 + turns[5] * t9);
  (*result)[3].x = turns[8] * t3 - turns[9] * t0;
  (*result)[3].y = turns[8] * t7 - turns[9] * t4;
  (*result)[3].z = turns[8] * t11 - turns[9] * t8;
  let t12 = -1.0f * (turns[2] * sh[4].x + turns[3] * sh[8].x);
  let t13 = turns[0] * sh[5].x + turns[1] * sh[7].x;
  let t14 = -1.0f * (turns[4] * t12 - turns[5] * t13);
  let t15 = turns[2] * sh[8].x - turns[3] * sh[4].x;
  let t16 = -0.5f * sh[6].x + -0.8660254f * t15;
  let t17 = -0.8660254f * sh[6].x + 0.5f * t15;
  let t18 = -1.0f * (turns[0] * sh[7].x - turns[1] * sh[5].x);
  let t19 = turns[6] * t17 - turns[7] * t18;
  let t20 = -0.8660254f * t16 + 0.5f * t19;
  (*result)[4].x = turns[10] * t14 + turns[11] * t20;
  let t21 = -1.0f * (turns[2] * sh[4].y + turns[3] * sh[8].y);
  let t22 = turns[0] * sh[5].y + turns[1] * sh[7].y;
  let t23 = -1.0f * (turns[4] * t21 - turns[5] * t22);
  let t24 = turns[2] * sh[8].y - turns[3] * sh[4].y;
  let t25 = -0.5f * sh[6].y + -0.8660254f * t24;
  let t26 = -0.8660254f * sh[6].y + 0.5f * t24;
  let t27 = -1.0f * (turns[0] * sh[7].y - turns[1] * sh[5].y);
  let t28 = turns[6] * t26 - turns[7] * t27;
  let t29 = -0.8660254f * t25 + 0.5f * t28;
  (*result)[4].y = turns[10] * t23 + turns[11] * t29;
  let t30 = -1.0f * (turns[2] * sh[4].z + turns[3] * sh[8].z);
  let t31 = turns[0] * sh[5].z + turns[1] * sh[7].z;
  let t32 = -1.0f * (turns[4] * t30 - turns[5] * t31);
  let t33 = turns[2] * sh[8].z - turns[3] * sh[4].z;
  let t34 = -0.5f * sh[6].z + -0.8660254f * t33;
  let t35 = -0.8660254f * sh[6].z + 0.5f * t33;
  let t36 = -1.0f * (turns[0] * sh[7].z - turns[1] * sh[5].z);
  let t37 = turns[6] * t35 - turns[7] * t36;
  let t38 = -0.8660254f * t34 + 0.5f * t37;
  (*result)[4].z = turns[10] * t32 + turns[11] * t38;
  let t39 = turns[4] * t13 + turns[5] * t12;
  let t40 = -1.0f * (turns[6] * t18 + turns[7] * t17);
  (*result)[5].x = turns[8] * t39 + turns[9] * t40;
  let t41 = turns[4] * t22 + turns[5] * t21;
  let t42 = -1.0f * (turns[6] * t27 + turns[7] * t26);
  (*result)[5].y = turns[8] * t41 + turns[9] * t42;
  let t43 = turns[4] * t31 + turns[5] * t30;
  let t44 = -1.0f * (turns[6] * t36 + turns[7] * t35);
  (*result)[5].z = turns[8] * t43 + turns[9] * t44;
  (*result)[6].x = -0.5f * t16 + -0.8660254f * t19;
  (*result)[6].y = -0.5f * t25 + -0.8660254f * t28;
  (*result)[6].z = -0.5f * t34 + -0.8660254f * t37;
  (*result)[7].x = turns[8] * t40 - turns[9] * t39;
  (*result)[7].y = turns[8] * t42 - turns[9] * t41;
  (*result)[7].z = turns[8] * t44 - turns[9] * t43;
  (*result)[8].x = turns[10] * t20 - turns[11] * t14;
  (*result)[8].y = turns[10] * t29 - turns[11] * t23;
  (*result)[8].z = turns[10] * t38 - turns[11] * t32;
}

// The product of two functions, of which the first bands are kept.
// 22 operations: 6 additions, 16 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_product_2(a: array<f32, 4>, b: array<f32, 4>, result: ptr<function, array<f32, 4>>) {
  let t0 = a[0] * b[0] * 0.2820948f + a[2] * b[2] * 0.2820948f + (a[3] * b[3] + a[1] * b[1]) * 0.2820948f;
  (*result)[0] = t0;
  (*result)[1] = (a[1] * b[0] + a[0] * b[1]) * 0.2820948f;
  (*result)[2] = (a[2] * b[0] + a[0] * b[2]) * 0.2820948f;
  (*result)[3] = (a[3] * b[0] + a[0] * b[3]) * 0.2820948f;
}

// The product of two functions, of which the first bands are kept.
// 181 operations: 71 additions, 110 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_product_3(a: array<f32, 9>, b: array<f32, 9>, result: ptr<function, array<f32, 9>>) {
  let t0 = a[2] * b[2];
  let t1 = a[6] * b[6];
  let t2 = a[3] * b[3];
  let t3 = a[1] * b[1];
  let t4 = t2 + t3;
  let t5 = a[0] * b[0] * 0.2820948f + t0 * 0.2820948f + t1 * 0.2820948f + t4 * 0.2820948f;
  let t6 = a[7] * b[7];
  let t7 = a[5] * b[5];
  let t8 = t6 + t7;
  let t9 = a[8] * b[8] + a[4] * b[4];
  (*result)[0] = t5 + t8 * 0.2820948f + t9 * 0.2820948f;
  let t10 = (a[1] * b[0] + a[0] * b[1]) * 0.2820948f + (a[1] * b[6] + a[6] * b[1]) * -0.12615663f;
  let t11 = t10 + (a[5] * b[2] + a[2] * b[5]) * 0.21850969f + (a[4] * b[3] + a[3] * b[4] - (a[8] * b[1] + a[1] * b[8])) * 0.21850969f;
  (*result)[1] = t11;
  let t12 = (a[2] * b[0] + a[0] * b[2]) * 0.2820948f + (a[6] * b[2] + a[2] * b[6]) * 0.25231326f;
  let t13 = t12 + (a[7] * b[3] + a[3] * b[7] + (a[5] * b[1] + a[1] * b[5])) * 0.21850969f;
  (*result)[2] = t13;
  let t14 = (a[3] * b[0] + a[0] * b[3]) * 0.2820948f + (a[3] * b[6] + a[6] * b[3]) * -0.12615663f;
  let t15 = t14 + (a[7] * b[2] + a[2] * b[7]) * 0.21850969f + (a[8] * b[3] + a[3] * b[8] + (a[4] * b[1] + a[1] * b[4])) * 0.21850969f;
  (*result)[3] = t15;
  let t16 = (a[1] * b[3] + a[3] * b[1]) * 0.21850969f + (a[5] * b[7] + a[7] * b[5]) * 0.15607835f;
  let t17 = t16 + (a[4] * b[0] + a[0] * b[4]) * 0.2820948f + (a[4] * b[6] + a[6] * b[4]) * -0.18022375f;
  (*result)[4] = t17;
  let t18 = (a[1] * b[2] + a[2] * b[1]) * 0.21850969f + (a[5] * b[0] + a[0] * b[5]) * 0.2820948f;
  let t19 = t18 + (a[5] * b[6] + a[6] * b[5]) * 0.090111874f + (a[4] * b[7] + a[7] * b[4] - (a[8] * b[5] + a[5] * b[8])) * 0.15607835f;
  (*result)[5] = t19;
  let t20 = t0 * 0.25231326f + (a[6] * b[0] + a[0] * b[6]) * 0.2820948f + t1 * 0.18022375f;
  (*result)[6] = t20 + t4 * -0.12615663f + t8 * 0.090111874f + t9 * -0.18022375f;
  let t21 = (a[3] * b[2] + a[2] * b[3]) * 0.21850969f + (a[7] * b[0] + a[0] * b[7]) * 0.2820948f;
  let t22 = t21 + (a[7] * b[6] + a[6] * b[7]) * 0.090111874f + (a[8] * b[7] + a[7] * b[8] + (a[4] * b[5] + a[5] * b[4])) * 0.15607835f;
  (*result)[7] = t22;
  let t23 = (t2 - t3) * 0.21850969f + (t6 - t7) * 0.15607835f + (a[8] * b[0] + a[0] * b[8]) * 0.2820948f;
  (*result)[8] = t23 + (a[8] * b[6] + a[6] * b[8]) * -0.18022375f;
}

// The product of two functions, of which the first bands are kept. For colours.
// 66 operations: 18 additions, 48 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_product_colour_2(a: array<vec3<f32>, 4>, b: array<f32, 4>, result: ptr<function, array<vec3<f32>, 4>>) {
  let t0 = a[0].x * b[0] * 0.2820948f + a[2].x * b[2] * 0.2820948f + (a[3].x * b[3] + a[1].x * b[1]) * 0.2820948f;
  (*result)[0].x = t0;
  let t1 = a[0].y * b[0] * 0.2820948f + a[2].y * b[2] * 0.2820948f + (a[3].y * b[3] + a[1].y * b[1]) * 0.2820948f;
  (*result)[0].y = t1;
  let t2 = a[0].z * b[0] * 0.2820948f + a[2].z * b[2] * 0.2820948f + (a[3].z * b[3] + a[1].z * b[1]) * 0.2820948f;
  (*result)[0].z = t2;
  (*result)[1].x = (a[1].x * b[0] + a[0].x * b[1]) * 0.2820948f;
  (*result)[1].y = (a[1].y * b[0] + a[0].y * b[1]) * 0.2820948f;
  (*result)[1].z = (a[1].z * b[0] + a[0].z * b[1]) * 0.2820948f;
  (*result)[2].x = (a[2].x * b[0] + a[0].x * b[2]) * 0.2820948f;
  (*result)[2].y = (a[2].y * b[0] + a[0].y * b[2]) * 0.2820948f;
  (*result)[2].z = (a[2].z * b[0] + a[0].z * b[2]) * 0.2820948f;
  (*result)[3].x = (a[3].x * b[0] + a[0].x * b[3]) * 0.2820948f;
  (*result)[3].y = (a[3].y * b[0] + a[0].y * b[3]) * 0.2820948f;
  (*result)[3].z = (a[3].z * b[0] + a[0].z * b[3]) * 0.2820948f;
}

// The product of two functions, of which the first bands are kept. For colours.
// 543 operations: 213 additions, 330 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_product_colour_3(a: array<vec3<f32>, 9>, b: array<f32, 9>, result: ptr<function, array<vec3<f32>, 9>>) {
  let t0 = a[2].x * b[2];
  let t1 = a[6].x * b[6];
  let t2 = a[3].x * b[3];
  let t3 = a[1].x * b[1];
  let t4 = t2 + t3;
  let t5 = a[0].x * b[0] * 0.2820948f + t0 * 0.2820948f + t1 * 0.2820948f + t4 * 0.2820948f;
  let t6 = a[7].x * b[7];
  let t7 = a[5].x * b[5];
  let t8 = t6 + t7;
  let t9 = a[8].x * b[8] + a[4].x * b[4];
  (*result)[0].x = t5 + t8 * 0.2820948f + t9 * 0.2820948f;
  let t10 = a[2].y * b[2];
  let t11 = a[6].y * b[6];
  let t12 = a[3].y * b[3];
  let t13 = a[1].y * b[1];
  let t14 = t12 + t13;
  let t15 = a[0].y * b[0] * 0.2820948f + t10 * 0.2820948f + t11 * 0.2820948f + t14 * 0.2820948f;
  let t16 = a[7].y * b[7];
  let t17 = a[5].y * b[5];
  let t18 = t16 + t17;
  let t19 = a[8].y * b[8] + a[4].y * b[4];
  (*result)[0].y = t15 + t18 * 0.2820948f + t19 * 0.2820948f;
  let t20 = a[2].z * b[2];
  let t21 = a[6].z * b[6];
  let t22 = a[3].z * b[3];
  let t23 = a[1].z * b[1];
  let t24 = t22 + t23;
  let t25 = a[0].z * b[0] * 0.2820948f + t20 * 0.2820948f + t21 * 0.2820948f + t24 * 0.2820948f;
  let t26 = a[7].z * b[7];
  let t27 = a[5].z * b[5];
  let t28 = t26 + t27;
  let t29 = a[8].z * b[8] + a[4].z * b[4];
  (*result)[0].z = t25 + t28 * 0.2820948f + t29 * 0.2820948f;
  let t30 = (a[1].x * b[0] + a[0].x * b[1]) * 0.2820948f + (a[1].x * b[6] + a[6].x * b[1]) * -0.12615663f;
  let t31 = (a[4].x * b[3] + a[3].x * b[4] - (a[8].x * b[1] + a[1].x * b[8])) * 0.21850969f;
  (*result)[1].x = t30 + (a[5].x * b[2] + a[2].x * b[5]) * 0.21850969f + t31;
  let t32 = (a[1].y * b[0] + a[0].y * b[1]) * 0.2820948f + (a[1].y * b[6] + a[6].y * b[1]) * -0.12615663f;
  let t33 = (a[4].y * b[3] + a[3].y * b[4] - (a[8].y * b[1] + a[1].y * b[8])) * 0.21850969f;
  (*result)[1].y = t32 + (a[5].y * b[2] + a[2].y * b[5]) * 0.21850969f + t33;
  let t34 = (a[1].z * b[0] + a[0].z * b[1]) * 0.2820948f + (a[1].z * b[6] + a[6].z * b[1]) * -0.12615663f;
  let t35 = (a[4].z * b[3] + a[3].z * b[4] - (a[8].z * b[1] + a[1].z * b[8])) * 0.21850969f;
  (*result)[1].z = t34 + (a[5].z * b[2] + a[2].z * b[5]) * 0.21850969f + t35;
  let t36 = (a[2].x * b[0] + a[0].x * b[2]) * 0.2820948f + (a[6].x * b[2] + a[2].x * b[6]) * 0.25231326f;
  let t37 = (a[7].x * b[3] + a[3].x * b[7] + (a[5].x * b[1] + a[1].x * b[5])) * 0.21850969f;
  (*result)[2].x = t36 + t37;
  let t38 = (a[2].y * b[0] + a[0].y * b[2]) * 0.2820948f + (a[6].y * b[2] + a[2].y * b[6]) * 0.25231326f;
  let t39 = (a[7].y * b[3] + a[3].y * b[7] + (a[5].y * b[1] + a[1].y * b[5])) * 0.21850969f;
  (*result)[2].y = t38 + t39;
  let t40 = (a[2].z * b[0] + a[0].z * b[2]) * 0.2820948f + (a[6].z * b[2] + a[2].z * b[6]) * 0.25231326f;
  let t41 = (a[7].z * b[3] + a[3].z * b[7] + (a[5].z * b[1] + a[1].z * b[5])) * 0.21850969f;
  (*result)[2].z = t40 + t41;
  let t42 = (a[3].x * b[0] + a[0].x * b[3]) * 0.2820948f + (a[3].x * b[6] + a[6].x * b[3]) * -0.12615663f;
  let t43 = (a[8].x * b[3] + a[3].x * b[8] + (a[4].x * b[1] + a[1].x * b[4])) * 0.21850969f;
  (*result)[3].x = t42 + (a[7].x * b[2] + a[2].x * b[7]) * 0.21850969f + t43;
  let t44 = (a[3].y * b[0] + a[0].y * b[3]) * 0.2820948f + (a[3].y * b[6] + a[6].y * b[3]) * -0.12615663f;
  let t45 = (a[8].y * b[3] + a[3].y * b[8] + (a[4].y * b[1] + a[1].y * b[4])) * 0.21850969f;
  (*result)[3].y = t44 + (a[7].y * b[2] + a[2].y * b[7]) * 0.21850969f + t45;
  let t46 = (a[3].z * b[0] + a[0].z * b[3]) * 0.2820948f + (a[3].z * b[6] + a[6].z * b[3]) * -0.12615663f;
  let t47 = (a[8].z * b[3] + a[3].z * b[8] + (a[4].z * b[1] + a[1].z * b[4])) * 0.21850969f;
  (*result)[3].z = t46 + (a[7].z * b[2] + a[2].z * b[7]) * 0.21850969f + t47;
  let t48 = (a[1].x * b[3] + a[3].x * b[1]) * 0.21850969f + (a[5].x * b[7] + a[7].x * b[5]) * 0.15607835f;
  let t49 = t48 + (a[4].x * b[0] + a[0].x * b[4]) * 0.2820948f + (a[4].x * b[6] + a[6].x * b[4]) * -0.18022375f;
  (*result)[4].x = t49;
  let t50 = (a[1].y * b[3] + a[3].y * b[1]) * 0.21850969f + (a[5].y * b[7] + a[7].y * b[5]) * 0.15607835f;
  let t51 = t50 + (a[4].y * b[0] + a[0].y * b[4]) * 0.2820948f + (a[4].y * b[6] + a[6].y * b[4]) * -0.18022375f;
  (*result)[4].y = t51;
  let t52 = (a[1].z * b[3] + a[3].z * b[1]) * 0.21850969f + (a[5].z * b[7] + a[7].z * b[5]) * 0.15607835f;
  let t53 = t52 + (a[4].z * b[0] + a[0].z * b[4]) * 0.2820948f + (a[4].z * b[6] + a[6].z * b[4]) * -0.18022375f;
  (*result)[4].z = t53;
  let t54 = (a[1].x * b[2] + a[2].x * b[1]) * 0.21850969f + (a[5].x * b[0] + a[0].x * b[5]) * 0.2820948f;
  let t55 = (a[4].x * b[7] + a[7].x * b[4] - (a[8].x * b[5] + a[5].x * b[8])) * 0.15607835f;
  (*result)[5].x = t54 + (a[5].x * b[6] + a[6].x * b[5]) * 0.090111874f + t55;
  let t56 = (a[1].y * b[2] + a[2].y * b[1]) * 0.21850969f + (a[5].y * b[0] + a[0].y * b[5]) * 0.2820948f;
  let t57 = (a[4].y * b[7] + a[7].y * b[4] - (a[8].y * b[5] + a[5].y * b[8])) * 0.15607835f;
  (*result)[5].y = t56 + (a[5].y * b[6] + a[6].y * b[5]) * 0.090111874f + t57;
  let t58 = (a[1].z * b[2] + a[2].z * b[1]) * 0.21850969f + (a[5].z * b[0] + a[0].z * b[5]) * 0.2820948f;
  let t59 = (a[4].z * b[7] + a[7].z * b[4] - (a[8].z * b[5] + a[5].z * b[8])) * 0.15607835f;
  (*result)[5].z = t58 + (a[5].z * b[6] + a[6].z * b[5]) * 0.090111874f + t59;
  let t60 = t0 * 0.25231326f + (a[6].x * b[0] + a[0].x * b[6]) * 0.2820948f + t1 * 0.18022375f;
  (*result)[6].x = t60 + t4 * -0.12615663f + t8 * 0.090111874f + t9 * -0.18022375f;
  let t61 = t10 * 0.25231326f + (a[6].y * b[0] + a[0].y * b[6]) * 0.2820948f + t11 * 0.18022375f;
  (*result)[6].y = t61 + t14 * -0.12615663f + t18 * 0.090111874f + t19 * -0.18022375f;
  let t62 = t20 * 0.25231326f + (a[6].z * b[0] + a[0].z * b[6]) * 0.2820948f + t21 * 0.18022375f;
  (*result)[6].z = t62 + t24 * -0.12615663f + t28 * 0.090111874f + t29 * -0.18022375f;
  let t63 = (a[3].x * b[2] + a[2].x * b[3]) * 0.21850969f + (a[7].x * b[0] + a[0].x * b[7]) * 0.2820948f;
  let t64 = (a[8].x * b[7] + a[7].x * b[8] + (a[4].x * b[5] + a[5].x * b[4])) * 0.15607835f;
  (*result)[7].x = t63 + (a[7].x * b[6] + a[6].x * b[7]) * 0.090111874f + t64;
  let t65 = (a[3].y * b[2] + a[2].y * b[3]) * 0.21850969f + (a[7].y * b[0] + a[0].y * b[7]) * 0.2820948f;
  let t66 = (a[8].y * b[7] + a[7].y * b[8] + (a[4].y * b[5] + a[5].y * b[4])) * 0.15607835f;
  (*result)[7].y = t65 + (a[7].y * b[6] + a[6].y * b[7]) * 0.090111874f + t66;
  let t67 = (a[3].z * b[2] + a[2].z * b[3]) * 0.21850969f + (a[7].z * b[0] + a[0].z * b[7]) * 0.2820948f;
  let t68 = (a[8].z * b[7] + a[7].z * b[8] + (a[4].z * b[5] + a[5].z * b[4])) * 0.15607835f;
  (*result)[7].z = t67 + (a[7].z * b[6] + a[6].z * b[7]) * 0.090111874f + t68;
  let t69 = (t2 - t3) * 0.21850969f + (t6 - t7) * 0.15607835f + (a[8].x * b[0] + a[0].x * b[8]) * 0.2820948f;
  (*result)[8].x = t69 + (a[8].x * b[6] + a[6].x * b[8]) * -0.18022375f;
  let t70 = (t12 - t13) * 0.21850969f + (t16 - t17) * 0.15607835f + (a[8].y * b[0] + a[0].y * b[8]) * 0.2820948f;
  (*result)[8].y = t70 + (a[8].y * b[6] + a[6].y * b[8]) * -0.18022375f;
  let t71 = (t22 - t23) * 0.21850969f + (t26 - t27) * 0.15607835f + (a[8].z * b[0] + a[0].z * b[8]) * 0.2820948f;
  (*result)[8].z = t71 + (a[8].z * b[6] + a[6].z * b[8]) * -0.18022375f;
}

// The integral of the product of three functions.
// 29 operations: 9 additions, 20 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_triple_product_2(a: array<f32, 4>, b: array<f32, 4>, c: array<f32, 4>) -> f32 {
  let t0 = a[0] * b[0] * 0.2820948f + a[2] * b[2] * 0.2820948f + (a[3] * b[3] + a[1] * b[1]) * 0.2820948f;
  let t1 = (a[2] * b[0] + a[0] * b[2]) * 0.2820948f * c[2] + (a[3] * b[0] + a[0] * b[3]) * 0.2820948f * c[3];
  let value = t0 * c[0] + (a[1] * b[0] + a[0] * b[1]) * 0.2820948f * c[1] + t1;
  return value;
}

// The integral of the product of three functions.
// 198 operations: 79 additions, 119 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_triple_product_3(a: array<f32, 9>, b: array<f32, 9>, c: array<f32, 9>) -> f32 {
  let t0 = a[2] * b[2];
  let t1 = a[6] * b[6];
  let t2 = a[3] * b[3];
  let t3 = a[1] * b[1];
  let t4 = t2 + t3;
  let t5 = a[0] * b[0] * 0.2820948f + t0 * 0.2820948f + t1 * 0.2820948f + t4 * 0.2820948f;
  let t6 = a[7] * b[7];
  let t7 = a[5] * b[5];
  let t8 = t6 + t7;
  let t9 = a[8] * b[8] + a[4] * b[4];
  let t10 = (a[1] * b[3] + a[3] * b[1]) * 0.21850969f + (a[5] * b[7] + a[7] * b[5]) * 0.15607835f;
  let t11 = t10 + (a[4] * b[0] + a[0] * b[4]) * 0.2820948f + (a[4] * b[6] + a[6] * b[4]) * -0.18022375f;
  let t12 = (t2 - t3) * 0.21850969f + (t6 - t7) * 0.15607835f + (a[8] * b[0] + a[0] * b[8]) * 0.2820948f;
  let t13 = (t5 + t8 * 0.2820948f + t9 * 0.2820948f) * c[0] + t11 * c[4] + (t12 + (a[8] * b[6] + a[6] * b[8]) * -0.18022375f) * c[8];
  let t14 = (a[1] * b[0] + a[0] * b[1]) * 0.2820948f + (a[1] * b[6] + a[6] * b[1]) * -0.12615663f;
  let t15 = t14 + (a[5] * b[2] + a[2] * b[5]) * 0.21850969f + (a[4] * b[3] + a[3] * b[4] - (a[8] * b[1] + a[1] * b[8])) * 0.21850969f;
  let t16 = (a[1] * b[2] + a[2] * b[1]) * 0.21850969f + (a[5] * b[0] + a[0] * b[5]) * 0.2820948f;
  let t17 = t16 + (a[5] * b[6] + a[6] * b[5]) * 0.090111874f + (a[4] * b[7] + a[7] * b[4] - (a[8] * b[5] + a[5] * b[8])) * 0.15607835f;
  let t18 = (a[2] * b[0] + a[0] * b[2]) * 0.2820948f + (a[6] * b[2] + a[2] * b[6]) * 0.25231326f;
  let t19 = t18 + (a[7] * b[3] + a[3] * b[7] + (a[5] * b[1] + a[1] * b[5])) * 0.21850969f;
  let t20 = t0 * 0.25231326f + (a[6] * b[0] + a[0] * b[6]) * 0.2820948f + t1 * 0.18022375f;
  let t21 = (t20 + t4 * -0.12615663f + t8 * 0.090111874f + t9 * -0.18022375f) * c[6];
  let t22 = (a[3] * b[0] + a[0] * b[3]) * 0.2820948f + (a[3] * b[6] + a[6] * b[3]) * -0.12615663f;
  let t23 = t22 + (a[7] * b[2] + a[2] * b[7]) * 0.21850969f + (a[8] * b[3] + a[3] * b[8] + (a[4] * b[1] + a[1] * b[4])) * 0.21850969f;
  let t24 = (a[3] * b[2] + a[2] * b[3]) * 0.21850969f + (a[7] * b[0] + a[0] * b[7]) * 0.2820948f;
  let t25 = t24 + (a[7] * b[6] + a[6] * b[7]) * 0.090111874f + (a[8] * b[7] + a[7] * b[8] + (a[4] * b[5] + a[5] * b[4])) * 0.15607835f;
  let t26 = t13 + (t15 * c[1] + t17 * c[5]) + (t19 * c[2] + t21 + (t23 * c[3] + t25 * c[7]));
  let value = t26;
  return value;
}

// Irradiance over pi of one channel of Unity's or Unreal's seven vectors, at a normal.
// 23 operations: 9 additions, 14 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_seven_vectors(a: array<f32, 4>, b: array<f32, 4>, c: f32, normal: vec3<f32>) -> f32 {
  let t0 = b[0] * (normal.x * normal.y) + b[1] * (normal.y * normal.z) + b[2] * (normal.z * normal.z);
  let t1 = a[0] * normal.x + a[1] * normal.y + a[2] * normal.z + a[3] + (t0 + b[3] * (normal.z * normal.x));
  let value = t1 + c * (normal.x * normal.x - normal.y * normal.y);
  return value;
}

// Irradiance over pi of Babylon.js' polynomial, x y z xx yy zz yz zx xy, at a normal. For colours.
// 57 operations: 24 additions, 33 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_nine_polynomials_colour(polynomial: array<vec3<f32>, 9>, normal: vec3<f32>) -> vec3<f32> {
  let t0 = polynomial[0].x * normal.x + polynomial[1].x * normal.y + polynomial[2].x * normal.z;
  let t1 = normal.x * normal.x;
  let t2 = normal.y * normal.y;
  let t3 = normal.z * normal.z;
  let t4 = normal.y * normal.z;
  let t5 = t0 + polynomial[3].x * t1 + polynomial[4].x * t2 + polynomial[5].x * t3 + polynomial[6].x * t4;
  let t6 = normal.z * normal.x;
  let t7 = normal.x * normal.y;
  let t8 = polynomial[0].y * normal.x + polynomial[1].y * normal.y + polynomial[2].y * normal.z;
  let t9 = t8 + polynomial[3].y * t1 + polynomial[4].y * t2 + polynomial[5].y * t3 + polynomial[6].y * t4;
  let t10 = polynomial[0].z * normal.x + polynomial[1].z * normal.y + polynomial[2].z * normal.z;
  let t11 = t10 + polynomial[3].z * t1 + polynomial[4].z * t2 + polynomial[5].z * t3;
  let t12 = t11 + polynomial[6].z * t4 + polynomial[7].z * t6 + polynomial[8].z * t7;
  let value = vec3<f32>(t5 + polynomial[7].x * t6 + polynomial[8].x * t7,
      t9 + polynomial[7].y * t6 + polynomial[8].y * t7,
      t12);
  return value;
}

// The value of plain polynomials, 1 y z x xy yz 3zz-1 xz xx-yy, as Filament's shaders and Unity's nine have it. For colours.
// 57 operations: 26 additions, 31 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_reconstruct_polynomials_colour(polynomials: array<vec3<f32>, 9>, normal: vec3<f32>) -> vec3<f32> {
  let t0 = polynomials[0].x + polynomials[1].x * normal.y + polynomials[2].x * normal.z;
  let t1 = normal.x * normal.y;
  let t2 = normal.y * normal.z;
  let t3 = t0 + polynomials[3].x * normal.x + polynomials[4].x * t1 + polynomials[5].x * t2;
  let t4 = 3.0f * (normal.z * normal.z) - 1.0f;
  let t5 = normal.x * normal.z;
  let t6 = normal.x * normal.x - normal.y * normal.y;
  let t7 = t3 + polynomials[6].x * t4 + polynomials[7].x * t5 + polynomials[8].x * t6;
  let t8 = polynomials[0].y + polynomials[1].y * normal.y + polynomials[2].y * normal.z;
  let t9 = t8 + polynomials[3].y * normal.x + polynomials[4].y * t1 + polynomials[5].y * t2;
  let t10 = t9 + polynomials[6].y * t4 + polynomials[7].y * t5 + polynomials[8].y * t6;
  let t11 = polynomials[0].z + polynomials[1].z * normal.y + polynomials[2].z * normal.z;
  let t12 = t11 + polynomials[3].z * normal.x + polynomials[4].z * t1 + polynomials[5].z * t2;
  let t13 = t12 + polynomials[6].z * t4 + polynomials[7].z * t5 + polynomials[8].z * t6;
  let value = vec3<f32>(t7, t10, t13);
  return value;
}

// Where the light of two bands comes from, a unit vector; z where from nowhere.
// 16 operations: 4 additions, 3 multiplications, 3 divisions, 1 square roots, 5 comparisons and choices.
fn zonal_linear_axis(radiance: array<f32, 4>) -> vec3<f32> {
  let t0 = -radiance[3];
  let t1 = -radiance[1];
  let t2 = t0 * t0 + t1 * t1 + radiance[2] * radiance[2];
  let is_3 = t2 < 1e-30f;
  let t4 = sqrt(max(t2, 1e-30f));
  let axis = vec3<f32>(select(t0 / t4, 0.0f, is_3),
      select(t1 / t4, 0.0f, is_3),
      select(radiance[2] / t4, 1.0f, is_3));
  return axis;
}

// ZH3's quadratic coefficient, guessed from two bands and their axis.
// 13 operations: 5 additions, 5 multiplications, 1 divisions, 0 square roots, 2 comparisons and choices.
fn zonal_hallucinate_zh3(radiance: array<f32, 4>, axis: vec3<f32>) -> f32 {
  let t0 = abs(-radiance[3] * axis.x + -radiance[1] * axis.y + radiance[2] * axis.z);
  let zonal = t0 * (0.08f + 0.6f * (t0 / max(radiance[0], 1e-30f)));
  return zonal;
}

// ZH3's quadratic coefficient, guessed from two bands and their axis. For colours.
// 39 operations: 15 additions, 15 multiplications, 3 divisions, 0 square roots, 6 comparisons and choices.
fn zonal_hallucinate_zh3_colour(radiance: array<vec3<f32>, 4>, axis: vec3<f32>) -> vec3<f32> {
  let t0 = -radiance[3].x * axis.x + -radiance[1].x * axis.y + radiance[2].x * axis.z;
  let t1 = abs(t0);
  let t2 = -radiance[3].y * axis.x + -radiance[1].y * axis.y + radiance[2].y * axis.z;
  let t3 = abs(t2);
  let t4 = -radiance[3].z * axis.x + -radiance[1].z * axis.y + radiance[2].z * axis.z;
  let t5 = abs(t4);
  let zonal = vec3<f32>(t1 * (0.08f + 0.6f * (t1 / max(radiance[0].x, 1e-30f))),
      t3 * (0.08f + 0.6f * (t3 / max(radiance[0].y, 1e-30f))),
      t5 * (0.08f + 0.6f * (t5 / max(radiance[0].z, 1e-30f))));
  return zonal;
}

// Irradiance over pi of ZH3, radiance of two bands and one quadratic about an axis.
// 23 operations: 7 additions, 16 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_irradiance_zh3(radiance: array<f32, 4>, zonal: f32, axis: vec3<f32>, normal: vec3<f32>) -> f32 {
  let t0 = radiance[2] * (0.48860252f * normal.z) + radiance[1] * (-0.48860252f * normal.y);
  let t1 = radiance[0] * 0.2820948f + (t0 + radiance[3] * (-0.48860252f * normal.x)) * 0.6666667f;
  let t2 = axis.x * normal.x + axis.y * normal.y + axis.z * normal.z;
  let value = t1 + 0.25f * (zonal * (0.31539157f * (3.0f * t2 * t2 - 1.0f)));
  return value;
}

// Irradiance over pi of ZH3, radiance of two bands and one quadratic about an axis. For colours.
// 45 operations: 15 additions, 30 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_irradiance_zh3_colour(radiance: array<vec3<f32>, 4>, zonal: vec3<f32>, axis: vec3<f32>, normal: vec3<f32>) -> vec3<f32> {
  let t0 = 0.48860252f * normal.z;
  let t1 = -0.48860252f * normal.y;
  let t2 = -0.48860252f * normal.x;
  let t3 = (radiance[2].x * t0 + radiance[1].x * t1 + radiance[3].x * t2) * 0.6666667f;
  let t4 = axis.x * normal.x + axis.y * normal.y + axis.z * normal.z;
  let t5 = 0.31539157f * (3.0f * t4 * t4 - 1.0f);
  let t6 = (radiance[2].y * t0 + radiance[1].y * t1 + radiance[3].y * t2) * 0.6666667f;
  let t7 = (radiance[2].z * t0 + radiance[1].z * t1 + radiance[3].z * t2) * 0.6666667f;
  let value = vec3<f32>(radiance[0].x * 0.2820948f + t3 + 0.25f * (zonal.x * t5),
      radiance[0].y * 0.2820948f + t6 + 0.25f * (zonal.y * t5),
      radiance[0].z * 0.2820948f + t7 + 0.25f * (zonal.z * t5));
  return value;
}

// Irradiance over pi of radiance of two bands, Geomerics' positive curve.
// 157 operations: 43 additions, 41 multiplications, 7 divisions, 1 square roots, 65 comparisons and choices.
fn zonal_irradiance_nonlinear(radiance: array<f32, 4>, normal: vec3<f32>) -> f32 {
  let t0 = -radiance[3];
  let t1 = -radiance[1];
  let t2 = t0 * t0 + t1 * t1 + radiance[2] * radiance[2];
  let is_3 = t2 < 1e-30f;
  let t4 = sqrt(max(t2, 1e-30f));
  let t5 = min(0.57735026f * select(t4, 0.0f, is_3) / max(radiance[0], 1e-30f), 1.0f);
  let t6 = 1.0f + t5;
  let t7 = (1.0f - t5) / t6;
  let t8 = t6 + t5;
  let t9 = select(t0 / t4, 0.0f, is_3) * normal.x + select(t1 / t4, 0.0f, is_3) * normal.y;
  let t10 = max(0.5f + 0.5f * (t9 + select(radiance[2] / t4, 1.0f, is_3) * normal.z), 0.0f);
  let t11 = max(min(t10, 1.0f), 1.0842022e-19f);
  let is_12 = t11 < 2.3283064e-10f;
  let t13 = select(t11, t11 * 4294967296.0f, is_12);
  let is_14 = t13 < 1.5258789e-05f;
  let t15 = select(t13, t13 * 65536.0f, is_14);
  let is_16 = t15 < 0.00390625f;
  let t17 = select(t15, t15 * 256.0f, is_16);
  let is_18 = t17 < 0.0625f;
  let t19 = select(t17, t17 * 16.0f, is_18);
  let is_20 = t19 < 0.25f;
  let t21 = select(t19, t19 * 4.0f, is_20);
  let is_22 = t21 < 0.5f;
  let t23 = select(t21, t21 * 2.0f, is_22);
  let is_24 = t23 < 0.70710677f;
  let t25 = select(0.0f, -32.0f, is_12);
  let t26 = select(t25, t25 - 16.0f, is_14);
  let t27 = select(t26, t26 - 8.0f, is_16);
  let t28 = select(t27, t27 - 4.0f, is_18);
  let t29 = select(t28, t28 - 2.0f, is_20);
  let t30 = select(t29, t29 - 1.0f, is_22);
  let t31 = select(t23, t23 + t23, is_24);
  let t32 = (t31 - 1.0f) / (t31 + 1.0f);
  let t33 = t32 * t32;
  let t34 = (((0.11111111f * t33 + 0.14285715f) * t33 + 0.2f) * t33 + 0.33333334f) * t33;
  let t35 = select(t30, t30 - 1.0f, is_24) * 0.6931472f + (t32 + t32) * (t34 + 1.0f);
  let t36 = t8 * t35;
  let t37 = min(abs(t36), 105.35837f);
  let is_38 = 64.0f <= t37;
  let is_39 = t36 < 0.0f;
  let t40 = select(t37, t37 - 64.0f, is_38);
  let is_41 = 32.0f <= t40;
  let t42 = select(t40, t40 - 32.0f, is_41);
  let is_43 = 16.0f <= t42;
  let t44 = select(t42, t42 - 16.0f, is_43);
  let is_45 = 8.0f <= t44;
  let t46 = select(t44, t44 - 8.0f, is_45);
  let is_47 = 4.0f <= t46;
  let t48 = select(t46, t46 - 4.0f, is_47);
  let is_49 = 2.0f <= t48;
  let t50 = select(t48, t48 - 2.0f, is_49);
  let is_51 = 1.0f <= t50;
  let t52 = select(t50, t50 - 1.0f, is_51);
  let is_53 = 0.5f <= t52;
  let t54 = select(t52, t52 - 0.5f, is_53);
  let is_55 = 0.25f <= t54;
  let t56 = select(1.0f, 1.2664166e-14f, is_41);
  let t57 = select(t56, t56 * 1.12535176e-07f, is_43);
  let t58 = select(t57, t57 * 0.00033546262f, is_45);
  let t59 = select(t58, t58 * 0.01831564f, is_47);
  let t60 = select(t59, t59 * 0.13533528f, is_49);
  let t61 = select(t60, t60 * 0.36787945f, is_51);
  let t62 = select(t61, t61 * 0.60653067f, is_53);
  let t63 = select(t54, t54 - 0.25f, is_55);
  let t64 = 0.16666667f - t63 * (0.041666668f - t63 * (0.008333334f - t63 * 0.0013888889f));
  let t65 = select(t62, t62 * 0.7788008f, is_55) * (1.0f - t63 * (1.0f - t63 * (0.5f - t63 * t64)));
  let t66 = select(1.0f / t65, t65, is_39);
  let t67 = (1.0f - t7) * (t8 + 1.0f) * select(t66, t66 * select(6.235149e+27f, 1.6038109e-28f, is_39), is_38);
  let value = max(radiance[0], 0.0f) * 0.2820948f * (t7 + t67);
  return value;
}

// Irradiance over pi of radiance of two bands, Geomerics' positive curve. For colours.
// 471 operations: 129 additions, 123 multiplications, 21 divisions, 3 square roots, 195 comparisons and choices.
fn zonal_irradiance_nonlinear_colour(radiance: array<vec3<f32>, 4>, normal: vec3<f32>) -> vec3<f32> {
  let t0 = -radiance[3].x;
  let t1 = -radiance[1].x;
  let t2 = t0 * t0 + t1 * t1 + radiance[2].x * radiance[2].x;
  let is_3 = t2 < 1e-30f;
  let t4 = sqrt(max(t2, 1e-30f));
  let t5 = min(0.57735026f * select(t4, 0.0f, is_3) / max(radiance[0].x, 1e-30f), 1.0f);
  let t6 = 1.0f + t5;
  let t7 = (1.0f - t5) / t6;
  let t8 = t6 + t5;
  let t9 = select(t0 / t4, 0.0f, is_3) * normal.x + select(t1 / t4, 0.0f, is_3) * normal.y;
  let t10 = max(0.5f + 0.5f * (t9 + select(radiance[2].x / t4, 1.0f, is_3) * normal.z), 0.0f);
  let t11 = max(min(t10, 1.0f), 1.0842022e-19f);
  let is_12 = t11 < 2.3283064e-10f;
  let t13 = select(t11, t11 * 4294967296.0f, is_12);
  let is_14 = t13 < 1.5258789e-05f;
  let t15 = select(t13, t13 * 65536.0f, is_14);
  let is_16 = t15 < 0.00390625f;
  let t17 = select(t15, t15 * 256.0f, is_16);
  let is_18 = t17 < 0.0625f;
  let t19 = select(t17, t17 * 16.0f, is_18);
  let is_20 = t19 < 0.25f;
  let t21 = select(t19, t19 * 4.0f, is_20);
  let is_22 = t21 < 0.5f;
  let t23 = select(t21, t21 * 2.0f, is_22);
  let is_24 = t23 < 0.70710677f;
  let t25 = select(0.0f, -32.0f, is_12);
  let t26 = select(t25, t25 - 16.0f, is_14);
  let t27 = select(t26, t26 - 8.0f, is_16);
  let t28 = select(t27, t27 - 4.0f, is_18);
  let t29 = select(t28, t28 - 2.0f, is_20);
  let t30 = select(t29, t29 - 1.0f, is_22);
  let t31 = select(t23, t23 + t23, is_24);
  let t32 = (t31 - 1.0f) / (t31 + 1.0f);
  let t33 = t32 * t32;
  let t34 = (((0.11111111f * t33 + 0.14285715f) * t33 + 0.2f) * t33 + 0.33333334f) * t33;
  let t35 = select(t30, t30 - 1.0f, is_24) * 0.6931472f + (t32 + t32) * (t34 + 1.0f);
  let t36 = t8 * t35;
  let t37 = min(abs(t36), 105.35837f);
  let is_38 = 64.0f <= t37;
  let is_39 = t36 < 0.0f;
  let t40 = select(t37, t37 - 64.0f, is_38);
  let is_41 = 32.0f <= t40;
  let t42 = select(t40, t40 - 32.0f, is_41);
  let is_43 = 16.0f <= t42;
  let t44 = select(t42, t42 - 16.0f, is_43);
  let is_45 = 8.0f <= t44;
  let t46 = select(t44, t44 - 8.0f, is_45);
  let is_47 = 4.0f <= t46;
  let t48 = select(t46, t46 - 4.0f, is_47);
  let is_49 = 2.0f <= t48;
  let t50 = select(t48, t48 - 2.0f, is_49);
  let is_51 = 1.0f <= t50;
  let t52 = select(t50, t50 - 1.0f, is_51);
  let is_53 = 0.5f <= t52;
  let t54 = select(t52, t52 - 0.5f, is_53);
  let is_55 = 0.25f <= t54;
  let t56 = select(1.0f, 1.2664166e-14f, is_41);
  let t57 = select(t56, t56 * 1.12535176e-07f, is_43);
  let t58 = select(t57, t57 * 0.00033546262f, is_45);
  let t59 = select(t58, t58 * 0.01831564f, is_47);
  let t60 = select(t59, t59 * 0.13533528f, is_49);
  let t61 = select(t60, t60 * 0.36787945f, is_51);
  let t62 = select(t61, t61 * 0.60653067f, is_53);
  let t63 = select(t54, t54 - 0.25f, is_55);
  let t64 = 0.16666667f - t63 * (0.041666668f - t63 * (0.008333334f - t63 * 0.0013888889f));
  let t65 = select(t62, t62 * 0.7788008f, is_55) * (1.0f - t63 * (1.0f - t63 * (0.5f - t63 * t64)));
  let t66 = select(1.0f / t65, t65, is_39);
  let t67 = (1.0f - t7) * (t8 + 1.0f) * select(t66, t66 * select(6.235149e+27f, 1.6038109e-28f, is_39), is_38);
  let t68 = -radiance[3].y;
  let t69 = -radiance[1].y;
  let t70 = t68 * t68 + t69 * t69 + radiance[2].y * radiance[2].y;
  let is_71 = t70 < 1e-30f;
  let t72 = sqrt(max(t70, 1e-30f));
  let t73 = min(0.57735026f * select(t72, 0.0f, is_71) / max(radiance[0].y, 1e-30f), 1.0f);
  let t74 = 1.0f + t73;
  let t75 = (1.0f - t73) / t74;
  let t76 = t74 + t73;
  let t77 = select(t68 / t72, 0.0f, is_71) * normal.x + select(t69 / t72, 0.0f, is_71) * normal.y;
  let t78 = 0.5f + 0.5f * (t77 + select(radiance[2].y / t72, 1.0f, is_71) * normal.z);
  let t79 = max(min(max(t78, 0.0f), 1.0f), 1.0842022e-19f);
  let is_80 = t79 < 2.3283064e-10f;
  let t81 = select(t79, t79 * 4294967296.0f, is_80);
  let is_82 = t81 < 1.5258789e-05f;
  let t83 = select(t81, t81 * 65536.0f, is_82);
  let is_84 = t83 < 0.00390625f;
  let t85 = select(t83, t83 * 256.0f, is_84);
  let is_86 = t85 < 0.0625f;
  let t87 = select(t85, t85 * 16.0f, is_86);
  let is_88 = t87 < 0.25f;
  let t89 = select(t87, t87 * 4.0f, is_88);
  let is_90 = t89 < 0.5f;
  let t91 = select(t89, t89 * 2.0f, is_90);
  let is_92 = t91 < 0.70710677f;
  let t93 = select(0.0f, -32.0f, is_80);
  let t94 = select(t93, t93 - 16.0f, is_82);
  let t95 = select(t94, t94 - 8.0f, is_84);
  let t96 = select(t95, t95 - 4.0f, is_86);
  let t97 = select(t96, t96 - 2.0f, is_88);
  let t98 = select(t97, t97 - 1.0f, is_90);
  let t99 = select(t91, t91 + t91, is_92);
  let t100 = (t99 - 1.0f) / (t99 + 1.0f);
  let t101 = t100 * t100;
  let t102 = (((0.11111111f * t101 + 0.14285715f) * t101 + 0.2f) * t101 + 0.33333334f) * t101;
  let t103 = select(t98, t98 - 1.0f, is_92) * 0.6931472f + (t100 + t100) * (t102 + 1.0f);
  let t104 = t76 * t103;
  let t105 = min(abs(t104), 105.35837f);
  let is_106 = 64.0f <= t105;
  let is_107 = t104 < 0.0f;
  let t108 = select(t105, t105 - 64.0f, is_106);
  let is_109 = 32.0f <= t108;
  let t110 = select(t108, t108 - 32.0f, is_109);
  let is_111 = 16.0f <= t110;
  let t112 = select(t110, t110 - 16.0f, is_111);
  let is_113 = 8.0f <= t112;
  let t114 = select(t112, t112 - 8.0f, is_113);
  let is_115 = 4.0f <= t114;
  let t116 = select(t114, t114 - 4.0f, is_115);
  let is_117 = 2.0f <= t116;
  let t118 = select(t116, t116 - 2.0f, is_117);
  let is_119 = 1.0f <= t118;
  let t120 = select(t118, t118 - 1.0f, is_119);
  let is_121 = 0.5f <= t120;
  let t122 = select(t120, t120 - 0.5f, is_121);
  let is_123 = 0.25f <= t122;
  let t124 = select(1.0f, 1.2664166e-14f, is_109);
  let t125 = select(t124, t124 * 1.12535176e-07f, is_111);
  let t126 = select(t125, t125 * 0.00033546262f, is_113);
  let t127 = select(t126, t126 * 0.01831564f, is_115);
  let t128 = select(t127, t127 * 0.13533528f, is_117);
  let t129 = select(t128, t128 * 0.36787945f, is_119);
  let t130 = select(t129, t129 * 0.60653067f, is_121);
  let t131 = select(t122, t122 - 0.25f, is_123);
  let t132 = 0.16666667f - t131 * (0.041666668f - t131 * (0.008333334f - t131 * 0.0013888889f));
  let t133 = select(t130, t130 * 0.7788008f, is_123) * (1.0f - t131 * (1.0f - t131 * (0.5f - t131 * t132)));
  let t134 = select(1.0f / t133, t133, is_107);
  let t135 = select(t134, t134 * select(6.235149e+27f, 1.6038109e-28f, is_107), is_106);
  let t136 = max(radiance[0].y, 0.0f) * 0.2820948f * (t75 + (1.0f - t75) * (t76 + 1.0f) * t135);
  let t137 = -radiance[3].z;
  let t138 = -radiance[1].z;
  let t139 = t137 * t137 + t138 * t138 + radiance[2].z * radiance[2].z;
  let is_140 = t139 < 1e-30f;
  let t141 = sqrt(max(t139, 1e-30f));
  let t142 = min(0.57735026f * select(t141, 0.0f, is_140) / max(radiance[0].z, 1e-30f), 1.0f);
  let t143 = 1.0f + t142;
  let t144 = (1.0f - t142) / t143;
  let t145 = t143 + t142;
  let t146 = select(t137 / t141, 0.0f, is_140) * normal.x + select(t138 / t141, 0.0f, is_140) * normal.y;
  let t147 = 0.5f + 0.5f * (t146 + select(radiance[2].z / t141, 1.0f, is_140) * normal.z);
  let t148 = max(min(max(t147, 0.0f), 1.0f), 1.0842022e-19f);
  let is_149 = t148 < 2.3283064e-10f;
  let t150 = select(t148, t148 * 4294967296.0f, is_149);
  let is_151 = t150 < 1.5258789e-05f;
  let t152 = select(t150, t150 * 65536.0f, is_151);
  let is_153 = t152 < 0.00390625f;
  let t154 = select(t152, t152 * 256.0f, is_153);
  let is_155 = t154 < 0.0625f;
  let t156 = select(t154, t154 * 16.0f, is_155);
  let is_157 = t156 < 0.25f;
  let t158 = select(t156, t156 * 4.0f, is_157);
  let is_159 = t158 < 0.5f;
  let t160 = select(t158, t158 * 2.0f, is_159);
  let is_161 = t160 < 0.70710677f;
  let t162 = select(0.0f, -32.0f, is_149);
  let t163 = select(t162, t162 - 16.0f, is_151);
  let t164 = select(t163, t163 - 8.0f, is_153);
  let t165 = select(t164, t164 - 4.0f, is_155);
  let t166 = select(t165, t165 - 2.0f, is_157);
  let t167 = select(t166, t166 - 1.0f, is_159);
  let t168 = select(t160, t160 + t160, is_161);
  let t169 = (t168 - 1.0f) / (t168 + 1.0f);
  let t170 = t169 * t169;
  let t171 = (((0.11111111f * t170 + 0.14285715f) * t170 + 0.2f) * t170 + 0.33333334f) * t170;
  let t172 = select(t167, t167 - 1.0f, is_161) * 0.6931472f + (t169 + t169) * (t171 + 1.0f);
  let t173 = t145 * t172;
  let t174 = min(abs(t173), 105.35837f);
  let is_175 = 64.0f <= t174;
  let is_176 = t173 < 0.0f;
  let t177 = select(t174, t174 - 64.0f, is_175);
  let is_178 = 32.0f <= t177;
  let t179 = select(t177, t177 - 32.0f, is_178);
  let is_180 = 16.0f <= t179;
  let t181 = select(t179, t179 - 16.0f, is_180);
  let is_182 = 8.0f <= t181;
  let t183 = select(t181, t181 - 8.0f, is_182);
  let is_184 = 4.0f <= t183;
  let t185 = select(t183, t183 - 4.0f, is_184);
  let is_186 = 2.0f <= t185;
  let t187 = select(t185, t185 - 2.0f, is_186);
  let is_188 = 1.0f <= t187;
  let t189 = select(t187, t187 - 1.0f, is_188);
  let is_190 = 0.5f <= t189;
  let t191 = select(t189, t189 - 0.5f, is_190);
  let is_192 = 0.25f <= t191;
  let t193 = select(1.0f, 1.2664166e-14f, is_178);
  let t194 = select(t193, t193 * 1.12535176e-07f, is_180);
  let t195 = select(t194, t194 * 0.00033546262f, is_182);
  let t196 = select(t195, t195 * 0.01831564f, is_184);
  let t197 = select(t196, t196 * 0.13533528f, is_186);
  let t198 = select(t197, t197 * 0.36787945f, is_188);
  let t199 = select(t198, t198 * 0.60653067f, is_190);
  let t200 = select(t191, t191 - 0.25f, is_192);
  let t201 = 0.16666667f - t200 * (0.041666668f - t200 * (0.008333334f - t200 * 0.0013888889f));
  let t202 = select(t199, t199 * 0.7788008f, is_192) * (1.0f - t200 * (1.0f - t200 * (0.5f - t200 * t201)));
  let t203 = select(1.0f / t202, t202, is_176);
  let t204 = select(t203, t203 * select(6.235149e+27f, 1.6038109e-28f, is_176), is_175);
  let t205 = max(radiance[0].z, 0.0f) * 0.2820948f * (t144 + (1.0f - t144) * (t145 + 1.0f) * t204);
  let value = vec3<f32>(max(radiance[0].x, 0.0f) * 0.2820948f * (t7 + t67), t136, t205);
  return value;
}

// Irradiance over pi, RGB, of luminance on two bands with Co and Cg.
// 24 operations: 7 additions, 11 multiplications, 1 divisions, 0 square roots, 5 comparisons and choices.
fn zonal_irradiance_six_floats(luminance: array<f32, 4>, co: f32, cg: f32, normal: vec3<f32>) -> vec3<f32> {
  let t0 = luminance[2] * (0.48860252f * normal.z) + luminance[1] * (-0.48860252f * normal.y);
  let t1 = luminance[0] * 0.2820948f + (t0 + luminance[3] * (-0.48860252f * normal.x)) * 0.6666667f;
  let t2 = max(t1, 0.0f);
  let t3 = 0.5f * (t2 / max(luminance[0], 1e-30f));
  let t4 = t3 * cg;
  let t5 = t2 - t4;
  let t6 = t3 * co;
  let colour = vec3<f32>(max(t5 + t6, 0.0f), max(t2 + t4, 0.0f), max(t5 - t6, 0.0f));
  return colour;
}

// The same by Geomerics' positive curve.
// 168 operations: 47 additions, 44 multiplications, 8 divisions, 1 square roots, 68 comparisons and choices.
fn zonal_irradiance_six_floats_nonlinear(luminance: array<f32, 4>, co: f32, cg: f32, normal: vec3<f32>) -> vec3<f32> {
  let t0 = -luminance[3];
  let t1 = -luminance[1];
  let t2 = t0 * t0 + t1 * t1 + luminance[2] * luminance[2];
  let is_3 = t2 < 1e-30f;
  let t4 = sqrt(max(t2, 1e-30f));
  let t5 = max(luminance[0], 1e-30f);
  let t6 = min(0.57735026f * select(t4, 0.0f, is_3) / t5, 1.0f);
  let t7 = 1.0f + t6;
  let t8 = (1.0f - t6) / t7;
  let t9 = t7 + t6;
  let t10 = select(t0 / t4, 0.0f, is_3) * normal.x + select(t1 / t4, 0.0f, is_3) * normal.y;
  let t11 = max(0.5f + 0.5f * (t10 + select(luminance[2] / t4, 1.0f, is_3) * normal.z), 0.0f);
  let t12 = max(min(t11, 1.0f), 1.0842022e-19f);
  let is_13 = t12 < 2.3283064e-10f;
  let t14 = select(t12, t12 * 4294967296.0f, is_13);
  let is_15 = t14 < 1.5258789e-05f;
  let t16 = select(t14, t14 * 65536.0f, is_15);
  let is_17 = t16 < 0.00390625f;
  let t18 = select(t16, t16 * 256.0f, is_17);
  let is_19 = t18 < 0.0625f;
  let t20 = select(t18, t18 * 16.0f, is_19);
  let is_21 = t20 < 0.25f;
  let t22 = select(t20, t20 * 4.0f, is_21);
  let is_23 = t22 < 0.5f;
  let t24 = select(t22, t22 * 2.0f, is_23);
  let is_25 = t24 < 0.70710677f;
  let t26 = select(0.0f, -32.0f, is_13);
  let t27 = select(t26, t26 - 16.0f, is_15);
  let t28 = select(t27, t27 - 8.0f, is_17);
  let t29 = select(t28, t28 - 4.0f, is_19);
  let t30 = select(t29, t29 - 2.0f, is_21);
  let t31 = select(t30, t30 - 1.0f, is_23);
  let t32 = select(t24, t24 + t24, is_25);
  let t33 = (t32 - 1.0f) / (t32 + 1.0f);
  let t34 = t33 * t33;
  let t35 = (((0.11111111f * t34 + 0.14285715f) * t34 + 0.2f) * t34 + 0.33333334f) * t34;
  let t36 = select(t31, t31 - 1.0f, is_25) * 0.6931472f + (t33 + t33) * (t35 + 1.0f);
  let t37 = t9 * t36;
  let t38 = min(abs(t37), 105.35837f);
  let is_39 = 64.0f <= t38;
  let is_40 = t37 < 0.0f;
  let t41 = select(t38, t38 - 64.0f, is_39);
  let is_42 = 32.0f <= t41;
  let t43 = select(t41, t41 - 32.0f, is_42);
  let is_44 = 16.0f <= t43;
  let t45 = select(t43, t43 - 16.0f, is_44);
  let is_46 = 8.0f <= t45;
  let t47 = select(t45, t45 - 8.0f, is_46);
  let is_48 = 4.0f <= t47;
  let t49 = select(t47, t47 - 4.0f, is_48);
  let is_50 = 2.0f <= t49;
  let t51 = select(t49, t49 - 2.0f, is_50);
  let is_52 = 1.0f <= t51;
  let t53 = select(t51, t51 - 1.0f, is_52);
  let is_54 = 0.5f <= t53;
  let t55 = select(t53, t53 - 0.5f, is_54);
  let is_56 = 0.25f <= t55;
  let t57 = select(1.0f, 1.2664166e-14f, is_42);
  let t58 = select(t57, t57 * 1.12535176e-07f, is_44);
  let t59 = select(t58, t58 * 0.00033546262f, is_46);
  let t60 = select(t59, t59 * 0.01831564f, is_48);
  let t61 = select(t60, t60 * 0.13533528f, is_50);
  let t62 = select(t61, t61 * 0.36787945f, is_52);
  let t63 = select(t62, t62 * 0.60653067f, is_54);
  let t64 = select(t55, t55 - 0.25f, is_56);
  let t65 = 0.16666667f - t64 * (0.041666668f - t64 * (0.008333334f - t64 * 0.0013888889f));
  let t66 = select(t63, t63 * 0.7788008f, is_56) * (1.0f - t64 * (1.0f - t64 * (0.5f - t64 * t65)));
  let t67 = select(1.0f / t66, t66, is_40);
  let t68 = (1.0f - t8) * (t9 + 1.0f) * select(t67, t67 * select(6.235149e+27f, 1.6038109e-28f, is_40), is_39);
  let t69 = max(luminance[0], 0.0f) * 0.2820948f * (t8 + t68);
  let t70 = 0.5f * (t69 / t5);
  let t71 = t70 * cg;
  let t72 = t69 - t71;
  let t73 = t70 * co;
  let colour = vec3<f32>(max(t72 + t73, 0.0f), max(t69 + t71, 0.0f), max(t72 - t73, 0.0f));
  return colour;
}

// Irradiance over pi of radiance that stands as whole numbers -127 to 127 times one scale.
// 12 operations: 3 additions, 9 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_irradiance_bytes_2(scale: f32, stored: array<f32, 4>, normal: vec3<f32>) -> f32 {
  let t0 = stored[2] * (0.48860252f * normal.z) + stored[1] * (-0.48860252f * normal.y);
  let t1 = stored[0] * 0.2820948f + 0.6666667f * (t0 + stored[3] * (-0.48860252f * normal.x));
  let value = scale * t1;
  return value;
}

// Irradiance over pi of radiance that stands as whole numbers -127 to 127 times one scale.
// 36 operations: 11 additions, 25 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
fn zonal_irradiance_bytes_3(scale: f32, stored: array<f32, 9>, normal: vec3<f32>) -> f32 {
  let t0 = stored[2] * (0.48860252f * normal.z) + stored[1] * (-0.48860252f * normal.y);
  let t1 = stored[0] * 0.2820948f + 0.6666667f * (t0 + stored[3] * (-0.48860252f * normal.x));
  let t2 = -1.0925485f * normal.z;
  let t3 = stored[6] * (0.9461747f * (normal.z * normal.z) + -0.31539157f) + stored[5] * (t2 * normal.y);
  let t4 = normal.y * normal.x;
  let t5 = t3 + stored[7] * (t2 * normal.x) + stored[4] * (0.54627424f * (t4 + t4));
  let t6 = t5 + stored[8] * (0.54627424f * (normal.x * normal.x - normal.y * normal.y));
  let value = scale * (t1 + 0.25f * t6);
  return value;
}
