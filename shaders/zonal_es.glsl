// zonal 0.2.0, GLSL ES 3.00. --bands 5 --functions evaluate@2,evaluate@3,evaluate@4,evaluate@5,evaluate_with_gradient@2,evaluate_with_gradient@3,evaluate_with_gradient@4,evaluate_with_gradient@5,reconstruct@2,reconstruct@3,reconstruct@4,reconstruct@5,reconstruct_colour@2,reconstruct_colour@3,reconstruct_colour@4,reconstruct_colour@5,reconstruct_lambert@2,reconstruct_lambert@3,reconstruct_lambert@4,reconstruct_lambert@5,reconstruct_lambert_colour@2,reconstruct_lambert_colour@3,reconstruct_lambert_colour@4,reconstruct_lambert_colour@5,orient@2,orient@3,orient@4,orient@5,orient_colour@2,orient_colour@3,orient_colour@4,orient_colour@5,dot@2,dot@3,dot@4,dot@5,dot_colour@2,dot_colour@3,dot_colour@4,dot_colour@5,dot_colours@2,dot_colours@3,dot_colours@4,dot_colours@5,convolve@2,convolve@3,convolve@4,convolve@5,convolve_colour@2,convolve_colour@3,convolve_colour@4,convolve_colour@5,lambert@2,lambert@3,lambert@4,lambert@5,cap@2,cap@3,cap@4,cap@5,cap_up_to_hemisphere@2,cap_up_to_hemisphere@3,cap_up_to_hemisphere@4,cap_up_to_hemisphere@5,sphere_cap@2,sphere_cap@3,sphere_cap@4,sphere_cap@5,phong@2,phong@3,phong@4,phong@5,spherical_gaussian@2,spherical_gaussian@3,spherical_gaussian@4,spherical_gaussian@5,project_sphere@2,project_sphere@3,project_sphere@4,project_sphere@5,reconstruct_with_adjoint@3,reconstruct_with_adjoint@4,splat_colour@3,splat_colour@4,splat_with_adjoint@3,splat_with_adjoint@4,rotate_about_z@2,rotate_about_z@3,prepare_rotation@2,prepare_rotation@3,rotate@2,rotate@3,rotate_colour@2,rotate_colour@3,product@2,product@3,product_colour@2,product_colour@3,triple_product@2,triple_product@3,reconstruct_seven_vectors,reconstruct_nine_polynomials_colour,reconstruct_polynomials_colour,linear_axis,hallucinate_zh3,hallucinate_zh3_colour,irradiance_zh3,irradiance_zh3_colour,irradiance_nonlinear,irradiance_nonlinear_colour,irradiance_six_floats,irradiance_six_floats_nonlinear,irradiance_bytes@2,irradiance_bytes@3
// 114 functions, 8708 operations. Written by zonal-glsl: do not edit.

#ifndef ZONAL_EVALUATE_2
#define ZONAL_EVALUATE_2
// Y_l^m at a unit vector, at l (l + 1) + m.
// 3 operations: 0 additions, 3 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_evaluate_2(highp vec3 direction, out highp float y[4]) {
  y[0] = 0.2820948f;
  y[1] = -0.48860252f * direction.y;
  y[2] = 0.48860252f * direction.z;
  y[3] = -0.48860252f * direction.x;
}
#endif

#ifndef ZONAL_EVALUATE_3
#define ZONAL_EVALUATE_3
// Y_l^m at a unit vector, at l (l + 1) + m.
// 16 operations: 3 additions, 13 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_evaluate_3(highp vec3 direction, out highp float y[9]) {
  y[0] = 0.2820948f;
  y[1] = -0.48860252f * direction.y;
  y[2] = 0.48860252f * direction.z;
  y[3] = -0.48860252f * direction.x;
  highp float t0 = direction.y * direction.x;
  y[4] = 0.54627424f * (t0 + t0);
  highp float t1 = -1.0925485f * direction.z;
  y[5] = t1 * direction.y;
  y[6] = 0.9461747f * (direction.z * direction.z) + -0.31539157f;
  y[7] = t1 * direction.x;
  y[8] = 0.54627424f * (direction.x * direction.x - direction.y * direction.y);
}
#endif

#ifndef ZONAL_EVALUATE_4
#define ZONAL_EVALUATE_4
// Y_l^m at a unit vector, at l (l + 1) + m.
// 34 operations: 7 additions, 27 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_evaluate_4(highp vec3 direction, out highp float y[16]) {
  y[0] = 0.2820948f;
  y[1] = -0.48860252f * direction.y;
  y[2] = 0.48860252f * direction.z;
  y[3] = -0.48860252f * direction.x;
  highp float t0 = direction.y * direction.x;
  highp float t1 = t0 + t0;
  y[4] = 0.54627424f * t1;
  highp float t2 = -1.0925485f * direction.z;
  y[5] = t2 * direction.y;
  highp float t3 = direction.z * direction.z;
  y[6] = 0.9461747f * t3 + -0.31539157f;
  y[7] = t2 * direction.x;
  highp float t4 = direction.x * direction.x - direction.y * direction.y;
  y[8] = 0.54627424f * t4;
  y[9] = -0.5900436f * (direction.x * t1 + direction.y * t4);
  highp float t5 = 1.4453057f * direction.z;
  y[10] = t5 * t1;
  highp float t6 = -2.285229f * t3 + 0.4570458f;
  y[11] = t6 * direction.y;
  y[12] = direction.z * (1.8658817f * t3 + -1.119529f);
  y[13] = t6 * direction.x;
  y[14] = t5 * t4;
  y[15] = -0.5900436f * (direction.x * t4 - direction.y * t1);
}
#endif

#ifndef ZONAL_EVALUATE_5
#define ZONAL_EVALUATE_5
// Y_l^m at a unit vector, at l (l + 1) + m.
// 58 operations: 12 additions, 46 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_evaluate_5(highp vec3 direction, out highp float y[25]) {
  y[0] = 0.2820948f;
  y[1] = -0.48860252f * direction.y;
  y[2] = 0.48860252f * direction.z;
  y[3] = -0.48860252f * direction.x;
  highp float t0 = direction.y * direction.x;
  highp float t1 = t0 + t0;
  y[4] = 0.54627424f * t1;
  highp float t2 = -1.0925485f * direction.z;
  y[5] = t2 * direction.y;
  highp float t3 = direction.z * direction.z;
  highp float t4 = 0.9461747f * t3 + -0.31539157f;
  y[6] = t4;
  y[7] = t2 * direction.x;
  highp float t5 = direction.x * direction.x - direction.y * direction.y;
  y[8] = 0.54627424f * t5;
  highp float t6 = direction.x * t1 + direction.y * t5;
  y[9] = -0.5900436f * t6;
  highp float t7 = 1.4453057f * direction.z;
  y[10] = t7 * t1;
  highp float t8 = -2.285229f * t3 + 0.4570458f;
  y[11] = t8 * direction.y;
  highp float t9 = direction.z * (1.8658817f * t3 + -1.119529f);
  y[12] = t9;
  y[13] = t8 * direction.x;
  y[14] = t7 * t5;
  highp float t10 = direction.x * t5 - direction.y * t1;
  y[15] = -0.5900436f * t10;
  y[16] = 0.6258357f * (direction.x * t6 + direction.y * t10);
  highp float t11 = -1.7701308f * direction.z;
  y[17] = t11 * t6;
  highp float t12 = 3.3116114f * t3 + -0.47308734f;
  y[18] = t12 * t1;
  highp float t13 = direction.z * (-4.683326f * t3 + 2.0071397f);
  y[19] = t13 * direction.y;
  y[20] = 1.9843135f * direction.z * t9 - 1.0062306f * t4;
  y[21] = t13 * direction.x;
  y[22] = t12 * t5;
  y[23] = t11 * t10;
  y[24] = 0.6258357f * (direction.x * t10 - direction.y * t6);
}
#endif

#ifndef ZONAL_EVALUATE_WITH_GRADIENT_2
#define ZONAL_EVALUATE_WITH_GRADIENT_2
// Y_l^m and the gradient of Y_l^m(v / |v|) at a unit vector.
// 21 operations: 9 additions, 12 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_evaluate_with_gradient_2(highp vec3 direction, out highp float y[4], out highp vec3 gradient[4]) {
  y[0] = 0.2820948f;
  highp float t0 = -0.48860252f * direction.y;
  y[1] = t0;
  highp float t1 = 0.48860252f * direction.z;
  y[2] = t1;
  highp float t2 = -0.48860252f * direction.x;
  y[3] = t2;
  gradient[0].x = 0.0f;
  gradient[0].y = 0.0f;
  gradient[0].z = 0.0f;
  gradient[1].x = 0.0f - direction.x * t0;
  gradient[1].y = -0.48860252f - direction.y * t0;
  gradient[1].z = 0.0f - direction.z * t0;
  gradient[2].x = 0.0f - direction.x * t1;
  gradient[2].y = 0.0f - direction.y * t1;
  gradient[2].z = 0.48860252f - direction.z * t1;
  gradient[3].x = -0.48860252f - direction.x * t2;
  gradient[3].y = 0.0f - direction.y * t2;
  gradient[3].z = 0.0f - direction.z * t2;
}
#endif

#ifndef ZONAL_EVALUATE_WITH_GRADIENT_3
#define ZONAL_EVALUATE_WITH_GRADIENT_3
// Y_l^m and the gradient of Y_l^m(v / |v|) at a unit vector.
// 76 operations: 28 additions, 48 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_evaluate_with_gradient_3(highp vec3 direction, out highp float y[9], out highp vec3 gradient[9]) {
  y[0] = 0.2820948f;
  highp float t0 = -0.48860252f * direction.y;
  y[1] = t0;
  highp float t1 = 0.48860252f * direction.z;
  y[2] = t1;
  highp float t2 = -0.48860252f * direction.x;
  y[3] = t2;
  highp float t3 = direction.y * direction.x;
  highp float t4 = 0.54627424f * (t3 + t3);
  y[4] = t4;
  highp float t5 = -1.0925485f * direction.z;
  highp float t6 = t5 * direction.y;
  y[5] = t6;
  highp float t7 = 0.9461747f * (direction.z * direction.z) + -0.31539157f;
  y[6] = t7;
  highp float t8 = t5 * direction.x;
  y[7] = t8;
  highp float t9 = 0.54627424f * (direction.x * direction.x - direction.y * direction.y);
  y[8] = t9;
  gradient[0].x = 0.0f;
  gradient[0].y = 0.0f;
  gradient[0].z = 0.0f;
  gradient[1].x = 0.0f - direction.x * t0;
  gradient[1].y = -0.48860252f - direction.y * t0;
  gradient[1].z = 0.0f - direction.z * t0;
  gradient[2].x = 0.0f - direction.x * t1;
  gradient[2].y = 0.0f - direction.y * t1;
  gradient[2].z = 0.48860252f - direction.z * t1;
  gradient[3].x = -0.48860252f - direction.x * t2;
  gradient[3].y = 0.0f - direction.y * t2;
  gradient[3].z = 0.0f - direction.z * t2;
  highp float t10 = -2.236068f * t0;
  highp float t11 = 2.0f * direction.x;
  gradient[4].x = t10 - t11 * t4;
  highp float t12 = -2.236068f * t2;
  highp float t13 = 2.0f * direction.y;
  gradient[4].y = t12 - t13 * t4;
  highp float t14 = 2.0f * direction.z;
  gradient[4].z = 0.0f - t14 * t4;
  gradient[5].x = 0.0f - t11 * t6;
  highp float t15 = -2.236068f * t1;
  gradient[5].y = t15 - t13 * t6;
  gradient[5].z = 2.236068f * t0 - t14 * t6;
  gradient[6].x = 1.2909944f * t2 - t11 * t7;
  gradient[6].y = 1.2909944f * t0 - t13 * t7;
  gradient[6].z = 2.5819888f * t1 - t14 * t7;
  gradient[7].x = t15 - t11 * t8;
  gradient[7].y = 0.0f - t13 * t8;
  gradient[7].z = 2.236068f * t2 - t14 * t8;
  gradient[8].x = t12 - t11 * t9;
  gradient[8].y = -t10 - t13 * t9;
  gradient[8].z = 0.0f - t14 * t9;
}
#endif

#ifndef ZONAL_EVALUATE_WITH_GRADIENT_4
#define ZONAL_EVALUATE_WITH_GRADIENT_4
// Y_l^m and the gradient of Y_l^m(v / |v|) at a unit vector.
// 157 operations: 57 additions, 100 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_evaluate_with_gradient_4(highp vec3 direction, out highp float y[16], out highp vec3 gradient[16]) {
  y[0] = 0.2820948f;
  highp float t0 = -0.48860252f * direction.y;
  y[1] = t0;
  highp float t1 = 0.48860252f * direction.z;
  y[2] = t1;
  highp float t2 = -0.48860252f * direction.x;
  y[3] = t2;
  highp float t3 = direction.y * direction.x;
  highp float t4 = t3 + t3;
  highp float t5 = 0.54627424f * t4;
  y[4] = t5;
  highp float t6 = -1.0925485f * direction.z;
  highp float t7 = t6 * direction.y;
  y[5] = t7;
  highp float t8 = direction.z * direction.z;
  highp float t9 = 0.9461747f * t8 + -0.31539157f;
  y[6] = t9;
  highp float t10 = t6 * direction.x;
  y[7] = t10;
  highp float t11 = direction.x * direction.x - direction.y * direction.y;
  highp float t12 = 0.54627424f * t11;
  y[8] = t12;
  highp float t13 = -0.5900436f * (direction.x * t4 + direction.y * t11);
  y[9] = t13;
  highp float t14 = 1.4453057f * direction.z;
  highp float t15 = t14 * t4;
  y[10] = t15;
  highp float t16 = -2.285229f * t8 + 0.4570458f;
  highp float t17 = t16 * direction.y;
  y[11] = t17;
  highp float t18 = direction.z * (1.8658817f * t8 + -1.119529f);
  y[12] = t18;
  highp float t19 = t16 * direction.x;
  y[13] = t19;
  highp float t20 = t14 * t11;
  y[14] = t20;
  highp float t21 = -0.5900436f * (direction.x * t11 - direction.y * t4);
  y[15] = t21;
  gradient[0].x = 0.0f;
  gradient[0].y = 0.0f;
  gradient[0].z = 0.0f;
  gradient[1].x = 0.0f - direction.x * t0;
  gradient[1].y = -0.48860252f - direction.y * t0;
  gradient[1].z = 0.0f - direction.z * t0;
  gradient[2].x = 0.0f - direction.x * t1;
  gradient[2].y = 0.0f - direction.y * t1;
  gradient[2].z = 0.48860252f - direction.z * t1;
  gradient[3].x = -0.48860252f - direction.x * t2;
  gradient[3].y = 0.0f - direction.y * t2;
  gradient[3].z = 0.0f - direction.z * t2;
  highp float t22 = -2.236068f * t0;
  highp float t23 = 2.0f * direction.x;
  gradient[4].x = t22 - t23 * t5;
  highp float t24 = -2.236068f * t2;
  highp float t25 = 2.0f * direction.y;
  gradient[4].y = t24 - t25 * t5;
  highp float t26 = 2.0f * direction.z;
  gradient[4].z = 0.0f - t26 * t5;
  gradient[5].x = 0.0f - t23 * t7;
  highp float t27 = -2.236068f * t1;
  gradient[5].y = t27 - t25 * t7;
  gradient[5].z = 2.236068f * t0 - t26 * t7;
  gradient[6].x = 1.2909944f * t2 - t23 * t9;
  gradient[6].y = 1.2909944f * t0 - t25 * t9;
  gradient[6].z = 2.5819888f * t1 - t26 * t9;
  gradient[7].x = t27 - t23 * t10;
  gradient[7].y = 0.0f - t25 * t10;
  gradient[7].z = 2.236068f * t2 - t26 * t10;
  gradient[8].x = t24 - t23 * t12;
  gradient[8].y = -t22 - t25 * t12;
  gradient[8].z = 0.0f - t26 * t12;
  highp float t28 = -3.2403703f * t5;
  highp float t29 = 3.0f * direction.x;
  gradient[9].x = t28 - t29 * t13;
  highp float t30 = -3.2403703f * t12;
  highp float t31 = 3.0f * direction.y;
  gradient[9].y = t30 - t31 * t13;
  highp float t32 = 3.0f * direction.z;
  gradient[9].z = 0.0f - t32 * t13;
  highp float t33 = -2.6457512f * t7;
  gradient[10].x = t33 - t29 * t15;
  highp float t34 = -2.6457512f * t10;
  gradient[10].y = t34 - t31 * t15;
  gradient[10].z = 2.6457512f * t5 - t32 * t15;
  highp float t35 = 0.83666f * t5;
  gradient[11].x = t35 - t29 * t17;
  highp float t36 = -2.8982754f * t9;
  highp float t37 = 0.83666f * t12;
  gradient[11].y = t36 - t37 - t31 * t17;
  gradient[11].z = 3.34664f * t7 - t32 * t17;
  gradient[12].x = 2.04939f * t10 - t29 * t18;
  gradient[12].y = 2.04939f * t7 - t31 * t18;
  gradient[12].z = 3.5496478f * t9 - t32 * t18;
  gradient[13].x = t37 + t36 - t29 * t19;
  gradient[13].y = t35 - t31 * t19;
  gradient[13].z = 3.34664f * t10 - t32 * t19;
  gradient[14].x = t34 - t29 * t20;
  gradient[14].y = -t33 - t31 * t20;
  gradient[14].z = 2.6457512f * t12 - t32 * t20;
  gradient[15].x = t30 - t29 * t21;
  gradient[15].y = -t28 - t31 * t21;
  gradient[15].z = 0.0f - t32 * t21;
}
#endif

#ifndef ZONAL_EVALUATE_WITH_GRADIENT_5
#define ZONAL_EVALUATE_WITH_GRADIENT_5
// Y_l^m and the gradient of Y_l^m(v / |v|) at a unit vector.
// 266 operations: 97 additions, 169 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_evaluate_with_gradient_5(highp vec3 direction, out highp float y[25], out highp vec3 gradient[25]) {
  y[0] = 0.2820948f;
  highp float t0 = -0.48860252f * direction.y;
  y[1] = t0;
  highp float t1 = 0.48860252f * direction.z;
  y[2] = t1;
  highp float t2 = -0.48860252f * direction.x;
  y[3] = t2;
  highp float t3 = direction.y * direction.x;
  highp float t4 = t3 + t3;
  highp float t5 = 0.54627424f * t4;
  y[4] = t5;
  highp float t6 = -1.0925485f * direction.z;
  highp float t7 = t6 * direction.y;
  y[5] = t7;
  highp float t8 = direction.z * direction.z;
  highp float t9 = 0.9461747f * t8 + -0.31539157f;
  y[6] = t9;
  highp float t10 = t6 * direction.x;
  y[7] = t10;
  highp float t11 = direction.x * direction.x - direction.y * direction.y;
  highp float t12 = 0.54627424f * t11;
  y[8] = t12;
  highp float t13 = direction.x * t4 + direction.y * t11;
  highp float t14 = -0.5900436f * t13;
  y[9] = t14;
  highp float t15 = 1.4453057f * direction.z;
  highp float t16 = t15 * t4;
  y[10] = t16;
  highp float t17 = -2.285229f * t8 + 0.4570458f;
  highp float t18 = t17 * direction.y;
  y[11] = t18;
  highp float t19 = direction.z * (1.8658817f * t8 + -1.119529f);
  y[12] = t19;
  highp float t20 = t17 * direction.x;
  y[13] = t20;
  highp float t21 = t15 * t11;
  y[14] = t21;
  highp float t22 = direction.x * t11 - direction.y * t4;
  highp float t23 = -0.5900436f * t22;
  y[15] = t23;
  highp float t24 = 0.6258357f * (direction.x * t13 + direction.y * t22);
  y[16] = t24;
  highp float t25 = -1.7701308f * direction.z;
  highp float t26 = t25 * t13;
  y[17] = t26;
  highp float t27 = 3.3116114f * t8 + -0.47308734f;
  highp float t28 = t27 * t4;
  y[18] = t28;
  highp float t29 = direction.z * (-4.683326f * t8 + 2.0071397f);
  highp float t30 = t29 * direction.y;
  y[19] = t30;
  highp float t31 = 1.9843135f * direction.z * t19 - 1.0062306f * t9;
  y[20] = t31;
  highp float t32 = t29 * direction.x;
  y[21] = t32;
  highp float t33 = t27 * t11;
  y[22] = t33;
  highp float t34 = t25 * t22;
  y[23] = t34;
  highp float t35 = 0.6258357f * (direction.x * t22 - direction.y * t13);
  y[24] = t35;
  gradient[0].x = 0.0f;
  gradient[0].y = 0.0f;
  gradient[0].z = 0.0f;
  gradient[1].x = 0.0f - direction.x * t0;
  gradient[1].y = -0.48860252f - direction.y * t0;
  gradient[1].z = 0.0f - direction.z * t0;
  gradient[2].x = 0.0f - direction.x * t1;
  gradient[2].y = 0.0f - direction.y * t1;
  gradient[2].z = 0.48860252f - direction.z * t1;
  gradient[3].x = -0.48860252f - direction.x * t2;
  gradient[3].y = 0.0f - direction.y * t2;
  gradient[3].z = 0.0f - direction.z * t2;
  highp float t36 = -2.236068f * t0;
  highp float t37 = 2.0f * direction.x;
  gradient[4].x = t36 - t37 * t5;
  highp float t38 = -2.236068f * t2;
  highp float t39 = 2.0f * direction.y;
  gradient[4].y = t38 - t39 * t5;
  highp float t40 = 2.0f * direction.z;
  gradient[4].z = 0.0f - t40 * t5;
  gradient[5].x = 0.0f - t37 * t7;
  highp float t41 = -2.236068f * t1;
  gradient[5].y = t41 - t39 * t7;
  gradient[5].z = 2.236068f * t0 - t40 * t7;
  gradient[6].x = 1.2909944f * t2 - t37 * t9;
  gradient[6].y = 1.2909944f * t0 - t39 * t9;
  gradient[6].z = 2.5819888f * t1 - t40 * t9;
  gradient[7].x = t41 - t37 * t10;
  gradient[7].y = 0.0f - t39 * t10;
  gradient[7].z = 2.236068f * t2 - t40 * t10;
  gradient[8].x = t38 - t37 * t12;
  gradient[8].y = -t36 - t39 * t12;
  gradient[8].z = 0.0f - t40 * t12;
  highp float t42 = -3.2403703f * t5;
  highp float t43 = 3.0f * direction.x;
  gradient[9].x = t42 - t43 * t14;
  highp float t44 = -3.2403703f * t12;
  highp float t45 = 3.0f * direction.y;
  gradient[9].y = t44 - t45 * t14;
  highp float t46 = 3.0f * direction.z;
  gradient[9].z = 0.0f - t46 * t14;
  highp float t47 = -2.6457512f * t7;
  gradient[10].x = t47 - t43 * t16;
  highp float t48 = -2.6457512f * t10;
  gradient[10].y = t48 - t45 * t16;
  gradient[10].z = 2.6457512f * t5 - t46 * t16;
  highp float t49 = 0.83666f * t5;
  gradient[11].x = t49 - t43 * t18;
  highp float t50 = -2.8982754f * t9;
  highp float t51 = 0.83666f * t12;
  gradient[11].y = t50 - t51 - t45 * t18;
  gradient[11].z = 3.34664f * t7 - t46 * t18;
  gradient[12].x = 2.04939f * t10 - t43 * t19;
  gradient[12].y = 2.04939f * t7 - t45 * t19;
  gradient[12].z = 3.5496478f * t9 - t46 * t19;
  gradient[13].x = t51 + t50 - t43 * t20;
  gradient[13].y = t49 - t45 * t20;
  gradient[13].z = 3.34664f * t10 - t46 * t20;
  gradient[14].x = t48 - t43 * t21;
  gradient[14].y = -t47 - t45 * t21;
  gradient[14].z = 2.6457512f * t12 - t46 * t21;
  gradient[15].x = t44 - t43 * t23;
  gradient[15].y = -t42 - t45 * t23;
  gradient[15].z = 0.0f - t46 * t23;
  highp float t52 = -4.2426405f * t14;
  highp float t53 = 4.0f * direction.x;
  gradient[16].x = t52 - t53 * t24;
  highp float t54 = -4.2426405f * t23;
  highp float t55 = 4.0f * direction.y;
  gradient[16].y = t54 - t55 * t24;
  highp float t56 = 4.0f * direction.z;
  gradient[16].z = 0.0f - t56 * t24;
  highp float t57 = -3.6742346f * t16;
  gradient[17].x = t57 - t53 * t26;
  highp float t58 = -3.6742346f * t21;
  gradient[17].y = t58 - t55 * t26;
  gradient[17].z = 3.0f * t14 - t56 * t26;
  highp float t59 = 0.80178374f * t14;
  highp float t60 = -3.105295f * t18;
  gradient[18].x = t59 + t60 - t53 * t28;
  highp float t61 = -3.105295f * t20;
  highp float t62 = 0.80178374f * t23;
  gradient[18].y = t61 - t62 - t55 * t28;
  gradient[18].z = 3.927922f * t16 - t56 * t28;
  highp float t63 = 1.3887302f * t16;
  gradient[19].x = t63 - t53 * t30;
  highp float t64 = -3.5856857f * t19;
  highp float t65 = 1.3887302f * t21;
  gradient[19].y = t64 - t65 - t55 * t30;
  gradient[19].z = 4.3915505f * t18 - t56 * t30;
  gradient[20].x = 2.7774603f * t20 - t53 * t31;
  gradient[20].y = 2.7774603f * t18 - t55 * t31;
  gradient[20].z = 4.5355735f * t19 - t56 * t31;
  gradient[21].x = t65 + t64 - t53 * t32;
  gradient[21].y = t63 - t55 * t32;
  gradient[21].z = 4.3915505f * t20 - t56 * t32;
  gradient[22].x = t62 + t61 - t53 * t33;
  gradient[22].y = t59 - t60 - t55 * t33;
  gradient[22].z = 3.927922f * t21 - t56 * t33;
  gradient[23].x = t58 - t53 * t34;
  gradient[23].y = -t57 - t55 * t34;
  gradient[23].z = 3.0f * t23 - t56 * t34;
  gradient[24].x = t54 - t53 * t35;
  gradient[24].y = -t52 - t55 * t35;
  gradient[24].z = 0.0f - t56 * t35;
}
#endif

#ifndef ZONAL_RECONSTRUCT_2
#define ZONAL_RECONSTRUCT_2
// A function's value in a direction: basis and sum fused.
// 10 operations: 3 additions, 7 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_reconstruct_2(in highp float sh[4], highp vec3 direction) {
  highp float t0 = sh[2] * (0.48860252f * direction.z) + sh[3] * (-0.48860252f * direction.x);
  highp float value = sh[0] * 0.2820948f + sh[1] * (-0.48860252f * direction.y) + t0;
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_3
#define ZONAL_RECONSTRUCT_3
// A function's value in a direction: basis and sum fused.
// 33 operations: 11 additions, 22 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_reconstruct_3(in highp float sh[9], highp vec3 direction) {
  highp float t0 = direction.y * direction.x;
  highp float t1 = sh[8] * (0.54627424f * (direction.x * direction.x - direction.y * direction.y));
  highp float t2 = -1.0925485f * direction.z;
  highp float t3 = sh[0] * 0.2820948f + sh[4] * (0.54627424f * (t0 + t0)) + t1 + (sh[1] * (-0.48860252f * direction.y) + sh[5] * (t2 * direction.y));
  highp float t4 = sh[2] * (0.48860252f * direction.z) + sh[6] * (0.9461747f * (direction.z * direction.z) + -0.31539157f);
  highp float t5 = t4 + (sh[3] * (-0.48860252f * direction.x) + sh[7] * (t2 * direction.x));
  highp float value = t3 + t5;
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_4
#define ZONAL_RECONSTRUCT_4
// A function's value in a direction: basis and sum fused.
// 65 operations: 22 additions, 43 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_reconstruct_4(in highp float sh[16], highp vec3 direction) {
  highp float t0 = direction.z * direction.z;
  highp float t1 = sh[0] * 0.2820948f + sh[12] * (direction.z * (1.8658817f * t0 + -1.119529f));
  highp float t2 = direction.y * direction.x;
  highp float t3 = t2 + t2;
  highp float t4 = direction.x * direction.x - direction.y * direction.y;
  highp float t5 = -1.0925485f * direction.z;
  highp float t6 = -2.285229f * t0 + 0.4570458f;
  highp float t7 = sh[1] * (-0.48860252f * direction.y) + sh[5] * (t5 * direction.y) + sh[13] * (t6 * direction.x);
  highp float t8 = t1 + sh[4] * (0.54627424f * t3) + sh[8] * (0.54627424f * t4) + (t7 + sh[9] * (-0.5900436f * (direction.x * t3 + direction.y * t4)));
  highp float t9 = sh[2] * (0.48860252f * direction.z) + sh[6] * (0.9461747f * t0 + -0.31539157f);
  highp float t10 = 1.4453057f * direction.z;
  highp float t11 = sh[3] * (-0.48860252f * direction.x) + sh[7] * (t5 * direction.x) + sh[11] * (t6 * direction.y);
  highp float t12 = t9 + sh[10] * (t10 * t3) + sh[14] * (t10 * t4) + (t11 + sh[15] * (-0.5900436f * (direction.x * t4 - direction.y * t3)));
  highp float value = t8 + t12;
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_5
#define ZONAL_RECONSTRUCT_5
// A function's value in a direction: basis and sum fused.
// 107 operations: 36 additions, 71 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_reconstruct_5(in highp float sh[25], highp vec3 direction) {
  highp float t0 = direction.z * direction.z;
  highp float t1 = direction.z * (1.8658817f * t0 + -1.119529f);
  highp float t2 = 0.9461747f * t0 + -0.31539157f;
  highp float t3 = sh[0] * 0.2820948f + sh[12] * t1 + sh[20] * (1.9843135f * direction.z * t1 - 1.0062306f * t2);
  highp float t4 = direction.y * direction.x;
  highp float t5 = t4 + t4;
  highp float t6 = direction.x * direction.x - direction.y * direction.y;
  highp float t7 = direction.x * t5 + direction.y * t6;
  highp float t8 = direction.x * t6 - direction.y * t5;
  highp float t9 = t3 + sh[4] * (0.54627424f * t5) + sh[8] * (0.54627424f * t6) + sh[16] * (0.6258357f * (direction.x * t7 + direction.y * t8));
  highp float t10 = -1.0925485f * direction.z;
  highp float t11 = -2.285229f * t0 + 0.4570458f;
  highp float t12 = sh[1] * (-0.48860252f * direction.y) + sh[5] * (t10 * direction.y) + sh[13] * (t11 * direction.x);
  highp float t13 = direction.z * (-4.683326f * t0 + 2.0071397f);
  highp float t14 = -1.7701308f * direction.z;
  highp float t15 = t12 + sh[21] * (t13 * direction.x) + sh[9] * (-0.5900436f * t7) + sh[17] * (t14 * t7);
  highp float t16 = t9 + sh[24] * (0.6258357f * (direction.x * t8 - direction.y * t7)) + t15;
  highp float t17 = 1.4453057f * direction.z;
  highp float t18 = sh[2] * (0.48860252f * direction.z) + sh[6] * t2 + sh[10] * (t17 * t5) + sh[14] * (t17 * t6);
  highp float t19 = 3.3116114f * t0 + -0.47308734f;
  highp float t20 = sh[3] * (-0.48860252f * direction.x) + sh[7] * (t10 * direction.x) + sh[11] * (t11 * direction.y);
  highp float t21 = t20 + sh[19] * (t13 * direction.y) + sh[15] * (-0.5900436f * t8) + sh[23] * (t14 * t8);
  highp float value = t16 + (t18 + sh[18] * (t19 * t5) + sh[22] * (t19 * t6) + t21);
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_COLOUR_2
#define ZONAL_RECONSTRUCT_COLOUR_2
// A function's value in a direction: basis and sum fused. For colours.
// 24 operations: 9 additions, 15 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_reconstruct_colour_2(in highp vec3 sh[4], highp vec3 direction) {
  highp float t0 = -0.48860252f * direction.y;
  highp float t1 = 0.48860252f * direction.z;
  highp float t2 = -0.48860252f * direction.x;
  highp vec3 value = vec3(sh[0].x * 0.2820948f + sh[1].x * t0 + (sh[2].x * t1 + sh[3].x * t2),
      sh[0].y * 0.2820948f + sh[1].y * t0 + (sh[2].y * t1 + sh[3].y * t2),
      sh[0].z * 0.2820948f + sh[1].z * t0 + (sh[2].z * t1 + sh[3].z * t2));
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_COLOUR_3
#define ZONAL_RECONSTRUCT_COLOUR_3
// A function's value in a direction: basis and sum fused. For colours.
// 67 operations: 27 additions, 40 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_reconstruct_colour_3(in highp vec3 sh[9], highp vec3 direction) {
  highp float t0 = direction.y * direction.x;
  highp float t1 = 0.54627424f * (t0 + t0);
  highp float t2 = 0.54627424f * (direction.x * direction.x - direction.y * direction.y);
  highp float t3 = -0.48860252f * direction.y;
  highp float t4 = -1.0925485f * direction.z;
  highp float t5 = t4 * direction.y;
  highp float t6 = sh[0].x * 0.2820948f + sh[4].x * t1 + sh[8].x * t2 + (sh[1].x * t3 + sh[5].x * t5);
  highp float t7 = 0.48860252f * direction.z;
  highp float t8 = 0.9461747f * (direction.z * direction.z) + -0.31539157f;
  highp float t9 = -0.48860252f * direction.x;
  highp float t10 = t4 * direction.x;
  highp float t11 = sh[0].y * 0.2820948f + sh[4].y * t1 + sh[8].y * t2 + (sh[1].y * t3 + sh[5].y * t5);
  highp float t12 = sh[0].z * 0.2820948f + sh[4].z * t1 + sh[8].z * t2 + (sh[1].z * t3 + sh[5].z * t5);
  highp vec3 value = vec3(t6 + (sh[2].x * t7 + sh[6].x * t8 + (sh[3].x * t9 + sh[7].x * t10)),
      t11 + (sh[2].y * t7 + sh[6].y * t8 + (sh[3].y * t9 + sh[7].y * t10)),
      t12 + (sh[2].z * t7 + sh[6].z * t8 + (sh[3].z * t9 + sh[7].z * t10)));
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_COLOUR_4
#define ZONAL_RECONSTRUCT_COLOUR_4
// A function's value in a direction: basis and sum fused. For colours.
// 127 operations: 52 additions, 75 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_reconstruct_colour_4(in highp vec3 sh[16], highp vec3 direction) {
  highp float t0 = direction.z * direction.z;
  highp float t1 = direction.z * (1.8658817f * t0 + -1.119529f);
  highp float t2 = direction.y * direction.x;
  highp float t3 = t2 + t2;
  highp float t4 = 0.54627424f * t3;
  highp float t5 = direction.x * direction.x - direction.y * direction.y;
  highp float t6 = 0.54627424f * t5;
  highp float t7 = -0.48860252f * direction.y;
  highp float t8 = -1.0925485f * direction.z;
  highp float t9 = t8 * direction.y;
  highp float t10 = -2.285229f * t0 + 0.4570458f;
  highp float t11 = t10 * direction.x;
  highp float t12 = -0.5900436f * (direction.x * t3 + direction.y * t5);
  highp float t13 = sh[0].x * 0.2820948f + sh[12].x * t1 + sh[4].x * t4 + sh[8].x * t6 + (sh[1].x * t7 + sh[5].x * t9 + sh[13].x * t11 + sh[9].x * t12);
  highp float t14 = 0.48860252f * direction.z;
  highp float t15 = 0.9461747f * t0 + -0.31539157f;
  highp float t16 = 1.4453057f * direction.z;
  highp float t17 = t16 * t3;
  highp float t18 = t16 * t5;
  highp float t19 = -0.48860252f * direction.x;
  highp float t20 = t8 * direction.x;
  highp float t21 = t10 * direction.y;
  highp float t22 = -0.5900436f * (direction.x * t5 - direction.y * t3);
  highp float t23 = sh[2].x * t14 + sh[6].x * t15 + sh[10].x * t17 + sh[14].x * t18 + (sh[3].x * t19 + sh[7].x * t20 + sh[11].x * t21 + sh[15].x * t22);
  highp float t24 = sh[0].y * 0.2820948f + sh[12].y * t1 + sh[4].y * t4 + sh[8].y * t6 + (sh[1].y * t7 + sh[5].y * t9 + sh[13].y * t11 + sh[9].y * t12);
  highp float t25 = sh[2].y * t14 + sh[6].y * t15 + sh[10].y * t17 + sh[14].y * t18 + (sh[3].y * t19 + sh[7].y * t20 + sh[11].y * t21 + sh[15].y * t22);
  highp float t26 = sh[0].z * 0.2820948f + sh[12].z * t1 + sh[4].z * t4 + sh[8].z * t6 + (sh[1].z * t7 + sh[5].z * t9 + sh[13].z * t11 + sh[9].z * t12);
  highp float t27 = sh[2].z * t14 + sh[6].z * t15 + sh[10].z * t17 + sh[14].z * t18 + (sh[3].z * t19 + sh[7].z * t20 + sh[11].z * t21 + sh[15].z * t22);
  highp vec3 value = vec3(t13 + t23, t24 + t25, t26 + t27);
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_COLOUR_5
#define ZONAL_RECONSTRUCT_COLOUR_5
// A function's value in a direction: basis and sum fused. For colours.
// 205 operations: 84 additions, 121 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_reconstruct_colour_5(in highp vec3 sh[25], highp vec3 direction) {
  highp float t0 = direction.z * direction.z;
  highp float t1 = direction.z * (1.8658817f * t0 + -1.119529f);
  highp float t2 = 0.9461747f * t0 + -0.31539157f;
  highp float t3 = 1.9843135f * direction.z * t1 - 1.0062306f * t2;
  highp float t4 = direction.y * direction.x;
  highp float t5 = t4 + t4;
  highp float t6 = 0.54627424f * t5;
  highp float t7 = direction.x * direction.x - direction.y * direction.y;
  highp float t8 = 0.54627424f * t7;
  highp float t9 = sh[0].x * 0.2820948f + sh[12].x * t1 + sh[20].x * t3 + sh[4].x * t6 + sh[8].x * t8;
  highp float t10 = direction.x * t5 + direction.y * t7;
  highp float t11 = direction.x * t7 - direction.y * t5;
  highp float t12 = 0.6258357f * (direction.x * t10 + direction.y * t11);
  highp float t13 = 0.6258357f * (direction.x * t11 - direction.y * t10);
  highp float t14 = -0.48860252f * direction.y;
  highp float t15 = -1.0925485f * direction.z;
  highp float t16 = t15 * direction.y;
  highp float t17 = -2.285229f * t0 + 0.4570458f;
  highp float t18 = t17 * direction.x;
  highp float t19 = direction.z * (-4.683326f * t0 + 2.0071397f);
  highp float t20 = t19 * direction.x;
  highp float t21 = -0.5900436f * t10;
  highp float t22 = sh[1].x * t14 + sh[5].x * t16 + sh[13].x * t18 + sh[21].x * t20 + sh[9].x * t21;
  highp float t23 = -1.7701308f * direction.z;
  highp float t24 = t23 * t10;
  highp float t25 = 0.48860252f * direction.z;
  highp float t26 = 1.4453057f * direction.z;
  highp float t27 = t26 * t5;
  highp float t28 = t26 * t7;
  highp float t29 = 3.3116114f * t0 + -0.47308734f;
  highp float t30 = t29 * t5;
  highp float t31 = sh[2].x * t25 + sh[6].x * t2 + sh[10].x * t27 + sh[14].x * t28 + sh[18].x * t30;
  highp float t32 = t29 * t7;
  highp float t33 = -0.48860252f * direction.x;
  highp float t34 = t15 * direction.x;
  highp float t35 = t17 * direction.y;
  highp float t36 = t19 * direction.y;
  highp float t37 = -0.5900436f * t11;
  highp float t38 = sh[3].x * t33 + sh[7].x * t34 + sh[11].x * t35 + sh[19].x * t36 + sh[15].x * t37;
  highp float t39 = t23 * t11;
  highp float t40 = t9 + sh[16].x * t12 + sh[24].x * t13 + (t22 + sh[17].x * t24) + (t31 + sh[22].x * t32 + (t38 + sh[23].x * t39));
  highp float t41 = sh[0].y * 0.2820948f + sh[12].y * t1 + sh[20].y * t3 + sh[4].y * t6 + sh[8].y * t8;
  highp float t42 = sh[1].y * t14 + sh[5].y * t16 + sh[13].y * t18 + sh[21].y * t20 + sh[9].y * t21;
  highp float t43 = sh[2].y * t25 + sh[6].y * t2 + sh[10].y * t27 + sh[14].y * t28 + sh[18].y * t30;
  highp float t44 = sh[3].y * t33 + sh[7].y * t34 + sh[11].y * t35 + sh[19].y * t36 + sh[15].y * t37;
  highp float t45 = t41 + sh[16].y * t12 + sh[24].y * t13 + (t42 + sh[17].y * t24) + (t43 + sh[22].y * t32 + (t44 + sh[23].y * t39));
  highp float t46 = sh[0].z * 0.2820948f + sh[12].z * t1 + sh[20].z * t3 + sh[4].z * t6 + sh[8].z * t8;
  highp float t47 = sh[1].z * t14 + sh[5].z * t16 + sh[13].z * t18 + sh[21].z * t20 + sh[9].z * t21;
  highp float t48 = sh[2].z * t25 + sh[6].z * t2 + sh[10].z * t27 + sh[14].z * t28 + sh[18].z * t30;
  highp float t49 = sh[3].z * t33 + sh[7].z * t34 + sh[11].z * t35 + sh[19].z * t36 + sh[15].z * t37;
  highp float t50 = t46 + sh[16].z * t12 + sh[24].z * t13 + (t47 + sh[17].z * t24) + (t48 + sh[22].z * t32 + (t49 + sh[23].z * t39));
  highp vec3 value = vec3(t40, t45, t50);
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_LAMBERT_2
#define ZONAL_RECONSTRUCT_LAMBERT_2
// Radiance convolved with the clamped cosine: irradiance over pi at a normal.
// 11 operations: 3 additions, 8 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_reconstruct_lambert_2(in highp float radiance[4], highp vec3 normal) {
  highp float t0 = radiance[2] * (0.48860252f * normal.z) + radiance[1] * (-0.48860252f * normal.y);
  highp float t1 = radiance[0] * 0.2820948f + (t0 + radiance[3] * (-0.48860252f * normal.x)) * 0.6666667f;
  highp float value = t1;
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_LAMBERT_3
#define ZONAL_RECONSTRUCT_LAMBERT_3
// Radiance convolved with the clamped cosine: irradiance over pi at a normal.
// 35 operations: 11 additions, 24 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_reconstruct_lambert_3(in highp float radiance[9], highp vec3 normal) {
  highp float t0 = radiance[2] * (0.48860252f * normal.z) + radiance[1] * (-0.48860252f * normal.y);
  highp float t1 = radiance[0] * 0.2820948f + (t0 + radiance[3] * (-0.48860252f * normal.x)) * 0.6666667f;
  highp float t2 = -1.0925485f * normal.z;
  highp float t3 = radiance[6] * (0.9461747f * (normal.z * normal.z) + -0.31539157f) + radiance[5] * (t2 * normal.y);
  highp float t4 = normal.y * normal.x;
  highp float t5 = t3 + radiance[7] * (t2 * normal.x) + radiance[4] * (0.54627424f * (t4 + t4));
  highp float t6 = radiance[8] * (0.54627424f * (normal.x * normal.x - normal.y * normal.y));
  highp float value = t1 + (t5 + t6) * 0.25f;
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_LAMBERT_4
#define ZONAL_RECONSTRUCT_LAMBERT_4
// Radiance convolved with the clamped cosine: irradiance over pi at a normal.
// 35 operations: 11 additions, 24 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_reconstruct_lambert_4(in highp float radiance[16], highp vec3 normal) {
  highp float t0 = radiance[2] * (0.48860252f * normal.z) + radiance[1] * (-0.48860252f * normal.y);
  highp float t1 = radiance[0] * 0.2820948f + (t0 + radiance[3] * (-0.48860252f * normal.x)) * 0.6666667f;
  highp float t2 = -1.0925485f * normal.z;
  highp float t3 = radiance[6] * (0.9461747f * (normal.z * normal.z) + -0.31539157f) + radiance[5] * (t2 * normal.y);
  highp float t4 = normal.y * normal.x;
  highp float t5 = t3 + radiance[7] * (t2 * normal.x) + radiance[4] * (0.54627424f * (t4 + t4));
  highp float t6 = radiance[8] * (0.54627424f * (normal.x * normal.x - normal.y * normal.y));
  highp float value = t1 + (t5 + t6) * 0.25f;
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_LAMBERT_5
#define ZONAL_RECONSTRUCT_LAMBERT_5
// Radiance convolved with the clamped cosine: irradiance over pi at a normal.
// 87 operations: 28 additions, 59 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_reconstruct_lambert_5(in highp float radiance[25], highp vec3 normal) {
  highp float t0 = normal.z * normal.z;
  highp float t1 = 0.9461747f * t0 + -0.31539157f;
  highp float t2 = 1.9843135f * normal.z * (normal.z * (1.8658817f * t0 + -1.119529f)) - 1.0062306f * t1;
  highp float t3 = normal.z * (-4.683326f * t0 + 2.0071397f);
  highp float t4 = radiance[20] * t2 + radiance[19] * (t3 * normal.y) + radiance[21] * (t3 * normal.x);
  highp float t5 = 3.3116114f * t0 + -0.47308734f;
  highp float t6 = normal.y * normal.x;
  highp float t7 = t6 + t6;
  highp float t8 = normal.x * normal.x - normal.y * normal.y;
  highp float t9 = -1.7701308f * normal.z;
  highp float t10 = normal.x * t7 + normal.y * t8;
  highp float t11 = t4 + radiance[18] * (t5 * t7) + radiance[22] * (t5 * t8) + radiance[17] * (t9 * t10);
  highp float t12 = normal.x * t8 - normal.y * t7;
  highp float t13 = t11 + radiance[23] * (t9 * t12) + radiance[16] * (0.6258357f * (normal.x * t10 + normal.y * t12));
  highp float t14 = (t13 + radiance[24] * (0.6258357f * (normal.x * t12 - normal.y * t10))) * -0.041666668f;
  highp float t15 = radiance[2] * (0.48860252f * normal.z) + radiance[1] * (-0.48860252f * normal.y);
  highp float t16 = radiance[0] * 0.2820948f + t14 + (t15 + radiance[3] * (-0.48860252f * normal.x)) * 0.6666667f;
  highp float t17 = -1.0925485f * normal.z;
  highp float t18 = radiance[6] * t1 + radiance[5] * (t17 * normal.y) + radiance[7] * (t17 * normal.x);
  highp float t19 = t18 + radiance[4] * (0.54627424f * t7) + radiance[8] * (0.54627424f * t8);
  highp float value = t16 + t19 * 0.25f;
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_LAMBERT_COLOUR_2
#define ZONAL_RECONSTRUCT_LAMBERT_COLOUR_2
// Radiance convolved with the clamped cosine: irradiance over pi at a normal. For colours.
// 27 operations: 9 additions, 18 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_reconstruct_lambert_colour_2(in highp vec3 radiance[4], highp vec3 normal) {
  highp float t0 = 0.48860252f * normal.z;
  highp float t1 = -0.48860252f * normal.y;
  highp float t2 = -0.48860252f * normal.x;
  highp float t3 = (radiance[2].x * t0 + radiance[1].x * t1 + radiance[3].x * t2) * 0.6666667f;
  highp float t4 = (radiance[2].y * t0 + radiance[1].y * t1 + radiance[3].y * t2) * 0.6666667f;
  highp float t5 = (radiance[2].z * t0 + radiance[1].z * t1 + radiance[3].z * t2) * 0.6666667f;
  highp vec3 value = vec3(radiance[0].x * 0.2820948f + t3,
      radiance[0].y * 0.2820948f + t4,
      radiance[0].z * 0.2820948f + t5);
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_LAMBERT_COLOUR_3
#define ZONAL_RECONSTRUCT_LAMBERT_COLOUR_3
// Radiance convolved with the clamped cosine: irradiance over pi at a normal. For colours.
// 73 operations: 27 additions, 46 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_reconstruct_lambert_colour_3(in highp vec3 radiance[9], highp vec3 normal) {
  highp float t0 = 0.48860252f * normal.z;
  highp float t1 = -0.48860252f * normal.y;
  highp float t2 = -0.48860252f * normal.x;
  highp float t3 = (radiance[2].x * t0 + radiance[1].x * t1 + radiance[3].x * t2) * 0.6666667f;
  highp float t4 = 0.9461747f * (normal.z * normal.z) + -0.31539157f;
  highp float t5 = -1.0925485f * normal.z;
  highp float t6 = t5 * normal.y;
  highp float t7 = t5 * normal.x;
  highp float t8 = normal.y * normal.x;
  highp float t9 = 0.54627424f * (t8 + t8);
  highp float t10 = radiance[6].x * t4 + radiance[5].x * t6 + radiance[7].x * t7 + radiance[4].x * t9;
  highp float t11 = 0.54627424f * (normal.x * normal.x - normal.y * normal.y);
  highp float t12 = (radiance[2].y * t0 + radiance[1].y * t1 + radiance[3].y * t2) * 0.6666667f;
  highp float t13 = radiance[6].y * t4 + radiance[5].y * t6 + radiance[7].y * t7 + radiance[4].y * t9;
  highp float t14 = (radiance[2].z * t0 + radiance[1].z * t1 + radiance[3].z * t2) * 0.6666667f;
  highp float t15 = radiance[6].z * t4 + radiance[5].z * t6 + radiance[7].z * t7 + radiance[4].z * t9;
  highp vec3 value = vec3(radiance[0].x * 0.2820948f + t3 + (t10 + radiance[8].x * t11) * 0.25f,
      radiance[0].y * 0.2820948f + t12 + (t13 + radiance[8].y * t11) * 0.25f,
      radiance[0].z * 0.2820948f + t14 + (t15 + radiance[8].z * t11) * 0.25f);
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_LAMBERT_COLOUR_4
#define ZONAL_RECONSTRUCT_LAMBERT_COLOUR_4
// Radiance convolved with the clamped cosine: irradiance over pi at a normal. For colours.
// 73 operations: 27 additions, 46 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_reconstruct_lambert_colour_4(in highp vec3 radiance[16], highp vec3 normal) {
  highp float t0 = 0.48860252f * normal.z;
  highp float t1 = -0.48860252f * normal.y;
  highp float t2 = -0.48860252f * normal.x;
  highp float t3 = (radiance[2].x * t0 + radiance[1].x * t1 + radiance[3].x * t2) * 0.6666667f;
  highp float t4 = 0.9461747f * (normal.z * normal.z) + -0.31539157f;
  highp float t5 = -1.0925485f * normal.z;
  highp float t6 = t5 * normal.y;
  highp float t7 = t5 * normal.x;
  highp float t8 = normal.y * normal.x;
  highp float t9 = 0.54627424f * (t8 + t8);
  highp float t10 = radiance[6].x * t4 + radiance[5].x * t6 + radiance[7].x * t7 + radiance[4].x * t9;
  highp float t11 = 0.54627424f * (normal.x * normal.x - normal.y * normal.y);
  highp float t12 = (radiance[2].y * t0 + radiance[1].y * t1 + radiance[3].y * t2) * 0.6666667f;
  highp float t13 = radiance[6].y * t4 + radiance[5].y * t6 + radiance[7].y * t7 + radiance[4].y * t9;
  highp float t14 = (radiance[2].z * t0 + radiance[1].z * t1 + radiance[3].z * t2) * 0.6666667f;
  highp float t15 = radiance[6].z * t4 + radiance[5].z * t6 + radiance[7].z * t7 + radiance[4].z * t9;
  highp vec3 value = vec3(radiance[0].x * 0.2820948f + t3 + (t10 + radiance[8].x * t11) * 0.25f,
      radiance[0].y * 0.2820948f + t12 + (t13 + radiance[8].y * t11) * 0.25f,
      radiance[0].z * 0.2820948f + t14 + (t15 + radiance[8].z * t11) * 0.25f);
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_LAMBERT_COLOUR_5
#define ZONAL_RECONSTRUCT_LAMBERT_COLOUR_5
// Radiance convolved with the clamped cosine: irradiance over pi at a normal. For colours.
// 163 operations: 62 additions, 101 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_reconstruct_lambert_colour_5(in highp vec3 radiance[25], highp vec3 normal) {
  highp float t0 = normal.z * normal.z;
  highp float t1 = 0.9461747f * t0 + -0.31539157f;
  highp float t2 = 1.9843135f * normal.z * (normal.z * (1.8658817f * t0 + -1.119529f)) - 1.0062306f * t1;
  highp float t3 = normal.z * (-4.683326f * t0 + 2.0071397f);
  highp float t4 = t3 * normal.y;
  highp float t5 = t3 * normal.x;
  highp float t6 = 3.3116114f * t0 + -0.47308734f;
  highp float t7 = normal.y * normal.x;
  highp float t8 = t7 + t7;
  highp float t9 = t6 * t8;
  highp float t10 = radiance[20].x * t2 + radiance[19].x * t4 + radiance[21].x * t5 + radiance[18].x * t9;
  highp float t11 = normal.x * normal.x - normal.y * normal.y;
  highp float t12 = t6 * t11;
  highp float t13 = -1.7701308f * normal.z;
  highp float t14 = normal.x * t8 + normal.y * t11;
  highp float t15 = t13 * t14;
  highp float t16 = normal.x * t11 - normal.y * t8;
  highp float t17 = t13 * t16;
  highp float t18 = t10 + radiance[22].x * t12 + radiance[17].x * t15 + radiance[23].x * t17;
  highp float t19 = 0.6258357f * (normal.x * t14 + normal.y * t16);
  highp float t20 = 0.6258357f * (normal.x * t16 - normal.y * t14);
  highp float t21 = radiance[0].x * 0.2820948f + (t18 + radiance[16].x * t19 + radiance[24].x * t20) * -0.041666668f;
  highp float t22 = 0.48860252f * normal.z;
  highp float t23 = -0.48860252f * normal.y;
  highp float t24 = -0.48860252f * normal.x;
  highp float t25 = (radiance[2].x * t22 + radiance[1].x * t23 + radiance[3].x * t24) * 0.6666667f;
  highp float t26 = -1.0925485f * normal.z;
  highp float t27 = t26 * normal.y;
  highp float t28 = t26 * normal.x;
  highp float t29 = 0.54627424f * t8;
  highp float t30 = radiance[6].x * t1 + radiance[5].x * t27 + radiance[7].x * t28 + radiance[4].x * t29;
  highp float t31 = 0.54627424f * t11;
  highp float t32 = radiance[20].y * t2 + radiance[19].y * t4 + radiance[21].y * t5 + radiance[18].y * t9;
  highp float t33 = t32 + radiance[22].y * t12 + radiance[17].y * t15 + radiance[23].y * t17;
  highp float t34 = radiance[0].y * 0.2820948f + (t33 + radiance[16].y * t19 + radiance[24].y * t20) * -0.041666668f;
  highp float t35 = (radiance[2].y * t22 + radiance[1].y * t23 + radiance[3].y * t24) * 0.6666667f;
  highp float t36 = radiance[6].y * t1 + radiance[5].y * t27 + radiance[7].y * t28 + radiance[4].y * t29;
  highp float t37 = radiance[20].z * t2 + radiance[19].z * t4 + radiance[21].z * t5 + radiance[18].z * t9;
  highp float t38 = t37 + radiance[22].z * t12 + radiance[17].z * t15 + radiance[23].z * t17;
  highp float t39 = radiance[0].z * 0.2820948f + (t38 + radiance[16].z * t19 + radiance[24].z * t20) * -0.041666668f;
  highp float t40 = (radiance[2].z * t22 + radiance[1].z * t23 + radiance[3].z * t24) * 0.6666667f;
  highp float t41 = radiance[6].z * t1 + radiance[5].z * t27 + radiance[7].z * t28 + radiance[4].z * t29;
  highp vec3 value = vec3(t21 + t25 + (t30 + radiance[8].x * t31) * 0.25f,
      t34 + t35 + (t36 + radiance[8].y * t31) * 0.25f,
      t39 + t40 + (t41 + radiance[8].z * t31) * 0.25f);
  return value;
}
#endif

#ifndef ZONAL_ORIENT_2
#define ZONAL_ORIENT_2
// A zonal lobe turned to an axis, a unit vector.
// 9 operations: 0 additions, 9 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_orient_2(in highp float zh[2], highp vec3 axis, out highp float sh[4]) {
  sh[0] = 3.5449078f * zh[0] * 0.2820948f;
  highp float t0 = 2.0466535f * zh[1];
  sh[1] = t0 * (-0.48860252f * axis.y);
  sh[2] = t0 * (0.48860252f * axis.z);
  sh[3] = t0 * (-0.48860252f * axis.x);
}
#endif

#ifndef ZONAL_ORIENT_3
#define ZONAL_ORIENT_3
// A zonal lobe turned to an axis, a unit vector.
// 28 operations: 3 additions, 25 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_orient_3(in highp float zh[3], highp vec3 axis, out highp float sh[9]) {
  sh[0] = 3.5449078f * zh[0] * 0.2820948f;
  highp float t0 = 2.0466535f * zh[1];
  sh[1] = t0 * (-0.48860252f * axis.y);
  sh[2] = t0 * (0.48860252f * axis.z);
  sh[3] = t0 * (-0.48860252f * axis.x);
  highp float t1 = 1.585331f * zh[2];
  highp float t2 = axis.y * axis.x;
  sh[4] = t1 * (0.54627424f * (t2 + t2));
  highp float t3 = -1.0925485f * axis.z;
  sh[5] = t1 * (t3 * axis.y);
  sh[6] = t1 * (0.9461747f * (axis.z * axis.z) + -0.31539157f);
  sh[7] = t1 * (t3 * axis.x);
  sh[8] = t1 * (0.54627424f * (axis.x * axis.x - axis.y * axis.y));
}
#endif

#ifndef ZONAL_ORIENT_4
#define ZONAL_ORIENT_4
// A zonal lobe turned to an axis, a unit vector.
// 54 operations: 7 additions, 47 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_orient_4(in highp float zh[4], highp vec3 axis, out highp float sh[16]) {
  sh[0] = 3.5449078f * zh[0] * 0.2820948f;
  highp float t0 = 2.0466535f * zh[1];
  sh[1] = t0 * (-0.48860252f * axis.y);
  sh[2] = t0 * (0.48860252f * axis.z);
  sh[3] = t0 * (-0.48860252f * axis.x);
  highp float t1 = 1.585331f * zh[2];
  highp float t2 = axis.y * axis.x;
  highp float t3 = t2 + t2;
  sh[4] = t1 * (0.54627424f * t3);
  highp float t4 = -1.0925485f * axis.z;
  sh[5] = t1 * (t4 * axis.y);
  highp float t5 = axis.z * axis.z;
  sh[6] = t1 * (0.9461747f * t5 + -0.31539157f);
  sh[7] = t1 * (t4 * axis.x);
  highp float t6 = axis.x * axis.x - axis.y * axis.y;
  sh[8] = t1 * (0.54627424f * t6);
  highp float t7 = 1.3398491f * zh[3];
  sh[9] = t7 * (-0.5900436f * (axis.x * t3 + axis.y * t6));
  highp float t8 = 1.4453057f * axis.z;
  sh[10] = t7 * (t8 * t3);
  highp float t9 = -2.285229f * t5 + 0.4570458f;
  sh[11] = t7 * (t9 * axis.y);
  sh[12] = t7 * (axis.z * (1.8658817f * t5 + -1.119529f));
  sh[13] = t7 * (t9 * axis.x);
  sh[14] = t7 * (t8 * t6);
  sh[15] = t7 * (-0.5900436f * (axis.x * t6 - axis.y * t3));
}
#endif

#ifndef ZONAL_ORIENT_5
#define ZONAL_ORIENT_5
// A zonal lobe turned to an axis, a unit vector.
// 88 operations: 12 additions, 76 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_orient_5(in highp float zh[5], highp vec3 axis, out highp float sh[25]) {
  sh[0] = 3.5449078f * zh[0] * 0.2820948f;
  highp float t0 = 2.0466535f * zh[1];
  sh[1] = t0 * (-0.48860252f * axis.y);
  sh[2] = t0 * (0.48860252f * axis.z);
  sh[3] = t0 * (-0.48860252f * axis.x);
  highp float t1 = 1.585331f * zh[2];
  highp float t2 = axis.y * axis.x;
  highp float t3 = t2 + t2;
  sh[4] = t1 * (0.54627424f * t3);
  highp float t4 = -1.0925485f * axis.z;
  sh[5] = t1 * (t4 * axis.y);
  highp float t5 = axis.z * axis.z;
  highp float t6 = 0.9461747f * t5 + -0.31539157f;
  sh[6] = t1 * t6;
  sh[7] = t1 * (t4 * axis.x);
  highp float t7 = axis.x * axis.x - axis.y * axis.y;
  sh[8] = t1 * (0.54627424f * t7);
  highp float t8 = 1.3398491f * zh[3];
  highp float t9 = axis.x * t3 + axis.y * t7;
  sh[9] = t8 * (-0.5900436f * t9);
  highp float t10 = 1.4453057f * axis.z;
  sh[10] = t8 * (t10 * t3);
  highp float t11 = -2.285229f * t5 + 0.4570458f;
  sh[11] = t8 * (t11 * axis.y);
  highp float t12 = axis.z * (1.8658817f * t5 + -1.119529f);
  sh[12] = t8 * t12;
  sh[13] = t8 * (t11 * axis.x);
  sh[14] = t8 * (t10 * t7);
  highp float t13 = axis.x * t7 - axis.y * t3;
  sh[15] = t8 * (-0.5900436f * t13);
  highp float t14 = 1.1816359f * zh[4];
  sh[16] = t14 * (0.6258357f * (axis.x * t9 + axis.y * t13));
  highp float t15 = -1.7701308f * axis.z;
  sh[17] = t14 * (t15 * t9);
  highp float t16 = 3.3116114f * t5 + -0.47308734f;
  sh[18] = t14 * (t16 * t3);
  highp float t17 = axis.z * (-4.683326f * t5 + 2.0071397f);
  sh[19] = t14 * (t17 * axis.y);
  sh[20] = t14 * (1.9843135f * axis.z * t12 - 1.0062306f * t6);
  sh[21] = t14 * (t17 * axis.x);
  sh[22] = t14 * (t16 * t7);
  sh[23] = t14 * (t15 * t13);
  sh[24] = t14 * (0.6258357f * (axis.x * t13 - axis.y * t9));
}
#endif

#ifndef ZONAL_ORIENT_COLOUR_2
#define ZONAL_ORIENT_COLOUR_2
// A zonal lobe turned to an axis, a unit vector. For colours.
// 21 operations: 0 additions, 21 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_orient_colour_2(in highp vec3 zh[2], highp vec3 axis, out highp vec3 sh[4]) {
  sh[0].x = 3.5449078f * zh[0].x * 0.2820948f;
  sh[0].y = 3.5449078f * zh[0].y * 0.2820948f;
  sh[0].z = 3.5449078f * zh[0].z * 0.2820948f;
  highp float t0 = 2.0466535f * zh[1].x;
  highp float t1 = -0.48860252f * axis.y;
  sh[1].x = t0 * t1;
  highp float t2 = 2.0466535f * zh[1].y;
  sh[1].y = t2 * t1;
  highp float t3 = 2.0466535f * zh[1].z;
  sh[1].z = t3 * t1;
  highp float t4 = 0.48860252f * axis.z;
  sh[2].x = t0 * t4;
  sh[2].y = t2 * t4;
  sh[2].z = t3 * t4;
  highp float t5 = -0.48860252f * axis.x;
  sh[3].x = t0 * t5;
  sh[3].y = t2 * t5;
  sh[3].z = t3 * t5;
}
#endif

#ifndef ZONAL_ORIENT_COLOUR_3
#define ZONAL_ORIENT_COLOUR_3
// A zonal lobe turned to an axis, a unit vector. For colours.
// 52 operations: 3 additions, 49 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_orient_colour_3(in highp vec3 zh[3], highp vec3 axis, out highp vec3 sh[9]) {
  sh[0].x = 3.5449078f * zh[0].x * 0.2820948f;
  sh[0].y = 3.5449078f * zh[0].y * 0.2820948f;
  sh[0].z = 3.5449078f * zh[0].z * 0.2820948f;
  highp float t0 = 2.0466535f * zh[1].x;
  highp float t1 = -0.48860252f * axis.y;
  sh[1].x = t0 * t1;
  highp float t2 = 2.0466535f * zh[1].y;
  sh[1].y = t2 * t1;
  highp float t3 = 2.0466535f * zh[1].z;
  sh[1].z = t3 * t1;
  highp float t4 = 0.48860252f * axis.z;
  sh[2].x = t0 * t4;
  sh[2].y = t2 * t4;
  sh[2].z = t3 * t4;
  highp float t5 = -0.48860252f * axis.x;
  sh[3].x = t0 * t5;
  sh[3].y = t2 * t5;
  sh[3].z = t3 * t5;
  highp float t6 = 1.585331f * zh[2].x;
  highp float t7 = axis.y * axis.x;
  highp float t8 = 0.54627424f * (t7 + t7);
  sh[4].x = t6 * t8;
  highp float t9 = 1.585331f * zh[2].y;
  sh[4].y = t9 * t8;
  highp float t10 = 1.585331f * zh[2].z;
  sh[4].z = t10 * t8;
  highp float t11 = -1.0925485f * axis.z;
  highp float t12 = t11 * axis.y;
  sh[5].x = t6 * t12;
  sh[5].y = t9 * t12;
  sh[5].z = t10 * t12;
  highp float t13 = 0.9461747f * (axis.z * axis.z) + -0.31539157f;
  sh[6].x = t6 * t13;
  sh[6].y = t9 * t13;
  sh[6].z = t10 * t13;
  highp float t14 = t11 * axis.x;
  sh[7].x = t6 * t14;
  sh[7].y = t9 * t14;
  sh[7].z = t10 * t14;
  highp float t15 = 0.54627424f * (axis.x * axis.x - axis.y * axis.y);
  sh[8].x = t6 * t15;
  sh[8].y = t9 * t15;
  sh[8].z = t10 * t15;
}
#endif

#ifndef ZONAL_ORIENT_COLOUR_4
#define ZONAL_ORIENT_COLOUR_4
// A zonal lobe turned to an axis, a unit vector. For colours.
// 94 operations: 7 additions, 87 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_orient_colour_4(in highp vec3 zh[4], highp vec3 axis, out highp vec3 sh[16]) {
  sh[0].x = 3.5449078f * zh[0].x * 0.2820948f;
  sh[0].y = 3.5449078f * zh[0].y * 0.2820948f;
  sh[0].z = 3.5449078f * zh[0].z * 0.2820948f;
  highp float t0 = 2.0466535f * zh[1].x;
  highp float t1 = -0.48860252f * axis.y;
  sh[1].x = t0 * t1;
  highp float t2 = 2.0466535f * zh[1].y;
  sh[1].y = t2 * t1;
  highp float t3 = 2.0466535f * zh[1].z;
  sh[1].z = t3 * t1;
  highp float t4 = 0.48860252f * axis.z;
  sh[2].x = t0 * t4;
  sh[2].y = t2 * t4;
  sh[2].z = t3 * t4;
  highp float t5 = -0.48860252f * axis.x;
  sh[3].x = t0 * t5;
  sh[3].y = t2 * t5;
  sh[3].z = t3 * t5;
  highp float t6 = 1.585331f * zh[2].x;
  highp float t7 = axis.y * axis.x;
  highp float t8 = t7 + t7;
  highp float t9 = 0.54627424f * t8;
  sh[4].x = t6 * t9;
  highp float t10 = 1.585331f * zh[2].y;
  sh[4].y = t10 * t9;
  highp float t11 = 1.585331f * zh[2].z;
  sh[4].z = t11 * t9;
  highp float t12 = -1.0925485f * axis.z;
  highp float t13 = t12 * axis.y;
  sh[5].x = t6 * t13;
  sh[5].y = t10 * t13;
  sh[5].z = t11 * t13;
  highp float t14 = axis.z * axis.z;
  highp float t15 = 0.9461747f * t14 + -0.31539157f;
  sh[6].x = t6 * t15;
  sh[6].y = t10 * t15;
  sh[6].z = t11 * t15;
  highp float t16 = t12 * axis.x;
  sh[7].x = t6 * t16;
  sh[7].y = t10 * t16;
  sh[7].z = t11 * t16;
  highp float t17 = axis.x * axis.x - axis.y * axis.y;
  highp float t18 = 0.54627424f * t17;
  sh[8].x = t6 * t18;
  sh[8].y = t10 * t18;
  sh[8].z = t11 * t18;
  highp float t19 = 1.3398491f * zh[3].x;
  highp float t20 = -0.5900436f * (axis.x * t8 + axis.y * t17);
  sh[9].x = t19 * t20;
  highp float t21 = 1.3398491f * zh[3].y;
  sh[9].y = t21 * t20;
  highp float t22 = 1.3398491f * zh[3].z;
  sh[9].z = t22 * t20;
  highp float t23 = 1.4453057f * axis.z;
  highp float t24 = t23 * t8;
  sh[10].x = t19 * t24;
  sh[10].y = t21 * t24;
  sh[10].z = t22 * t24;
  highp float t25 = -2.285229f * t14 + 0.4570458f;
  highp float t26 = t25 * axis.y;
  sh[11].x = t19 * t26;
  sh[11].y = t21 * t26;
  sh[11].z = t22 * t26;
  highp float t27 = axis.z * (1.8658817f * t14 + -1.119529f);
  sh[12].x = t19 * t27;
  sh[12].y = t21 * t27;
  sh[12].z = t22 * t27;
  highp float t28 = t25 * axis.x;
  sh[13].x = t19 * t28;
  sh[13].y = t21 * t28;
  sh[13].z = t22 * t28;
  highp float t29 = t23 * t17;
  sh[14].x = t19 * t29;
  sh[14].y = t21 * t29;
  sh[14].z = t22 * t29;
  highp float t30 = -0.5900436f * (axis.x * t17 - axis.y * t8);
  sh[15].x = t19 * t30;
  sh[15].y = t21 * t30;
  sh[15].z = t22 * t30;
}
#endif

#ifndef ZONAL_ORIENT_COLOUR_5
#define ZONAL_ORIENT_COLOUR_5
// A zonal lobe turned to an axis, a unit vector. For colours.
// 148 operations: 12 additions, 136 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_orient_colour_5(in highp vec3 zh[5], highp vec3 axis, out highp vec3 sh[25]) {
  sh[0].x = 3.5449078f * zh[0].x * 0.2820948f;
  sh[0].y = 3.5449078f * zh[0].y * 0.2820948f;
  sh[0].z = 3.5449078f * zh[0].z * 0.2820948f;
  highp float t0 = 2.0466535f * zh[1].x;
  highp float t1 = -0.48860252f * axis.y;
  sh[1].x = t0 * t1;
  highp float t2 = 2.0466535f * zh[1].y;
  sh[1].y = t2 * t1;
  highp float t3 = 2.0466535f * zh[1].z;
  sh[1].z = t3 * t1;
  highp float t4 = 0.48860252f * axis.z;
  sh[2].x = t0 * t4;
  sh[2].y = t2 * t4;
  sh[2].z = t3 * t4;
  highp float t5 = -0.48860252f * axis.x;
  sh[3].x = t0 * t5;
  sh[3].y = t2 * t5;
  sh[3].z = t3 * t5;
  highp float t6 = 1.585331f * zh[2].x;
  highp float t7 = axis.y * axis.x;
  highp float t8 = t7 + t7;
  highp float t9 = 0.54627424f * t8;
  sh[4].x = t6 * t9;
  highp float t10 = 1.585331f * zh[2].y;
  sh[4].y = t10 * t9;
  highp float t11 = 1.585331f * zh[2].z;
  sh[4].z = t11 * t9;
  highp float t12 = -1.0925485f * axis.z;
  highp float t13 = t12 * axis.y;
  sh[5].x = t6 * t13;
  sh[5].y = t10 * t13;
  sh[5].z = t11 * t13;
  highp float t14 = axis.z * axis.z;
  highp float t15 = 0.9461747f * t14 + -0.31539157f;
  sh[6].x = t6 * t15;
  sh[6].y = t10 * t15;
  sh[6].z = t11 * t15;
  highp float t16 = t12 * axis.x;
  sh[7].x = t6 * t16;
  sh[7].y = t10 * t16;
  sh[7].z = t11 * t16;
  highp float t17 = axis.x * axis.x - axis.y * axis.y;
  highp float t18 = 0.54627424f * t17;
  sh[8].x = t6 * t18;
  sh[8].y = t10 * t18;
  sh[8].z = t11 * t18;
  highp float t19 = 1.3398491f * zh[3].x;
  highp float t20 = axis.x * t8 + axis.y * t17;
  highp float t21 = -0.5900436f * t20;
  sh[9].x = t19 * t21;
  highp float t22 = 1.3398491f * zh[3].y;
  sh[9].y = t22 * t21;
  highp float t23 = 1.3398491f * zh[3].z;
  sh[9].z = t23 * t21;
  highp float t24 = 1.4453057f * axis.z;
  highp float t25 = t24 * t8;
  sh[10].x = t19 * t25;
  sh[10].y = t22 * t25;
  sh[10].z = t23 * t25;
  highp float t26 = -2.285229f * t14 + 0.4570458f;
  highp float t27 = t26 * axis.y;
  sh[11].x = t19 * t27;
  sh[11].y = t22 * t27;
  sh[11].z = t23 * t27;
  highp float t28 = axis.z * (1.8658817f * t14 + -1.119529f);
  sh[12].x = t19 * t28;
  sh[12].y = t22 * t28;
  sh[12].z = t23 * t28;
  highp float t29 = t26 * axis.x;
  sh[13].x = t19 * t29;
  sh[13].y = t22 * t29;
  sh[13].z = t23 * t29;
  highp float t30 = t24 * t17;
  sh[14].x = t19 * t30;
  sh[14].y = t22 * t30;
  sh[14].z = t23 * t30;
  highp float t31 = axis.x * t17 - axis.y * t8;
  highp float t32 = -0.5900436f * t31;
  sh[15].x = t19 * t32;
  sh[15].y = t22 * t32;
  sh[15].z = t23 * t32;
  highp float t33 = 1.1816359f * zh[4].x;
  highp float t34 = 0.6258357f * (axis.x * t20 + axis.y * t31);
  sh[16].x = t33 * t34;
  highp float t35 = 1.1816359f * zh[4].y;
  sh[16].y = t35 * t34;
  highp float t36 = 1.1816359f * zh[4].z;
  sh[16].z = t36 * t34;
  highp float t37 = -1.7701308f * axis.z;
  highp float t38 = t37 * t20;
  sh[17].x = t33 * t38;
  sh[17].y = t35 * t38;
  sh[17].z = t36 * t38;
  highp float t39 = 3.3116114f * t14 + -0.47308734f;
  highp float t40 = t39 * t8;
  sh[18].x = t33 * t40;
  sh[18].y = t35 * t40;
  sh[18].z = t36 * t40;
  highp float t41 = axis.z * (-4.683326f * t14 + 2.0071397f);
  highp float t42 = t41 * axis.y;
  sh[19].x = t33 * t42;
  sh[19].y = t35 * t42;
  sh[19].z = t36 * t42;
  highp float t43 = 1.9843135f * axis.z * t28 - 1.0062306f * t15;
  sh[20].x = t33 * t43;
  sh[20].y = t35 * t43;
  sh[20].z = t36 * t43;
  highp float t44 = t41 * axis.x;
  sh[21].x = t33 * t44;
  sh[21].y = t35 * t44;
  sh[21].z = t36 * t44;
  highp float t45 = t39 * t17;
  sh[22].x = t33 * t45;
  sh[22].y = t35 * t45;
  sh[22].z = t36 * t45;
  highp float t46 = t37 * t31;
  sh[23].x = t33 * t46;
  sh[23].y = t35 * t46;
  sh[23].z = t36 * t46;
  highp float t47 = 0.6258357f * (axis.x * t31 - axis.y * t20);
  sh[24].x = t33 * t47;
  sh[24].y = t35 * t47;
  sh[24].z = t36 * t47;
}
#endif

#ifndef ZONAL_DOT_2
#define ZONAL_DOT_2
// The integral of a product: the sum of the products of coefficients.
// 7 operations: 3 additions, 4 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_dot_2(in highp float a[4], in highp float b[4]) {
  highp float value = a[0] * b[0] + a[1] * b[1] + (a[2] * b[2] + a[3] * b[3]);
  return value;
}
#endif

#ifndef ZONAL_DOT_3
#define ZONAL_DOT_3
// The integral of a product: the sum of the products of coefficients.
// 17 operations: 8 additions, 9 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_dot_3(in highp float a[9], in highp float b[9]) {
  highp float t0 = a[0] * b[0] + a[4] * b[4] + a[8] * b[8] + (a[1] * b[1] + a[5] * b[5]) + (a[2] * b[2] + a[6] * b[6] + (a[3] * b[3] + a[7] * b[7]));
  highp float value = t0;
  return value;
}
#endif

#ifndef ZONAL_DOT_4
#define ZONAL_DOT_4
// The integral of a product: the sum of the products of coefficients.
// 31 operations: 15 additions, 16 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_dot_4(in highp float a[16], in highp float b[16]) {
  highp float t0 = a[0] * b[0] + a[4] * b[4] + a[8] * b[8] + a[12] * b[12] + (a[1] * b[1] + a[5] * b[5] + a[9] * b[9] + a[13] * b[13]);
  highp float t1 = a[2] * b[2] + a[6] * b[6] + a[10] * b[10] + a[14] * b[14] + (a[3] * b[3] + a[7] * b[7] + a[11] * b[11] + a[15] * b[15]);
  highp float value = t0 + t1;
  return value;
}
#endif

#ifndef ZONAL_DOT_5
#define ZONAL_DOT_5
// The integral of a product: the sum of the products of coefficients.
// 49 operations: 24 additions, 25 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_dot_5(in highp float a[25], in highp float b[25]) {
  highp float t0 = a[0] * b[0] + a[4] * b[4] + a[8] * b[8] + a[12] * b[12] + a[16] * b[16] + a[20] * b[20];
  highp float t1 = a[1] * b[1] + a[5] * b[5] + a[9] * b[9] + a[13] * b[13] + a[17] * b[17] + a[21] * b[21];
  highp float t2 = a[2] * b[2] + a[6] * b[6] + a[10] * b[10] + a[14] * b[14] + a[18] * b[18];
  highp float t3 = a[3] * b[3] + a[7] * b[7] + a[11] * b[11] + a[15] * b[15] + a[19] * b[19];
  highp float value = t0 + a[24] * b[24] + t1 + (t2 + a[22] * b[22] + (t3 + a[23] * b[23]));
  return value;
}
#endif

#ifndef ZONAL_DOT_COLOUR_2
#define ZONAL_DOT_COLOUR_2
// The integral of a product: the sum of the products of coefficients. For colours.
// 21 operations: 9 additions, 12 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_dot_colour_2(in highp vec3 a[4], in highp float b[4]) {
  highp vec3 value = vec3(a[0].x * b[0] + a[1].x * b[1] + (a[2].x * b[2] + a[3].x * b[3]),
      a[0].y * b[0] + a[1].y * b[1] + (a[2].y * b[2] + a[3].y * b[3]),
      a[0].z * b[0] + a[1].z * b[1] + (a[2].z * b[2] + a[3].z * b[3]));
  return value;
}
#endif

#ifndef ZONAL_DOT_COLOUR_3
#define ZONAL_DOT_COLOUR_3
// The integral of a product: the sum of the products of coefficients. For colours.
// 51 operations: 24 additions, 27 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_dot_colour_3(in highp vec3 a[9], in highp float b[9]) {
  highp float t0 = a[0].x * b[0] + a[4].x * b[4] + a[8].x * b[8] + (a[1].x * b[1] + a[5].x * b[5]);
  highp float t1 = a[0].y * b[0] + a[4].y * b[4] + a[8].y * b[8] + (a[1].y * b[1] + a[5].y * b[5]);
  highp float t2 = a[0].z * b[0] + a[4].z * b[4] + a[8].z * b[8] + (a[1].z * b[1] + a[5].z * b[5]);
  highp vec3 value = vec3(t0 + (a[2].x * b[2] + a[6].x * b[6] + (a[3].x * b[3] + a[7].x * b[7])),
      t1 + (a[2].y * b[2] + a[6].y * b[6] + (a[3].y * b[3] + a[7].y * b[7])),
      t2 + (a[2].z * b[2] + a[6].z * b[6] + (a[3].z * b[3] + a[7].z * b[7])));
  return value;
}
#endif

#ifndef ZONAL_DOT_COLOUR_4
#define ZONAL_DOT_COLOUR_4
// The integral of a product: the sum of the products of coefficients. For colours.
// 93 operations: 45 additions, 48 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_dot_colour_4(in highp vec3 a[16], in highp float b[16]) {
  highp float t0 = a[0].x * b[0] + a[4].x * b[4] + a[8].x * b[8] + a[12].x * b[12] + (a[1].x * b[1] + a[5].x * b[5] + a[9].x * b[9] + a[13].x * b[13]);
  highp float t1 = a[2].x * b[2] + a[6].x * b[6] + a[10].x * b[10] + a[14].x * b[14] + (a[3].x * b[3] + a[7].x * b[7] + a[11].x * b[11] + a[15].x * b[15]);
  highp float t2 = a[0].y * b[0] + a[4].y * b[4] + a[8].y * b[8] + a[12].y * b[12] + (a[1].y * b[1] + a[5].y * b[5] + a[9].y * b[9] + a[13].y * b[13]);
  highp float t3 = a[2].y * b[2] + a[6].y * b[6] + a[10].y * b[10] + a[14].y * b[14] + (a[3].y * b[3] + a[7].y * b[7] + a[11].y * b[11] + a[15].y * b[15]);
  highp float t4 = a[0].z * b[0] + a[4].z * b[4] + a[8].z * b[8] + a[12].z * b[12] + (a[1].z * b[1] + a[5].z * b[5] + a[9].z * b[9] + a[13].z * b[13]);
  highp float t5 = a[2].z * b[2] + a[6].z * b[6] + a[10].z * b[10] + a[14].z * b[14] + (a[3].z * b[3] + a[7].z * b[7] + a[11].z * b[11] + a[15].z * b[15]);
  highp vec3 value = vec3(t0 + t1, t2 + t3, t4 + t5);
  return value;
}
#endif

#ifndef ZONAL_DOT_COLOUR_5
#define ZONAL_DOT_COLOUR_5
// The integral of a product: the sum of the products of coefficients. For colours.
// 147 operations: 72 additions, 75 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_dot_colour_5(in highp vec3 a[25], in highp float b[25]) {
  highp float t0 = a[0].x * b[0] + a[4].x * b[4] + a[8].x * b[8] + a[12].x * b[12] + a[16].x * b[16];
  highp float t1 = a[1].x * b[1] + a[5].x * b[5] + a[9].x * b[9] + a[13].x * b[13] + a[17].x * b[17];
  highp float t2 = a[2].x * b[2] + a[6].x * b[6] + a[10].x * b[10] + a[14].x * b[14] + a[18].x * b[18];
  highp float t3 = a[3].x * b[3] + a[7].x * b[7] + a[11].x * b[11] + a[15].x * b[15] + a[19].x * b[19];
  highp float t4 = t0 + a[20].x * b[20] + a[24].x * b[24] + (t1 + a[21].x * b[21]) + (t2 + a[22].x * b[22] + (t3 + a[23].x * b[23]));
  highp float t5 = a[0].y * b[0] + a[4].y * b[4] + a[8].y * b[8] + a[12].y * b[12] + a[16].y * b[16];
  highp float t6 = a[1].y * b[1] + a[5].y * b[5] + a[9].y * b[9] + a[13].y * b[13] + a[17].y * b[17];
  highp float t7 = a[2].y * b[2] + a[6].y * b[6] + a[10].y * b[10] + a[14].y * b[14] + a[18].y * b[18];
  highp float t8 = a[3].y * b[3] + a[7].y * b[7] + a[11].y * b[11] + a[15].y * b[15] + a[19].y * b[19];
  highp float t9 = t5 + a[20].y * b[20] + a[24].y * b[24] + (t6 + a[21].y * b[21]) + (t7 + a[22].y * b[22] + (t8 + a[23].y * b[23]));
  highp float t10 = a[0].z * b[0] + a[4].z * b[4] + a[8].z * b[8] + a[12].z * b[12] + a[16].z * b[16];
  highp float t11 = a[1].z * b[1] + a[5].z * b[5] + a[9].z * b[9] + a[13].z * b[13] + a[17].z * b[17];
  highp float t12 = a[2].z * b[2] + a[6].z * b[6] + a[10].z * b[10] + a[14].z * b[14] + a[18].z * b[18];
  highp float t13 = a[3].z * b[3] + a[7].z * b[7] + a[11].z * b[11] + a[15].z * b[15] + a[19].z * b[19];
  highp float t14 = t10 + a[20].z * b[20] + a[24].z * b[24] + (t11 + a[21].z * b[21]) + (t12 + a[22].z * b[22] + (t13 + a[23].z * b[23]));
  highp vec3 value = vec3(t4, t9, t14);
  return value;
}
#endif

#ifndef ZONAL_DOT_COLOURS_2
#define ZONAL_DOT_COLOURS_2
// The integral of a product: the sum of the products of coefficients. For colours by colours.
// 21 operations: 9 additions, 12 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_dot_colours_2(in highp vec3 a[4], in highp vec3 b[4]) {
  highp vec3 value = vec3(a[0].x * b[0].x + a[1].x * b[1].x + (a[2].x * b[2].x + a[3].x * b[3].x),
      a[0].y * b[0].y + a[1].y * b[1].y + (a[2].y * b[2].y + a[3].y * b[3].y),
      a[0].z * b[0].z + a[1].z * b[1].z + (a[2].z * b[2].z + a[3].z * b[3].z));
  return value;
}
#endif

#ifndef ZONAL_DOT_COLOURS_3
#define ZONAL_DOT_COLOURS_3
// The integral of a product: the sum of the products of coefficients. For colours by colours.
// 51 operations: 24 additions, 27 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_dot_colours_3(in highp vec3 a[9], in highp vec3 b[9]) {
  highp float t0 = a[0].x * b[0].x + a[4].x * b[4].x + a[8].x * b[8].x + (a[1].x * b[1].x + a[5].x * b[5].x);
  highp float t1 = t0 + (a[2].x * b[2].x + a[6].x * b[6].x + (a[3].x * b[3].x + a[7].x * b[7].x));
  highp float t2 = a[0].y * b[0].y + a[4].y * b[4].y + a[8].y * b[8].y + (a[1].y * b[1].y + a[5].y * b[5].y);
  highp float t3 = t2 + (a[2].y * b[2].y + a[6].y * b[6].y + (a[3].y * b[3].y + a[7].y * b[7].y));
  highp float t4 = a[0].z * b[0].z + a[4].z * b[4].z + a[8].z * b[8].z + (a[1].z * b[1].z + a[5].z * b[5].z);
  highp float t5 = t4 + (a[2].z * b[2].z + a[6].z * b[6].z + (a[3].z * b[3].z + a[7].z * b[7].z));
  highp vec3 value = vec3(t1, t3, t5);
  return value;
}
#endif

#ifndef ZONAL_DOT_COLOURS_4
#define ZONAL_DOT_COLOURS_4
// The integral of a product: the sum of the products of coefficients. For colours by colours.
// 93 operations: 45 additions, 48 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_dot_colours_4(in highp vec3 a[16], in highp vec3 b[16]) {
  highp float t0 = a[0].x * b[0].x + a[4].x * b[4].x + a[8].x * b[8].x + a[12].x * b[12].x + (a[1].x * b[1].x + a[5].x * b[5].x + a[9].x * b[9].x + a[13].x * b[13].x);
  highp float t1 = a[2].x * b[2].x + a[6].x * b[6].x + a[10].x * b[10].x + a[14].x * b[14].x;
  highp float t2 = a[3].x * b[3].x + a[7].x * b[7].x + a[11].x * b[11].x + a[15].x * b[15].x;
  highp float t3 = a[0].y * b[0].y + a[4].y * b[4].y + a[8].y * b[8].y + a[12].y * b[12].y + (a[1].y * b[1].y + a[5].y * b[5].y + a[9].y * b[9].y + a[13].y * b[13].y);
  highp float t4 = a[2].y * b[2].y + a[6].y * b[6].y + a[10].y * b[10].y + a[14].y * b[14].y;
  highp float t5 = a[3].y * b[3].y + a[7].y * b[7].y + a[11].y * b[11].y + a[15].y * b[15].y;
  highp float t6 = a[0].z * b[0].z + a[4].z * b[4].z + a[8].z * b[8].z + a[12].z * b[12].z + (a[1].z * b[1].z + a[5].z * b[5].z + a[9].z * b[9].z + a[13].z * b[13].z);
  highp float t7 = a[2].z * b[2].z + a[6].z * b[6].z + a[10].z * b[10].z + a[14].z * b[14].z;
  highp float t8 = a[3].z * b[3].z + a[7].z * b[7].z + a[11].z * b[11].z + a[15].z * b[15].z;
  highp vec3 value = vec3(t0 + (t1 + t2), t3 + (t4 + t5), t6 + (t7 + t8));
  return value;
}
#endif

#ifndef ZONAL_DOT_COLOURS_5
#define ZONAL_DOT_COLOURS_5
// The integral of a product: the sum of the products of coefficients. For colours by colours.
// 147 operations: 72 additions, 75 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_dot_colours_5(in highp vec3 a[25], in highp vec3 b[25]) {
  highp float t0 = a[0].x * b[0].x + a[4].x * b[4].x + a[8].x * b[8].x + a[12].x * b[12].x + a[16].x * b[16].x;
  highp float t1 = a[1].x * b[1].x + a[5].x * b[5].x + a[9].x * b[9].x + a[13].x * b[13].x + a[17].x * b[17].x;
  highp float t2 = a[2].x * b[2].x + a[6].x * b[6].x + a[10].x * b[10].x + a[14].x * b[14].x;
  highp float t3 = a[3].x * b[3].x + a[7].x * b[7].x + a[11].x * b[11].x + a[15].x * b[15].x;
  highp float t4 = t2 + a[18].x * b[18].x + a[22].x * b[22].x + (t3 + a[19].x * b[19].x + a[23].x * b[23].x);
  highp float t5 = t0 + a[20].x * b[20].x + a[24].x * b[24].x + (t1 + a[21].x * b[21].x) + t4;
  highp float t6 = a[0].y * b[0].y + a[4].y * b[4].y + a[8].y * b[8].y + a[12].y * b[12].y + a[16].y * b[16].y;
  highp float t7 = a[1].y * b[1].y + a[5].y * b[5].y + a[9].y * b[9].y + a[13].y * b[13].y + a[17].y * b[17].y;
  highp float t8 = a[2].y * b[2].y + a[6].y * b[6].y + a[10].y * b[10].y + a[14].y * b[14].y;
  highp float t9 = a[3].y * b[3].y + a[7].y * b[7].y + a[11].y * b[11].y + a[15].y * b[15].y;
  highp float t10 = t8 + a[18].y * b[18].y + a[22].y * b[22].y + (t9 + a[19].y * b[19].y + a[23].y * b[23].y);
  highp float t11 = t6 + a[20].y * b[20].y + a[24].y * b[24].y + (t7 + a[21].y * b[21].y) + t10;
  highp float t12 = a[0].z * b[0].z + a[4].z * b[4].z + a[8].z * b[8].z + a[12].z * b[12].z + a[16].z * b[16].z;
  highp float t13 = a[1].z * b[1].z + a[5].z * b[5].z + a[9].z * b[9].z + a[13].z * b[13].z + a[17].z * b[17].z;
  highp float t14 = a[2].z * b[2].z + a[6].z * b[6].z + a[10].z * b[10].z + a[14].z * b[14].z;
  highp float t15 = a[3].z * b[3].z + a[7].z * b[7].z + a[11].z * b[11].z + a[15].z * b[15].z;
  highp float t16 = t14 + a[18].z * b[18].z + a[22].z * b[22].z + (t15 + a[19].z * b[19].z + a[23].z * b[23].z);
  highp float t17 = t12 + a[20].z * b[20].z + a[24].z * b[24].z + (t13 + a[21].z * b[21].z) + t16;
  highp vec3 value = vec3(t5, t11, t17);
  return value;
}
#endif

#ifndef ZONAL_CONVOLVE_2
#define ZONAL_CONVOLVE_2
// Convolution with a zonal kernel.
// 6 operations: 0 additions, 6 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_convolve_2(in highp float sh[4], in highp float kernel[2], out highp float result[4]) {
  result[0] = sh[0] * (3.5449078f * kernel[0]);
  highp float t0 = 2.0466535f * kernel[1];
  result[1] = sh[1] * t0;
  result[2] = sh[2] * t0;
  result[3] = sh[3] * t0;
}
#endif

#ifndef ZONAL_CONVOLVE_3
#define ZONAL_CONVOLVE_3
// Convolution with a zonal kernel.
// 12 operations: 0 additions, 12 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_convolve_3(in highp float sh[9], in highp float kernel[3], out highp float result[9]) {
  result[0] = sh[0] * (3.5449078f * kernel[0]);
  highp float t0 = 2.0466535f * kernel[1];
  result[1] = sh[1] * t0;
  result[2] = sh[2] * t0;
  result[3] = sh[3] * t0;
  highp float t1 = 1.585331f * kernel[2];
  result[4] = sh[4] * t1;
  result[5] = sh[5] * t1;
  result[6] = sh[6] * t1;
  result[7] = sh[7] * t1;
  result[8] = sh[8] * t1;
}
#endif

#ifndef ZONAL_CONVOLVE_4
#define ZONAL_CONVOLVE_4
// Convolution with a zonal kernel.
// 20 operations: 0 additions, 20 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_convolve_4(in highp float sh[16], in highp float kernel[4], out highp float result[16]) {
  result[0] = sh[0] * (3.5449078f * kernel[0]);
  highp float t0 = 2.0466535f * kernel[1];
  result[1] = sh[1] * t0;
  result[2] = sh[2] * t0;
  result[3] = sh[3] * t0;
  highp float t1 = 1.585331f * kernel[2];
  result[4] = sh[4] * t1;
  result[5] = sh[5] * t1;
  result[6] = sh[6] * t1;
  result[7] = sh[7] * t1;
  result[8] = sh[8] * t1;
  highp float t2 = 1.3398491f * kernel[3];
  result[9] = sh[9] * t2;
  result[10] = sh[10] * t2;
  result[11] = sh[11] * t2;
  result[12] = sh[12] * t2;
  result[13] = sh[13] * t2;
  result[14] = sh[14] * t2;
  result[15] = sh[15] * t2;
}
#endif

#ifndef ZONAL_CONVOLVE_5
#define ZONAL_CONVOLVE_5
// Convolution with a zonal kernel.
// 30 operations: 0 additions, 30 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_convolve_5(in highp float sh[25], in highp float kernel[5], out highp float result[25]) {
  result[0] = sh[0] * (3.5449078f * kernel[0]);
  highp float t0 = 2.0466535f * kernel[1];
  result[1] = sh[1] * t0;
  result[2] = sh[2] * t0;
  result[3] = sh[3] * t0;
  highp float t1 = 1.585331f * kernel[2];
  result[4] = sh[4] * t1;
  result[5] = sh[5] * t1;
  result[6] = sh[6] * t1;
  result[7] = sh[7] * t1;
  result[8] = sh[8] * t1;
  highp float t2 = 1.3398491f * kernel[3];
  result[9] = sh[9] * t2;
  result[10] = sh[10] * t2;
  result[11] = sh[11] * t2;
  result[12] = sh[12] * t2;
  result[13] = sh[13] * t2;
  result[14] = sh[14] * t2;
  result[15] = sh[15] * t2;
  highp float t3 = 1.1816359f * kernel[4];
  result[16] = sh[16] * t3;
  result[17] = sh[17] * t3;
  result[18] = sh[18] * t3;
  result[19] = sh[19] * t3;
  result[20] = sh[20] * t3;
  result[21] = sh[21] * t3;
  result[22] = sh[22] * t3;
  result[23] = sh[23] * t3;
  result[24] = sh[24] * t3;
}
#endif

#ifndef ZONAL_CONVOLVE_COLOUR_2
#define ZONAL_CONVOLVE_COLOUR_2
// Convolution with a zonal kernel. For colours.
// 14 operations: 0 additions, 14 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_convolve_colour_2(in highp vec3 sh[4], in highp float kernel[2], out highp vec3 result[4]) {
  highp float t0 = 3.5449078f * kernel[0];
  result[0].x = sh[0].x * t0;
  result[0].y = sh[0].y * t0;
  result[0].z = sh[0].z * t0;
  highp float t1 = 2.0466535f * kernel[1];
  result[1].x = sh[1].x * t1;
  result[1].y = sh[1].y * t1;
  result[1].z = sh[1].z * t1;
  result[2].x = sh[2].x * t1;
  result[2].y = sh[2].y * t1;
  result[2].z = sh[2].z * t1;
  result[3].x = sh[3].x * t1;
  result[3].y = sh[3].y * t1;
  result[3].z = sh[3].z * t1;
}
#endif

#ifndef ZONAL_CONVOLVE_COLOUR_3
#define ZONAL_CONVOLVE_COLOUR_3
// Convolution with a zonal kernel. For colours.
// 30 operations: 0 additions, 30 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_convolve_colour_3(in highp vec3 sh[9], in highp float kernel[3], out highp vec3 result[9]) {
  highp float t0 = 3.5449078f * kernel[0];
  result[0].x = sh[0].x * t0;
  result[0].y = sh[0].y * t0;
  result[0].z = sh[0].z * t0;
  highp float t1 = 2.0466535f * kernel[1];
  result[1].x = sh[1].x * t1;
  result[1].y = sh[1].y * t1;
  result[1].z = sh[1].z * t1;
  result[2].x = sh[2].x * t1;
  result[2].y = sh[2].y * t1;
  result[2].z = sh[2].z * t1;
  result[3].x = sh[3].x * t1;
  result[3].y = sh[3].y * t1;
  result[3].z = sh[3].z * t1;
  highp float t2 = 1.585331f * kernel[2];
  result[4].x = sh[4].x * t2;
  result[4].y = sh[4].y * t2;
  result[4].z = sh[4].z * t2;
  result[5].x = sh[5].x * t2;
  result[5].y = sh[5].y * t2;
  result[5].z = sh[5].z * t2;
  result[6].x = sh[6].x * t2;
  result[6].y = sh[6].y * t2;
  result[6].z = sh[6].z * t2;
  result[7].x = sh[7].x * t2;
  result[7].y = sh[7].y * t2;
  result[7].z = sh[7].z * t2;
  result[8].x = sh[8].x * t2;
  result[8].y = sh[8].y * t2;
  result[8].z = sh[8].z * t2;
}
#endif

#ifndef ZONAL_CONVOLVE_COLOUR_4
#define ZONAL_CONVOLVE_COLOUR_4
// Convolution with a zonal kernel. For colours.
// 52 operations: 0 additions, 52 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_convolve_colour_4(in highp vec3 sh[16], in highp float kernel[4], out highp vec3 result[16]) {
  highp float t0 = 3.5449078f * kernel[0];
  result[0].x = sh[0].x * t0;
  result[0].y = sh[0].y * t0;
  result[0].z = sh[0].z * t0;
  highp float t1 = 2.0466535f * kernel[1];
  result[1].x = sh[1].x * t1;
  result[1].y = sh[1].y * t1;
  result[1].z = sh[1].z * t1;
  result[2].x = sh[2].x * t1;
  result[2].y = sh[2].y * t1;
  result[2].z = sh[2].z * t1;
  result[3].x = sh[3].x * t1;
  result[3].y = sh[3].y * t1;
  result[3].z = sh[3].z * t1;
  highp float t2 = 1.585331f * kernel[2];
  result[4].x = sh[4].x * t2;
  result[4].y = sh[4].y * t2;
  result[4].z = sh[4].z * t2;
  result[5].x = sh[5].x * t2;
  result[5].y = sh[5].y * t2;
  result[5].z = sh[5].z * t2;
  result[6].x = sh[6].x * t2;
  result[6].y = sh[6].y * t2;
  result[6].z = sh[6].z * t2;
  result[7].x = sh[7].x * t2;
  result[7].y = sh[7].y * t2;
  result[7].z = sh[7].z * t2;
  result[8].x = sh[8].x * t2;
  result[8].y = sh[8].y * t2;
  result[8].z = sh[8].z * t2;
  highp float t3 = 1.3398491f * kernel[3];
  result[9].x = sh[9].x * t3;
  result[9].y = sh[9].y * t3;
  result[9].z = sh[9].z * t3;
  result[10].x = sh[10].x * t3;
  result[10].y = sh[10].y * t3;
  result[10].z = sh[10].z * t3;
  result[11].x = sh[11].x * t3;
  result[11].y = sh[11].y * t3;
  result[11].z = sh[11].z * t3;
  result[12].x = sh[12].x * t3;
  result[12].y = sh[12].y * t3;
  result[12].z = sh[12].z * t3;
  result[13].x = sh[13].x * t3;
  result[13].y = sh[13].y * t3;
  result[13].z = sh[13].z * t3;
  result[14].x = sh[14].x * t3;
  result[14].y = sh[14].y * t3;
  result[14].z = sh[14].z * t3;
  result[15].x = sh[15].x * t3;
  result[15].y = sh[15].y * t3;
  result[15].z = sh[15].z * t3;
}
#endif

#ifndef ZONAL_CONVOLVE_COLOUR_5
#define ZONAL_CONVOLVE_COLOUR_5
// Convolution with a zonal kernel. For colours.
// 80 operations: 0 additions, 80 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_convolve_colour_5(in highp vec3 sh[25], in highp float kernel[5], out highp vec3 result[25]) {
  highp float t0 = 3.5449078f * kernel[0];
  result[0].x = sh[0].x * t0;
  result[0].y = sh[0].y * t0;
  result[0].z = sh[0].z * t0;
  highp float t1 = 2.0466535f * kernel[1];
  result[1].x = sh[1].x * t1;
  result[1].y = sh[1].y * t1;
  result[1].z = sh[1].z * t1;
  result[2].x = sh[2].x * t1;
  result[2].y = sh[2].y * t1;
  result[2].z = sh[2].z * t1;
  result[3].x = sh[3].x * t1;
  result[3].y = sh[3].y * t1;
  result[3].z = sh[3].z * t1;
  highp float t2 = 1.585331f * kernel[2];
  result[4].x = sh[4].x * t2;
  result[4].y = sh[4].y * t2;
  result[4].z = sh[4].z * t2;
  result[5].x = sh[5].x * t2;
  result[5].y = sh[5].y * t2;
  result[5].z = sh[5].z * t2;
  result[6].x = sh[6].x * t2;
  result[6].y = sh[6].y * t2;
  result[6].z = sh[6].z * t2;
  result[7].x = sh[7].x * t2;
  result[7].y = sh[7].y * t2;
  result[7].z = sh[7].z * t2;
  result[8].x = sh[8].x * t2;
  result[8].y = sh[8].y * t2;
  result[8].z = sh[8].z * t2;
  highp float t3 = 1.3398491f * kernel[3];
  result[9].x = sh[9].x * t3;
  result[9].y = sh[9].y * t3;
  result[9].z = sh[9].z * t3;
  result[10].x = sh[10].x * t3;
  result[10].y = sh[10].y * t3;
  result[10].z = sh[10].z * t3;
  result[11].x = sh[11].x * t3;
  result[11].y = sh[11].y * t3;
  result[11].z = sh[11].z * t3;
  result[12].x = sh[12].x * t3;
  result[12].y = sh[12].y * t3;
  result[12].z = sh[12].z * t3;
  result[13].x = sh[13].x * t3;
  result[13].y = sh[13].y * t3;
  result[13].z = sh[13].z * t3;
  result[14].x = sh[14].x * t3;
  result[14].y = sh[14].y * t3;
  result[14].z = sh[14].z * t3;
  result[15].x = sh[15].x * t3;
  result[15].y = sh[15].y * t3;
  result[15].z = sh[15].z * t3;
  highp float t4 = 1.1816359f * kernel[4];
  result[16].x = sh[16].x * t4;
  result[16].y = sh[16].y * t4;
  result[16].z = sh[16].z * t4;
  result[17].x = sh[17].x * t4;
  result[17].y = sh[17].y * t4;
  result[17].z = sh[17].z * t4;
  result[18].x = sh[18].x * t4;
  result[18].y = sh[18].y * t4;
  result[18].z = sh[18].z * t4;
  result[19].x = sh[19].x * t4;
  result[19].y = sh[19].y * t4;
  result[19].z = sh[19].z * t4;
  result[20].x = sh[20].x * t4;
  result[20].y = sh[20].y * t4;
  result[20].z = sh[20].z * t4;
  result[21].x = sh[21].x * t4;
  result[21].y = sh[21].y * t4;
  result[21].z = sh[21].z * t4;
  result[22].x = sh[22].x * t4;
  result[22].y = sh[22].y * t4;
  result[22].z = sh[22].z * t4;
  result[23].x = sh[23].x * t4;
  result[23].y = sh[23].y * t4;
  result[23].z = sh[23].z * t4;
  result[24].x = sh[24].x * t4;
  result[24].y = sh[24].y * t4;
  result[24].z = sh[24].z * t4;
}
#endif

#ifndef ZONAL_LAMBERT_2
#define ZONAL_LAMBERT_2
// Zonal coefficients of the clamped cosine over pi.
// 0 operations: 0 additions, 0 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_lambert_2(out highp float z[2]) {
  z[0] = 0.2820948f;
  z[1] = 0.325735f;
}
#endif

#ifndef ZONAL_LAMBERT_3
#define ZONAL_LAMBERT_3
// Zonal coefficients of the clamped cosine over pi.
// 0 operations: 0 additions, 0 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_lambert_3(out highp float z[3]) {
  z[0] = 0.2820948f;
  z[1] = 0.325735f;
  z[2] = 0.15769579f;
}
#endif

#ifndef ZONAL_LAMBERT_4
#define ZONAL_LAMBERT_4
// Zonal coefficients of the clamped cosine over pi.
// 0 operations: 0 additions, 0 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_lambert_4(out highp float z[4]) {
  z[0] = 0.2820948f;
  z[1] = 0.325735f;
  z[2] = 0.15769579f;
  z[3] = 0.0f;
}
#endif

#ifndef ZONAL_LAMBERT_5
#define ZONAL_LAMBERT_5
// Zonal coefficients of the clamped cosine over pi.
// 0 operations: 0 additions, 0 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_lambert_5(out highp float z[5]) {
  z[0] = 0.2820948f;
  z[1] = 0.325735f;
  z[2] = 0.15769579f;
  z[3] = 0.0f;
  z[4] = -0.03526185f;
}
#endif

#ifndef ZONAL_CAP_2
#define ZONAL_CAP_2
// Zonal coefficients of a spherical cap, by cosine and sine of its half angle.
// 12 operations: 2 additions, 4 multiplications, 1 divisions, 0 square roots, 5 comparisons and choices.
void zonal_cap_2(highp vec2 cap, out highp float z[2]) {
  highp float t0 = abs(cap.x);
  highp float t1 = cap.y * cap.y;
  highp float t2 = 1.0f + t0;
  highp float t3 = 0.88622695f * (2.0f * (0.0f < cap.x ? (t0 < 0.5f ? 1.0f - t0 : t1 / t2) : t2));
  z[0] = t3;
  z[1] = 1.5349901f * t1;
}
#endif

#ifndef ZONAL_CAP_3
#define ZONAL_CAP_3
// Zonal coefficients of a spherical cap, by cosine and sine of its half angle.
// 22 operations: 6 additions, 7 multiplications, 1 divisions, 0 square roots, 8 comparisons and choices.
void zonal_cap_3(highp vec2 cap, out highp float z[3]) {
  bool is_0 = 0.0f < cap.x;
  highp float t1 = abs(cap.x);
  highp float t2 = cap.y * cap.y;
  highp float t3 = 1.0f + t1;
  highp float t4 = t1 < 0.5f ? 1.0f - t1 : t2 / t3;
  z[0] = 0.88622695f * (2.0f * (is_0 ? t4 : t3));
  z[1] = 1.5349901f * t2;
  highp float t5 = 0.33333334f < t1 ? t2 : 0.0f;
  z[2] = 1.9816637f * ((is_0 ? 1.0f : -1.0f) * (t5 + (t2 - t5 + -(t4 * t2))));
}
#endif

#ifndef ZONAL_CAP_4
#define ZONAL_CAP_4
// Zonal coefficients of a spherical cap, by cosine and sine of its half angle.
// 29 operations: 9 additions, 11 multiplications, 1 divisions, 0 square roots, 8 comparisons and choices.
void zonal_cap_4(highp vec2 cap, out highp float z[4]) {
  bool is_0 = 0.0f < cap.x;
  highp float t1 = abs(cap.x);
  highp float t2 = cap.y * cap.y;
  highp float t3 = 1.0f + t1;
  highp float t4 = t1 < 0.5f ? 1.0f - t1 : t2 / t3;
  z[0] = 0.88622695f * (2.0f * (is_0 ? t4 : t3));
  z[1] = 1.5349901f * t2;
  highp float t5 = 0.625f < t1 ? t2 : 0.0f;
  highp float t6 = -(t4 * t2);
  highp float t7 = t2 - t5 + t6;
  highp float t8 = t5 + t7;
  z[2] = 1.9816637f * ((is_0 ? 1.0f : -1.0f) * t8);
  z[3] = 2.344736f * (t5 + (t7 + (0.25f * t6 - 1.25f * (t4 * t8))));
}
#endif

#ifndef ZONAL_CAP_5
#define ZONAL_CAP_5
// Zonal coefficients of a spherical cap, by cosine and sine of its half angle.
// 37 operations: 12 additions, 16 multiplications, 1 divisions, 0 square roots, 8 comparisons and choices.
void zonal_cap_5(highp vec2 cap, out highp float z[5]) {
  bool is_0 = 0.0f < cap.x;
  highp float t1 = abs(cap.x);
  highp float t2 = cap.y * cap.y;
  highp float t3 = 1.0f + t1;
  highp float t4 = t1 < 0.5f ? 1.0f - t1 : t2 / t3;
  z[0] = 0.88622695f * (2.0f * (is_0 ? t4 : t3));
  z[1] = 1.5349901f * t2;
  highp float t5 = is_0 ? 1.0f : -1.0f;
  highp float t6 = 0.76f < t1 ? t2 : 0.0f;
  highp float t7 = -(t4 * t2);
  highp float t8 = t2 - t6 + t7;
  highp float t9 = t6 + t8;
  z[2] = 1.9816637f * (t5 * t9);
  highp float t10 = 0.25f * t7 - 1.25f * (t4 * t9);
  highp float t11 = t8 + t10;
  highp float t12 = t6 + t11;
  z[3] = 2.344736f * t12;
  z[4] = 2.6586807f * (t5 * (t6 + (t11 + (0.4f * t10 - 1.4f * (t4 * t12)))));
}
#endif

#ifndef ZONAL_CAP_UP_TO_HEMISPHERE_2
#define ZONAL_CAP_UP_TO_HEMISPHERE_2
// The same up to the hemisphere, in fewer operations.
// 6 operations: 2 additions, 3 multiplications, 1 divisions, 0 square roots, 0 comparisons and choices.
void zonal_cap_up_to_hemisphere_2(highp vec2 cap, out highp float z[2]) {
  highp float t0 = cap.y * cap.y;
  highp float t1 = t0 / (1.0f + cap.x);
  z[0] = 0.88622695f * (t1 + t1);
  z[1] = 1.5349901f * t0;
}
#endif

#ifndef ZONAL_CAP_UP_TO_HEMISPHERE_3
#define ZONAL_CAP_UP_TO_HEMISPHERE_3
// The same up to the hemisphere, in fewer operations.
// 10 operations: 4 additions, 5 multiplications, 1 divisions, 0 square roots, 0 comparisons and choices.
void zonal_cap_up_to_hemisphere_3(highp vec2 cap, out highp float z[3]) {
  highp float t0 = cap.y * cap.y;
  highp float t1 = t0 / (1.0f + cap.x);
  z[0] = 0.88622695f * (t1 + t1);
  z[1] = 1.5349901f * t0;
  z[2] = 1.9816637f * (t0 + -(t1 * t0));
}
#endif

#ifndef ZONAL_CAP_UP_TO_HEMISPHERE_4
#define ZONAL_CAP_UP_TO_HEMISPHERE_4
// The same up to the hemisphere, in fewer operations.
// 16 operations: 6 additions, 9 multiplications, 1 divisions, 0 square roots, 0 comparisons and choices.
void zonal_cap_up_to_hemisphere_4(highp vec2 cap, out highp float z[4]) {
  highp float t0 = cap.y * cap.y;
  highp float t1 = t0 / (1.0f + cap.x);
  z[0] = 0.88622695f * (t1 + t1);
  z[1] = 1.5349901f * t0;
  highp float t2 = -(t1 * t0);
  highp float t3 = t0 + t2;
  z[2] = 1.9816637f * t3;
  z[3] = 2.344736f * (t3 + (0.25f * t2 - 1.25f * (t1 * t3)));
}
#endif

#ifndef ZONAL_CAP_UP_TO_HEMISPHERE_5
#define ZONAL_CAP_UP_TO_HEMISPHERE_5
// The same up to the hemisphere, in fewer operations.
// 22 operations: 8 additions, 13 multiplications, 1 divisions, 0 square roots, 0 comparisons and choices.
void zonal_cap_up_to_hemisphere_5(highp vec2 cap, out highp float z[5]) {
  highp float t0 = cap.y * cap.y;
  highp float t1 = t0 / (1.0f + cap.x);
  z[0] = 0.88622695f * (t1 + t1);
  z[1] = 1.5349901f * t0;
  highp float t2 = -(t1 * t0);
  highp float t3 = t0 + t2;
  z[2] = 1.9816637f * t3;
  highp float t4 = 0.25f * t2 - 1.25f * (t1 * t3);
  highp float t5 = t3 + t4;
  z[3] = 2.344736f * t5;
  z[4] = 2.6586807f * (t5 + (0.4f * t4 - 1.4f * (t1 * t5)));
}
#endif

#ifndef ZONAL_SPHERE_CAP_2
#define ZONAL_SPHERE_CAP_2
// Zonal coefficients of the cap that a sphere covers, seen from a distance.
// 15 operations: 4 additions, 6 multiplications, 2 divisions, 1 square roots, 2 comparisons and choices.
void zonal_sphere_cap_2(highp float distance, highp float radius, out highp float z[2]) {
  highp float t0 = 1.0f / distance;
  highp float t1 = min(radius * t0, 1.0f);
  highp float t2 = t1 * t1;
  highp float t3 = t2 / (1.0f + sqrt(max(distance - radius, 0.0f) * t0 * (1.0f + t1)));
  z[0] = 0.88622695f * (t3 + t3);
  z[1] = 1.5349901f * t2;
}
#endif

#ifndef ZONAL_SPHERE_CAP_3
#define ZONAL_SPHERE_CAP_3
// Zonal coefficients of the cap that a sphere covers, seen from a distance.
// 19 operations: 6 additions, 8 multiplications, 2 divisions, 1 square roots, 2 comparisons and choices.
void zonal_sphere_cap_3(highp float distance, highp float radius, out highp float z[3]) {
  highp float t0 = 1.0f / distance;
  highp float t1 = min(radius * t0, 1.0f);
  highp float t2 = t1 * t1;
  highp float t3 = t2 / (1.0f + sqrt(max(distance - radius, 0.0f) * t0 * (1.0f + t1)));
  z[0] = 0.88622695f * (t3 + t3);
  z[1] = 1.5349901f * t2;
  z[2] = 1.9816637f * (t2 + -(t3 * t2));
}
#endif

#ifndef ZONAL_SPHERE_CAP_4
#define ZONAL_SPHERE_CAP_4
// Zonal coefficients of the cap that a sphere covers, seen from a distance.
// 25 operations: 8 additions, 12 multiplications, 2 divisions, 1 square roots, 2 comparisons and choices.
void zonal_sphere_cap_4(highp float distance, highp float radius, out highp float z[4]) {
  highp float t0 = 1.0f / distance;
  highp float t1 = min(radius * t0, 1.0f);
  highp float t2 = t1 * t1;
  highp float t3 = t2 / (1.0f + sqrt(max(distance - radius, 0.0f) * t0 * (1.0f + t1)));
  z[0] = 0.88622695f * (t3 + t3);
  z[1] = 1.5349901f * t2;
  highp float t4 = -(t3 * t2);
  highp float t5 = t2 + t4;
  z[2] = 1.9816637f * t5;
  z[3] = 2.344736f * (t5 + (0.25f * t4 - 1.25f * (t3 * t5)));
}
#endif

#ifndef ZONAL_SPHERE_CAP_5
#define ZONAL_SPHERE_CAP_5
// Zonal coefficients of the cap that a sphere covers, seen from a distance.
// 31 operations: 10 additions, 16 multiplications, 2 divisions, 1 square roots, 2 comparisons and choices.
void zonal_sphere_cap_5(highp float distance, highp float radius, out highp float z[5]) {
  highp float t0 = 1.0f / distance;
  highp float t1 = min(radius * t0, 1.0f);
  highp float t2 = t1 * t1;
  highp float t3 = t2 / (1.0f + sqrt(max(distance - radius, 0.0f) * t0 * (1.0f + t1)));
  z[0] = 0.88622695f * (t3 + t3);
  z[1] = 1.5349901f * t2;
  highp float t4 = -(t3 * t2);
  highp float t5 = t2 + t4;
  z[2] = 1.9816637f * t5;
  highp float t6 = 0.25f * t4 - 1.25f * (t3 * t5);
  highp float t7 = t5 + t6;
  z[3] = 2.344736f * t7;
  z[4] = 2.6586807f * (t7 + (0.4f * t6 - 1.4f * (t3 * t7)));
}
#endif

#ifndef ZONAL_PHONG_2
#define ZONAL_PHONG_2
// Zonal coefficients of the cosine power that integrates to 1.
// 4 operations: 2 additions, 1 multiplications, 1 divisions, 0 square roots, 0 comparisons and choices.
void zonal_phong_2(highp float exponent, out highp float z[2]) {
  z[0] = 0.2820948f;
  z[1] = 0.48860252f * ((exponent + 1.0f) / (exponent + 2.0f));
}
#endif

#ifndef ZONAL_PHONG_3
#define ZONAL_PHONG_3
// Zonal coefficients of the cosine power that integrates to 1.
// 7 operations: 3 additions, 2 multiplications, 2 divisions, 0 square roots, 0 comparisons and choices.
void zonal_phong_3(highp float exponent, out highp float z[3]) {
  z[0] = 0.2820948f;
  z[1] = 0.48860252f * ((exponent + 1.0f) / (exponent + 2.0f));
  z[2] = 0.63078314f * (exponent / (exponent + 3.0f));
}
#endif

#ifndef ZONAL_PHONG_4
#define ZONAL_PHONG_4
// Zonal coefficients of the cosine power that integrates to 1.
// 12 operations: 5 additions, 4 multiplications, 3 divisions, 0 square roots, 0 comparisons and choices.
void zonal_phong_4(highp float exponent, out highp float z[4]) {
  z[0] = 0.2820948f;
  highp float t0 = (exponent + 1.0f) / (exponent + 2.0f);
  z[1] = 0.48860252f * t0;
  z[2] = 0.63078314f * (exponent / (exponent + 3.0f));
  z[3] = 0.7463527f * (t0 * ((exponent - 1.0f) / (exponent + 4.0f)));
}
#endif

#ifndef ZONAL_PHONG_5
#define ZONAL_PHONG_5
// Zonal coefficients of the cosine power that integrates to 1.
// 17 operations: 7 additions, 6 multiplications, 4 divisions, 0 square roots, 0 comparisons and choices.
void zonal_phong_5(highp float exponent, out highp float z[5]) {
  z[0] = 0.2820948f;
  highp float t0 = (exponent + 1.0f) / (exponent + 2.0f);
  z[1] = 0.48860252f * t0;
  highp float t1 = exponent / (exponent + 3.0f);
  z[2] = 0.63078314f * t1;
  z[3] = 0.7463527f * (t0 * ((exponent - 1.0f) / (exponent + 4.0f)));
  z[4] = 0.8462844f * (t1 * ((exponent - 2.0f) / (exponent + 5.0f)));
}
#endif

#ifndef ZONAL_SPHERICAL_GAUSSIAN_2
#define ZONAL_SPHERICAL_GAUSSIAN_2
// Zonal coefficients of exp(sharpness (cos theta - 1)).
// 162 operations: 52 additions, 52 multiplications, 20 divisions, 1 square roots, 37 comparisons and choices.
void zonal_spherical_gaussian_2(highp float sharpness, out highp float z[2]) {
  highp float t0 = sharpness / (16.0f + sqrt(272.0f + sharpness * sharpness));
  highp float t1 = sharpness / (31.0f + sharpness * t0);
  highp float t2 = sharpness / (29.0f + sharpness * t1);
  highp float t3 = sharpness / (27.0f + sharpness * t2);
  highp float t4 = sharpness / (25.0f + sharpness * t3);
  highp float t5 = sharpness / (23.0f + sharpness * t4);
  highp float t6 = sharpness / (21.0f + sharpness * t5);
  highp float t7 = sharpness / (19.0f + sharpness * t6);
  highp float t8 = sharpness / (17.0f + sharpness * t7);
  highp float t9 = sharpness / (15.0f + sharpness * t8);
  highp float t10 = sharpness / (13.0f + sharpness * t9);
  highp float t11 = sharpness / (11.0f + sharpness * t10);
  highp float t12 = sharpness / (9.0f + sharpness * t11);
  highp float t13 = sharpness / (7.0f + sharpness * t12);
  highp float t14 = sharpness / (5.0f + sharpness * t13);
  highp float t15 = sharpness / (3.0f + sharpness * t14);
  highp float t16 = 23.0f + t4 * (25.0f + t3 * (27.0f + t2 * (29.0f + t1 * (31.0f + t0 * 33.0f))));
  highp float t17 = 13.0f + t9 * (15.0f + t8 * (17.0f + t7 * (19.0f + t6 * (21.0f + t5 * t16))));
  highp float t18 = 3.0f + t14 * (5.0f + t13 * (7.0f + t12 * (9.0f + t11 * (11.0f + t10 * t17))));
  highp float t19 = max(sharpness, 1.0f);
  highp float t20 = -2.0f * t19;
  highp float t21 = min(abs(t20), 105.35837f);
  bool is_22 = 64.0f <= t21;
  bool is_23 = t20 < 0.0f;
  highp float t24 = is_22 ? t21 - 64.0f : t21;
  bool is_25 = 32.0f <= t24;
  highp float t26 = is_25 ? t24 - 32.0f : t24;
  bool is_27 = 16.0f <= t26;
  highp float t28 = is_27 ? t26 - 16.0f : t26;
  bool is_29 = 8.0f <= t28;
  highp float t30 = is_29 ? t28 - 8.0f : t28;
  bool is_31 = 4.0f <= t30;
  highp float t32 = is_31 ? t30 - 4.0f : t30;
  bool is_33 = 2.0f <= t32;
  highp float t34 = is_33 ? t32 - 2.0f : t32;
  bool is_35 = 1.0f <= t34;
  highp float t36 = is_35 ? t34 - 1.0f : t34;
  bool is_37 = 0.5f <= t36;
  highp float t38 = is_37 ? t36 - 0.5f : t36;
  bool is_39 = 0.25f <= t38;
  highp float t40 = is_25 ? 1.2664166e-14f : 1.0f;
  highp float t41 = is_27 ? t40 * 1.12535176e-07f : t40;
  highp float t42 = is_29 ? t41 * 0.00033546262f : t41;
  highp float t43 = is_31 ? t42 * 0.01831564f : t42;
  highp float t44 = is_33 ? t43 * 0.13533528f : t43;
  highp float t45 = is_35 ? t44 * 0.36787945f : t44;
  highp float t46 = is_37 ? t45 * 0.60653067f : t45;
  highp float t47 = is_39 ? t38 - 0.25f : t38;
  highp float t48 = 0.16666667f - t47 * (0.041666668f - t47 * (0.008333334f - t47 * 0.0013888889f));
  highp float t49 = (is_39 ? t46 * 0.7788008f : t46) * (1.0f - t47 * (1.0f - t47 * (0.5f - t47 * t48)));
  highp float t50 = is_23 ? t49 : 1.0f / t49;
  highp float t51 = is_22 ? t50 * (is_23 ? 1.6038109e-28f : 6.235149e+27f) : t50;
  highp float t52 = sharpness < 1.0f ? 1.0f / (1.0f + t15 * t18) : (1.0f - t51) / (t19 + t19);
  z[0] = 3.5449078f * t52;
  highp float t53 = 6.1399603f * (2.0f < sharpness ? ((1.0f + t51) * 0.5f - t52) / t19 : t52 * t15);
  z[1] = t53;
}
#endif

#ifndef ZONAL_SPHERICAL_GAUSSIAN_3
#define ZONAL_SPHERICAL_GAUSSIAN_3
// Zonal coefficients of exp(sharpness (cos theta - 1)).
// 188 operations: 61 additions, 63 multiplications, 25 divisions, 1 square roots, 38 comparisons and choices.
void zonal_spherical_gaussian_3(highp float sharpness, out highp float z[3]) {
  highp float t0 = sharpness / (20.0f + sqrt(420.0f + sharpness * sharpness));
  highp float t1 = sharpness / (39.0f + sharpness * t0);
  highp float t2 = sharpness / (37.0f + sharpness * t1);
  highp float t3 = sharpness / (35.0f + sharpness * t2);
  highp float t4 = sharpness / (33.0f + sharpness * t3);
  highp float t5 = sharpness / (31.0f + sharpness * t4);
  highp float t6 = sharpness / (29.0f + sharpness * t5);
  highp float t7 = sharpness / (27.0f + sharpness * t6);
  highp float t8 = sharpness / (25.0f + sharpness * t7);
  highp float t9 = sharpness / (23.0f + sharpness * t8);
  highp float t10 = sharpness / (21.0f + sharpness * t9);
  highp float t11 = sharpness / (19.0f + sharpness * t10);
  highp float t12 = sharpness / (17.0f + sharpness * t11);
  highp float t13 = sharpness / (15.0f + sharpness * t12);
  highp float t14 = sharpness / (13.0f + sharpness * t13);
  highp float t15 = sharpness / (11.0f + sharpness * t14);
  highp float t16 = sharpness / (9.0f + sharpness * t15);
  highp float t17 = sharpness / (7.0f + sharpness * t16);
  highp float t18 = sharpness / (5.0f + sharpness * t17);
  highp float t19 = sharpness / (3.0f + sharpness * t18);
  highp float t20 = 31.0f + t4 * (33.0f + t3 * (35.0f + t2 * (37.0f + t1 * (39.0f + t0 * 41.0f))));
  highp float t21 = 21.0f + t9 * (23.0f + t8 * (25.0f + t7 * (27.0f + t6 * (29.0f + t5 * t20))));
  highp float t22 = t14 * (13.0f + t13 * (15.0f + t12 * (17.0f + t11 * (19.0f + t10 * t21))));
  highp float t23 = t19 * (3.0f + t18 * (5.0f + t17 * (7.0f + t16 * (9.0f + t15 * (11.0f + t22)))));
  highp float t24 = max(sharpness, 1.0f);
  highp float t25 = -2.0f * t24;
  highp float t26 = min(abs(t25), 105.35837f);
  bool is_27 = 64.0f <= t26;
  bool is_28 = t25 < 0.0f;
  highp float t29 = is_27 ? t26 - 64.0f : t26;
  bool is_30 = 32.0f <= t29;
  highp float t31 = is_30 ? t29 - 32.0f : t29;
  bool is_32 = 16.0f <= t31;
  highp float t33 = is_32 ? t31 - 16.0f : t31;
  bool is_34 = 8.0f <= t33;
  highp float t35 = is_34 ? t33 - 8.0f : t33;
  bool is_36 = 4.0f <= t35;
  highp float t37 = is_36 ? t35 - 4.0f : t35;
  bool is_38 = 2.0f <= t37;
  highp float t39 = is_38 ? t37 - 2.0f : t37;
  bool is_40 = 1.0f <= t39;
  highp float t41 = is_40 ? t39 - 1.0f : t39;
  bool is_42 = 0.5f <= t41;
  highp float t43 = is_42 ? t41 - 0.5f : t41;
  bool is_44 = 0.25f <= t43;
  highp float t45 = is_30 ? 1.2664166e-14f : 1.0f;
  highp float t46 = is_32 ? t45 * 1.12535176e-07f : t45;
  highp float t47 = is_34 ? t46 * 0.00033546262f : t46;
  highp float t48 = is_36 ? t47 * 0.01831564f : t47;
  highp float t49 = is_38 ? t48 * 0.13533528f : t48;
  highp float t50 = is_40 ? t49 * 0.36787945f : t49;
  highp float t51 = is_42 ? t50 * 0.60653067f : t50;
  highp float t52 = is_44 ? t43 - 0.25f : t43;
  highp float t53 = 0.16666667f - t52 * (0.041666668f - t52 * (0.008333334f - t52 * 0.0013888889f));
  highp float t54 = (is_44 ? t51 * 0.7788008f : t51) * (1.0f - t52 * (1.0f - t52 * (0.5f - t52 * t53)));
  highp float t55 = is_28 ? t54 : 1.0f / t54;
  highp float t56 = is_27 ? t55 * (is_28 ? 1.6038109e-28f : 6.235149e+27f) : t55;
  highp float t57 = sharpness < 1.0f ? 1.0f / (1.0f + t23) : (1.0f - t56) / (t24 + t24);
  z[0] = 3.5449078f * t57;
  bool is_58 = 4.5f < sharpness;
  highp float t59 = ((1.0f + t56) * 0.5f - t57) / t24;
  highp float t60 = t57 * t19;
  z[1] = 6.1399603f * (is_58 ? t59 : t60);
  z[2] = 7.926655f * (is_58 ? t57 - 3.0f / t24 * t59 : t60 * t18);
}
#endif

#ifndef ZONAL_SPHERICAL_GAUSSIAN_4
#define ZONAL_SPHERICAL_GAUSSIAN_4
// Zonal coefficients of exp(sharpness (cos theta - 1)).
// 214 operations: 70 additions, 74 multiplications, 30 divisions, 1 square roots, 39 comparisons and choices.
void zonal_spherical_gaussian_4(highp float sharpness, out highp float z[4]) {
  highp float t0 = sharpness / (24.0f + sqrt(600.0f + sharpness * sharpness));
  highp float t1 = sharpness / (47.0f + sharpness * t0);
  highp float t2 = sharpness / (45.0f + sharpness * t1);
  highp float t3 = sharpness / (43.0f + sharpness * t2);
  highp float t4 = sharpness / (41.0f + sharpness * t3);
  highp float t5 = sharpness / (39.0f + sharpness * t4);
  highp float t6 = sharpness / (37.0f + sharpness * t5);
  highp float t7 = sharpness / (35.0f + sharpness * t6);
  highp float t8 = sharpness / (33.0f + sharpness * t7);
  highp float t9 = sharpness / (31.0f + sharpness * t8);
  highp float t10 = sharpness / (29.0f + sharpness * t9);
  highp float t11 = sharpness / (27.0f + sharpness * t10);
  highp float t12 = sharpness / (25.0f + sharpness * t11);
  highp float t13 = sharpness / (23.0f + sharpness * t12);
  highp float t14 = sharpness / (21.0f + sharpness * t13);
  highp float t15 = sharpness / (19.0f + sharpness * t14);
  highp float t16 = sharpness / (17.0f + sharpness * t15);
  highp float t17 = sharpness / (15.0f + sharpness * t16);
  highp float t18 = sharpness / (13.0f + sharpness * t17);
  highp float t19 = sharpness / (11.0f + sharpness * t18);
  highp float t20 = sharpness / (9.0f + sharpness * t19);
  highp float t21 = sharpness / (7.0f + sharpness * t20);
  highp float t22 = sharpness / (5.0f + sharpness * t21);
  highp float t23 = sharpness / (3.0f + sharpness * t22);
  highp float t24 = 39.0f + t4 * (41.0f + t3 * (43.0f + t2 * (45.0f + t1 * (47.0f + t0 * 49.0f))));
  highp float t25 = 29.0f + t9 * (31.0f + t8 * (33.0f + t7 * (35.0f + t6 * (37.0f + t5 * t24))));
  highp float t26 = t14 * (21.0f + t13 * (23.0f + t12 * (25.0f + t11 * (27.0f + t10 * t25))));
  highp float t27 = 11.0f + t18 * (13.0f + t17 * (15.0f + t16 * (17.0f + t15 * (19.0f + t26))));
  highp float t28 = 1.0f + t23 * (3.0f + t22 * (5.0f + t21 * (7.0f + t20 * (9.0f + t19 * t27))));
  highp float t29 = max(sharpness, 1.0f);
  highp float t30 = -2.0f * t29;
  highp float t31 = min(abs(t30), 105.35837f);
  bool is_32 = 64.0f <= t31;
  bool is_33 = t30 < 0.0f;
  highp float t34 = is_32 ? t31 - 64.0f : t31;
  bool is_35 = 32.0f <= t34;
  highp float t36 = is_35 ? t34 - 32.0f : t34;
  bool is_37 = 16.0f <= t36;
  highp float t38 = is_37 ? t36 - 16.0f : t36;
  bool is_39 = 8.0f <= t38;
  highp float t40 = is_39 ? t38 - 8.0f : t38;
  bool is_41 = 4.0f <= t40;
  highp float t42 = is_41 ? t40 - 4.0f : t40;
  bool is_43 = 2.0f <= t42;
  highp float t44 = is_43 ? t42 - 2.0f : t42;
  bool is_45 = 1.0f <= t44;
  highp float t46 = is_45 ? t44 - 1.0f : t44;
  bool is_47 = 0.5f <= t46;
  highp float t48 = is_47 ? t46 - 0.5f : t46;
  bool is_49 = 0.25f <= t48;
  highp float t50 = is_35 ? 1.2664166e-14f : 1.0f;
  highp float t51 = is_37 ? t50 * 1.12535176e-07f : t50;
  highp float t52 = is_39 ? t51 * 0.00033546262f : t51;
  highp float t53 = is_41 ? t52 * 0.01831564f : t52;
  highp float t54 = is_43 ? t53 * 0.13533528f : t53;
  highp float t55 = is_45 ? t54 * 0.36787945f : t54;
  highp float t56 = is_47 ? t55 * 0.60653067f : t55;
  highp float t57 = is_49 ? t48 - 0.25f : t48;
  highp float t58 = 0.16666667f - t57 * (0.041666668f - t57 * (0.008333334f - t57 * 0.0013888889f));
  highp float t59 = (is_49 ? t56 * 0.7788008f : t56) * (1.0f - t57 * (1.0f - t57 * (0.5f - t57 * t58)));
  highp float t60 = is_33 ? t59 : 1.0f / t59;
  highp float t61 = is_32 ? t60 * (is_33 ? 1.6038109e-28f : 6.235149e+27f) : t60;
  highp float t62 = sharpness < 1.0f ? 1.0f / t28 : (1.0f - t61) / (t29 + t29);
  z[0] = 3.5449078f * t62;
  bool is_63 = 8.0f < sharpness;
  highp float t64 = ((1.0f + t61) * 0.5f - t62) / t29;
  highp float t65 = t62 * t23;
  z[1] = 6.1399603f * (is_63 ? t64 : t65);
  highp float t66 = t62 - 3.0f / t29 * t64;
  highp float t67 = t65 * t22;
  z[2] = 7.926655f * (is_63 ? t66 : t67);
  z[3] = 9.378944f * (is_63 ? t64 - 5.0f / t29 * t66 : t67 * t21);
}
#endif

#ifndef ZONAL_SPHERICAL_GAUSSIAN_5
#define ZONAL_SPHERICAL_GAUSSIAN_5
// Zonal coefficients of exp(sharpness (cos theta - 1)).
// 240 operations: 79 additions, 85 multiplications, 35 divisions, 1 square roots, 40 comparisons and choices.
void zonal_spherical_gaussian_5(highp float sharpness, out highp float z[5]) {
  highp float t0 = sharpness / (28.0f + sqrt(812.0f + sharpness * sharpness));
  highp float t1 = sharpness / (55.0f + sharpness * t0);
  highp float t2 = sharpness / (53.0f + sharpness * t1);
  highp float t3 = sharpness / (51.0f + sharpness * t2);
  highp float t4 = sharpness / (49.0f + sharpness * t3);
  highp float t5 = sharpness / (47.0f + sharpness * t4);
  highp float t6 = sharpness / (45.0f + sharpness * t5);
  highp float t7 = sharpness / (43.0f + sharpness * t6);
  highp float t8 = sharpness / (41.0f + sharpness * t7);
  highp float t9 = sharpness / (39.0f + sharpness * t8);
  highp float t10 = sharpness / (37.0f + sharpness * t9);
  highp float t11 = sharpness / (35.0f + sharpness * t10);
  highp float t12 = sharpness / (33.0f + sharpness * t11);
  highp float t13 = sharpness / (31.0f + sharpness * t12);
  highp float t14 = sharpness / (29.0f + sharpness * t13);
  highp float t15 = sharpness / (27.0f + sharpness * t14);
  highp float t16 = sharpness / (25.0f + sharpness * t15);
  highp float t17 = sharpness / (23.0f + sharpness * t16);
  highp float t18 = sharpness / (21.0f + sharpness * t17);
  highp float t19 = sharpness / (19.0f + sharpness * t18);
  highp float t20 = sharpness / (17.0f + sharpness * t19);
  highp float t21 = sharpness / (15.0f + sharpness * t20);
  highp float t22 = sharpness / (13.0f + sharpness * t21);
  highp float t23 = sharpness / (11.0f + sharpness * t22);
  highp float t24 = sharpness / (9.0f + sharpness * t23);
  highp float t25 = sharpness / (7.0f + sharpness * t24);
  highp float t26 = sharpness / (5.0f + sharpness * t25);
  highp float t27 = sharpness / (3.0f + sharpness * t26);
  highp float t28 = 47.0f + t4 * (49.0f + t3 * (51.0f + t2 * (53.0f + t1 * (55.0f + t0 * 57.0f))));
  highp float t29 = 37.0f + t9 * (39.0f + t8 * (41.0f + t7 * (43.0f + t6 * (45.0f + t5 * t28))));
  highp float t30 = t14 * (29.0f + t13 * (31.0f + t12 * (33.0f + t11 * (35.0f + t10 * t29))));
  highp float t31 = 19.0f + t18 * (21.0f + t17 * (23.0f + t16 * (25.0f + t15 * (27.0f + t30))));
  highp float t32 = t23 * (11.0f + t22 * (13.0f + t21 * (15.0f + t20 * (17.0f + t19 * t31))));
  highp float t33 = 1.0f / (1.0f + t27 * (3.0f + t26 * (5.0f + t25 * (7.0f + t24 * (9.0f + t32)))));
  highp float t34 = max(sharpness, 1.0f);
  highp float t35 = -2.0f * t34;
  highp float t36 = min(abs(t35), 105.35837f);
  bool is_37 = 64.0f <= t36;
  bool is_38 = t35 < 0.0f;
  highp float t39 = is_37 ? t36 - 64.0f : t36;
  bool is_40 = 32.0f <= t39;
  highp float t41 = is_40 ? t39 - 32.0f : t39;
  bool is_42 = 16.0f <= t41;
  highp float t43 = is_42 ? t41 - 16.0f : t41;
  bool is_44 = 8.0f <= t43;
  highp float t45 = is_44 ? t43 - 8.0f : t43;
  bool is_46 = 4.0f <= t45;
  highp float t47 = is_46 ? t45 - 4.0f : t45;
  bool is_48 = 2.0f <= t47;
  highp float t49 = is_48 ? t47 - 2.0f : t47;
  bool is_50 = 1.0f <= t49;
  highp float t51 = is_50 ? t49 - 1.0f : t49;
  bool is_52 = 0.5f <= t51;
  highp float t53 = is_52 ? t51 - 0.5f : t51;
  bool is_54 = 0.25f <= t53;
  highp float t55 = is_40 ? 1.2664166e-14f : 1.0f;
  highp float t56 = is_42 ? t55 * 1.12535176e-07f : t55;
  highp float t57 = is_44 ? t56 * 0.00033546262f : t56;
  highp float t58 = is_46 ? t57 * 0.01831564f : t57;
  highp float t59 = is_48 ? t58 * 0.13533528f : t58;
  highp float t60 = is_50 ? t59 * 0.36787945f : t59;
  highp float t61 = is_52 ? t60 * 0.60653067f : t60;
  highp float t62 = is_54 ? t53 - 0.25f : t53;
  highp float t63 = 0.16666667f - t62 * (0.041666668f - t62 * (0.008333334f - t62 * 0.0013888889f));
  highp float t64 = (is_54 ? t61 * 0.7788008f : t61) * (1.0f - t62 * (1.0f - t62 * (0.5f - t62 * t63)));
  highp float t65 = is_38 ? t64 : 1.0f / t64;
  highp float t66 = is_37 ? t65 * (is_38 ? 1.6038109e-28f : 6.235149e+27f) : t65;
  highp float t67 = sharpness < 1.0f ? t33 : (1.0f - t66) / (t34 + t34);
  z[0] = 3.5449078f * t67;
  bool is_68 = 12.5f < sharpness;
  highp float t69 = ((1.0f + t66) * 0.5f - t67) / t34;
  highp float t70 = t67 * t27;
  z[1] = 6.1399603f * (is_68 ? t69 : t70);
  highp float t71 = t67 - 3.0f / t34 * t69;
  highp float t72 = t70 * t26;
  z[2] = 7.926655f * (is_68 ? t71 : t72);
  highp float t73 = t69 - 5.0f / t34 * t71;
  highp float t74 = t72 * t25;
  z[3] = 9.378944f * (is_68 ? t73 : t74);
  z[4] = 10.634723f * (is_68 ? t71 - 7.0f / t34 * t73 : t74 * t24);
}
#endif

#ifndef ZONAL_PROJECT_SPHERE_2
#define ZONAL_PROJECT_SPHERE_2
// A sphere light of radiance 1, seen from a receiver.
// 51 operations: 9 additions, 20 multiplications, 2 divisions, 2 square roots, 18 comparisons and choices.
void zonal_project_sphere_2(highp vec3 center, highp float radius, highp vec3 receiver, out highp float sh[4]) {
  highp float t0 = min(max(center.x - receiver.x, -4.611686e+18f), 4.611686e+18f);
  highp float t1 = min(max(center.y - receiver.y, -4.611686e+18f), 4.611686e+18f);
  highp float t2 = min(max(center.z - receiver.z, -4.611686e+18f), 4.611686e+18f);
  highp float t3 = t0 * t0 + t1 * t1 + t2 * t2;
  highp float t4 = sqrt(max(t3, 5.421011e-20f));
  highp float t5 = 1.0f / t4;
  highp float t6 = min(radius * t5, 1.0f);
  highp float t7 = sqrt(max(t4 - radius, 0.0f) * t5 * (1.0f + t6));
  highp float t8 = abs(t7);
  highp float t9 = t6 * t6;
  highp float t10 = 1.0f + t8;
  highp float t11 = 3.1415927f * (2.0f * (0.0f < t7 ? (t8 < 0.5f ? 1.0f - t8 : t9 / t10) : t10));
  sh[0] = t11 * 0.2820948f;
  highp float t12 = 3.1415927f * t9;
  bool is_13 = t3 < 5.421011e-20f;
  sh[1] = t12 * (-0.48860252f * (is_13 ? 0.0f : t1 * t5));
  sh[2] = t12 * (0.48860252f * (is_13 ? 1.0f : t2 * t5));
  sh[3] = t12 * (-0.48860252f * (is_13 ? 0.0f : t0 * t5));
}
#endif

#ifndef ZONAL_PROJECT_SPHERE_3
#define ZONAL_PROJECT_SPHERE_3
// A sphere light of radiance 1, seen from a receiver.
// 79 operations: 16 additions, 38 multiplications, 2 divisions, 2 square roots, 21 comparisons and choices.
void zonal_project_sphere_3(highp vec3 center, highp float radius, highp vec3 receiver, out highp float sh[9]) {
  highp float t0 = min(max(center.x - receiver.x, -4.611686e+18f), 4.611686e+18f);
  highp float t1 = min(max(center.y - receiver.y, -4.611686e+18f), 4.611686e+18f);
  highp float t2 = min(max(center.z - receiver.z, -4.611686e+18f), 4.611686e+18f);
  highp float t3 = t0 * t0 + t1 * t1 + t2 * t2;
  highp float t4 = sqrt(max(t3, 5.421011e-20f));
  highp float t5 = 1.0f / t4;
  highp float t6 = min(radius * t5, 1.0f);
  highp float t7 = sqrt(max(t4 - radius, 0.0f) * t5 * (1.0f + t6));
  bool is_8 = 0.0f < t7;
  highp float t9 = abs(t7);
  highp float t10 = t6 * t6;
  highp float t11 = 1.0f + t9;
  highp float t12 = t9 < 0.5f ? 1.0f - t9 : t10 / t11;
  sh[0] = 3.1415927f * (2.0f * (is_8 ? t12 : t11)) * 0.2820948f;
  highp float t13 = 3.1415927f * t10;
  bool is_14 = t3 < 5.421011e-20f;
  highp float t15 = is_14 ? 0.0f : t1 * t5;
  sh[1] = t13 * (-0.48860252f * t15);
  highp float t16 = is_14 ? 1.0f : t2 * t5;
  sh[2] = t13 * (0.48860252f * t16);
  highp float t17 = is_14 ? 0.0f : t0 * t5;
  sh[3] = t13 * (-0.48860252f * t17);
  highp float t18 = 0.33333334f < t9 ? t10 : 0.0f;
  highp float t19 = 3.1415927f * ((is_8 ? 1.0f : -1.0f) * (t18 + (t10 - t18 + -(t12 * t10))));
  highp float t20 = t15 * t17;
  sh[4] = t19 * (0.54627424f * (t20 + t20));
  highp float t21 = -1.0925485f * t16;
  sh[5] = t19 * (t21 * t15);
  sh[6] = t19 * (0.9461747f * (t16 * t16) + -0.31539157f);
  sh[7] = t19 * (t21 * t17);
  sh[8] = t19 * (0.54627424f * (t17 * t17 - t15 * t15));
}
#endif

#ifndef ZONAL_PROJECT_SPHERE_4
#define ZONAL_PROJECT_SPHERE_4
// A sphere light of radiance 1, seen from a receiver.
// 111 operations: 23 additions, 63 multiplications, 2 divisions, 2 square roots, 21 comparisons and choices.
void zonal_project_sphere_4(highp vec3 center, highp float radius, highp vec3 receiver, out highp float sh[16]) {
  highp float t0 = min(max(center.x - receiver.x, -4.611686e+18f), 4.611686e+18f);
  highp float t1 = min(max(center.y - receiver.y, -4.611686e+18f), 4.611686e+18f);
  highp float t2 = min(max(center.z - receiver.z, -4.611686e+18f), 4.611686e+18f);
  highp float t3 = t0 * t0 + t1 * t1 + t2 * t2;
  highp float t4 = sqrt(max(t3, 5.421011e-20f));
  highp float t5 = 1.0f / t4;
  highp float t6 = min(radius * t5, 1.0f);
  highp float t7 = sqrt(max(t4 - radius, 0.0f) * t5 * (1.0f + t6));
  bool is_8 = 0.0f < t7;
  highp float t9 = abs(t7);
  highp float t10 = t6 * t6;
  highp float t11 = 1.0f + t9;
  highp float t12 = t9 < 0.5f ? 1.0f - t9 : t10 / t11;
  sh[0] = 3.1415927f * (2.0f * (is_8 ? t12 : t11)) * 0.2820948f;
  highp float t13 = 3.1415927f * t10;
  bool is_14 = t3 < 5.421011e-20f;
  highp float t15 = is_14 ? 0.0f : t1 * t5;
  sh[1] = t13 * (-0.48860252f * t15);
  highp float t16 = is_14 ? 1.0f : t2 * t5;
  sh[2] = t13 * (0.48860252f * t16);
  highp float t17 = is_14 ? 0.0f : t0 * t5;
  sh[3] = t13 * (-0.48860252f * t17);
  highp float t18 = 0.625f < t9 ? t10 : 0.0f;
  highp float t19 = -(t12 * t10);
  highp float t20 = t10 - t18 + t19;
  highp float t21 = t18 + t20;
  highp float t22 = 3.1415927f * ((is_8 ? 1.0f : -1.0f) * t21);
  highp float t23 = t15 * t17;
  highp float t24 = t23 + t23;
  sh[4] = t22 * (0.54627424f * t24);
  highp float t25 = -1.0925485f * t16;
  sh[5] = t22 * (t25 * t15);
  highp float t26 = t16 * t16;
  sh[6] = t22 * (0.9461747f * t26 + -0.31539157f);
  sh[7] = t22 * (t25 * t17);
  highp float t27 = t17 * t17 - t15 * t15;
  sh[8] = t22 * (0.54627424f * t27);
  highp float t28 = 3.1415927f * (t18 + (t20 + (0.25f * t19 - 1.25f * (t12 * t21))));
  sh[9] = t28 * (-0.5900436f * (t17 * t24 + t15 * t27));
  highp float t29 = 1.4453057f * t16;
  sh[10] = t28 * (t29 * t24);
  highp float t30 = -2.285229f * t26 + 0.4570458f;
  sh[11] = t28 * (t30 * t15);
  sh[12] = t28 * (t16 * (1.8658817f * t26 + -1.119529f));
  sh[13] = t28 * (t30 * t17);
  sh[14] = t28 * (t29 * t27);
  sh[15] = t28 * (-0.5900436f * (t17 * t27 - t15 * t24));
}
#endif

#ifndef ZONAL_PROJECT_SPHERE_5
#define ZONAL_PROJECT_SPHERE_5
// A sphere light of radiance 1, seen from a receiver.
// 152 operations: 31 additions, 96 multiplications, 2 divisions, 2 square roots, 21 comparisons and choices.
void zonal_project_sphere_5(highp vec3 center, highp float radius, highp vec3 receiver, out highp float sh[25]) {
  highp float t0 = min(max(center.x - receiver.x, -4.611686e+18f), 4.611686e+18f);
  highp float t1 = min(max(center.y - receiver.y, -4.611686e+18f), 4.611686e+18f);
  highp float t2 = min(max(center.z - receiver.z, -4.611686e+18f), 4.611686e+18f);
  highp float t3 = t0 * t0 + t1 * t1 + t2 * t2;
  highp float t4 = sqrt(max(t3, 5.421011e-20f));
  highp float t5 = 1.0f / t4;
  highp float t6 = min(radius * t5, 1.0f);
  highp float t7 = sqrt(max(t4 - radius, 0.0f) * t5 * (1.0f + t6));
  bool is_8 = 0.0f < t7;
  highp float t9 = abs(t7);
  highp float t10 = t6 * t6;
  highp float t11 = 1.0f + t9;
  highp float t12 = t9 < 0.5f ? 1.0f - t9 : t10 / t11;
  sh[0] = 3.1415927f * (2.0f * (is_8 ? t12 : t11)) * 0.2820948f;
  highp float t13 = 3.1415927f * t10;
  bool is_14 = t3 < 5.421011e-20f;
  highp float t15 = is_14 ? 0.0f : t1 * t5;
  sh[1] = t13 * (-0.48860252f * t15);
  highp float t16 = is_14 ? 1.0f : t2 * t5;
  sh[2] = t13 * (0.48860252f * t16);
  highp float t17 = is_14 ? 0.0f : t0 * t5;
  sh[3] = t13 * (-0.48860252f * t17);
  highp float t18 = is_8 ? 1.0f : -1.0f;
  highp float t19 = 0.76f < t9 ? t10 : 0.0f;
  highp float t20 = -(t12 * t10);
  highp float t21 = t10 - t19 + t20;
  highp float t22 = t19 + t21;
  highp float t23 = 3.1415927f * (t18 * t22);
  highp float t24 = t15 * t17;
  highp float t25 = t24 + t24;
  sh[4] = t23 * (0.54627424f * t25);
  highp float t26 = -1.0925485f * t16;
  sh[5] = t23 * (t26 * t15);
  highp float t27 = t16 * t16;
  highp float t28 = 0.9461747f * t27 + -0.31539157f;
  sh[6] = t23 * t28;
  sh[7] = t23 * (t26 * t17);
  highp float t29 = t17 * t17 - t15 * t15;
  sh[8] = t23 * (0.54627424f * t29);
  highp float t30 = 0.25f * t20 - 1.25f * (t12 * t22);
  highp float t31 = t21 + t30;
  highp float t32 = t19 + t31;
  highp float t33 = 3.1415927f * t32;
  highp float t34 = t17 * t25 + t15 * t29;
  sh[9] = t33 * (-0.5900436f * t34);
  highp float t35 = 1.4453057f * t16;
  sh[10] = t33 * (t35 * t25);
  highp float t36 = -2.285229f * t27 + 0.4570458f;
  sh[11] = t33 * (t36 * t15);
  highp float t37 = t16 * (1.8658817f * t27 + -1.119529f);
  sh[12] = t33 * t37;
  sh[13] = t33 * (t36 * t17);
  sh[14] = t33 * (t35 * t29);
  highp float t38 = t17 * t29 - t15 * t25;
  sh[15] = t33 * (-0.5900436f * t38);
  highp float t39 = 3.1415927f * (t18 * (t19 + (t31 + (0.4f * t30 - 1.4f * (t12 * t32)))));
  sh[16] = t39 * (0.6258357f * (t17 * t34 + t15 * t38));
  highp float t40 = -1.7701308f * t16;
  sh[17] = t39 * (t40 * t34);
  highp float t41 = 3.3116114f * t27 + -0.47308734f;
  sh[18] = t39 * (t41 * t25);
  highp float t42 = t16 * (-4.683326f * t27 + 2.0071397f);
  sh[19] = t39 * (t42 * t15);
  sh[20] = t39 * (1.9843135f * t16 * t37 - 1.0062306f * t28);
  sh[21] = t39 * (t42 * t17);
  sh[22] = t39 * (t41 * t29);
  sh[23] = t39 * (t40 * t38);
  sh[24] = t39 * (0.6258357f * (t17 * t38 - t15 * t34));
}
#endif

#ifndef ZONAL_RECONSTRUCT_WITH_ADJOINT_3
#define ZONAL_RECONSTRUCT_WITH_ADJOINT_3
// A colour in a direction of any length but 0, and a loss's derivatives, given those by the colour.
// 184 operations: 59 additions, 123 multiplications, 1 divisions, 1 square roots, 0 comparisons and choices.
void zonal_reconstruct_with_adjoint_3(in highp vec3 sh[9], highp vec3 direction, highp vec3 by_value,
    out highp vec3 value, out highp vec3 by_sh[9], out highp vec3 by_direction) {
  highp float t0 = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
  highp float t1 = 1.0f / sqrt(t0);
  highp float t2 = direction.y * t1;
  highp float t3 = direction.x * t1;
  highp float t4 = t2 * t3;
  highp float t5 = 0.54627424f * (t4 + t4);
  highp float t6 = 0.54627424f * (t3 * t3 - t2 * t2);
  highp float t7 = -0.48860252f * t2;
  highp float t8 = direction.z * t1;
  highp float t9 = -1.0925485f * t8;
  highp float t10 = t9 * t2;
  highp float t11 = sh[0].x * 0.2820948f + sh[4].x * t5 + sh[8].x * t6 + (sh[1].x * t7 + sh[5].x * t10);
  highp float t12 = 0.48860252f * t8;
  highp float t13 = 0.9461747f * (t8 * t8) + -0.31539157f;
  highp float t14 = -0.48860252f * t3;
  highp float t15 = t9 * t3;
  value.x = t11 + (sh[2].x * t12 + sh[6].x * t13 + (sh[3].x * t14 + sh[7].x * t15));
  highp float t16 = sh[0].y * 0.2820948f + sh[4].y * t5 + sh[8].y * t6 + (sh[1].y * t7 + sh[5].y * t10);
  value.y = t16 + (sh[2].y * t12 + sh[6].y * t13 + (sh[3].y * t14 + sh[7].y * t15));
  highp float t17 = sh[0].z * 0.2820948f + sh[4].z * t5 + sh[8].z * t6 + (sh[1].z * t7 + sh[5].z * t10);
  value.z = t17 + (sh[2].z * t12 + sh[6].z * t13 + (sh[3].z * t14 + sh[7].z * t15));
  by_sh[0].x = by_value.x * 0.2820948f;
  by_sh[0].y = by_value.y * 0.2820948f;
  by_sh[0].z = by_value.z * 0.2820948f;
  by_sh[1].x = by_value.x * t7;
  by_sh[1].y = by_value.y * t7;
  by_sh[1].z = by_value.z * t7;
  by_sh[2].x = by_value.x * t12;
  by_sh[2].y = by_value.y * t12;
  by_sh[2].z = by_value.z * t12;
  by_sh[3].x = by_value.x * t14;
  by_sh[3].y = by_value.y * t14;
  by_sh[3].z = by_value.z * t14;
  by_sh[4].x = by_value.x * t5;
  by_sh[4].y = by_value.y * t5;
  by_sh[4].z = by_value.z * t5;
  by_sh[5].x = by_value.x * t10;
  by_sh[5].y = by_value.y * t10;
  by_sh[5].z = by_value.z * t10;
  by_sh[6].x = by_value.x * t13;
  by_sh[6].y = by_value.y * t13;
  by_sh[6].z = by_value.z * t13;
  by_sh[7].x = by_value.x * t15;
  by_sh[7].y = by_value.y * t15;
  by_sh[7].z = by_value.z * t15;
  by_sh[8].x = by_value.x * t6;
  by_sh[8].y = by_value.y * t6;
  by_sh[8].z = by_value.z * t6;
  highp float t18 = -0.48860252f * (by_value.x * sh[3].x + by_value.y * sh[3].y + by_value.z * sh[3].z);
  highp float t19 = by_value.x * sh[7].x + by_value.y * sh[7].y + by_value.z * sh[7].z;
  highp float t20 = 1.0925485f * (by_value.x * sh[8].x + by_value.y * sh[8].y + by_value.z * sh[8].z);
  highp float t21 = 1.0925485f * (by_value.x * sh[4].x + by_value.y * sh[4].y + by_value.z * sh[4].z);
  highp float t22 = t18 + t9 * t19 + (t20 * t3 + t21 * t2);
  highp float t23 = -0.48860252f * (by_value.x * sh[1].x + by_value.y * sh[1].y + by_value.z * sh[1].z);
  highp float t24 = by_value.x * sh[5].x + by_value.y * sh[5].y + by_value.z * sh[5].z;
  highp float t25 = t23 + t9 * t24 + (t21 * t3 - t20 * t2);
  highp float t26 = 0.48860252f * (by_value.x * sh[2].x + by_value.y * sh[2].y + by_value.z * sh[2].z);
  highp float t27 = -1.7320508f * t9 * (by_value.x * sh[6].x + by_value.y * sh[6].y + by_value.z * sh[6].z);
  highp float t28 = t26 + t27 + (-1.0925485f * t19 * t3 + -1.0925485f * t24 * t2);
  highp float t29 = t22 * t3 + t25 * t2 + t28 * t8;
  by_direction.x = (t22 - t3 * t29) * t1;
  by_direction.y = (t25 - t2 * t29) * t1;
  by_direction.z = (t28 - t8 * t29) * t1;
}
#endif

#ifndef ZONAL_RECONSTRUCT_WITH_ADJOINT_4
#define ZONAL_RECONSTRUCT_WITH_ADJOINT_4
// A colour in a direction of any length but 0, and a loss's derivatives, given those by the colour.
// 333 operations: 111 additions, 220 multiplications, 1 divisions, 1 square roots, 0 comparisons and choices.
void zonal_reconstruct_with_adjoint_4(in highp vec3 sh[16], highp vec3 direction, highp vec3 by_value,
    out highp vec3 value, out highp vec3 by_sh[16], out highp vec3 by_direction) {
  highp float t0 = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
  highp float t1 = 1.0f / sqrt(t0);
  highp float t2 = direction.z * t1;
  highp float t3 = t2 * t2;
  highp float t4 = t2 * (1.8658817f * t3 + -1.119529f);
  highp float t5 = direction.y * t1;
  highp float t6 = direction.x * t1;
  highp float t7 = t5 * t6;
  highp float t8 = t7 + t7;
  highp float t9 = 0.54627424f * t8;
  highp float t10 = t6 * t6 - t5 * t5;
  highp float t11 = 0.54627424f * t10;
  highp float t12 = -0.48860252f * t5;
  highp float t13 = -1.0925485f * t2;
  highp float t14 = t13 * t5;
  highp float t15 = -2.285229f * t3 + 0.4570458f;
  highp float t16 = t15 * t6;
  highp float t17 = -0.5900436f * (t6 * t8 + t5 * t10);
  highp float t18 = sh[0].x * 0.2820948f + sh[12].x * t4 + sh[4].x * t9 + sh[8].x * t11 + (sh[1].x * t12 + sh[5].x * t14 + sh[13].x * t16 + sh[9].x * t17);
  highp float t19 = 0.48860252f * t2;
  highp float t20 = 0.9461747f * t3 + -0.31539157f;
  highp float t21 = 1.4453057f * t2;
  highp float t22 = t21 * t8;
  highp float t23 = t21 * t10;
  highp float t24 = -0.48860252f * t6;
  highp float t25 = t13 * t6;
  highp float t26 = t15 * t5;
  highp float t27 = -0.5900436f * (t6 * t10 - t5 * t8);
  highp float t28 = sh[2].x * t19 + sh[6].x * t20 + sh[10].x * t22 + sh[14].x * t23 + (sh[3].x * t24 + sh[7].x * t25 + sh[11].x * t26 + sh[15].x * t27);
  value.x = t18 + t28;
  highp float t29 = sh[0].y * 0.2820948f + sh[12].y * t4 + sh[4].y * t9 + sh[8].y * t11 + (sh[1].y * t12 + sh[5].y * t14 + sh[13].y * t16 + sh[9].y * t17);
  highp float t30 = sh[2].y * t19 + sh[6].y * t20 + sh[10].y * t22 + sh[14].y * t23 + (sh[3].y * t24 + sh[7].y * t25 + sh[11].y * t26 + sh[15].y * t27);
  value.y = t29 + t30;
  highp float t31 = sh[0].z * 0.2820948f + sh[12].z * t4 + sh[4].z * t9 + sh[8].z * t11 + (sh[1].z * t12 + sh[5].z * t14 + sh[13].z * t16 + sh[9].z * t17);
  highp float t32 = sh[2].z * t19 + sh[6].z * t20 + sh[10].z * t22 + sh[14].z * t23 + (sh[3].z * t24 + sh[7].z * t25 + sh[11].z * t26 + sh[15].z * t27);
  value.z = t31 + t32;
  by_sh[0].x = by_value.x * 0.2820948f;
  by_sh[0].y = by_value.y * 0.2820948f;
  by_sh[0].z = by_value.z * 0.2820948f;
  by_sh[1].x = by_value.x * t12;
  by_sh[1].y = by_value.y * t12;
  by_sh[1].z = by_value.z * t12;
  by_sh[2].x = by_value.x * t19;
  by_sh[2].y = by_value.y * t19;
  by_sh[2].z = by_value.z * t19;
  by_sh[3].x = by_value.x * t24;
  by_sh[3].y = by_value.y * t24;
  by_sh[3].z = by_value.z * t24;
  by_sh[4].x = by_value.x * t9;
  by_sh[4].y = by_value.y * t9;
  by_sh[4].z = by_value.z * t9;
  by_sh[5].x = by_value.x * t14;
  by_sh[5].y = by_value.y * t14;
  by_sh[5].z = by_value.z * t14;
  by_sh[6].x = by_value.x * t20;
  by_sh[6].y = by_value.y * t20;
  by_sh[6].z = by_value.z * t20;
  by_sh[7].x = by_value.x * t25;
  by_sh[7].y = by_value.y * t25;
  by_sh[7].z = by_value.z * t25;
  by_sh[8].x = by_value.x * t11;
  by_sh[8].y = by_value.y * t11;
  by_sh[8].z = by_value.z * t11;
  by_sh[9].x = by_value.x * t17;
  by_sh[9].y = by_value.y * t17;
  by_sh[9].z = by_value.z * t17;
  by_sh[10].x = by_value.x * t22;
  by_sh[10].y = by_value.y * t22;
  by_sh[10].z = by_value.z * t22;
  by_sh[11].x = by_value.x * t26;
  by_sh[11].y = by_value.y * t26;
  by_sh[11].z = by_value.z * t26;
  by_sh[12].x = by_value.x * t4;
  by_sh[12].y = by_value.y * t4;
  by_sh[12].z = by_value.z * t4;
  by_sh[13].x = by_value.x * t16;
  by_sh[13].y = by_value.y * t16;
  by_sh[13].z = by_value.z * t16;
  by_sh[14].x = by_value.x * t23;
  by_sh[14].y = by_value.y * t23;
  by_sh[14].z = by_value.z * t23;
  by_sh[15].x = by_value.x * t27;
  by_sh[15].y = by_value.y * t27;
  by_sh[15].z = by_value.z * t27;
  highp float t33 = -0.48860252f * (by_value.x * sh[3].x + by_value.y * sh[3].y + by_value.z * sh[3].z);
  highp float t34 = by_value.x * sh[7].x + by_value.y * sh[7].y + by_value.z * sh[7].z;
  highp float t35 = by_value.x * sh[13].x + by_value.y * sh[13].y + by_value.z * sh[13].z;
  highp float t36 = 1.0925485f * (by_value.x * sh[8].x + by_value.y * sh[8].y + by_value.z * sh[8].z);
  highp float t37 = 2.0f * t21;
  highp float t38 = by_value.x * sh[14].x + by_value.y * sh[14].y + by_value.z * sh[14].z;
  highp float t39 = t36 + t37 * t38;
  highp float t40 = 1.0925485f * (by_value.x * sh[4].x + by_value.y * sh[4].y + by_value.z * sh[4].z);
  highp float t41 = by_value.x * sh[10].x + by_value.y * sh[10].y + by_value.z * sh[10].z;
  highp float t42 = t40 + t37 * t41;
  highp float t43 = -1.7701309f * (by_value.x * sh[15].x + by_value.y * sh[15].y + by_value.z * sh[15].z);
  highp float t44 = -1.7701309f * (by_value.x * sh[9].x + by_value.y * sh[9].y + by_value.z * sh[9].z);
  highp float t45 = t33 + t13 * t34 + t15 * t35 + (t39 * t6 + t42 * t5) + (t43 * t10 + t44 * t8);
  highp float t46 = -0.48860252f * (by_value.x * sh[1].x + by_value.y * sh[1].y + by_value.z * sh[1].z);
  highp float t47 = by_value.x * sh[5].x + by_value.y * sh[5].y + by_value.z * sh[5].z;
  highp float t48 = by_value.x * sh[11].x + by_value.y * sh[11].y + by_value.z * sh[11].z;
  highp float t49 = t46 + t13 * t47 + t15 * t48 + (t42 * t6 - t39 * t5) + (t44 * t10 - t43 * t8);
  highp float t50 = 0.48860252f * (by_value.x * sh[2].x + by_value.y * sh[2].y + by_value.z * sh[2].z);
  highp float t51 = -1.7320508f * t13 * (by_value.x * sh[6].x + by_value.y * sh[6].y + by_value.z * sh[6].z);
  highp float t52 = -2.4494898f * t15 * (by_value.x * sh[12].x + by_value.y * sh[12].y + by_value.z * sh[12].z);
  highp float t53 = -3.1622777f * t21;
  highp float t54 = (-1.0925485f * t34 + t53 * t35) * t6 + (-1.0925485f * t47 + t53 * t48) * t5;
  highp float t55 = t50 + t51 + t52 + t54 + (1.4453058f * t38 * t10 + 1.4453058f * t41 * t8);
  highp float t56 = t45 * t6 + t49 * t5 + t55 * t2;
  by_direction.x = (t45 - t6 * t56) * t1;
  by_direction.y = (t49 - t5 * t56) * t1;
  by_direction.z = (t55 - t2 * t56) * t1;
}
#endif

#ifndef ZONAL_SPLAT_COLOUR_3
#define ZONAL_SPLAT_COLOUR_3
// A splat's colour as a camera sees it: the value, and half more, and at least 0 [Kerbl et al. 2023]. For colours.
// 86 operations: 35 additions, 46 multiplications, 1 divisions, 1 square roots, 3 comparisons and choices.
highp vec3 zonal_splat_colour_3(in highp vec3 sh[9], highp vec3 position, highp vec3 camera) {
  highp float t0 = position.y - camera.y;
  highp float t1 = position.x - camera.x;
  highp float t2 = position.z - camera.z;
  highp float t3 = 1.0f / sqrt(t1 * t1 + t0 * t0 + t2 * t2);
  highp float t4 = t0 * t3;
  highp float t5 = t1 * t3;
  highp float t6 = t4 * t5;
  highp float t7 = 0.54627424f * (t6 + t6);
  highp float t8 = 0.54627424f * (t5 * t5 - t4 * t4);
  highp float t9 = -0.48860252f * t4;
  highp float t10 = t2 * t3;
  highp float t11 = -1.0925485f * t10;
  highp float t12 = t11 * t4;
  highp float t13 = sh[0].x * 0.2820948f + sh[4].x * t7 + sh[8].x * t8 + (sh[1].x * t9 + sh[5].x * t12);
  highp float t14 = 0.48860252f * t10;
  highp float t15 = 0.9461747f * (t10 * t10) + -0.31539157f;
  highp float t16 = -0.48860252f * t5;
  highp float t17 = t11 * t5;
  highp float t18 = t13 + (sh[2].x * t14 + sh[6].x * t15 + (sh[3].x * t16 + sh[7].x * t17)) + 0.5f;
  highp float t19 = sh[0].y * 0.2820948f + sh[4].y * t7 + sh[8].y * t8 + (sh[1].y * t9 + sh[5].y * t12);
  highp float t20 = t19 + (sh[2].y * t14 + sh[6].y * t15 + (sh[3].y * t16 + sh[7].y * t17)) + 0.5f;
  highp float t21 = sh[0].z * 0.2820948f + sh[4].z * t7 + sh[8].z * t8 + (sh[1].z * t9 + sh[5].z * t12);
  highp float t22 = t21 + (sh[2].z * t14 + sh[6].z * t15 + (sh[3].z * t16 + sh[7].z * t17)) + 0.5f;
  highp vec3 value = vec3(max(t18, 0.0f), max(t20, 0.0f), max(t22, 0.0f));
  return value;
}
#endif

#ifndef ZONAL_SPLAT_COLOUR_4
#define ZONAL_SPLAT_COLOUR_4
// A splat's colour as a camera sees it: the value, and half more, and at least 0 [Kerbl et al. 2023]. For colours.
// 146 operations: 60 additions, 81 multiplications, 1 divisions, 1 square roots, 3 comparisons and choices.
highp vec3 zonal_splat_colour_4(in highp vec3 sh[16], highp vec3 position, highp vec3 camera) {
  highp float t0 = position.z - camera.z;
  highp float t1 = position.x - camera.x;
  highp float t2 = position.y - camera.y;
  highp float t3 = 1.0f / sqrt(t1 * t1 + t2 * t2 + t0 * t0);
  highp float t4 = t0 * t3;
  highp float t5 = t4 * t4;
  highp float t6 = t4 * (1.8658817f * t5 + -1.119529f);
  highp float t7 = t2 * t3;
  highp float t8 = t1 * t3;
  highp float t9 = t7 * t8;
  highp float t10 = t9 + t9;
  highp float t11 = 0.54627424f * t10;
  highp float t12 = t8 * t8 - t7 * t7;
  highp float t13 = 0.54627424f * t12;
  highp float t14 = -0.48860252f * t7;
  highp float t15 = -1.0925485f * t4;
  highp float t16 = t15 * t7;
  highp float t17 = -2.285229f * t5 + 0.4570458f;
  highp float t18 = t17 * t8;
  highp float t19 = -0.5900436f * (t8 * t10 + t7 * t12);
  highp float t20 = sh[0].x * 0.2820948f + sh[12].x * t6 + sh[4].x * t11 + sh[8].x * t13 + (sh[1].x * t14 + sh[5].x * t16 + sh[13].x * t18 + sh[9].x * t19);
  highp float t21 = 0.48860252f * t4;
  highp float t22 = 0.9461747f * t5 + -0.31539157f;
  highp float t23 = 1.4453057f * t4;
  highp float t24 = t23 * t10;
  highp float t25 = t23 * t12;
  highp float t26 = -0.48860252f * t8;
  highp float t27 = t15 * t8;
  highp float t28 = t17 * t7;
  highp float t29 = -0.5900436f * (t8 * t12 - t7 * t10);
  highp float t30 = sh[2].x * t21 + sh[6].x * t22 + sh[10].x * t24 + sh[14].x * t25 + (sh[3].x * t26 + sh[7].x * t27 + sh[11].x * t28 + sh[15].x * t29);
  highp float t31 = sh[0].y * 0.2820948f + sh[12].y * t6 + sh[4].y * t11 + sh[8].y * t13 + (sh[1].y * t14 + sh[5].y * t16 + sh[13].y * t18 + sh[9].y * t19);
  highp float t32 = sh[2].y * t21 + sh[6].y * t22 + sh[10].y * t24 + sh[14].y * t25 + (sh[3].y * t26 + sh[7].y * t27 + sh[11].y * t28 + sh[15].y * t29);
  highp float t33 = sh[0].z * 0.2820948f + sh[12].z * t6 + sh[4].z * t11 + sh[8].z * t13 + (sh[1].z * t14 + sh[5].z * t16 + sh[13].z * t18 + sh[9].z * t19);
  highp float t34 = sh[2].z * t21 + sh[6].z * t22 + sh[10].z * t24 + sh[14].z * t25 + (sh[3].z * t26 + sh[7].z * t27 + sh[11].z * t28 + sh[15].z * t29);
  highp vec3 value = vec3(max(t20 + t30 + 0.5f, 0.0f),
      max(t31 + t32 + 0.5f, 0.0f),
      max(t33 + t34 + 0.5f, 0.0f));
  return value;
}
#endif

#ifndef ZONAL_SPLAT_WITH_ADJOINT_3
#define ZONAL_SPLAT_WITH_ADJOINT_3
// A splat's colour in the direction from the camera, and a loss's derivatives, given those by the colour.
// 196 operations: 62 additions, 123 multiplications, 1 divisions, 1 square roots, 9 comparisons and choices.
void zonal_splat_with_adjoint_3(in highp vec3 sh[9], highp vec3 direction, highp vec3 by_value,
    out highp vec3 value, out highp vec3 by_sh[9], out highp vec3 by_direction) {
  highp float t0 = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
  highp float t1 = 1.0f / sqrt(t0);
  highp float t2 = direction.y * t1;
  highp float t3 = direction.x * t1;
  highp float t4 = t2 * t3;
  highp float t5 = 0.54627424f * (t4 + t4);
  highp float t6 = 0.54627424f * (t3 * t3 - t2 * t2);
  highp float t7 = -0.48860252f * t2;
  highp float t8 = direction.z * t1;
  highp float t9 = -1.0925485f * t8;
  highp float t10 = t9 * t2;
  highp float t11 = sh[0].x * 0.2820948f + sh[4].x * t5 + sh[8].x * t6 + (sh[1].x * t7 + sh[5].x * t10);
  highp float t12 = 0.48860252f * t8;
  highp float t13 = 0.9461747f * (t8 * t8) + -0.31539157f;
  highp float t14 = -0.48860252f * t3;
  highp float t15 = t9 * t3;
  highp float t16 = t11 + (sh[2].x * t12 + sh[6].x * t13 + (sh[3].x * t14 + sh[7].x * t15)) + 0.5f;
  value.x = max(t16, 0.0f);
  highp float t17 = sh[0].y * 0.2820948f + sh[4].y * t5 + sh[8].y * t6 + (sh[1].y * t7 + sh[5].y * t10);
  highp float t18 = t17 + (sh[2].y * t12 + sh[6].y * t13 + (sh[3].y * t14 + sh[7].y * t15)) + 0.5f;
  value.y = max(t18, 0.0f);
  highp float t19 = sh[0].z * 0.2820948f + sh[4].z * t5 + sh[8].z * t6 + (sh[1].z * t7 + sh[5].z * t10);
  highp float t20 = t19 + (sh[2].z * t12 + sh[6].z * t13 + (sh[3].z * t14 + sh[7].z * t15)) + 0.5f;
  value.z = max(t20, 0.0f);
  highp float t21 = t16 < 0.0f ? 0.0f : by_value.x;
  by_sh[0].x = t21 * 0.2820948f;
  highp float t22 = t18 < 0.0f ? 0.0f : by_value.y;
  by_sh[0].y = t22 * 0.2820948f;
  highp float t23 = t20 < 0.0f ? 0.0f : by_value.z;
  by_sh[0].z = t23 * 0.2820948f;
  by_sh[1].x = t21 * t7;
  by_sh[1].y = t22 * t7;
  by_sh[1].z = t23 * t7;
  by_sh[2].x = t21 * t12;
  by_sh[2].y = t22 * t12;
  by_sh[2].z = t23 * t12;
  by_sh[3].x = t21 * t14;
  by_sh[3].y = t22 * t14;
  by_sh[3].z = t23 * t14;
  by_sh[4].x = t21 * t5;
  by_sh[4].y = t22 * t5;
  by_sh[4].z = t23 * t5;
  by_sh[5].x = t21 * t10;
  by_sh[5].y = t22 * t10;
  by_sh[5].z = t23 * t10;
  by_sh[6].x = t21 * t13;
  by_sh[6].y = t22 * t13;
  by_sh[6].z = t23 * t13;
  by_sh[7].x = t21 * t15;
  by_sh[7].y = t22 * t15;
  by_sh[7].z = t23 * t15;
  by_sh[8].x = t21 * t6;
  by_sh[8].y = t22 * t6;
  by_sh[8].z = t23 * t6;
  highp float t24 = t21 * sh[7].x + t22 * sh[7].y + t23 * sh[7].z;
  highp float t25 = -0.48860252f * (t21 * sh[3].x + t22 * sh[3].y + t23 * sh[3].z) + t9 * t24;
  highp float t26 = 1.0925485f * (t21 * sh[8].x + t22 * sh[8].y + t23 * sh[8].z);
  highp float t27 = 1.0925485f * (t21 * sh[4].x + t22 * sh[4].y + t23 * sh[4].z);
  highp float t28 = t25 + (t26 * t3 + t27 * t2);
  highp float t29 = t21 * sh[5].x + t22 * sh[5].y + t23 * sh[5].z;
  highp float t30 = -0.48860252f * (t21 * sh[1].x + t22 * sh[1].y + t23 * sh[1].z) + t9 * t29;
  highp float t31 = t30 + (t27 * t3 - t26 * t2);
  highp float t32 = 0.48860252f * (t21 * sh[2].x + t22 * sh[2].y + t23 * sh[2].z) + -1.7320508f * t9 * (t21 * sh[6].x + t22 * sh[6].y + t23 * sh[6].z);
  highp float t33 = t32 + (-1.0925485f * t24 * t3 + -1.0925485f * t29 * t2);
  highp float t34 = t28 * t3 + t31 * t2 + t33 * t8;
  by_direction.x = (t28 - t3 * t34) * t1;
  by_direction.y = (t31 - t2 * t34) * t1;
  by_direction.z = (t33 - t8 * t34) * t1;
}
#endif

#ifndef ZONAL_SPLAT_WITH_ADJOINT_4
#define ZONAL_SPLAT_WITH_ADJOINT_4
// A splat's colour in the direction from the camera, and a loss's derivatives, given those by the colour.
// 345 operations: 114 additions, 220 multiplications, 1 divisions, 1 square roots, 9 comparisons and choices.
void zonal_splat_with_adjoint_4(in highp vec3 sh[16], highp vec3 direction, highp vec3 by_value,
    out highp vec3 value, out highp vec3 by_sh[16], out highp vec3 by_direction) {
  highp float t0 = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
  highp float t1 = 1.0f / sqrt(t0);
  highp float t2 = direction.z * t1;
  highp float t3 = t2 * t2;
  highp float t4 = t2 * (1.8658817f * t3 + -1.119529f);
  highp float t5 = direction.y * t1;
  highp float t6 = direction.x * t1;
  highp float t7 = t5 * t6;
  highp float t8 = t7 + t7;
  highp float t9 = 0.54627424f * t8;
  highp float t10 = t6 * t6 - t5 * t5;
  highp float t11 = 0.54627424f * t10;
  highp float t12 = -0.48860252f * t5;
  highp float t13 = -1.0925485f * t2;
  highp float t14 = t13 * t5;
  highp float t15 = -2.285229f * t3 + 0.4570458f;
  highp float t16 = t15 * t6;
  highp float t17 = -0.5900436f * (t6 * t8 + t5 * t10);
  highp float t18 = sh[0].x * 0.2820948f + sh[12].x * t4 + sh[4].x * t9 + sh[8].x * t11 + (sh[1].x * t12 + sh[5].x * t14 + sh[13].x * t16 + sh[9].x * t17);
  highp float t19 = 0.48860252f * t2;
  highp float t20 = 0.9461747f * t3 + -0.31539157f;
  highp float t21 = 1.4453057f * t2;
  highp float t22 = t21 * t8;
  highp float t23 = t21 * t10;
  highp float t24 = -0.48860252f * t6;
  highp float t25 = t13 * t6;
  highp float t26 = t15 * t5;
  highp float t27 = -0.5900436f * (t6 * t10 - t5 * t8);
  highp float t28 = sh[2].x * t19 + sh[6].x * t20 + sh[10].x * t22 + sh[14].x * t23 + (sh[3].x * t24 + sh[7].x * t25 + sh[11].x * t26 + sh[15].x * t27);
  highp float t29 = t18 + t28 + 0.5f;
  value.x = max(t29, 0.0f);
  highp float t30 = sh[0].y * 0.2820948f + sh[12].y * t4 + sh[4].y * t9 + sh[8].y * t11 + (sh[1].y * t12 + sh[5].y * t14 + sh[13].y * t16 + sh[9].y * t17);
  highp float t31 = sh[2].y * t19 + sh[6].y * t20 + sh[10].y * t22 + sh[14].y * t23 + (sh[3].y * t24 + sh[7].y * t25 + sh[11].y * t26 + sh[15].y * t27);
  highp float t32 = t30 + t31 + 0.5f;
  value.y = max(t32, 0.0f);
  highp float t33 = sh[0].z * 0.2820948f + sh[12].z * t4 + sh[4].z * t9 + sh[8].z * t11 + (sh[1].z * t12 + sh[5].z * t14 + sh[13].z * t16 + sh[9].z * t17);
  highp float t34 = sh[2].z * t19 + sh[6].z * t20 + sh[10].z * t22 + sh[14].z * t23 + (sh[3].z * t24 + sh[7].z * t25 + sh[11].z * t26 + sh[15].z * t27);
  highp float t35 = t33 + t34 + 0.5f;
  value.z = max(t35, 0.0f);
  highp float t36 = t29 < 0.0f ? 0.0f : by_value.x;
  by_sh[0].x = t36 * 0.2820948f;
  highp float t37 = t32 < 0.0f ? 0.0f : by_value.y;
  by_sh[0].y = t37 * 0.2820948f;
  highp float t38 = t35 < 0.0f ? 0.0f : by_value.z;
  by_sh[0].z = t38 * 0.2820948f;
  by_sh[1].x = t36 * t12;
  by_sh[1].y = t37 * t12;
  by_sh[1].z = t38 * t12;
  by_sh[2].x = t36 * t19;
  by_sh[2].y = t37 * t19;
  by_sh[2].z = t38 * t19;
  by_sh[3].x = t36 * t24;
  by_sh[3].y = t37 * t24;
  by_sh[3].z = t38 * t24;
  by_sh[4].x = t36 * t9;
  by_sh[4].y = t37 * t9;
  by_sh[4].z = t38 * t9;
  by_sh[5].x = t36 * t14;
  by_sh[5].y = t37 * t14;
  by_sh[5].z = t38 * t14;
  by_sh[6].x = t36 * t20;
  by_sh[6].y = t37 * t20;
  by_sh[6].z = t38 * t20;
  by_sh[7].x = t36 * t25;
  by_sh[7].y = t37 * t25;
  by_sh[7].z = t38 * t25;
  by_sh[8].x = t36 * t11;
  by_sh[8].y = t37 * t11;
  by_sh[8].z = t38 * t11;
  by_sh[9].x = t36 * t17;
  by_sh[9].y = t37 * t17;
  by_sh[9].z = t38 * t17;
  by_sh[10].x = t36 * t22;
  by_sh[10].y = t37 * t22;
  by_sh[10].z = t38 * t22;
  by_sh[11].x = t36 * t26;
  by_sh[11].y = t37 * t26;
  by_sh[11].z = t38 * t26;
  by_sh[12].x = t36 * t4;
  by_sh[12].y = t37 * t4;
  by_sh[12].z = t38 * t4;
  by_sh[13].x = t36 * t16;
  by_sh[13].y = t37 * t16;
  by_sh[13].z = t38 * t16;
  by_sh[14].x = t36 * t23;
  by_sh[14].y = t37 * t23;
  by_sh[14].z = t38 * t23;
  by_sh[15].x = t36 * t27;
  by_sh[15].y = t37 * t27;
  by_sh[15].z = t38 * t27;
  highp float t39 = t36 * sh[7].x + t37 * sh[7].y + t38 * sh[7].z;
  highp float t40 = -0.48860252f * (t36 * sh[3].x + t37 * sh[3].y + t38 * sh[3].z) + t13 * t39;
  highp float t41 = t36 * sh[13].x + t37 * sh[13].y + t38 * sh[13].z;
  highp float t42 = 2.0f * t21;
  highp float t43 = t36 * sh[14].x + t37 * sh[14].y + t38 * sh[14].z;
  highp float t44 = 1.0925485f * (t36 * sh[8].x + t37 * sh[8].y + t38 * sh[8].z) + t42 * t43;
  highp float t45 = t36 * sh[10].x + t37 * sh[10].y + t38 * sh[10].z;
  highp float t46 = 1.0925485f * (t36 * sh[4].x + t37 * sh[4].y + t38 * sh[4].z) + t42 * t45;
  highp float t47 = -1.7701309f * (t36 * sh[15].x + t37 * sh[15].y + t38 * sh[15].z);
  highp float t48 = -1.7701309f * (t36 * sh[9].x + t37 * sh[9].y + t38 * sh[9].z);
  highp float t49 = t40 + t15 * t41 + (t44 * t6 + t46 * t5) + (t47 * t10 + t48 * t8);
  highp float t50 = t36 * sh[5].x + t37 * sh[5].y + t38 * sh[5].z;
  highp float t51 = -0.48860252f * (t36 * sh[1].x + t37 * sh[1].y + t38 * sh[1].z) + t13 * t50;
  highp float t52 = t36 * sh[11].x + t37 * sh[11].y + t38 * sh[11].z;
  highp float t53 = t51 + t15 * t52 + (t46 * t6 - t44 * t5) + (t48 * t10 - t47 * t8);
  highp float t54 = 0.48860252f * (t36 * sh[2].x + t37 * sh[2].y + t38 * sh[2].z) + -1.7320508f * t13 * (t36 * sh[6].x + t37 * sh[6].y + t38 * sh[6].z);
  highp float t55 = t54 + -2.4494898f * t15 * (t36 * sh[12].x + t37 * sh[12].y + t38 * sh[12].z);
  highp float t56 = -3.1622777f * t21;
  highp float t57 = (-1.0925485f * t39 + t56 * t41) * t6 + (-1.0925485f * t50 + t56 * t52) * t5;
  highp float t58 = t55 + t57 + (1.4453058f * t43 * t10 + 1.4453058f * t45 * t8);
  highp float t59 = t49 * t6 + t53 * t5 + t58 * t2;
  by_direction.x = (t49 - t6 * t59) * t1;
  by_direction.y = (t53 - t5 * t59) * t1;
  by_direction.z = (t58 - t2 * t59) * t1;
}
#endif

#ifndef ZONAL_ROTATE_ABOUT_Z_2
#define ZONAL_ROTATE_ABOUT_Z_2
// A function turned about z, from x towards y.
// 6 operations: 2 additions, 4 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_rotate_about_z_2(in highp float sh[4], highp vec2 angle, out highp float result[4]) {
  result[0] = sh[0];
  result[1] = angle.x * sh[1] + angle.y * sh[3];
  result[2] = sh[2];
  result[3] = angle.x * sh[3] - angle.y * sh[1];
}
#endif

#ifndef ZONAL_ROTATE_ABOUT_Z_3
#define ZONAL_ROTATE_ABOUT_Z_3
// A function turned about z, from x towards y.
// 23 operations: 8 additions, 15 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_rotate_about_z_3(in highp float sh[9], highp vec2 angle, out highp float result[9]) {
  result[0] = sh[0];
  result[1] = angle.x * sh[1] + angle.y * sh[3];
  result[2] = sh[2];
  result[3] = angle.x * sh[3] - angle.y * sh[1];
  highp float t0 = angle.x * angle.x - angle.y * angle.y;
  highp float t1 = angle.x * angle.y;
  highp float t2 = t1 + t1;
  result[4] = t0 * sh[4] + t2 * sh[8];
  result[5] = angle.x * sh[5] + angle.y * sh[7];
  result[6] = sh[6];
  result[7] = angle.x * sh[7] - angle.y * sh[5];
  result[8] = t0 * sh[8] - t2 * sh[4];
}
#endif

#ifndef ZONAL_PREPARE_ROTATION_2
#define ZONAL_PREPARE_ROTATION_2
// What rotate takes: cosines and sines of m = 1, 2, ... of three turns. By a quaternion, w first, of any length but 0.
// 45 operations: 10 additions, 18 multiplications, 3 divisions, 2 square roots, 12 comparisons and choices.
void zonal_prepare_rotation_2(in highp float quaternion[4], out highp float turns[6]) {
  highp float t0 = quaternion[0] * quaternion[0] + quaternion[3] * quaternion[3];
  bool is_1 = 1.1754944e-38f < t0;
  highp float t2 = is_1 ? 1.0f / sqrt(is_1 ? t0 : 1.0f) : 0.0f;
  bool is_3 = 0.0f < t2;
  highp float t4 = is_3 ? quaternion[0] * t2 : 1.0f;
  highp float t5 = quaternion[1] * quaternion[1] + quaternion[2] * quaternion[2];
  bool is_6 = 1.1754944e-38f < t5;
  highp float t7 = is_6 ? 1.0f / sqrt(is_6 ? t5 : 1.0f) : 0.0f;
  bool is_8 = 0.0f < t7;
  highp float t9 = is_8 ? quaternion[2] * t7 : 1.0f;
  highp float t10 = t4 * t9;
  highp float t11 = is_3 ? quaternion[3] * t2 : 0.0f;
  highp float t12 = is_8 ? -(quaternion[1] * t7) : 0.0f;
  highp float t13 = t11 * t12;
  turns[0] = t10 + t13;
  highp float t14 = t11 * t9;
  highp float t15 = t4 * t12;
  turns[1] = t14 - t15;
  highp float t16 = 1.0f / (t0 + t5);
  turns[2] = (t0 - t5) * t16;
  turns[3] = -(2.0f * (t0 * t2) * (t5 * t7) * t16);
  turns[4] = t10 - t13;
  turns[5] = t14 + t15;
}
#endif

#ifndef ZONAL_PREPARE_ROTATION_3
#define ZONAL_PREPARE_ROTATION_3
// What rotate takes: cosines and sines of m = 1, 2, ... of three turns. By a quaternion, w first, of any length but 0.
// 60 operations: 16 additions, 27 multiplications, 3 divisions, 2 square roots, 12 comparisons and choices.
void zonal_prepare_rotation_3(in highp float quaternion[4], out highp float turns[12]) {
  highp float t0 = quaternion[0] * quaternion[0] + quaternion[3] * quaternion[3];
  bool is_1 = 1.1754944e-38f < t0;
  highp float t2 = is_1 ? 1.0f / sqrt(is_1 ? t0 : 1.0f) : 0.0f;
  bool is_3 = 0.0f < t2;
  highp float t4 = is_3 ? quaternion[0] * t2 : 1.0f;
  highp float t5 = quaternion[1] * quaternion[1] + quaternion[2] * quaternion[2];
  bool is_6 = 1.1754944e-38f < t5;
  highp float t7 = is_6 ? 1.0f / sqrt(is_6 ? t5 : 1.0f) : 0.0f;
  bool is_8 = 0.0f < t7;
  highp float t9 = is_8 ? quaternion[2] * t7 : 1.0f;
  highp float t10 = t4 * t9;
  highp float t11 = is_3 ? quaternion[3] * t2 : 0.0f;
  highp float t12 = is_8 ? -(quaternion[1] * t7) : 0.0f;
  highp float t13 = t11 * t12;
  highp float t14 = t10 + t13;
  turns[0] = t14;
  highp float t15 = t11 * t9;
  highp float t16 = t4 * t12;
  highp float t17 = t15 - t16;
  turns[1] = t17;
  turns[2] = t14 * t14 - t17 * t17;
  highp float t18 = t14 * t17;
  turns[3] = t18 + t18;
  highp float t19 = 1.0f / (t0 + t5);
  highp float t20 = (t0 - t5) * t19;
  turns[4] = t20;
  highp float t21 = -(2.0f * (t0 * t2) * (t5 * t7) * t19);
  turns[5] = t21;
  turns[6] = t20 * t20 - t21 * t21;
  highp float t22 = t20 * t21;
  turns[7] = t22 + t22;
  highp float t23 = t10 - t13;
  turns[8] = t23;
  highp float t24 = t15 + t16;
  turns[9] = t24;
  turns[10] = t23 * t23 - t24 * t24;
  highp float t25 = t23 * t24;
  turns[11] = t25 + t25;
}
#endif

#ifndef ZONAL_ROTATE_2
#define ZONAL_ROTATE_2
// A function rotated, as prepare_rotation prepares it.
// 22 operations: 10 additions, 12 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_rotate_2(in highp float sh[4], in highp float turns[6], out highp float result[4]) {
  result[0] = sh[0];
  highp float t0 = -(-(turns[0] * sh[1] + turns[1] * sh[3]));
  highp float t1 = turns[0] * sh[3] - turns[1] * sh[1];
  highp float t2 = -sh[2];
  highp float t3 = turns[2] * t1 - turns[3] * t2;
  result[1] = turns[4] * t0 + turns[5] * t3;
  result[2] = -(turns[2] * t2 + turns[3] * t1);
  result[3] = turns[4] * t3 - turns[5] * t0;
}
#endif

#ifndef ZONAL_ROTATE_3
#define ZONAL_ROTATE_3
// A function rotated, as prepare_rotation prepares it.
// 74 operations: 26 additions, 48 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_rotate_3(in highp float sh[9], in highp float turns[12], out highp float result[9]) {
  result[0] = sh[0];
  highp float t0 = -(-(turns[0] * sh[1] + turns[1] * sh[3]));
  highp float t1 = turns[0] * sh[3] - turns[1] * sh[1];
  highp float t2 = -sh[2];
  highp float t3 = turns[4] * t1 - turns[5] * t2;
  result[1] = turns[8] * t0 + turns[9] * t3;
  result[2] = -(turns[4] * t2 + turns[5] * t1);
  result[3] = turns[8] * t3 - turns[9] * t0;
  highp float t4 = -1.0f * (turns[2] * sh[4] + turns[3] * sh[8]);
  highp float t5 = turns[0] * sh[5] + turns[1] * sh[7];
  highp float t6 = -1.0f * (turns[4] * t4 - turns[5] * t5);
  highp float t7 = turns[2] * sh[8] - turns[3] * sh[4];
  highp float t8 = -0.5f * sh[6] + -0.8660254f * t7;
  highp float t9 = -0.8660254f * sh[6] + 0.5f * t7;
  highp float t10 = -1.0f * (turns[0] * sh[7] - turns[1] * sh[5]);
  highp float t11 = turns[6] * t9 - turns[7] * t10;
  highp float t12 = -0.8660254f * t8 + 0.5f * t11;
  result[4] = turns[10] * t6 + turns[11] * t12;
  highp float t13 = turns[4] * t5 + turns[5] * t4;
  highp float t14 = -1.0f * (turns[6] * t10 + turns[7] * t9);
  result[5] = turns[8] * t13 + turns[9] * t14;
  result[6] = -0.5f * t8 + -0.8660254f * t11;
  result[7] = turns[8] * t14 - turns[9] * t13;
  result[8] = turns[10] * t12 - turns[11] * t6;
}
#endif

#ifndef ZONAL_ROTATE_COLOUR_2
#define ZONAL_ROTATE_COLOUR_2
// A function rotated, as prepare_rotation prepares it. For colours.
// 66 operations: 30 additions, 36 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_rotate_colour_2(in highp vec3 sh[4], in highp float turns[6], out highp vec3 result[4]) {
  result[0].x = sh[0].x;
  result[0].y = sh[0].y;
  result[0].z = sh[0].z;
  highp float t0 = -(-(turns[0] * sh[1].x + turns[1] * sh[3].x));
  highp float t1 = turns[0] * sh[3].x - turns[1] * sh[1].x;
  highp float t2 = -sh[2].x;
  highp float t3 = turns[2] * t1 - turns[3] * t2;
  result[1].x = turns[4] * t0 + turns[5] * t3;
  highp float t4 = -(-(turns[0] * sh[1].y + turns[1] * sh[3].y));
  highp float t5 = turns[0] * sh[3].y - turns[1] * sh[1].y;
  highp float t6 = -sh[2].y;
  highp float t7 = turns[2] * t5 - turns[3] * t6;
  result[1].y = turns[4] * t4 + turns[5] * t7;
  highp float t8 = -(-(turns[0] * sh[1].z + turns[1] * sh[3].z));
  highp float t9 = turns[0] * sh[3].z - turns[1] * sh[1].z;
  highp float t10 = -sh[2].z;
  highp float t11 = turns[2] * t9 - turns[3] * t10;
  result[1].z = turns[4] * t8 + turns[5] * t11;
  result[2].x = -(turns[2] * t2 + turns[3] * t1);
  result[2].y = -(turns[2] * t6 + turns[3] * t5);
  result[2].z = -(turns[2] * t10 + turns[3] * t9);
  result[3].x = turns[4] * t3 - turns[5] * t0;
  result[3].y = turns[4] * t7 - turns[5] * t4;
  result[3].z = turns[4] * t11 - turns[5] * t8;
}
#endif

#ifndef ZONAL_ROTATE_COLOUR_3
#define ZONAL_ROTATE_COLOUR_3
// A function rotated, as prepare_rotation prepares it. For colours.
// 222 operations: 78 additions, 144 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_rotate_colour_3(in highp vec3 sh[9], in highp float turns[12], out highp vec3 result[9]) {
  result[0].x = sh[0].x;
  result[0].y = sh[0].y;
  result[0].z = sh[0].z;
  highp float t0 = -(-(turns[0] * sh[1].x + turns[1] * sh[3].x));
  highp float t1 = turns[0] * sh[3].x - turns[1] * sh[1].x;
  highp float t2 = -sh[2].x;
  highp float t3 = turns[4] * t1 - turns[5] * t2;
  result[1].x = turns[8] * t0 + turns[9] * t3;
  highp float t4 = -(-(turns[0] * sh[1].y + turns[1] * sh[3].y));
  highp float t5 = turns[0] * sh[3].y - turns[1] * sh[1].y;
  highp float t6 = -sh[2].y;
  highp float t7 = turns[4] * t5 - turns[5] * t6;
  result[1].y = turns[8] * t4 + turns[9] * t7;
  highp float t8 = -(-(turns[0] * sh[1].z + turns[1] * sh[3].z));
  highp float t9 = turns[0] * sh[3].z - turns[1] * sh[1].z;
  highp float t10 = -sh[2].z;
  highp float t11 = turns[4] * t9 - turns[5] * t10;
  result[1].z = turns[8] * t8 + turns[9] * t11;
  result[2].x = -(turns[4] * t2 + turns[5] * t1);
  result[2].y = -(turns[4] * t6 + turns[5] * t5);
  result[2].z = -(turns[4] * t10 + turns[5] * t9);
  result[3].x = turns[8] * t3 - turns[9] * t0;
  result[3].y = turns[8] * t7 - turns[9] * t4;
  result[3].z = turns[8] * t11 - turns[9] * t8;
  highp float t12 = -1.0f * (turns[2] * sh[4].x + turns[3] * sh[8].x);
  highp float t13 = turns[0] * sh[5].x + turns[1] * sh[7].x;
  highp float t14 = -1.0f * (turns[4] * t12 - turns[5] * t13);
  highp float t15 = turns[2] * sh[8].x - turns[3] * sh[4].x;
  highp float t16 = -0.5f * sh[6].x + -0.8660254f * t15;
  highp float t17 = -0.8660254f * sh[6].x + 0.5f * t15;
  highp float t18 = -1.0f * (turns[0] * sh[7].x - turns[1] * sh[5].x);
  highp float t19 = turns[6] * t17 - turns[7] * t18;
  highp float t20 = -0.8660254f * t16 + 0.5f * t19;
  result[4].x = turns[10] * t14 + turns[11] * t20;
  highp float t21 = -1.0f * (turns[2] * sh[4].y + turns[3] * sh[8].y);
  highp float t22 = turns[0] * sh[5].y + turns[1] * sh[7].y;
  highp float t23 = -1.0f * (turns[4] * t21 - turns[5] * t22);
  highp float t24 = turns[2] * sh[8].y - turns[3] * sh[4].y;
  highp float t25 = -0.5f * sh[6].y + -0.8660254f * t24;
  highp float t26 = -0.8660254f * sh[6].y + 0.5f * t24;
  highp float t27 = -1.0f * (turns[0] * sh[7].y - turns[1] * sh[5].y);
  highp float t28 = turns[6] * t26 - turns[7] * t27;
  highp float t29 = -0.8660254f * t25 + 0.5f * t28;
  result[4].y = turns[10] * t23 + turns[11] * t29;
  highp float t30 = -1.0f * (turns[2] * sh[4].z + turns[3] * sh[8].z);
  highp float t31 = turns[0] * sh[5].z + turns[1] * sh[7].z;
  highp float t32 = -1.0f * (turns[4] * t30 - turns[5] * t31);
  highp float t33 = turns[2] * sh[8].z - turns[3] * sh[4].z;
  highp float t34 = -0.5f * sh[6].z + -0.8660254f * t33;
  highp float t35 = -0.8660254f * sh[6].z + 0.5f * t33;
  highp float t36 = -1.0f * (turns[0] * sh[7].z - turns[1] * sh[5].z);
  highp float t37 = turns[6] * t35 - turns[7] * t36;
  highp float t38 = -0.8660254f * t34 + 0.5f * t37;
  result[4].z = turns[10] * t32 + turns[11] * t38;
  highp float t39 = turns[4] * t13 + turns[5] * t12;
  highp float t40 = -1.0f * (turns[6] * t18 + turns[7] * t17);
  result[5].x = turns[8] * t39 + turns[9] * t40;
  highp float t41 = turns[4] * t22 + turns[5] * t21;
  highp float t42 = -1.0f * (turns[6] * t27 + turns[7] * t26);
  result[5].y = turns[8] * t41 + turns[9] * t42;
  highp float t43 = turns[4] * t31 + turns[5] * t30;
  highp float t44 = -1.0f * (turns[6] * t36 + turns[7] * t35);
  result[5].z = turns[8] * t43 + turns[9] * t44;
  result[6].x = -0.5f * t16 + -0.8660254f * t19;
  result[6].y = -0.5f * t25 + -0.8660254f * t28;
  result[6].z = -0.5f * t34 + -0.8660254f * t37;
  result[7].x = turns[8] * t40 - turns[9] * t39;
  result[7].y = turns[8] * t42 - turns[9] * t41;
  result[7].z = turns[8] * t44 - turns[9] * t43;
  result[8].x = turns[10] * t20 - turns[11] * t14;
  result[8].y = turns[10] * t29 - turns[11] * t23;
  result[8].z = turns[10] * t38 - turns[11] * t32;
}
#endif

#ifndef ZONAL_PRODUCT_2
#define ZONAL_PRODUCT_2
// The product of two functions, of which the first bands are kept.
// 22 operations: 6 additions, 16 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_product_2(in highp float a[4], in highp float b[4], out highp float result[4]) {
  highp float t0 = a[0] * b[0] * 0.2820948f + a[2] * b[2] * 0.2820948f + (a[3] * b[3] + a[1] * b[1]) * 0.2820948f;
  result[0] = t0;
  result[1] = (a[1] * b[0] + a[0] * b[1]) * 0.2820948f;
  result[2] = (a[2] * b[0] + a[0] * b[2]) * 0.2820948f;
  result[3] = (a[3] * b[0] + a[0] * b[3]) * 0.2820948f;
}
#endif

#ifndef ZONAL_PRODUCT_3
#define ZONAL_PRODUCT_3
// The product of two functions, of which the first bands are kept.
// 181 operations: 71 additions, 110 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_product_3(in highp float a[9], in highp float b[9], out highp float result[9]) {
  highp float t0 = a[2] * b[2];
  highp float t1 = a[6] * b[6];
  highp float t2 = a[3] * b[3];
  highp float t3 = a[1] * b[1];
  highp float t4 = t2 + t3;
  highp float t5 = a[0] * b[0] * 0.2820948f + t0 * 0.2820948f + t1 * 0.2820948f + t4 * 0.2820948f;
  highp float t6 = a[7] * b[7];
  highp float t7 = a[5] * b[5];
  highp float t8 = t6 + t7;
  highp float t9 = a[8] * b[8] + a[4] * b[4];
  result[0] = t5 + t8 * 0.2820948f + t9 * 0.2820948f;
  highp float t10 = (a[1] * b[0] + a[0] * b[1]) * 0.2820948f + (a[1] * b[6] + a[6] * b[1]) * -0.12615663f;
  highp float t11 = t10 + (a[5] * b[2] + a[2] * b[5]) * 0.21850969f + (a[4] * b[3] + a[3] * b[4] - (a[8] * b[1] + a[1] * b[8])) * 0.21850969f;
  result[1] = t11;
  highp float t12 = (a[2] * b[0] + a[0] * b[2]) * 0.2820948f + (a[6] * b[2] + a[2] * b[6]) * 0.25231326f;
  highp float t13 = t12 + (a[7] * b[3] + a[3] * b[7] + (a[5] * b[1] + a[1] * b[5])) * 0.21850969f;
  result[2] = t13;
  highp float t14 = (a[3] * b[0] + a[0] * b[3]) * 0.2820948f + (a[3] * b[6] + a[6] * b[3]) * -0.12615663f;
  highp float t15 = t14 + (a[7] * b[2] + a[2] * b[7]) * 0.21850969f + (a[8] * b[3] + a[3] * b[8] + (a[4] * b[1] + a[1] * b[4])) * 0.21850969f;
  result[3] = t15;
  highp float t16 = (a[1] * b[3] + a[3] * b[1]) * 0.21850969f + (a[5] * b[7] + a[7] * b[5]) * 0.15607835f;
  highp float t17 = t16 + (a[4] * b[0] + a[0] * b[4]) * 0.2820948f + (a[4] * b[6] + a[6] * b[4]) * -0.18022375f;
  result[4] = t17;
  highp float t18 = (a[1] * b[2] + a[2] * b[1]) * 0.21850969f + (a[5] * b[0] + a[0] * b[5]) * 0.2820948f;
  highp float t19 = t18 + (a[5] * b[6] + a[6] * b[5]) * 0.090111874f + (a[4] * b[7] + a[7] * b[4] - (a[8] * b[5] + a[5] * b[8])) * 0.15607835f;
  result[5] = t19;
  highp float t20 = t0 * 0.25231326f + (a[6] * b[0] + a[0] * b[6]) * 0.2820948f + t1 * 0.18022375f;
  result[6] = t20 + t4 * -0.12615663f + t8 * 0.090111874f + t9 * -0.18022375f;
  highp float t21 = (a[3] * b[2] + a[2] * b[3]) * 0.21850969f + (a[7] * b[0] + a[0] * b[7]) * 0.2820948f;
  highp float t22 = t21 + (a[7] * b[6] + a[6] * b[7]) * 0.090111874f + (a[8] * b[7] + a[7] * b[8] + (a[4] * b[5] + a[5] * b[4])) * 0.15607835f;
  result[7] = t22;
  highp float t23 = (t2 - t3) * 0.21850969f + (t6 - t7) * 0.15607835f + (a[8] * b[0] + a[0] * b[8]) * 0.2820948f;
  result[8] = t23 + (a[8] * b[6] + a[6] * b[8]) * -0.18022375f;
}
#endif

#ifndef ZONAL_PRODUCT_COLOUR_2
#define ZONAL_PRODUCT_COLOUR_2
// The product of two functions, of which the first bands are kept. For colours.
// 66 operations: 18 additions, 48 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_product_colour_2(in highp vec3 a[4], in highp float b[4], out highp vec3 result[4]) {
  highp float t0 = a[0].x * b[0] * 0.2820948f + a[2].x * b[2] * 0.2820948f + (a[3].x * b[3] + a[1].x * b[1]) * 0.2820948f;
  result[0].x = t0;
  highp float t1 = a[0].y * b[0] * 0.2820948f + a[2].y * b[2] * 0.2820948f + (a[3].y * b[3] + a[1].y * b[1]) * 0.2820948f;
  result[0].y = t1;
  highp float t2 = a[0].z * b[0] * 0.2820948f + a[2].z * b[2] * 0.2820948f + (a[3].z * b[3] + a[1].z * b[1]) * 0.2820948f;
  result[0].z = t2;
  result[1].x = (a[1].x * b[0] + a[0].x * b[1]) * 0.2820948f;
  result[1].y = (a[1].y * b[0] + a[0].y * b[1]) * 0.2820948f;
  result[1].z = (a[1].z * b[0] + a[0].z * b[1]) * 0.2820948f;
  result[2].x = (a[2].x * b[0] + a[0].x * b[2]) * 0.2820948f;
  result[2].y = (a[2].y * b[0] + a[0].y * b[2]) * 0.2820948f;
  result[2].z = (a[2].z * b[0] + a[0].z * b[2]) * 0.2820948f;
  result[3].x = (a[3].x * b[0] + a[0].x * b[3]) * 0.2820948f;
  result[3].y = (a[3].y * b[0] + a[0].y * b[3]) * 0.2820948f;
  result[3].z = (a[3].z * b[0] + a[0].z * b[3]) * 0.2820948f;
}
#endif

#ifndef ZONAL_PRODUCT_COLOUR_3
#define ZONAL_PRODUCT_COLOUR_3
// The product of two functions, of which the first bands are kept. For colours.
// 543 operations: 213 additions, 330 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
void zonal_product_colour_3(in highp vec3 a[9], in highp float b[9], out highp vec3 result[9]) {
  highp float t0 = a[2].x * b[2];
  highp float t1 = a[6].x * b[6];
  highp float t2 = a[3].x * b[3];
  highp float t3 = a[1].x * b[1];
  highp float t4 = t2 + t3;
  highp float t5 = a[0].x * b[0] * 0.2820948f + t0 * 0.2820948f + t1 * 0.2820948f + t4 * 0.2820948f;
  highp float t6 = a[7].x * b[7];
  highp float t7 = a[5].x * b[5];
  highp float t8 = t6 + t7;
  highp float t9 = a[8].x * b[8] + a[4].x * b[4];
  result[0].x = t5 + t8 * 0.2820948f + t9 * 0.2820948f;
  highp float t10 = a[2].y * b[2];
  highp float t11 = a[6].y * b[6];
  highp float t12 = a[3].y * b[3];
  highp float t13 = a[1].y * b[1];
  highp float t14 = t12 + t13;
  highp float t15 = a[0].y * b[0] * 0.2820948f + t10 * 0.2820948f + t11 * 0.2820948f + t14 * 0.2820948f;
  highp float t16 = a[7].y * b[7];
  highp float t17 = a[5].y * b[5];
  highp float t18 = t16 + t17;
  highp float t19 = a[8].y * b[8] + a[4].y * b[4];
  result[0].y = t15 + t18 * 0.2820948f + t19 * 0.2820948f;
  highp float t20 = a[2].z * b[2];
  highp float t21 = a[6].z * b[6];
  highp float t22 = a[3].z * b[3];
  highp float t23 = a[1].z * b[1];
  highp float t24 = t22 + t23;
  highp float t25 = a[0].z * b[0] * 0.2820948f + t20 * 0.2820948f + t21 * 0.2820948f + t24 * 0.2820948f;
  highp float t26 = a[7].z * b[7];
  highp float t27 = a[5].z * b[5];
  highp float t28 = t26 + t27;
  highp float t29 = a[8].z * b[8] + a[4].z * b[4];
  result[0].z = t25 + t28 * 0.2820948f + t29 * 0.2820948f;
  highp float t30 = (a[1].x * b[0] + a[0].x * b[1]) * 0.2820948f + (a[1].x * b[6] + a[6].x * b[1]) * -0.12615663f;
  highp float t31 = (a[4].x * b[3] + a[3].x * b[4] - (a[8].x * b[1] + a[1].x * b[8])) * 0.21850969f;
  result[1].x = t30 + (a[5].x * b[2] + a[2].x * b[5]) * 0.21850969f + t31;
  highp float t32 = (a[1].y * b[0] + a[0].y * b[1]) * 0.2820948f + (a[1].y * b[6] + a[6].y * b[1]) * -0.12615663f;
  highp float t33 = (a[4].y * b[3] + a[3].y * b[4] - (a[8].y * b[1] + a[1].y * b[8])) * 0.21850969f;
  result[1].y = t32 + (a[5].y * b[2] + a[2].y * b[5]) * 0.21850969f + t33;
  highp float t34 = (a[1].z * b[0] + a[0].z * b[1]) * 0.2820948f + (a[1].z * b[6] + a[6].z * b[1]) * -0.12615663f;
  highp float t35 = (a[4].z * b[3] + a[3].z * b[4] - (a[8].z * b[1] + a[1].z * b[8])) * 0.21850969f;
  result[1].z = t34 + (a[5].z * b[2] + a[2].z * b[5]) * 0.21850969f + t35;
  highp float t36 = (a[2].x * b[0] + a[0].x * b[2]) * 0.2820948f + (a[6].x * b[2] + a[2].x * b[6]) * 0.25231326f;
  highp float t37 = (a[7].x * b[3] + a[3].x * b[7] + (a[5].x * b[1] + a[1].x * b[5])) * 0.21850969f;
  result[2].x = t36 + t37;
  highp float t38 = (a[2].y * b[0] + a[0].y * b[2]) * 0.2820948f + (a[6].y * b[2] + a[2].y * b[6]) * 0.25231326f;
  highp float t39 = (a[7].y * b[3] + a[3].y * b[7] + (a[5].y * b[1] + a[1].y * b[5])) * 0.21850969f;
  result[2].y = t38 + t39;
  highp float t40 = (a[2].z * b[0] + a[0].z * b[2]) * 0.2820948f + (a[6].z * b[2] + a[2].z * b[6]) * 0.25231326f;
  highp float t41 = (a[7].z * b[3] + a[3].z * b[7] + (a[5].z * b[1] + a[1].z * b[5])) * 0.21850969f;
  result[2].z = t40 + t41;
  highp float t42 = (a[3].x * b[0] + a[0].x * b[3]) * 0.2820948f + (a[3].x * b[6] + a[6].x * b[3]) * -0.12615663f;
  highp float t43 = (a[8].x * b[3] + a[3].x * b[8] + (a[4].x * b[1] + a[1].x * b[4])) * 0.21850969f;
  result[3].x = t42 + (a[7].x * b[2] + a[2].x * b[7]) * 0.21850969f + t43;
  highp float t44 = (a[3].y * b[0] + a[0].y * b[3]) * 0.2820948f + (a[3].y * b[6] + a[6].y * b[3]) * -0.12615663f;
  highp float t45 = (a[8].y * b[3] + a[3].y * b[8] + (a[4].y * b[1] + a[1].y * b[4])) * 0.21850969f;
  result[3].y = t44 + (a[7].y * b[2] + a[2].y * b[7]) * 0.21850969f + t45;
  highp float t46 = (a[3].z * b[0] + a[0].z * b[3]) * 0.2820948f + (a[3].z * b[6] + a[6].z * b[3]) * -0.12615663f;
  highp float t47 = (a[8].z * b[3] + a[3].z * b[8] + (a[4].z * b[1] + a[1].z * b[4])) * 0.21850969f;
  result[3].z = t46 + (a[7].z * b[2] + a[2].z * b[7]) * 0.21850969f + t47;
  highp float t48 = (a[1].x * b[3] + a[3].x * b[1]) * 0.21850969f + (a[5].x * b[7] + a[7].x * b[5]) * 0.15607835f;
  highp float t49 = t48 + (a[4].x * b[0] + a[0].x * b[4]) * 0.2820948f + (a[4].x * b[6] + a[6].x * b[4]) * -0.18022375f;
  result[4].x = t49;
  highp float t50 = (a[1].y * b[3] + a[3].y * b[1]) * 0.21850969f + (a[5].y * b[7] + a[7].y * b[5]) * 0.15607835f;
  highp float t51 = t50 + (a[4].y * b[0] + a[0].y * b[4]) * 0.2820948f + (a[4].y * b[6] + a[6].y * b[4]) * -0.18022375f;
  result[4].y = t51;
  highp float t52 = (a[1].z * b[3] + a[3].z * b[1]) * 0.21850969f + (a[5].z * b[7] + a[7].z * b[5]) * 0.15607835f;
  highp float t53 = t52 + (a[4].z * b[0] + a[0].z * b[4]) * 0.2820948f + (a[4].z * b[6] + a[6].z * b[4]) * -0.18022375f;
  result[4].z = t53;
  highp float t54 = (a[1].x * b[2] + a[2].x * b[1]) * 0.21850969f + (a[5].x * b[0] + a[0].x * b[5]) * 0.2820948f;
  highp float t55 = (a[4].x * b[7] + a[7].x * b[4] - (a[8].x * b[5] + a[5].x * b[8])) * 0.15607835f;
  result[5].x = t54 + (a[5].x * b[6] + a[6].x * b[5]) * 0.090111874f + t55;
  highp float t56 = (a[1].y * b[2] + a[2].y * b[1]) * 0.21850969f + (a[5].y * b[0] + a[0].y * b[5]) * 0.2820948f;
  highp float t57 = (a[4].y * b[7] + a[7].y * b[4] - (a[8].y * b[5] + a[5].y * b[8])) * 0.15607835f;
  result[5].y = t56 + (a[5].y * b[6] + a[6].y * b[5]) * 0.090111874f + t57;
  highp float t58 = (a[1].z * b[2] + a[2].z * b[1]) * 0.21850969f + (a[5].z * b[0] + a[0].z * b[5]) * 0.2820948f;
  highp float t59 = (a[4].z * b[7] + a[7].z * b[4] - (a[8].z * b[5] + a[5].z * b[8])) * 0.15607835f;
  result[5].z = t58 + (a[5].z * b[6] + a[6].z * b[5]) * 0.090111874f + t59;
  highp float t60 = t0 * 0.25231326f + (a[6].x * b[0] + a[0].x * b[6]) * 0.2820948f + t1 * 0.18022375f;
  result[6].x = t60 + t4 * -0.12615663f + t8 * 0.090111874f + t9 * -0.18022375f;
  highp float t61 = t10 * 0.25231326f + (a[6].y * b[0] + a[0].y * b[6]) * 0.2820948f + t11 * 0.18022375f;
  result[6].y = t61 + t14 * -0.12615663f + t18 * 0.090111874f + t19 * -0.18022375f;
  highp float t62 = t20 * 0.25231326f + (a[6].z * b[0] + a[0].z * b[6]) * 0.2820948f + t21 * 0.18022375f;
  result[6].z = t62 + t24 * -0.12615663f + t28 * 0.090111874f + t29 * -0.18022375f;
  highp float t63 = (a[3].x * b[2] + a[2].x * b[3]) * 0.21850969f + (a[7].x * b[0] + a[0].x * b[7]) * 0.2820948f;
  highp float t64 = (a[8].x * b[7] + a[7].x * b[8] + (a[4].x * b[5] + a[5].x * b[4])) * 0.15607835f;
  result[7].x = t63 + (a[7].x * b[6] + a[6].x * b[7]) * 0.090111874f + t64;
  highp float t65 = (a[3].y * b[2] + a[2].y * b[3]) * 0.21850969f + (a[7].y * b[0] + a[0].y * b[7]) * 0.2820948f;
  highp float t66 = (a[8].y * b[7] + a[7].y * b[8] + (a[4].y * b[5] + a[5].y * b[4])) * 0.15607835f;
  result[7].y = t65 + (a[7].y * b[6] + a[6].y * b[7]) * 0.090111874f + t66;
  highp float t67 = (a[3].z * b[2] + a[2].z * b[3]) * 0.21850969f + (a[7].z * b[0] + a[0].z * b[7]) * 0.2820948f;
  highp float t68 = (a[8].z * b[7] + a[7].z * b[8] + (a[4].z * b[5] + a[5].z * b[4])) * 0.15607835f;
  result[7].z = t67 + (a[7].z * b[6] + a[6].z * b[7]) * 0.090111874f + t68;
  highp float t69 = (t2 - t3) * 0.21850969f + (t6 - t7) * 0.15607835f + (a[8].x * b[0] + a[0].x * b[8]) * 0.2820948f;
  result[8].x = t69 + (a[8].x * b[6] + a[6].x * b[8]) * -0.18022375f;
  highp float t70 = (t12 - t13) * 0.21850969f + (t16 - t17) * 0.15607835f + (a[8].y * b[0] + a[0].y * b[8]) * 0.2820948f;
  result[8].y = t70 + (a[8].y * b[6] + a[6].y * b[8]) * -0.18022375f;
  highp float t71 = (t22 - t23) * 0.21850969f + (t26 - t27) * 0.15607835f + (a[8].z * b[0] + a[0].z * b[8]) * 0.2820948f;
  result[8].z = t71 + (a[8].z * b[6] + a[6].z * b[8]) * -0.18022375f;
}
#endif

#ifndef ZONAL_TRIPLE_PRODUCT_2
#define ZONAL_TRIPLE_PRODUCT_2
// The integral of the product of three functions.
// 29 operations: 9 additions, 20 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_triple_product_2(in highp float a[4], in highp float b[4], in highp float c[4]) {
  highp float t0 = a[0] * b[0] * 0.2820948f + a[2] * b[2] * 0.2820948f + (a[3] * b[3] + a[1] * b[1]) * 0.2820948f;
  highp float t1 = (a[2] * b[0] + a[0] * b[2]) * 0.2820948f * c[2] + (a[3] * b[0] + a[0] * b[3]) * 0.2820948f * c[3];
  highp float value = t0 * c[0] + (a[1] * b[0] + a[0] * b[1]) * 0.2820948f * c[1] + t1;
  return value;
}
#endif

#ifndef ZONAL_TRIPLE_PRODUCT_3
#define ZONAL_TRIPLE_PRODUCT_3
// The integral of the product of three functions.
// 198 operations: 79 additions, 119 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_triple_product_3(in highp float a[9], in highp float b[9], in highp float c[9]) {
  highp float t0 = a[2] * b[2];
  highp float t1 = a[6] * b[6];
  highp float t2 = a[3] * b[3];
  highp float t3 = a[1] * b[1];
  highp float t4 = t2 + t3;
  highp float t5 = a[0] * b[0] * 0.2820948f + t0 * 0.2820948f + t1 * 0.2820948f + t4 * 0.2820948f;
  highp float t6 = a[7] * b[7];
  highp float t7 = a[5] * b[5];
  highp float t8 = t6 + t7;
  highp float t9 = a[8] * b[8] + a[4] * b[4];
  highp float t10 = (a[1] * b[3] + a[3] * b[1]) * 0.21850969f + (a[5] * b[7] + a[7] * b[5]) * 0.15607835f;
  highp float t11 = t10 + (a[4] * b[0] + a[0] * b[4]) * 0.2820948f + (a[4] * b[6] + a[6] * b[4]) * -0.18022375f;
  highp float t12 = (t2 - t3) * 0.21850969f + (t6 - t7) * 0.15607835f + (a[8] * b[0] + a[0] * b[8]) * 0.2820948f;
  highp float t13 = (t5 + t8 * 0.2820948f + t9 * 0.2820948f) * c[0] + t11 * c[4] + (t12 + (a[8] * b[6] + a[6] * b[8]) * -0.18022375f) * c[8];
  highp float t14 = (a[1] * b[0] + a[0] * b[1]) * 0.2820948f + (a[1] * b[6] + a[6] * b[1]) * -0.12615663f;
  highp float t15 = t14 + (a[5] * b[2] + a[2] * b[5]) * 0.21850969f + (a[4] * b[3] + a[3] * b[4] - (a[8] * b[1] + a[1] * b[8])) * 0.21850969f;
  highp float t16 = (a[1] * b[2] + a[2] * b[1]) * 0.21850969f + (a[5] * b[0] + a[0] * b[5]) * 0.2820948f;
  highp float t17 = t16 + (a[5] * b[6] + a[6] * b[5]) * 0.090111874f + (a[4] * b[7] + a[7] * b[4] - (a[8] * b[5] + a[5] * b[8])) * 0.15607835f;
  highp float t18 = (a[2] * b[0] + a[0] * b[2]) * 0.2820948f + (a[6] * b[2] + a[2] * b[6]) * 0.25231326f;
  highp float t19 = t18 + (a[7] * b[3] + a[3] * b[7] + (a[5] * b[1] + a[1] * b[5])) * 0.21850969f;
  highp float t20 = t0 * 0.25231326f + (a[6] * b[0] + a[0] * b[6]) * 0.2820948f + t1 * 0.18022375f;
  highp float t21 = (t20 + t4 * -0.12615663f + t8 * 0.090111874f + t9 * -0.18022375f) * c[6];
  highp float t22 = (a[3] * b[0] + a[0] * b[3]) * 0.2820948f + (a[3] * b[6] + a[6] * b[3]) * -0.12615663f;
  highp float t23 = t22 + (a[7] * b[2] + a[2] * b[7]) * 0.21850969f + (a[8] * b[3] + a[3] * b[8] + (a[4] * b[1] + a[1] * b[4])) * 0.21850969f;
  highp float t24 = (a[3] * b[2] + a[2] * b[3]) * 0.21850969f + (a[7] * b[0] + a[0] * b[7]) * 0.2820948f;
  highp float t25 = t24 + (a[7] * b[6] + a[6] * b[7]) * 0.090111874f + (a[8] * b[7] + a[7] * b[8] + (a[4] * b[5] + a[5] * b[4])) * 0.15607835f;
  highp float t26 = t13 + (t15 * c[1] + t17 * c[5]) + (t19 * c[2] + t21 + (t23 * c[3] + t25 * c[7]));
  highp float value = t26;
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_SEVEN_VECTORS
#define ZONAL_RECONSTRUCT_SEVEN_VECTORS
// Irradiance over pi of one channel of Unity's or Unreal's seven vectors, at a normal.
// 23 operations: 9 additions, 14 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_reconstruct_seven_vectors(in highp float a[4], in highp float b[4], highp float c,
    highp vec3 normal) {
  highp float t0 = b[0] * (normal.x * normal.y) + b[1] * (normal.y * normal.z) + b[2] * (normal.z * normal.z);
  highp float t1 = a[0] * normal.x + a[1] * normal.y + a[2] * normal.z + a[3] + (t0 + b[3] * (normal.z * normal.x));
  highp float value = t1 + c * (normal.x * normal.x - normal.y * normal.y);
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_NINE_POLYNOMIALS_COLOUR
#define ZONAL_RECONSTRUCT_NINE_POLYNOMIALS_COLOUR
// Irradiance over pi of Babylon.js' polynomial, x y z xx yy zz yz zx xy, at a normal. For colours.
// 57 operations: 24 additions, 33 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_reconstruct_nine_polynomials_colour(in highp vec3 polynomial[9], highp vec3 normal) {
  highp float t0 = polynomial[0].x * normal.x + polynomial[1].x * normal.y + polynomial[2].x * normal.z;
  highp float t1 = normal.x * normal.x;
  highp float t2 = normal.y * normal.y;
  highp float t3 = normal.z * normal.z;
  highp float t4 = normal.y * normal.z;
  highp float t5 = t0 + polynomial[3].x * t1 + polynomial[4].x * t2 + polynomial[5].x * t3 + polynomial[6].x * t4;
  highp float t6 = normal.z * normal.x;
  highp float t7 = normal.x * normal.y;
  highp float t8 = polynomial[0].y * normal.x + polynomial[1].y * normal.y + polynomial[2].y * normal.z;
  highp float t9 = t8 + polynomial[3].y * t1 + polynomial[4].y * t2 + polynomial[5].y * t3 + polynomial[6].y * t4;
  highp float t10 = polynomial[0].z * normal.x + polynomial[1].z * normal.y + polynomial[2].z * normal.z;
  highp float t11 = t10 + polynomial[3].z * t1 + polynomial[4].z * t2 + polynomial[5].z * t3;
  highp float t12 = t11 + polynomial[6].z * t4 + polynomial[7].z * t6 + polynomial[8].z * t7;
  highp vec3 value = vec3(t5 + polynomial[7].x * t6 + polynomial[8].x * t7,
      t9 + polynomial[7].y * t6 + polynomial[8].y * t7,
      t12);
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_POLYNOMIALS_COLOUR
#define ZONAL_RECONSTRUCT_POLYNOMIALS_COLOUR
// The value of plain polynomials, 1 y z x xy yz 3zz-1 xz xx-yy, as Filament's shaders and Unity's nine have it. For colours.
// 57 operations: 26 additions, 31 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_reconstruct_polynomials_colour(in highp vec3 polynomials[9], highp vec3 normal) {
  highp float t0 = polynomials[0].x + polynomials[1].x * normal.y + polynomials[2].x * normal.z;
  highp float t1 = normal.x * normal.y;
  highp float t2 = normal.y * normal.z;
  highp float t3 = t0 + polynomials[3].x * normal.x + polynomials[4].x * t1 + polynomials[5].x * t2;
  highp float t4 = 3.0f * (normal.z * normal.z) - 1.0f;
  highp float t5 = normal.x * normal.z;
  highp float t6 = normal.x * normal.x - normal.y * normal.y;
  highp float t7 = t3 + polynomials[6].x * t4 + polynomials[7].x * t5 + polynomials[8].x * t6;
  highp float t8 = polynomials[0].y + polynomials[1].y * normal.y + polynomials[2].y * normal.z;
  highp float t9 = t8 + polynomials[3].y * normal.x + polynomials[4].y * t1 + polynomials[5].y * t2;
  highp float t10 = t9 + polynomials[6].y * t4 + polynomials[7].y * t5 + polynomials[8].y * t6;
  highp float t11 = polynomials[0].z + polynomials[1].z * normal.y + polynomials[2].z * normal.z;
  highp float t12 = t11 + polynomials[3].z * normal.x + polynomials[4].z * t1 + polynomials[5].z * t2;
  highp float t13 = t12 + polynomials[6].z * t4 + polynomials[7].z * t5 + polynomials[8].z * t6;
  highp vec3 value = vec3(t7, t10, t13);
  return value;
}
#endif

#ifndef ZONAL_LINEAR_AXIS
#define ZONAL_LINEAR_AXIS
// Where the light of two bands comes from, a unit vector; z where from nowhere.
// 16 operations: 4 additions, 3 multiplications, 3 divisions, 1 square roots, 5 comparisons and choices.
highp vec3 zonal_linear_axis(in highp float radiance[4]) {
  highp float t0 = -radiance[3];
  highp float t1 = -radiance[1];
  highp float t2 = t0 * t0 + t1 * t1 + radiance[2] * radiance[2];
  bool is_3 = t2 < 1e-30f;
  highp float t4 = sqrt(max(t2, 1e-30f));
  highp vec3 axis = vec3(is_3 ? 0.0f : t0 / t4,
      is_3 ? 0.0f : t1 / t4,
      is_3 ? 1.0f : radiance[2] / t4);
  return axis;
}
#endif

#ifndef ZONAL_HALLUCINATE_ZH3
#define ZONAL_HALLUCINATE_ZH3
// ZH3's quadratic coefficient, guessed from two bands and their axis.
// 13 operations: 5 additions, 5 multiplications, 1 divisions, 0 square roots, 2 comparisons and choices.
highp float zonal_hallucinate_zh3(in highp float radiance[4], highp vec3 axis) {
  highp float t0 = abs(-radiance[3] * axis.x + -radiance[1] * axis.y + radiance[2] * axis.z);
  highp float zonal = t0 * (0.08f + 0.6f * (t0 / max(radiance[0], 1e-30f)));
  return zonal;
}
#endif

#ifndef ZONAL_HALLUCINATE_ZH3_COLOUR
#define ZONAL_HALLUCINATE_ZH3_COLOUR
// ZH3's quadratic coefficient, guessed from two bands and their axis. For colours.
// 39 operations: 15 additions, 15 multiplications, 3 divisions, 0 square roots, 6 comparisons and choices.
highp vec3 zonal_hallucinate_zh3_colour(in highp vec3 radiance[4], highp vec3 axis) {
  highp float t0 = -radiance[3].x * axis.x + -radiance[1].x * axis.y + radiance[2].x * axis.z;
  highp float t1 = abs(t0);
  highp float t2 = -radiance[3].y * axis.x + -radiance[1].y * axis.y + radiance[2].y * axis.z;
  highp float t3 = abs(t2);
  highp float t4 = -radiance[3].z * axis.x + -radiance[1].z * axis.y + radiance[2].z * axis.z;
  highp float t5 = abs(t4);
  highp vec3 zonal = vec3(t1 * (0.08f + 0.6f * (t1 / max(radiance[0].x, 1e-30f))),
      t3 * (0.08f + 0.6f * (t3 / max(radiance[0].y, 1e-30f))),
      t5 * (0.08f + 0.6f * (t5 / max(radiance[0].z, 1e-30f))));
  return zonal;
}
#endif

#ifndef ZONAL_IRRADIANCE_ZH3
#define ZONAL_IRRADIANCE_ZH3
// Irradiance over pi of ZH3, radiance of two bands and one quadratic about an axis.
// 23 operations: 7 additions, 16 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_irradiance_zh3(in highp float radiance[4], highp float zonal, highp vec3 axis, highp vec3 normal) {
  highp float t0 = radiance[2] * (0.48860252f * normal.z) + radiance[1] * (-0.48860252f * normal.y);
  highp float t1 = radiance[0] * 0.2820948f + (t0 + radiance[3] * (-0.48860252f * normal.x)) * 0.6666667f;
  highp float t2 = axis.x * normal.x + axis.y * normal.y + axis.z * normal.z;
  highp float value = t1 + 0.25f * (zonal * (0.31539157f * (3.0f * t2 * t2 - 1.0f)));
  return value;
}
#endif

#ifndef ZONAL_IRRADIANCE_ZH3_COLOUR
#define ZONAL_IRRADIANCE_ZH3_COLOUR
// Irradiance over pi of ZH3, radiance of two bands and one quadratic about an axis. For colours.
// 45 operations: 15 additions, 30 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_irradiance_zh3_colour(in highp vec3 radiance[4], highp vec3 zonal, highp vec3 axis,
    highp vec3 normal) {
  highp float t0 = 0.48860252f * normal.z;
  highp float t1 = -0.48860252f * normal.y;
  highp float t2 = -0.48860252f * normal.x;
  highp float t3 = (radiance[2].x * t0 + radiance[1].x * t1 + radiance[3].x * t2) * 0.6666667f;
  highp float t4 = axis.x * normal.x + axis.y * normal.y + axis.z * normal.z;
  highp float t5 = 0.31539157f * (3.0f * t4 * t4 - 1.0f);
  highp float t6 = (radiance[2].y * t0 + radiance[1].y * t1 + radiance[3].y * t2) * 0.6666667f;
  highp float t7 = (radiance[2].z * t0 + radiance[1].z * t1 + radiance[3].z * t2) * 0.6666667f;
  highp vec3 value = vec3(radiance[0].x * 0.2820948f + t3 + 0.25f * (zonal.x * t5),
      radiance[0].y * 0.2820948f + t6 + 0.25f * (zonal.y * t5),
      radiance[0].z * 0.2820948f + t7 + 0.25f * (zonal.z * t5));
  return value;
}
#endif

#ifndef ZONAL_IRRADIANCE_NONLINEAR
#define ZONAL_IRRADIANCE_NONLINEAR
// Irradiance over pi of radiance of two bands, Geomerics' positive curve.
// 157 operations: 43 additions, 41 multiplications, 7 divisions, 1 square roots, 65 comparisons and choices.
highp float zonal_irradiance_nonlinear(in highp float radiance[4], highp vec3 normal) {
  highp float t0 = -radiance[3];
  highp float t1 = -radiance[1];
  highp float t2 = t0 * t0 + t1 * t1 + radiance[2] * radiance[2];
  bool is_3 = t2 < 1e-30f;
  highp float t4 = sqrt(max(t2, 1e-30f));
  highp float t5 = min(0.57735026f * (is_3 ? 0.0f : t4) / max(radiance[0], 1e-30f), 1.0f);
  highp float t6 = 1.0f + t5;
  highp float t7 = (1.0f - t5) / t6;
  highp float t8 = t6 + t5;
  highp float t9 = (is_3 ? 0.0f : t0 / t4) * normal.x + (is_3 ? 0.0f : t1 / t4) * normal.y + (is_3 ? 1.0f : radiance[2] / t4) * normal.z;
  highp float t10 = max(min(max(0.5f + 0.5f * t9, 0.0f), 1.0f), 1.0842022e-19f);
  bool is_11 = t10 < 2.3283064e-10f;
  highp float t12 = is_11 ? t10 * 4294967296.0f : t10;
  bool is_13 = t12 < 1.5258789e-05f;
  highp float t14 = is_13 ? t12 * 65536.0f : t12;
  bool is_15 = t14 < 0.00390625f;
  highp float t16 = is_15 ? t14 * 256.0f : t14;
  bool is_17 = t16 < 0.0625f;
  highp float t18 = is_17 ? t16 * 16.0f : t16;
  bool is_19 = t18 < 0.25f;
  highp float t20 = is_19 ? t18 * 4.0f : t18;
  bool is_21 = t20 < 0.5f;
  highp float t22 = is_21 ? t20 * 2.0f : t20;
  bool is_23 = t22 < 0.70710677f;
  highp float t24 = is_11 ? -32.0f : 0.0f;
  highp float t25 = is_13 ? t24 - 16.0f : t24;
  highp float t26 = is_15 ? t25 - 8.0f : t25;
  highp float t27 = is_17 ? t26 - 4.0f : t26;
  highp float t28 = is_19 ? t27 - 2.0f : t27;
  highp float t29 = is_21 ? t28 - 1.0f : t28;
  highp float t30 = is_23 ? t22 + t22 : t22;
  highp float t31 = (t30 - 1.0f) / (t30 + 1.0f);
  highp float t32 = t31 * t31;
  highp float t33 = (((0.11111111f * t32 + 0.14285715f) * t32 + 0.2f) * t32 + 0.33333334f) * t32;
  highp float t34 = t8 * ((is_23 ? t29 - 1.0f : t29) * 0.6931472f + (t31 + t31) * (t33 + 1.0f));
  highp float t35 = min(abs(t34), 105.35837f);
  bool is_36 = 64.0f <= t35;
  bool is_37 = t34 < 0.0f;
  highp float t38 = is_36 ? t35 - 64.0f : t35;
  bool is_39 = 32.0f <= t38;
  highp float t40 = is_39 ? t38 - 32.0f : t38;
  bool is_41 = 16.0f <= t40;
  highp float t42 = is_41 ? t40 - 16.0f : t40;
  bool is_43 = 8.0f <= t42;
  highp float t44 = is_43 ? t42 - 8.0f : t42;
  bool is_45 = 4.0f <= t44;
  highp float t46 = is_45 ? t44 - 4.0f : t44;
  bool is_47 = 2.0f <= t46;
  highp float t48 = is_47 ? t46 - 2.0f : t46;
  bool is_49 = 1.0f <= t48;
  highp float t50 = is_49 ? t48 - 1.0f : t48;
  bool is_51 = 0.5f <= t50;
  highp float t52 = is_51 ? t50 - 0.5f : t50;
  bool is_53 = 0.25f <= t52;
  highp float t54 = is_39 ? 1.2664166e-14f : 1.0f;
  highp float t55 = is_41 ? t54 * 1.12535176e-07f : t54;
  highp float t56 = is_43 ? t55 * 0.00033546262f : t55;
  highp float t57 = is_45 ? t56 * 0.01831564f : t56;
  highp float t58 = is_47 ? t57 * 0.13533528f : t57;
  highp float t59 = is_49 ? t58 * 0.36787945f : t58;
  highp float t60 = is_51 ? t59 * 0.60653067f : t59;
  highp float t61 = is_53 ? t52 - 0.25f : t52;
  highp float t62 = 0.16666667f - t61 * (0.041666668f - t61 * (0.008333334f - t61 * 0.0013888889f));
  highp float t63 = (is_53 ? t60 * 0.7788008f : t60) * (1.0f - t61 * (1.0f - t61 * (0.5f - t61 * t62)));
  highp float t64 = is_37 ? t63 : 1.0f / t63;
  highp float t65 = (1.0f - t7) * (t8 + 1.0f) * (is_36 ? t64 * (is_37 ? 1.6038109e-28f : 6.235149e+27f) : t64);
  highp float value = max(radiance[0], 0.0f) * 0.2820948f * (t7 + t65);
  return value;
}
#endif

#ifndef ZONAL_IRRADIANCE_NONLINEAR_COLOUR
#define ZONAL_IRRADIANCE_NONLINEAR_COLOUR
// Irradiance over pi of radiance of two bands, Geomerics' positive curve. For colours.
// 471 operations: 129 additions, 123 multiplications, 21 divisions, 3 square roots, 195 comparisons and choices.
highp vec3 zonal_irradiance_nonlinear_colour(in highp vec3 radiance[4], highp vec3 normal) {
  highp float t0 = -radiance[3].x;
  highp float t1 = -radiance[1].x;
  highp float t2 = t0 * t0 + t1 * t1 + radiance[2].x * radiance[2].x;
  bool is_3 = t2 < 1e-30f;
  highp float t4 = sqrt(max(t2, 1e-30f));
  highp float t5 = min(0.57735026f * (is_3 ? 0.0f : t4) / max(radiance[0].x, 1e-30f), 1.0f);
  highp float t6 = 1.0f + t5;
  highp float t7 = (1.0f - t5) / t6;
  highp float t8 = t6 + t5;
  highp float t9 = (is_3 ? 0.0f : t0 / t4) * normal.x + (is_3 ? 0.0f : t1 / t4) * normal.y + (is_3 ? 1.0f : radiance[2].x / t4) * normal.z;
  highp float t10 = max(min(max(0.5f + 0.5f * t9, 0.0f), 1.0f), 1.0842022e-19f);
  bool is_11 = t10 < 2.3283064e-10f;
  highp float t12 = is_11 ? t10 * 4294967296.0f : t10;
  bool is_13 = t12 < 1.5258789e-05f;
  highp float t14 = is_13 ? t12 * 65536.0f : t12;
  bool is_15 = t14 < 0.00390625f;
  highp float t16 = is_15 ? t14 * 256.0f : t14;
  bool is_17 = t16 < 0.0625f;
  highp float t18 = is_17 ? t16 * 16.0f : t16;
  bool is_19 = t18 < 0.25f;
  highp float t20 = is_19 ? t18 * 4.0f : t18;
  bool is_21 = t20 < 0.5f;
  highp float t22 = is_21 ? t20 * 2.0f : t20;
  bool is_23 = t22 < 0.70710677f;
  highp float t24 = is_11 ? -32.0f : 0.0f;
  highp float t25 = is_13 ? t24 - 16.0f : t24;
  highp float t26 = is_15 ? t25 - 8.0f : t25;
  highp float t27 = is_17 ? t26 - 4.0f : t26;
  highp float t28 = is_19 ? t27 - 2.0f : t27;
  highp float t29 = is_21 ? t28 - 1.0f : t28;
  highp float t30 = is_23 ? t22 + t22 : t22;
  highp float t31 = (t30 - 1.0f) / (t30 + 1.0f);
  highp float t32 = t31 * t31;
  highp float t33 = (((0.11111111f * t32 + 0.14285715f) * t32 + 0.2f) * t32 + 0.33333334f) * t32;
  highp float t34 = t8 * ((is_23 ? t29 - 1.0f : t29) * 0.6931472f + (t31 + t31) * (t33 + 1.0f));
  highp float t35 = min(abs(t34), 105.35837f);
  bool is_36 = 64.0f <= t35;
  bool is_37 = t34 < 0.0f;
  highp float t38 = is_36 ? t35 - 64.0f : t35;
  bool is_39 = 32.0f <= t38;
  highp float t40 = is_39 ? t38 - 32.0f : t38;
  bool is_41 = 16.0f <= t40;
  highp float t42 = is_41 ? t40 - 16.0f : t40;
  bool is_43 = 8.0f <= t42;
  highp float t44 = is_43 ? t42 - 8.0f : t42;
  bool is_45 = 4.0f <= t44;
  highp float t46 = is_45 ? t44 - 4.0f : t44;
  bool is_47 = 2.0f <= t46;
  highp float t48 = is_47 ? t46 - 2.0f : t46;
  bool is_49 = 1.0f <= t48;
  highp float t50 = is_49 ? t48 - 1.0f : t48;
  bool is_51 = 0.5f <= t50;
  highp float t52 = is_51 ? t50 - 0.5f : t50;
  bool is_53 = 0.25f <= t52;
  highp float t54 = is_39 ? 1.2664166e-14f : 1.0f;
  highp float t55 = is_41 ? t54 * 1.12535176e-07f : t54;
  highp float t56 = is_43 ? t55 * 0.00033546262f : t55;
  highp float t57 = is_45 ? t56 * 0.01831564f : t56;
  highp float t58 = is_47 ? t57 * 0.13533528f : t57;
  highp float t59 = is_49 ? t58 * 0.36787945f : t58;
  highp float t60 = is_51 ? t59 * 0.60653067f : t59;
  highp float t61 = is_53 ? t52 - 0.25f : t52;
  highp float t62 = 0.16666667f - t61 * (0.041666668f - t61 * (0.008333334f - t61 * 0.0013888889f));
  highp float t63 = (is_53 ? t60 * 0.7788008f : t60) * (1.0f - t61 * (1.0f - t61 * (0.5f - t61 * t62)));
  highp float t64 = is_37 ? t63 : 1.0f / t63;
  highp float t65 = (1.0f - t7) * (t8 + 1.0f) * (is_36 ? t64 * (is_37 ? 1.6038109e-28f : 6.235149e+27f) : t64);
  highp float t66 = -radiance[3].y;
  highp float t67 = -radiance[1].y;
  highp float t68 = t66 * t66 + t67 * t67 + radiance[2].y * radiance[2].y;
  bool is_69 = t68 < 1e-30f;
  highp float t70 = sqrt(max(t68, 1e-30f));
  highp float t71 = min(0.57735026f * (is_69 ? 0.0f : t70) / max(radiance[0].y, 1e-30f), 1.0f);
  highp float t72 = 1.0f + t71;
  highp float t73 = (1.0f - t71) / t72;
  highp float t74 = t72 + t71;
  highp float t75 = (is_69 ? 0.0f : t66 / t70) * normal.x + (is_69 ? 0.0f : t67 / t70) * normal.y;
  highp float t76 = max(0.5f + 0.5f * (t75 + (is_69 ? 1.0f : radiance[2].y / t70) * normal.z), 0.0f);
  highp float t77 = max(min(t76, 1.0f), 1.0842022e-19f);
  bool is_78 = t77 < 2.3283064e-10f;
  highp float t79 = is_78 ? t77 * 4294967296.0f : t77;
  bool is_80 = t79 < 1.5258789e-05f;
  highp float t81 = is_80 ? t79 * 65536.0f : t79;
  bool is_82 = t81 < 0.00390625f;
  highp float t83 = is_82 ? t81 * 256.0f : t81;
  bool is_84 = t83 < 0.0625f;
  highp float t85 = is_84 ? t83 * 16.0f : t83;
  bool is_86 = t85 < 0.25f;
  highp float t87 = is_86 ? t85 * 4.0f : t85;
  bool is_88 = t87 < 0.5f;
  highp float t89 = is_88 ? t87 * 2.0f : t87;
  bool is_90 = t89 < 0.70710677f;
  highp float t91 = is_78 ? -32.0f : 0.0f;
  highp float t92 = is_80 ? t91 - 16.0f : t91;
  highp float t93 = is_82 ? t92 - 8.0f : t92;
  highp float t94 = is_84 ? t93 - 4.0f : t93;
  highp float t95 = is_86 ? t94 - 2.0f : t94;
  highp float t96 = is_88 ? t95 - 1.0f : t95;
  highp float t97 = is_90 ? t89 + t89 : t89;
  highp float t98 = (t97 - 1.0f) / (t97 + 1.0f);
  highp float t99 = t98 * t98;
  highp float t100 = (((0.11111111f * t99 + 0.14285715f) * t99 + 0.2f) * t99 + 0.33333334f) * t99;
  highp float t101 = t74 * ((is_90 ? t96 - 1.0f : t96) * 0.6931472f + (t98 + t98) * (t100 + 1.0f));
  highp float t102 = min(abs(t101), 105.35837f);
  bool is_103 = 64.0f <= t102;
  bool is_104 = t101 < 0.0f;
  highp float t105 = is_103 ? t102 - 64.0f : t102;
  bool is_106 = 32.0f <= t105;
  highp float t107 = is_106 ? t105 - 32.0f : t105;
  bool is_108 = 16.0f <= t107;
  highp float t109 = is_108 ? t107 - 16.0f : t107;
  bool is_110 = 8.0f <= t109;
  highp float t111 = is_110 ? t109 - 8.0f : t109;
  bool is_112 = 4.0f <= t111;
  highp float t113 = is_112 ? t111 - 4.0f : t111;
  bool is_114 = 2.0f <= t113;
  highp float t115 = is_114 ? t113 - 2.0f : t113;
  bool is_116 = 1.0f <= t115;
  highp float t117 = is_116 ? t115 - 1.0f : t115;
  bool is_118 = 0.5f <= t117;
  highp float t119 = is_118 ? t117 - 0.5f : t117;
  bool is_120 = 0.25f <= t119;
  highp float t121 = is_106 ? 1.2664166e-14f : 1.0f;
  highp float t122 = is_108 ? t121 * 1.12535176e-07f : t121;
  highp float t123 = is_110 ? t122 * 0.00033546262f : t122;
  highp float t124 = is_112 ? t123 * 0.01831564f : t123;
  highp float t125 = is_114 ? t124 * 0.13533528f : t124;
  highp float t126 = is_116 ? t125 * 0.36787945f : t125;
  highp float t127 = is_118 ? t126 * 0.60653067f : t126;
  highp float t128 = is_120 ? t119 - 0.25f : t119;
  highp float t129 = 0.16666667f - t128 * (0.041666668f - t128 * (0.008333334f - t128 * 0.0013888889f));
  highp float t130 = (is_120 ? t127 * 0.7788008f : t127) * (1.0f - t128 * (1.0f - t128 * (0.5f - t128 * t129)));
  highp float t131 = is_104 ? t130 : 1.0f / t130;
  highp float t132 = (1.0f - t73) * (t74 + 1.0f) * (is_103 ? t131 * (is_104 ? 1.6038109e-28f : 6.235149e+27f) : t131);
  highp float t133 = -radiance[3].z;
  highp float t134 = -radiance[1].z;
  highp float t135 = t133 * t133 + t134 * t134 + radiance[2].z * radiance[2].z;
  bool is_136 = t135 < 1e-30f;
  highp float t137 = sqrt(max(t135, 1e-30f));
  highp float t138 = min(0.57735026f * (is_136 ? 0.0f : t137) / max(radiance[0].z, 1e-30f), 1.0f);
  highp float t139 = 1.0f + t138;
  highp float t140 = (1.0f - t138) / t139;
  highp float t141 = t139 + t138;
  highp float t142 = (is_136 ? 0.0f : t133 / t137) * normal.x + (is_136 ? 0.0f : t134 / t137) * normal.y;
  highp float t143 = 0.5f + 0.5f * (t142 + (is_136 ? 1.0f : radiance[2].z / t137) * normal.z);
  highp float t144 = max(min(max(t143, 0.0f), 1.0f), 1.0842022e-19f);
  bool is_145 = t144 < 2.3283064e-10f;
  highp float t146 = is_145 ? t144 * 4294967296.0f : t144;
  bool is_147 = t146 < 1.5258789e-05f;
  highp float t148 = is_147 ? t146 * 65536.0f : t146;
  bool is_149 = t148 < 0.00390625f;
  highp float t150 = is_149 ? t148 * 256.0f : t148;
  bool is_151 = t150 < 0.0625f;
  highp float t152 = is_151 ? t150 * 16.0f : t150;
  bool is_153 = t152 < 0.25f;
  highp float t154 = is_153 ? t152 * 4.0f : t152;
  bool is_155 = t154 < 0.5f;
  highp float t156 = is_155 ? t154 * 2.0f : t154;
  bool is_157 = t156 < 0.70710677f;
  highp float t158 = is_145 ? -32.0f : 0.0f;
  highp float t159 = is_147 ? t158 - 16.0f : t158;
  highp float t160 = is_149 ? t159 - 8.0f : t159;
  highp float t161 = is_151 ? t160 - 4.0f : t160;
  highp float t162 = is_153 ? t161 - 2.0f : t161;
  highp float t163 = is_155 ? t162 - 1.0f : t162;
  highp float t164 = is_157 ? t156 + t156 : t156;
  highp float t165 = (t164 - 1.0f) / (t164 + 1.0f);
  highp float t166 = t165 * t165;
  highp float t167 = (((0.11111111f * t166 + 0.14285715f) * t166 + 0.2f) * t166 + 0.33333334f) * t166;
  highp float t168 = (is_157 ? t163 - 1.0f : t163) * 0.6931472f + (t165 + t165) * (t167 + 1.0f);
  highp float t169 = t141 * t168;
  highp float t170 = min(abs(t169), 105.35837f);
  bool is_171 = 64.0f <= t170;
  bool is_172 = t169 < 0.0f;
  highp float t173 = is_171 ? t170 - 64.0f : t170;
  bool is_174 = 32.0f <= t173;
  highp float t175 = is_174 ? t173 - 32.0f : t173;
  bool is_176 = 16.0f <= t175;
  highp float t177 = is_176 ? t175 - 16.0f : t175;
  bool is_178 = 8.0f <= t177;
  highp float t179 = is_178 ? t177 - 8.0f : t177;
  bool is_180 = 4.0f <= t179;
  highp float t181 = is_180 ? t179 - 4.0f : t179;
  bool is_182 = 2.0f <= t181;
  highp float t183 = is_182 ? t181 - 2.0f : t181;
  bool is_184 = 1.0f <= t183;
  highp float t185 = is_184 ? t183 - 1.0f : t183;
  bool is_186 = 0.5f <= t185;
  highp float t187 = is_186 ? t185 - 0.5f : t185;
  bool is_188 = 0.25f <= t187;
  highp float t189 = is_174 ? 1.2664166e-14f : 1.0f;
  highp float t190 = is_176 ? t189 * 1.12535176e-07f : t189;
  highp float t191 = is_178 ? t190 * 0.00033546262f : t190;
  highp float t192 = is_180 ? t191 * 0.01831564f : t191;
  highp float t193 = is_182 ? t192 * 0.13533528f : t192;
  highp float t194 = is_184 ? t193 * 0.36787945f : t193;
  highp float t195 = is_186 ? t194 * 0.60653067f : t194;
  highp float t196 = is_188 ? t187 - 0.25f : t187;
  highp float t197 = 0.16666667f - t196 * (0.041666668f - t196 * (0.008333334f - t196 * 0.0013888889f));
  highp float t198 = (is_188 ? t195 * 0.7788008f : t195) * (1.0f - t196 * (1.0f - t196 * (0.5f - t196 * t197)));
  highp float t199 = is_172 ? t198 : 1.0f / t198;
  highp float t200 = (1.0f - t140) * (t141 + 1.0f) * (is_171 ? t199 * (is_172 ? 1.6038109e-28f : 6.235149e+27f) : t199);
  highp vec3 value = vec3(max(radiance[0].x, 0.0f) * 0.2820948f * (t7 + t65),
      max(radiance[0].y, 0.0f) * 0.2820948f * (t73 + t132),
      max(radiance[0].z, 0.0f) * 0.2820948f * (t140 + t200));
  return value;
}
#endif

#ifndef ZONAL_IRRADIANCE_SIX_FLOATS
#define ZONAL_IRRADIANCE_SIX_FLOATS
// Irradiance over pi, RGB, of luminance on two bands with Co and Cg.
// 24 operations: 7 additions, 11 multiplications, 1 divisions, 0 square roots, 5 comparisons and choices.
highp vec3 zonal_irradiance_six_floats(in highp float luminance[4], highp float co, highp float cg,
    highp vec3 normal) {
  highp float t0 = luminance[2] * (0.48860252f * normal.z) + luminance[1] * (-0.48860252f * normal.y);
  highp float t1 = luminance[0] * 0.2820948f + (t0 + luminance[3] * (-0.48860252f * normal.x)) * 0.6666667f;
  highp float t2 = max(t1, 0.0f);
  highp float t3 = 0.5f * (t2 / max(luminance[0], 1e-30f));
  highp float t4 = t3 * cg;
  highp float t5 = t2 - t4;
  highp float t6 = t3 * co;
  highp vec3 colour = vec3(max(t5 + t6, 0.0f), max(t2 + t4, 0.0f), max(t5 - t6, 0.0f));
  return colour;
}
#endif

#ifndef ZONAL_IRRADIANCE_SIX_FLOATS_NONLINEAR
#define ZONAL_IRRADIANCE_SIX_FLOATS_NONLINEAR
// The same by Geomerics' positive curve.
// 168 operations: 47 additions, 44 multiplications, 8 divisions, 1 square roots, 68 comparisons and choices.
highp vec3 zonal_irradiance_six_floats_nonlinear(in highp float luminance[4], highp float co, highp float cg,
    highp vec3 normal) {
  highp float t0 = -luminance[3];
  highp float t1 = -luminance[1];
  highp float t2 = t0 * t0 + t1 * t1 + luminance[2] * luminance[2];
  bool is_3 = t2 < 1e-30f;
  highp float t4 = sqrt(max(t2, 1e-30f));
  highp float t5 = max(luminance[0], 1e-30f);
  highp float t6 = min(0.57735026f * (is_3 ? 0.0f : t4) / t5, 1.0f);
  highp float t7 = 1.0f + t6;
  highp float t8 = (1.0f - t6) / t7;
  highp float t9 = t7 + t6;
  highp float t10 = (is_3 ? 0.0f : t0 / t4) * normal.x + (is_3 ? 0.0f : t1 / t4) * normal.y + (is_3 ? 1.0f : luminance[2] / t4) * normal.z;
  highp float t11 = max(min(max(0.5f + 0.5f * t10, 0.0f), 1.0f), 1.0842022e-19f);
  bool is_12 = t11 < 2.3283064e-10f;
  highp float t13 = is_12 ? t11 * 4294967296.0f : t11;
  bool is_14 = t13 < 1.5258789e-05f;
  highp float t15 = is_14 ? t13 * 65536.0f : t13;
  bool is_16 = t15 < 0.00390625f;
  highp float t17 = is_16 ? t15 * 256.0f : t15;
  bool is_18 = t17 < 0.0625f;
  highp float t19 = is_18 ? t17 * 16.0f : t17;
  bool is_20 = t19 < 0.25f;
  highp float t21 = is_20 ? t19 * 4.0f : t19;
  bool is_22 = t21 < 0.5f;
  highp float t23 = is_22 ? t21 * 2.0f : t21;
  bool is_24 = t23 < 0.70710677f;
  highp float t25 = is_12 ? -32.0f : 0.0f;
  highp float t26 = is_14 ? t25 - 16.0f : t25;
  highp float t27 = is_16 ? t26 - 8.0f : t26;
  highp float t28 = is_18 ? t27 - 4.0f : t27;
  highp float t29 = is_20 ? t28 - 2.0f : t28;
  highp float t30 = is_22 ? t29 - 1.0f : t29;
  highp float t31 = is_24 ? t23 + t23 : t23;
  highp float t32 = (t31 - 1.0f) / (t31 + 1.0f);
  highp float t33 = t32 * t32;
  highp float t34 = (((0.11111111f * t33 + 0.14285715f) * t33 + 0.2f) * t33 + 0.33333334f) * t33;
  highp float t35 = t9 * ((is_24 ? t30 - 1.0f : t30) * 0.6931472f + (t32 + t32) * (t34 + 1.0f));
  highp float t36 = min(abs(t35), 105.35837f);
  bool is_37 = 64.0f <= t36;
  bool is_38 = t35 < 0.0f;
  highp float t39 = is_37 ? t36 - 64.0f : t36;
  bool is_40 = 32.0f <= t39;
  highp float t41 = is_40 ? t39 - 32.0f : t39;
  bool is_42 = 16.0f <= t41;
  highp float t43 = is_42 ? t41 - 16.0f : t41;
  bool is_44 = 8.0f <= t43;
  highp float t45 = is_44 ? t43 - 8.0f : t43;
  bool is_46 = 4.0f <= t45;
  highp float t47 = is_46 ? t45 - 4.0f : t45;
  bool is_48 = 2.0f <= t47;
  highp float t49 = is_48 ? t47 - 2.0f : t47;
  bool is_50 = 1.0f <= t49;
  highp float t51 = is_50 ? t49 - 1.0f : t49;
  bool is_52 = 0.5f <= t51;
  highp float t53 = is_52 ? t51 - 0.5f : t51;
  bool is_54 = 0.25f <= t53;
  highp float t55 = is_40 ? 1.2664166e-14f : 1.0f;
  highp float t56 = is_42 ? t55 * 1.12535176e-07f : t55;
  highp float t57 = is_44 ? t56 * 0.00033546262f : t56;
  highp float t58 = is_46 ? t57 * 0.01831564f : t57;
  highp float t59 = is_48 ? t58 * 0.13533528f : t58;
  highp float t60 = is_50 ? t59 * 0.36787945f : t59;
  highp float t61 = is_52 ? t60 * 0.60653067f : t60;
  highp float t62 = is_54 ? t53 - 0.25f : t53;
  highp float t63 = 0.16666667f - t62 * (0.041666668f - t62 * (0.008333334f - t62 * 0.0013888889f));
  highp float t64 = (is_54 ? t61 * 0.7788008f : t61) * (1.0f - t62 * (1.0f - t62 * (0.5f - t62 * t63)));
  highp float t65 = is_38 ? t64 : 1.0f / t64;
  highp float t66 = (1.0f - t8) * (t9 + 1.0f) * (is_37 ? t65 * (is_38 ? 1.6038109e-28f : 6.235149e+27f) : t65);
  highp float t67 = max(luminance[0], 0.0f) * 0.2820948f * (t8 + t66);
  highp float t68 = 0.5f * (t67 / t5);
  highp float t69 = t68 * cg;
  highp float t70 = t67 - t69;
  highp float t71 = t68 * co;
  highp vec3 colour = vec3(max(t70 + t71, 0.0f), max(t67 + t69, 0.0f), max(t70 - t71, 0.0f));
  return colour;
}
#endif

#ifndef ZONAL_IRRADIANCE_BYTES_2
#define ZONAL_IRRADIANCE_BYTES_2
// Irradiance over pi of radiance that stands as whole numbers -127 to 127 times one scale.
// 12 operations: 3 additions, 9 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_irradiance_bytes_2(highp float scale, in highp float stored[4], highp vec3 normal) {
  highp float t0 = stored[2] * (0.48860252f * normal.z) + stored[1] * (-0.48860252f * normal.y);
  highp float t1 = stored[0] * 0.2820948f + 0.6666667f * (t0 + stored[3] * (-0.48860252f * normal.x));
  highp float value = scale * t1;
  return value;
}
#endif

#ifndef ZONAL_IRRADIANCE_BYTES_3
#define ZONAL_IRRADIANCE_BYTES_3
// Irradiance over pi of radiance that stands as whole numbers -127 to 127 times one scale.
// 36 operations: 11 additions, 25 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp float zonal_irradiance_bytes_3(highp float scale, in highp float stored[9], highp vec3 normal) {
  highp float t0 = stored[2] * (0.48860252f * normal.z) + stored[1] * (-0.48860252f * normal.y);
  highp float t1 = stored[0] * 0.2820948f + 0.6666667f * (t0 + stored[3] * (-0.48860252f * normal.x));
  highp float t2 = -1.0925485f * normal.z;
  highp float t3 = stored[6] * (0.9461747f * (normal.z * normal.z) + -0.31539157f) + stored[5] * (t2 * normal.y);
  highp float t4 = normal.y * normal.x;
  highp float t5 = t3 + stored[7] * (t2 * normal.x) + stored[4] * (0.54627424f * (t4 + t4));
  highp float t6 = t5 + stored[8] * (0.54627424f * (normal.x * normal.x - normal.y * normal.y));
  highp float value = scale * (t1 + 0.25f * t6);
  return value;
}
#endif
