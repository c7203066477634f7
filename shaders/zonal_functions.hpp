// zonal 0.2.0, C++ and CUDA. --bands 5 --functions evaluate@2,evaluate@3,evaluate@4,evaluate@5,evaluate_with_gradient@2,evaluate_with_gradient@3,evaluate_with_gradient@4,evaluate_with_gradient@5,reconstruct@2,reconstruct@3,reconstruct@4,reconstruct@5,reconstruct_colour@2,reconstruct_colour@3,reconstruct_colour@4,reconstruct_colour@5,reconstruct_lambert@2,reconstruct_lambert@3,reconstruct_lambert@4,reconstruct_lambert@5,reconstruct_lambert_colour@2,reconstruct_lambert_colour@3,reconstruct_lambert_colour@4,reconstruct_lambert_colour@5,orient@2,orient@3,orient@4,orient@5,orient_colour@2,orient_colour@3,orient_colour@4,orient_colour@5,dot@2,dot@3,dot@4,dot@5,dot_colour@2,dot_colour@3,dot_colour@4,dot_colour@5,dot_colours@2,dot_colours@3,dot_colours@4,dot_colours@5,convolve@2,convolve@3,convolve@4,convolve@5,convolve_colour@2,convolve_colour@3,convolve_colour@4,convolve_colour@5,lambert@2,lambert@3,lambert@4,lambert@5,cap@2,cap@3,cap@4,cap@5,cap_up_to_hemisphere@2,cap_up_to_hemisphere@3,cap_up_to_hemisphere@4,cap_up_to_hemisphere@5,sphere_cap@2,sphere_cap@3,sphere_cap@4,sphere_cap@5,phong@2,phong@3,phong@4,phong@5,spherical_gaussian@2,spherical_gaussian@3,spherical_gaussian@4,spherical_gaussian@5,project_sphere@2,project_sphere@3,project_sphere@4,project_sphere@5,reconstruct_with_adjoint@3,reconstruct_with_adjoint@4,splat_colour@3,splat_colour@4,splat_with_adjoint@3,splat_with_adjoint@4,rotate_about_z@2,rotate_about_z@3,prepare_rotation@2,prepare_rotation@3,rotate@2,rotate@3,rotate_colour@2,rotate_colour@3,product@2,product@3,product_colour@2,product_colour@3,triple_product@2,triple_product@3,reconstruct_seven_vectors,reconstruct_nine_polynomials_colour,reconstruct_polynomials_colour,linear_axis,hallucinate_zh3,hallucinate_zh3_colour,irradiance_zh3,irradiance_zh3_colour,irradiance_nonlinear,irradiance_nonlinear_colour,irradiance_six_floats,irradiance_six_floats_nonlinear,irradiance_bytes@2,irradiance_bytes@3
// 114 functions, 8708 operations. Written by zonal-glsl: do not edit.
#include <math.h>
#ifndef ZONAL_FUNCTION
#ifdef __CUDACC__
#define ZONAL_FUNCTION __host__ __device__ inline
#else
#define ZONAL_FUNCTION inline
#endif
#endif

#ifndef ZONAL_EVALUATE_2
#define ZONAL_EVALUATE_2
// Y_l^m at a unit vector, at l (l + 1) + m.
// 3 operations: 0 additions, 3 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_evaluate_2(const float (&direction)[3], float (&y)[4]) {
  y[0] = 0.2820948f;
  y[1] = -0.48860252f * direction[1];
  y[2] = 0.48860252f * direction[2];
  y[3] = -0.48860252f * direction[0];
}
#endif

#ifndef ZONAL_EVALUATE_3
#define ZONAL_EVALUATE_3
// Y_l^m at a unit vector, at l (l + 1) + m.
// 16 operations: 3 additions, 13 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_evaluate_3(const float (&direction)[3], float (&y)[9]) {
  y[0] = 0.2820948f;
  y[1] = -0.48860252f * direction[1];
  y[2] = 0.48860252f * direction[2];
  y[3] = -0.48860252f * direction[0];
  const float t0 = direction[1] * direction[0];
  y[4] = 0.54627424f * (t0 + t0);
  const float t1 = -1.0925485f * direction[2];
  y[5] = t1 * direction[1];
  y[6] = 0.9461747f * (direction[2] * direction[2]) + -0.31539157f;
  y[7] = t1 * direction[0];
  const float t2 = 0.54627424f * (direction[0] * direction[0] - direction[1] * direction[1]);
  y[8] = t2;
}
#endif

#ifndef ZONAL_EVALUATE_4
#define ZONAL_EVALUATE_4
// Y_l^m at a unit vector, at l (l + 1) + m.
// 34 operations: 7 additions, 27 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_evaluate_4(const float (&direction)[3], float (&y)[16]) {
  y[0] = 0.2820948f;
  y[1] = -0.48860252f * direction[1];
  y[2] = 0.48860252f * direction[2];
  y[3] = -0.48860252f * direction[0];
  const float t0 = direction[1] * direction[0];
  const float t1 = t0 + t0;
  y[4] = 0.54627424f * t1;
  const float t2 = -1.0925485f * direction[2];
  y[5] = t2 * direction[1];
  const float t3 = direction[2] * direction[2];
  y[6] = 0.9461747f * t3 + -0.31539157f;
  y[7] = t2 * direction[0];
  const float t4 = direction[0] * direction[0] - direction[1] * direction[1];
  y[8] = 0.54627424f * t4;
  y[9] = -0.5900436f * (direction[0] * t1 + direction[1] * t4);
  const float t5 = 1.4453057f * direction[2];
  y[10] = t5 * t1;
  const float t6 = -2.285229f * t3 + 0.4570458f;
  y[11] = t6 * direction[1];
  y[12] = direction[2] * (1.8658817f * t3 + -1.119529f);
  y[13] = t6 * direction[0];
  y[14] = t5 * t4;
  y[15] = -0.5900436f * (direction[0] * t4 - direction[1] * t1);
}
#endif

#ifndef ZONAL_EVALUATE_5
#define ZONAL_EVALUATE_5
// Y_l^m at a unit vector, at l (l + 1) + m.
// 58 operations: 12 additions, 46 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_evaluate_5(const float (&direction)[3], float (&y)[25]) {
  y[0] = 0.2820948f;
  y[1] = -0.48860252f * direction[1];
  y[2] = 0.48860252f * direction[2];
  y[3] = -0.48860252f * direction[0];
  const float t0 = direction[1] * direction[0];
  const float t1 = t0 + t0;
  y[4] = 0.54627424f * t1;
  const float t2 = -1.0925485f * direction[2];
  y[5] = t2 * direction[1];
  const float t3 = direction[2] * direction[2];
  const float t4 = 0.9461747f * t3 + -0.31539157f;
  y[6] = t4;
  y[7] = t2 * direction[0];
  const float t5 = direction[0] * direction[0] - direction[1] * direction[1];
  y[8] = 0.54627424f * t5;
  const float t6 = direction[0] * t1 + direction[1] * t5;
  y[9] = -0.5900436f * t6;
  const float t7 = 1.4453057f * direction[2];
  y[10] = t7 * t1;
  const float t8 = -2.285229f * t3 + 0.4570458f;
  y[11] = t8 * direction[1];
  const float t9 = direction[2] * (1.8658817f * t3 + -1.119529f);
  y[12] = t9;
  y[13] = t8 * direction[0];
  y[14] = t7 * t5;
  const float t10 = direction[0] * t5 - direction[1] * t1;
  y[15] = -0.5900436f * t10;
  y[16] = 0.6258357f * (direction[0] * t6 + direction[1] * t10);
  const float t11 = -1.7701308f * direction[2];
  y[17] = t11 * t6;
  const float t12 = 3.3116114f * t3 + -0.47308734f;
  y[18] = t12 * t1;
  const float t13 = direction[2] * (-4.683326f * t3 + 2.0071397f);
  y[19] = t13 * direction[1];
  y[20] = 1.9843135f * direction[2] * t9 - 1.0062306f * t4;
  y[21] = t13 * direction[0];
  y[22] = t12 * t5;
  y[23] = t11 * t10;
  y[24] = 0.6258357f * (direction[0] * t10 - direction[1] * t6);
}
#endif

#ifndef ZONAL_EVALUATE_WITH_GRADIENT_2
#define ZONAL_EVALUATE_WITH_GRADIENT_2
// Y_l^m and the gradient of Y_l^m(v / |v|) at a unit vector.
// 21 operations: 9 additions, 12 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_evaluate_with_gradient_2(const float (&direction)[3], float (&y)[4],
    float (&gradient)[4][3]) {
  y[0] = 0.2820948f;
  const float t0 = -0.48860252f * direction[1];
  y[1] = t0;
  const float t1 = 0.48860252f * direction[2];
  y[2] = t1;
  const float t2 = -0.48860252f * direction[0];
  y[3] = t2;
  gradient[0][0] = 0.0f;
  gradient[0][1] = 0.0f;
  gradient[0][2] = 0.0f;
  gradient[1][0] = 0.0f - direction[0] * t0;
  gradient[1][1] = -0.48860252f - direction[1] * t0;
  gradient[1][2] = 0.0f - direction[2] * t0;
  gradient[2][0] = 0.0f - direction[0] * t1;
  gradient[2][1] = 0.0f - direction[1] * t1;
  gradient[2][2] = 0.48860252f - direction[2] * t1;
  gradient[3][0] = -0.48860252f - direction[0] * t2;
  gradient[3][1] = 0.0f - direction[1] * t2;
  gradient[3][2] = 0.0f - direction[2] * t2;
}
#endif

#ifndef ZONAL_EVALUATE_WITH_GRADIENT_3
#define ZONAL_EVALUATE_WITH_GRADIENT_3
// Y_l^m and the gradient of Y_l^m(v / |v|) at a unit vector.
// 76 operations: 28 additions, 48 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_evaluate_with_gradient_3(const float (&direction)[3], float (&y)[9],
    float (&gradient)[9][3]) {
  y[0] = 0.2820948f;
  const float t0 = -0.48860252f * direction[1];
  y[1] = t0;
  const float t1 = 0.48860252f * direction[2];
  y[2] = t1;
  const float t2 = -0.48860252f * direction[0];
  y[3] = t2;
  const float t3 = direction[1] * direction[0];
  const float t4 = 0.54627424f * (t3 + t3);
  y[4] = t4;
  const float t5 = -1.0925485f * direction[2];
  const float t6 = t5 * direction[1];
  y[5] = t6;
  const float t7 = 0.9461747f * (direction[2] * direction[2]) + -0.31539157f;
  y[6] = t7;
  const float t8 = t5 * direction[0];
  y[7] = t8;
  const float t9 = 0.54627424f * (direction[0] * direction[0] - direction[1] * direction[1]);
  y[8] = t9;
  gradient[0][0] = 0.0f;
  gradient[0][1] = 0.0f;
  gradient[0][2] = 0.0f;
  gradient[1][0] = 0.0f - direction[0] * t0;
  gradient[1][1] = -0.48860252f - direction[1] * t0;
  gradient[1][2] = 0.0f - direction[2] * t0;
  gradient[2][0] = 0.0f - direction[0] * t1;
  gradient[2][1] = 0.0f - direction[1] * t1;
  gradient[2][2] = 0.48860252f - direction[2] * t1;
  gradient[3][0] = -0.48860252f - direction[0] * t2;
  gradient[3][1] = 0.0f - direction[1] * t2;
  gradient[3][2] = 0.0f - direction[2] * t2;
  const float t10 = -2.236068f * t0;
  const float t11 = 2.0f * direction[0];
  gradient[4][0] = t10 - t11 * t4;
  const float t12 = -2.236068f * t2;
  const float t13 = 2.0f * direction[1];
  gradient[4][1] = t12 - t13 * t4;
  const float t14 = 2.0f * direction[2];
  gradient[4][2] = 0.0f - t14 * t4;
  gradient[5][0] = 0.0f - t11 * t6;
  const float t15 = -2.236068f * t1;
  gradient[5][1] = t15 - t13 * t6;
  gradient[5][2] = 2.236068f * t0 - t14 * t6;
  gradient[6][0] = 1.2909944f * t2 - t11 * t7;
  gradient[6][1] = 1.2909944f * t0 - t13 * t7;
  gradient[6][2] = 2.5819888f * t1 - t14 * t7;
  gradient[7][0] = t15 - t11 * t8;
  gradient[7][1] = 0.0f - t13 * t8;
  gradient[7][2] = 2.236068f * t2 - t14 * t8;
  gradient[8][0] = t12 - t11 * t9;
  gradient[8][1] = -t10 - t13 * t9;
  gradient[8][2] = 0.0f - t14 * t9;
}
#endif

#ifndef ZONAL_EVALUATE_WITH_GRADIENT_4
#define ZONAL_EVALUATE_WITH_GRADIENT_4
// Y_l^m and the gradient of Y_l^m(v / |v|) at a unit vector.
// 157 operations: 57 additions, 100 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_evaluate_with_gradient_4(const float (&direction)[3], float (&y)[16],
    float (&gradient)[16][3]) {
  y[0] = 0.2820948f;
  const float t0 = -0.48860252f * direction[1];
  y[1] = t0;
  const float t1 = 0.48860252f * direction[2];
  y[2] = t1;
  const float t2 = -0.48860252f * direction[0];
  y[3] = t2;
  const float t3 = direction[1] * direction[0];
  const float t4 = t3 + t3;
  const float t5 = 0.54627424f * t4;
  y[4] = t5;
  const float t6 = -1.0925485f * direction[2];
  const float t7 = t6 * direction[1];
  y[5] = t7;
  const float t8 = direction[2] * direction[2];
  const float t9 = 0.9461747f * t8 + -0.31539157f;
  y[6] = t9;
  const float t10 = t6 * direction[0];
  y[7] = t10;
  const float t11 = direction[0] * direction[0] - direction[1] * direction[1];
  const float t12 = 0.54627424f * t11;
  y[8] = t12;
  const float t13 = -0.5900436f * (direction[0] * t4 + direction[1] * t11);
  y[9] = t13;
  const float t14 = 1.4453057f * direction[2];
  const float t15 = t14 * t4;
  y[10] = t15;
  const float t16 = -2.285229f * t8 + 0.4570458f;
  const float t17 = t16 * direction[1];
  y[11] = t17;
  const float t18 = direction[2] * (1.8658817f * t8 + -1.119529f);
  y[12] = t18;
  const float t19 = t16 * direction[0];
  y[13] = t19;
  const float t20 = t14 * t11;
  y[14] = t20;
  const float t21 = -0.5900436f * (direction[0] * t11 - direction[1] * t4);
  y[15] = t21;
  gradient[0][0] = 0.0f;
  gradient[0][1] = 0.0f;
  gradient[0][2] = 0.0f;
  gradient[1][0] = 0.0f - direction[0] * t0;
  gradient[1][1] = -0.48860252f - direction[1] * t0;
  gradient[1][2] = 0.0f - direction[2] * t0;
  gradient[2][0] = 0.0f - direction[0] * t1;
  gradient[2][1] = 0.0f - direction[1] * t1;
  gradient[2][2] = 0.48860252f - direction[2] * t1;
  gradient[3][0] = -0.48860252f - direction[0] * t2;
  gradient[3][1] = 0.0f - direction[1] * t2;
  gradient[3][2] = 0.0f - direction[2] * t2;
  const float t22 = -2.236068f * t0;
  const float t23 = 2.0f * direction[0];
  gradient[4][0] = t22 - t23 * t5;
  const float t24 = -2.236068f * t2;
  const float t25 = 2.0f * direction[1];
  gradient[4][1] = t24 - t25 * t5;
  const float t26 = 2.0f * direction[2];
  gradient[4][2] = 0.0f - t26 * t5;
  gradient[5][0] = 0.0f - t23 * t7;
  const float t27 = -2.236068f * t1;
  gradient[5][1] = t27 - t25 * t7;
  gradient[5][2] = 2.236068f * t0 - t26 * t7;
  gradient[6][0] = 1.2909944f * t2 - t23 * t9;
  gradient[6][1] = 1.2909944f * t0 - t25 * t9;
  gradient[6][2] = 2.5819888f * t1 - t26 * t9;
  gradient[7][0] = t27 - t23 * t10;
  gradient[7][1] = 0.0f - t25 * t10;
  gradient[7][2] = 2.236068f * t2 - t26 * t10;
  gradient[8][0] = t24 - t23 * t12;
  gradient[8][1] = -t22 - t25 * t12;
  gradient[8][2] = 0.0f - t26 * t12;
  const float t28 = -3.2403703f * t5;
  const float t29 = 3.0f * direction[0];
  gradient[9][0] = t28 - t29 * t13;
  const float t30 = -3.2403703f * t12;
  const float t31 = 3.0f * direction[1];
  gradient[9][1] = t30 - t31 * t13;
  const float t32 = 3.0f * direction[2];
  gradient[9][2] = 0.0f - t32 * t13;
  const float t33 = -2.6457512f * t7;
  gradient[10][0] = t33 - t29 * t15;
  const float t34 = -2.6457512f * t10;
  gradient[10][1] = t34 - t31 * t15;
  gradient[10][2] = 2.6457512f * t5 - t32 * t15;
  const float t35 = 0.83666f * t5;
  gradient[11][0] = t35 - t29 * t17;
  const float t36 = -2.8982754f * t9;
  const float t37 = 0.83666f * t12;
  gradient[11][1] = t36 - t37 - t31 * t17;
  gradient[11][2] = 3.34664f * t7 - t32 * t17;
  gradient[12][0] = 2.04939f * t10 - t29 * t18;
  gradient[12][1] = 2.04939f * t7 - t31 * t18;
  gradient[12][2] = 3.5496478f * t9 - t32 * t18;
  gradient[13][0] = t37 + t36 - t29 * t19;
  gradient[13][1] = t35 - t31 * t19;
  gradient[13][2] = 3.34664f * t10 - t32 * t19;
  gradient[14][0] = t34 - t29 * t20;
  gradient[14][1] = -t33 - t31 * t20;
  gradient[14][2] = 2.6457512f * t12 - t32 * t20;
  gradient[15][0] = t30 - t29 * t21;
  gradient[15][1] = -t28 - t31 * t21;
  gradient[15][2] = 0.0f - t32 * t21;
}
#endif

#ifndef ZONAL_EVALUATE_WITH_GRADIENT_5
#define ZONAL_EVALUATE_WITH_GRADIENT_5
// Y_l^m and the gradient of Y_l^m(v / |v|) at a unit vector.
// 266 operations: 97 additions, 169 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_evaluate_with_gradient_5(const float (&direction)[3], float (&y)[25],
    float (&gradient)[25][3]) {
  y[0] = 0.2820948f;
  const float t0 = -0.48860252f * direction[1];
  y[1] = t0;
  const float t1 = 0.48860252f * direction[2];
  y[2] = t1;
  const float t2 = -0.48860252f * direction[0];
  y[3] = t2;
  const float t3 = direction[1] * direction[0];
  const float t4 = t3 + t3;
  const float t5 = 0.54627424f * t4;
  y[4] = t5;
  const float t6 = -1.0925485f * direction[2];
  const float t7 = t6 * direction[1];
  y[5] = t7;
  const float t8 = direction[2] * direction[2];
  const float t9 = 0.9461747f * t8 + -0.31539157f;
  y[6] = t9;
  const float t10 = t6 * direction[0];
  y[7] = t10;
  const float t11 = direction[0] * direction[0] - direction[1] * direction[1];
  const float t12 = 0.54627424f * t11;
  y[8] = t12;
  const float t13 = direction[0] * t4 + direction[1] * t11;
  const float t14 = -0.5900436f * t13;
  y[9] = t14;
  const float t15 = 1.4453057f * direction[2];
  const float t16 = t15 * t4;
  y[10] = t16;
  const float t17 = -2.285229f * t8 + 0.4570458f;
  const float t18 = t17 * direction[1];
  y[11] = t18;
  const float t19 = direction[2] * (1.8658817f * t8 + -1.119529f);
  y[12] = t19;
  const float t20 = t17 * direction[0];
  y[13] = t20;
  const float t21 = t15 * t11;
  y[14] = t21;
  const float t22 = direction[0] * t11 - direction[1] * t4;
  const float t23 = -0.5900436f * t22;
  y[15] = t23;
  const float t24 = 0.6258357f * (direction[0] * t13 + direction[1] * t22);
  y[16] = t24;
  const float t25 = -1.7701308f * direction[2];
  const float t26 = t25 * t13;
  y[17] = t26;
  const float t27 = 3.3116114f * t8 + -0.47308734f;
  const float t28 = t27 * t4;
  y[18] = t28;
  const float t29 = direction[2] * (-4.683326f * t8 + 2.0071397f);
  const float t30 = t29 * direction[1];
  y[19] = t30;
  const float t31 = 1.9843135f * direction[2] * t19 - 1.0062306f * t9;
  y[20] = t31;
  const float t32 = t29 * direction[0];
  y[21] = t32;
  const float t33 = t27 * t11;
  y[22] = t33;
  const float t34 = t25 * t22;
  y[23] = t34;
  const float t35 = 0.6258357f * (direction[0] * t22 - direction[1] * t13);
  y[24] = t35;
  gradient[0][0] = 0.0f;
  gradient[0][1] = 0.0f;
  gradient[0][2] = 0.0f;
  gradient[1][0] = 0.0f - direction[0] * t0;
  gradient[1][1] = -0.48860252f - direction[1] * t0;
  gradient[1][2] = 0.0f - direction[2] * t0;
  gradient[2][0] = 0.0f - direction[0] * t1;
  gradient[2][1] = 0.0f - direction[1] * t1;
  gradient[2][2] = 0.48860252f - direction[2] * t1;
  gradient[3][0] = -0.48860252f - direction[0] * t2;
  gradient[3][1] = 0.0f - direction[1] * t2;
  gradient[3][2] = 0.0f - direction[2] * t2;
  const float t36 = -2.236068f * t0;
  const float t37 = 2.0f * direction[0];
  gradient[4][0] = t36 - t37 * t5;
  const float t38 = -2.236068f * t2;
  const float t39 = 2.0f * direction[1];
  gradient[4][1] = t38 - t39 * t5;
  const float t40 = 2.0f * direction[2];
  gradient[4][2] = 0.0f - t40 * t5;
  gradient[5][0] = 0.0f - t37 * t7;
  const float t41 = -2.236068f * t1;
  gradient[5][1] = t41 - t39 * t7;
  gradient[5][2] = 2.236068f * t0 - t40 * t7;
  gradient[6][0] = 1.2909944f * t2 - t37 * t9;
  gradient[6][1] = 1.2909944f * t0 - t39 * t9;
  gradient[6][2] = 2.5819888f * t1 - t40 * t9;
  gradient[7][0] = t41 - t37 * t10;
  gradient[7][1] = 0.0f - t39 * t10;
  gradient[7][2] = 2.236068f * t2 - t40 * t10;
  gradient[8][0] = t38 - t37 * t12;
  gradient[8][1] = -t36 - t39 * t12;
  gradient[8][2] = 0.0f - t40 * t12;
  const float t42 = -3.2403703f * t5;
  const float t43 = 3.0f * direction[0];
  gradient[9][0] = t42 - t43 * t14;
  const float t44 = -3.2403703f * t12;
  const float t45 = 3.0f * direction[1];
  gradient[9][1] = t44 - t45 * t14;
  const float t46 = 3.0f * direction[2];
  gradient[9][2] = 0.0f - t46 * t14;
  const float t47 = -2.6457512f * t7;
  gradient[10][0] = t47 - t43 * t16;
  const float t48 = -2.6457512f * t10;
  gradient[10][1] = t48 - t45 * t16;
  gradient[10][2] = 2.6457512f * t5 - t46 * t16;
  const float t49 = 0.83666f * t5;
  gradient[11][0] = t49 - t43 * t18;
  const float t50 = -2.8982754f * t9;
  const float t51 = 0.83666f * t12;
  gradient[11][1] = t50 - t51 - t45 * t18;
  gradient[11][2] = 3.34664f * t7 - t46 * t18;
  gradient[12][0] = 2.04939f * t10 - t43 * t19;
  gradient[12][1] = 2.04939f * t7 - t45 * t19;
  gradient[12][2] = 3.5496478f * t9 - t46 * t19;
  gradient[13][0] = t51 + t50 - t43 * t20;
  gradient[13][1] = t49 - t45 * t20;
  gradient[13][2] = 3.34664f * t10 - t46 * t20;
  gradient[14][0] = t48 - t43 * t21;
  gradient[14][1] = -t47 - t45 * t21;
  gradient[14][2] = 2.6457512f * t12 - t46 * t21;
  gradient[15][0] = t44 - t43 * t23;
  gradient[15][1] = -t42 - t45 * t23;
  gradient[15][2] = 0.0f - t46 * t23;
  const float t52 = -4.2426405f * t14;
  const float t53 = 4.0f * direction[0];
  gradient[16][0] = t52 - t53 * t24;
  const float t54 = -4.2426405f * t23;
  const float t55 = 4.0f * direction[1];
  gradient[16][1] = t54 - t55 * t24;
  const float t56 = 4.0f * direction[2];
  gradient[16][2] = 0.0f - t56 * t24;
  const float t57 = -3.6742346f * t16;
  gradient[17][0] = t57 - t53 * t26;
  const float t58 = -3.6742346f * t21;
  gradient[17][1] = t58 - t55 * t26;
  gradient[17][2] = 3.0f * t14 - t56 * t26;
  const float t59 = 0.80178374f * t14;
  const float t60 = -3.105295f * t18;
  gradient[18][0] = t59 + t60 - t53 * t28;
  const float t61 = -3.105295f * t20;
  const float t62 = 0.80178374f * t23;
  gradient[18][1] = t61 - t62 - t55 * t28;
  gradient[18][2] = 3.927922f * t16 - t56 * t28;
  const float t63 = 1.3887302f * t16;
  gradient[19][0] = t63 - t53 * t30;
  const float t64 = -3.5856857f * t19;
  const float t65 = 1.3887302f * t21;
  gradient[19][1] = t64 - t65 - t55 * t30;
  gradient[19][2] = 4.3915505f * t18 - t56 * t30;
  gradient[20][0] = 2.7774603f * t20 - t53 * t31;
  gradient[20][1] = 2.7774603f * t18 - t55 * t31;
  gradient[20][2] = 4.5355735f * t19 - t56 * t31;
  gradient[21][0] = t65 + t64 - t53 * t32;
  gradient[21][1] = t63 - t55 * t32;
  gradient[21][2] = 4.3915505f * t20 - t56 * t32;
  gradient[22][0] = t62 + t61 - t53 * t33;
  gradient[22][1] = t59 - t60 - t55 * t33;
  gradient[22][2] = 3.927922f * t21 - t56 * t33;
  gradient[23][0] = t58 - t53 * t34;
  gradient[23][1] = -t57 - t55 * t34;
  gradient[23][2] = 3.0f * t23 - t56 * t34;
  gradient[24][0] = t54 - t53 * t35;
  gradient[24][1] = -t52 - t55 * t35;
  gradient[24][2] = 0.0f - t56 * t35;
}
#endif

#ifndef ZONAL_RECONSTRUCT_2
#define ZONAL_RECONSTRUCT_2
// A function's value in a direction: basis and sum fused.
// 10 operations: 3 additions, 7 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_reconstruct_2(const float (&sh)[4], const float (&direction)[3]) {
  const float t0 = sh[2] * (0.48860252f * direction[2]) + sh[3] * (-0.48860252f * direction[0]);
  const float value = sh[0] * 0.2820948f + sh[1] * (-0.48860252f * direction[1]) + t0;
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_3
#define ZONAL_RECONSTRUCT_3
// A function's value in a direction: basis and sum fused.
// 33 operations: 11 additions, 22 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_reconstruct_3(const float (&sh)[9], const float (&direction)[3]) {
  const float t0 = direction[1] * direction[0];
  const float t1 = 0.54627424f * (direction[0] * direction[0] - direction[1] * direction[1]);
  const float t2 = -1.0925485f * direction[2];
  const float t3 = sh[0] * 0.2820948f + sh[4] * (0.54627424f * (t0 + t0)) + sh[8] * t1 + (sh[1] * (-0.48860252f * direction[1]) + sh[5] * (t2 * direction[1]));
  const float t4 = sh[2] * (0.48860252f * direction[2]) + sh[6] * (0.9461747f * (direction[2] * direction[2]) + -0.31539157f);
  const float t5 = t4 + (sh[3] * (-0.48860252f * direction[0]) + sh[7] * (t2 * direction[0]));
  const float value = t3 + t5;
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_4
#define ZONAL_RECONSTRUCT_4
// A function's value in a direction: basis and sum fused.
// 65 operations: 22 additions, 43 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_reconstruct_4(const float (&sh)[16], const float (&direction)[3]) {
  const float t0 = direction[2] * direction[2];
  const float t1 = sh[0] * 0.2820948f + sh[12] * (direction[2] * (1.8658817f * t0 + -1.119529f));
  const float t2 = direction[1] * direction[0];
  const float t3 = t2 + t2;
  const float t4 = direction[0] * direction[0] - direction[1] * direction[1];
  const float t5 = -1.0925485f * direction[2];
  const float t6 = -2.285229f * t0 + 0.4570458f;
  const float t7 = sh[1] * (-0.48860252f * direction[1]) + sh[5] * (t5 * direction[1]) + sh[13] * (t6 * direction[0]);
  const float t8 = t1 + sh[4] * (0.54627424f * t3) + sh[8] * (0.54627424f * t4) + (t7 + sh[9] * (-0.5900436f * (direction[0] * t3 + direction[1] * t4)));
  const float t9 = sh[2] * (0.48860252f * direction[2]) + sh[6] * (0.9461747f * t0 + -0.31539157f);
  const float t10 = 1.4453057f * direction[2];
  const float t11 = sh[3] * (-0.48860252f * direction[0]) + sh[7] * (t5 * direction[0]) + sh[11] * (t6 * direction[1]);
  const float t12 = t9 + sh[10] * (t10 * t3) + sh[14] * (t10 * t4) + (t11 + sh[15] * (-0.5900436f * (direction[0] * t4 - direction[1] * t3)));
  const float value = t8 + t12;
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_5
#define ZONAL_RECONSTRUCT_5
// A function's value in a direction: basis and sum fused.
// 107 operations: 36 additions, 71 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_reconstruct_5(const float (&sh)[25], const float (&direction)[3]) {
  const float t0 = direction[2] * direction[2];
  const float t1 = direction[2] * (1.8658817f * t0 + -1.119529f);
  const float t2 = 0.9461747f * t0 + -0.31539157f;
  const float t3 = sh[0] * 0.2820948f + sh[12] * t1 + sh[20] * (1.9843135f * direction[2] * t1 - 1.0062306f * t2);
  const float t4 = direction[1] * direction[0];
  const float t5 = t4 + t4;
  const float t6 = direction[0] * direction[0] - direction[1] * direction[1];
  const float t7 = direction[0] * t5 + direction[1] * t6;
  const float t8 = direction[0] * t6 - direction[1] * t5;
  const float t9 = t3 + sh[4] * (0.54627424f * t5) + sh[8] * (0.54627424f * t6) + sh[16] * (0.6258357f * (direction[0] * t7 + direction[1] * t8));
  const float t10 = -1.0925485f * direction[2];
  const float t11 = -2.285229f * t0 + 0.4570458f;
  const float t12 = sh[1] * (-0.48860252f * direction[1]) + sh[5] * (t10 * direction[1]) + sh[13] * (t11 * direction[0]);
  const float t13 = direction[2] * (-4.683326f * t0 + 2.0071397f);
  const float t14 = -1.7701308f * direction[2];
  const float t15 = t12 + sh[21] * (t13 * direction[0]) + sh[9] * (-0.5900436f * t7) + sh[17] * (t14 * t7);
  const float t16 = t9 + sh[24] * (0.6258357f * (direction[0] * t8 - direction[1] * t7)) + t15;
  const float t17 = 1.4453057f * direction[2];
  const float t18 = sh[2] * (0.48860252f * direction[2]) + sh[6] * t2 + sh[10] * (t17 * t5) + sh[14] * (t17 * t6);
  const float t19 = 3.3116114f * t0 + -0.47308734f;
  const float t20 = sh[3] * (-0.48860252f * direction[0]) + sh[7] * (t10 * direction[0]) + sh[11] * (t11 * direction[1]);
  const float t21 = t20 + sh[19] * (t13 * direction[1]) + sh[15] * (-0.5900436f * t8) + sh[23] * (t14 * t8);
  const float value = t16 + (t18 + sh[18] * (t19 * t5) + sh[22] * (t19 * t6) + t21);
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_COLOUR_2
#define ZONAL_RECONSTRUCT_COLOUR_2
// A function's value in a direction: basis and sum fused. For colours.
// 24 operations: 9 additions, 15 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_reconstruct_colour_2(const float (&sh)[4][3], const float (&direction)[3],
    float (&value)[3]) {
  const float t0 = -0.48860252f * direction[1];
  const float t1 = 0.48860252f * direction[2];
  const float t2 = -0.48860252f * direction[0];
  value[0] = sh[0][0] * 0.2820948f + sh[1][0] * t0 + (sh[2][0] * t1 + sh[3][0] * t2);
  value[1] = sh[0][1] * 0.2820948f + sh[1][1] * t0 + (sh[2][1] * t1 + sh[3][1] * t2);
  value[2] = sh[0][2] * 0.2820948f + sh[1][2] * t0 + (sh[2][2] * t1 + sh[3][2] * t2);
}
#endif

#ifndef ZONAL_RECONSTRUCT_COLOUR_3
#define ZONAL_RECONSTRUCT_COLOUR_3
// A function's value in a direction: basis and sum fused. For colours.
// 67 operations: 27 additions, 40 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_reconstruct_colour_3(const float (&sh)[9][3], const float (&direction)[3],
    float (&value)[3]) {
  const float t0 = direction[1] * direction[0];
  const float t1 = 0.54627424f * (t0 + t0);
  const float t2 = 0.54627424f * (direction[0] * direction[0] - direction[1] * direction[1]);
  const float t3 = -0.48860252f * direction[1];
  const float t4 = -1.0925485f * direction[2];
  const float t5 = t4 * direction[1];
  const float t6 = sh[0][0] * 0.2820948f + sh[4][0] * t1 + sh[8][0] * t2 + (sh[1][0] * t3 + sh[5][0] * t5);
  const float t7 = 0.48860252f * direction[2];
  const float t8 = 0.9461747f * (direction[2] * direction[2]) + -0.31539157f;
  const float t9 = -0.48860252f * direction[0];
  const float t10 = t4 * direction[0];
  value[0] = t6 + (sh[2][0] * t7 + sh[6][0] * t8 + (sh[3][0] * t9 + sh[7][0] * t10));
  const float t11 = sh[0][1] * 0.2820948f + sh[4][1] * t1 + sh[8][1] * t2 + (sh[1][1] * t3 + sh[5][1] * t5);
  const float t12 = t11 + (sh[2][1] * t7 + sh[6][1] * t8 + (sh[3][1] * t9 + sh[7][1] * t10));
  value[1] = t12;
  const float t13 = sh[0][2] * 0.2820948f + sh[4][2] * t1 + sh[8][2] * t2 + (sh[1][2] * t3 + sh[5][2] * t5);
  const float t14 = t13 + (sh[2][2] * t7 + sh[6][2] * t8 + (sh[3][2] * t9 + sh[7][2] * t10));
  value[2] = t14;
}
#endif

#ifndef ZONAL_RECONSTRUCT_COLOUR_4
#define ZONAL_RECONSTRUCT_COLOUR_4
// A function's value in a direction: basis and sum fused. For colours.
// 127 operations: 52 additions, 75 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_reconstruct_colour_4(const float (&sh)[16][3], const float (&direction)[3],
    float (&value)[3]) {
  const float t0 = direction[2] * direction[2];
  const float t1 = direction[2] * (1.8658817f * t0 + -1.119529f);
  const float t2 = direction[1] * direction[0];
  const float t3 = t2 + t2;
  const float t4 = 0.54627424f * t3;
  const float t5 = direction[0] * direction[0] - direction[1] * direction[1];
  const float t6 = 0.54627424f * t5;
  const float t7 = -0.48860252f * direction[1];
  const float t8 = -1.0925485f * direction[2];
  const float t9 = t8 * direction[1];
  const float t10 = -2.285229f * t0 + 0.4570458f;
  const float t11 = t10 * direction[0];
  const float t12 = -0.5900436f * (direction[0] * t3 + direction[1] * t5);
  const float t13 = sh[0][0] * 0.2820948f + sh[12][0] * t1 + sh[4][0] * t4 + sh[8][0] * t6 + (sh[1][0] * t7 + sh[5][0] * t9 + sh[13][0] * t11 + sh[9][0] * t12);
  const float t14 = 0.48860252f * direction[2];
  const float t15 = 0.9461747f * t0 + -0.31539157f;
  const float t16 = 1.4453057f * direction[2];
  const float t17 = t16 * t3;
  const float t18 = t16 * t5;
  const float t19 = -0.48860252f * direction[0];
  const float t20 = t8 * direction[0];
  const float t21 = t10 * direction[1];
  const float t22 = -0.5900436f * (direction[0] * t5 - direction[1] * t3);
  const float t23 = sh[2][0] * t14 + sh[6][0] * t15 + sh[10][0] * t17 + sh[14][0] * t18 + (sh[3][0] * t19 + sh[7][0] * t20 + sh[11][0] * t21 + sh[15][0] * t22);
  value[0] = t13 + t23;
  const float t24 = sh[0][1] * 0.2820948f + sh[12][1] * t1 + sh[4][1] * t4 + sh[8][1] * t6 + (sh[1][1] * t7 + sh[5][1] * t9 + sh[13][1] * t11 + sh[9][1] * t12);
  const float t25 = sh[2][1] * t14 + sh[6][1] * t15 + sh[10][1] * t17 + sh[14][1] * t18 + (sh[3][1] * t19 + sh[7][1] * t20 + sh[11][1] * t21 + sh[15][1] * t22);
  value[1] = t24 + t25;
  const float t26 = sh[0][2] * 0.2820948f + sh[12][2] * t1 + sh[4][2] * t4 + sh[8][2] * t6 + (sh[1][2] * t7 + sh[5][2] * t9 + sh[13][2] * t11 + sh[9][2] * t12);
  const float t27 = sh[2][2] * t14 + sh[6][2] * t15 + sh[10][2] * t17 + sh[14][2] * t18 + (sh[3][2] * t19 + sh[7][2] * t20 + sh[11][2] * t21 + sh[15][2] * t22);
  value[2] = t26 + t27;
}
#endif

#ifndef ZONAL_RECONSTRUCT_COLOUR_5
#define ZONAL_RECONSTRUCT_COLOUR_5
// A function's value in a direction: basis and sum fused. For colours.
// 205 operations: 84 additions, 121 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_reconstruct_colour_5(const float (&sh)[25][3], const float (&direction)[3],
    float (&value)[3]) {
  const float t0 = direction[2] * direction[2];
  const float t1 = direction[2] * (1.8658817f * t0 + -1.119529f);
  const float t2 = 0.9461747f * t0 + -0.31539157f;
  const float t3 = 1.9843135f * direction[2] * t1 - 1.0062306f * t2;
  const float t4 = direction[1] * direction[0];
  const float t5 = t4 + t4;
  const float t6 = 0.54627424f * t5;
  const float t7 = direction[0] * direction[0] - direction[1] * direction[1];
  const float t8 = 0.54627424f * t7;
  const float t9 = sh[0][0] * 0.2820948f + sh[12][0] * t1 + sh[20][0] * t3 + sh[4][0] * t6 + sh[8][0] * t8;
  const float t10 = direction[0] * t5 + direction[1] * t7;
  const float t11 = direction[0] * t7 - direction[1] * t5;
  const float t12 = 0.6258357f * (direction[0] * t10 + direction[1] * t11);
  const float t13 = 0.6258357f * (direction[0] * t11 - direction[1] * t10);
  const float t14 = -0.48860252f * direction[1];
  const float t15 = -1.0925485f * direction[2];
  const float t16 = t15 * direction[1];
  const float t17 = -2.285229f * t0 + 0.4570458f;
  const float t18 = t17 * direction[0];
  const float t19 = direction[2] * (-4.683326f * t0 + 2.0071397f);
  const float t20 = t19 * direction[0];
  const float t21 = -0.5900436f * t10;
  const float t22 = sh[1][0] * t14 + sh[5][0] * t16 + sh[13][0] * t18 + sh[21][0] * t20 + sh[9][0] * t21;
  const float t23 = -1.7701308f * direction[2];
  const float t24 = t23 * t10;
  const float t25 = 0.48860252f * direction[2];
  const float t26 = 1.4453057f * direction[2];
  const float t27 = t26 * t5;
  const float t28 = t26 * t7;
  const float t29 = 3.3116114f * t0 + -0.47308734f;
  const float t30 = t29 * t5;
  const float t31 = sh[2][0] * t25 + sh[6][0] * t2 + sh[10][0] * t27 + sh[14][0] * t28 + sh[18][0] * t30;
  const float t32 = t29 * t7;
  const float t33 = -0.48860252f * direction[0];
  const float t34 = t15 * direction[0];
  const float t35 = t17 * direction[1];
  const float t36 = t19 * direction[1];
  const float t37 = -0.5900436f * t11;
  const float t38 = sh[3][0] * t33 + sh[7][0] * t34 + sh[11][0] * t35 + sh[19][0] * t36 + sh[15][0] * t37;
  const float t39 = t23 * t11;
  const float t40 = t9 + sh[16][0] * t12 + sh[24][0] * t13 + (t22 + sh[17][0] * t24) + (t31 + sh[22][0] * t32 + (t38 + sh[23][0] * t39));
  value[0] = t40;
  const float t41 = sh[0][1] * 0.2820948f + sh[12][1] * t1 + sh[20][1] * t3 + sh[4][1] * t6 + sh[8][1] * t8;
  const float t42 = sh[1][1] * t14 + sh[5][1] * t16 + sh[13][1] * t18 + sh[21][1] * t20 + sh[9][1] * t21;
  const float t43 = sh[2][1] * t25 + sh[6][1] * t2 + sh[10][1] * t27 + sh[14][1] * t28 + sh[18][1] * t30;
  const float t44 = sh[3][1] * t33 + sh[7][1] * t34 + sh[11][1] * t35 + sh[19][1] * t36 + sh[15][1] * t37;
  const float t45 = t41 + sh[16][1] * t12 + sh[24][1] * t13 + (t42 + sh[17][1] * t24) + (t43 + sh[22][1] * t32 + (t44 + sh[23][1] * t39));
  value[1] = t45;
  const float t46 = sh[0][2] * 0.2820948f + sh[12][2] * t1 + sh[20][2] * t3 + sh[4][2] * t6 + sh[8][2] * t8;
  const float t47 = sh[1][2] * t14 + sh[5][2] * t16 + sh[13][2] * t18 + sh[21][2] * t20 + sh[9][2] * t21;
  const float t48 = sh[2][2] * t25 + sh[6][2] * t2 + sh[10][2] * t27 + sh[14][2] * t28 + sh[18][2] * t30;
  const float t49 = sh[3][2] * t33 + sh[7][2] * t34 + sh[11][2] * t35 + sh[19][2] * t36 + sh[15][2] * t37;
  const float t50 = t46 + sh[16][2] * t12 + sh[24][2] * t13 + (t47 + sh[17][2] * t24) + (t48 + sh[22][2] * t32 + (t49 + sh[23][2] * t39));
  value[2] = t50;
}
#endif

#ifndef ZONAL_RECONSTRUCT_LAMBERT_2
#define ZONAL_RECONSTRUCT_LAMBERT_2
// Radiance convolved with the clamped cosine: irradiance over pi at a normal.
// 11 operations: 3 additions, 8 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_reconstruct_lambert_2(const float (&radiance)[4], const float (&normal)[3]) {
  const float t0 = radiance[2] * (0.48860252f * normal[2]) + radiance[1] * (-0.48860252f * normal[1]);
  const float t1 = radiance[0] * 0.2820948f + (t0 + radiance[3] * (-0.48860252f * normal[0])) * 0.6666667f;
  const float value = t1;
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_LAMBERT_3
#define ZONAL_RECONSTRUCT_LAMBERT_3
// Radiance convolved with the clamped cosine: irradiance over pi at a normal.
// 35 operations: 11 additions, 24 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_reconstruct_lambert_3(const float (&radiance)[9], const float (&normal)[3]) {
  const float t0 = radiance[2] * (0.48860252f * normal[2]) + radiance[1] * (-0.48860252f * normal[1]);
  const float t1 = radiance[0] * 0.2820948f + (t0 + radiance[3] * (-0.48860252f * normal[0])) * 0.6666667f;
  const float t2 = -1.0925485f * normal[2];
  const float t3 = radiance[6] * (0.9461747f * (normal[2] * normal[2]) + -0.31539157f) + radiance[5] * (t2 * normal[1]);
  const float t4 = normal[1] * normal[0];
  const float t5 = t3 + radiance[7] * (t2 * normal[0]) + radiance[4] * (0.54627424f * (t4 + t4));
  const float t6 = radiance[8] * (0.54627424f * (normal[0] * normal[0] - normal[1] * normal[1]));
  const float value = t1 + (t5 + t6) * 0.25f;
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_LAMBERT_4
#define ZONAL_RECONSTRUCT_LAMBERT_4
// Radiance convolved with the clamped cosine: irradiance over pi at a normal.
// 35 operations: 11 additions, 24 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_reconstruct_lambert_4(const float (&radiance)[16], const float (&normal)[3]) {
  const float t0 = radiance[2] * (0.48860252f * normal[2]) + radiance[1] * (-0.48860252f * normal[1]);
  const float t1 = radiance[0] * 0.2820948f + (t0 + radiance[3] * (-0.48860252f * normal[0])) * 0.6666667f;
  const float t2 = -1.0925485f * normal[2];
  const float t3 = radiance[6] * (0.9461747f * (normal[2] * normal[2]) + -0.31539157f) + radiance[5] * (t2 * normal[1]);
  const float t4 = normal[1] * normal[0];
  const float t5 = t3 + radiance[7] * (t2 * normal[0]) + radiance[4] * (0.54627424f * (t4 + t4));
  const float t6 = radiance[8] * (0.54627424f * (normal[0] * normal[0] - normal[1] * normal[1]));
  const float value = t1 + (t5 + t6) * 0.25f;
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_LAMBERT_5
#define ZONAL_RECONSTRUCT_LAMBERT_5
// Radiance convolved with the clamped cosine: irradiance over pi at a normal.
// 87 operations: 28 additions, 59 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_reconstruct_lambert_5(const float (&radiance)[25], const float (&normal)[3]) {
  const float t0 = normal[2] * normal[2];
  const float t1 = 0.9461747f * t0 + -0.31539157f;
  const float t2 = 1.9843135f * normal[2] * (normal[2] * (1.8658817f * t0 + -1.119529f)) - 1.0062306f * t1;
  const float t3 = normal[2] * (-4.683326f * t0 + 2.0071397f);
  const float t4 = radiance[20] * t2 + radiance[19] * (t3 * normal[1]) + radiance[21] * (t3 * normal[0]);
  const float t5 = 3.3116114f * t0 + -0.47308734f;
  const float t6 = normal[1] * normal[0];
  const float t7 = t6 + t6;
  const float t8 = normal[0] * normal[0] - normal[1] * normal[1];
  const float t9 = -1.7701308f * normal[2];
  const float t10 = normal[0] * t7 + normal[1] * t8;
  const float t11 = t4 + radiance[18] * (t5 * t7) + radiance[22] * (t5 * t8) + radiance[17] * (t9 * t10);
  const float t12 = normal[0] * t8 - normal[1] * t7;
  const float t13 = t11 + radiance[23] * (t9 * t12) + radiance[16] * (0.6258357f * (normal[0] * t10 + normal[1] * t12));
  const float t14 = (t13 + radiance[24] * (0.6258357f * (normal[0] * t12 - normal[1] * t10))) * -0.041666668f;
  const float t15 = radiance[2] * (0.48860252f * normal[2]) + radiance[1] * (-0.48860252f * normal[1]);
  const float t16 = radiance[0] * 0.2820948f + t14 + (t15 + radiance[3] * (-0.48860252f * normal[0])) * 0.6666667f;
  const float t17 = -1.0925485f * normal[2];
  const float t18 = radiance[6] * t1 + radiance[5] * (t17 * normal[1]) + radiance[7] * (t17 * normal[0]);
  const float t19 = t18 + radiance[4] * (0.54627424f * t7) + radiance[8] * (0.54627424f * t8);
  const float value = t16 + t19 * 0.25f;
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_LAMBERT_COLOUR_2
#define ZONAL_RECONSTRUCT_LAMBERT_COLOUR_2
// Radiance convolved with the clamped cosine: irradiance over pi at a normal. For colours.
// 27 operations: 9 additions, 18 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_reconstruct_lambert_colour_2(const float (&radiance)[4][3], const float (&normal)[3],
    float (&value)[3]) {
  const float t0 = 0.48860252f * normal[2];
  const float t1 = -0.48860252f * normal[1];
  const float t2 = -0.48860252f * normal[0];
  const float t3 = (radiance[2][0] * t0 + radiance[1][0] * t1 + radiance[3][0] * t2) * 0.6666667f;
  value[0] = radiance[0][0] * 0.2820948f + t3;
  const float t4 = (radiance[2][1] * t0 + radiance[1][1] * t1 + radiance[3][1] * t2) * 0.6666667f;
  value[1] = radiance[0][1] * 0.2820948f + t4;
  const float t5 = (radiance[2][2] * t0 + radiance[1][2] * t1 + radiance[3][2] * t2) * 0.6666667f;
  value[2] = radiance[0][2] * 0.2820948f + t5;
}
#endif

#ifndef ZONAL_RECONSTRUCT_LAMBERT_COLOUR_3
#define ZONAL_RECONSTRUCT_LAMBERT_COLOUR_3
// Radiance convolved with the clamped cosine: irradiance over pi at a normal. For colours.
// 73 operations: 27 additions, 46 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_reconstruct_lambert_colour_3(const float (&radiance)[9][3], const float (&normal)[3],
    float (&value)[3]) {
  const float t0 = 0.48860252f * normal[2];
  const float t1 = -0.48860252f * normal[1];
  const float t2 = -0.48860252f * normal[0];
  const float t3 = (radiance[2][0] * t0 + radiance[1][0] * t1 + radiance[3][0] * t2) * 0.6666667f;
  const float t4 = 0.9461747f * (normal[2] * normal[2]) + -0.31539157f;
  const float t5 = -1.0925485f * normal[2];
  const float t6 = t5 * normal[1];
  const float t7 = t5 * normal[0];
  const float t8 = normal[1] * normal[0];
  const float t9 = 0.54627424f * (t8 + t8);
  const float t10 = radiance[6][0] * t4 + radiance[5][0] * t6 + radiance[7][0] * t7 + radiance[4][0] * t9;
  const float t11 = 0.54627424f * (normal[0] * normal[0] - normal[1] * normal[1]);
  value[0] = radiance[0][0] * 0.2820948f + t3 + (t10 + radiance[8][0] * t11) * 0.25f;
  const float t12 = (radiance[2][1] * t0 + radiance[1][1] * t1 + radiance[3][1] * t2) * 0.6666667f;
  const float t13 = radiance[6][1] * t4 + radiance[5][1] * t6 + radiance[7][1] * t7 + radiance[4][1] * t9;
  const float t14 = radiance[0][1] * 0.2820948f + t12 + (t13 + radiance[8][1] * t11) * 0.25f;
  value[1] = t14;
  const float t15 = (radiance[2][2] * t0 + radiance[1][2] * t1 + radiance[3][2] * t2) * 0.6666667f;
  const float t16 = radiance[6][2] * t4 + radiance[5][2] * t6 + radiance[7][2] * t7 + radiance[4][2] * t9;
  const float t17 = radiance[0][2] * 0.2820948f + t15 + (t16 + radiance[8][2] * t11) * 0.25f;
  value[2] = t17;
}
#endif

#ifndef ZONAL_RECONSTRUCT_LAMBERT_COLOUR_4
#define ZONAL_RECONSTRUCT_LAMBERT_COLOUR_4
// Radiance convolved with the clamped cosine: irradiance over pi at a normal. For colours.
// 73 operations: 27 additions, 46 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_reconstruct_lambert_colour_4(const float (&radiance)[16][3], const float (&normal)[3],
    float (&value)[3]) {
  const float t0 = 0.48860252f * normal[2];
  const float t1 = -0.48860252f * normal[1];
  const float t2 = -0.48860252f * normal[0];
  const float t3 = (radiance[2][0] * t0 + radiance[1][0] * t1 + radiance[3][0] * t2) * 0.6666667f;
  const float t4 = 0.9461747f * (normal[2] * normal[2]) + -0.31539157f;
  const float t5 = -1.0925485f * normal[2];
  const float t6 = t5 * normal[1];
  const float t7 = t5 * normal[0];
  const float t8 = normal[1] * normal[0];
  const float t9 = 0.54627424f * (t8 + t8);
  const float t10 = radiance[6][0] * t4 + radiance[5][0] * t6 + radiance[7][0] * t7 + radiance[4][0] * t9;
  const float t11 = 0.54627424f * (normal[0] * normal[0] - normal[1] * normal[1]);
  value[0] = radiance[0][0] * 0.2820948f + t3 + (t10 + radiance[8][0] * t11) * 0.25f;
  const float t12 = (radiance[2][1] * t0 + radiance[1][1] * t1 + radiance[3][1] * t2) * 0.6666667f;
  const float t13 = radiance[6][1] * t4 + radiance[5][1] * t6 + radiance[7][1] * t7 + radiance[4][1] * t9;
  const float t14 = radiance[0][1] * 0.2820948f + t12 + (t13 + radiance[8][1] * t11) * 0.25f;
  value[1] = t14;
  const float t15 = (radiance[2][2] * t0 + radiance[1][2] * t1 + radiance[3][2] * t2) * 0.6666667f;
  const float t16 = radiance[6][2] * t4 + radiance[5][2] * t6 + radiance[7][2] * t7 + radiance[4][2] * t9;
  const float t17 = radiance[0][2] * 0.2820948f + t15 + (t16 + radiance[8][2] * t11) * 0.25f;
  value[2] = t17;
}
#endif

#ifndef ZONAL_RECONSTRUCT_LAMBERT_COLOUR_5
#define ZONAL_RECONSTRUCT_LAMBERT_COLOUR_5
// Radiance convolved with the clamped cosine: irradiance over pi at a normal. For colours.
// 163 operations: 62 additions, 101 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_reconstruct_lambert_colour_5(const float (&radiance)[25][3], const float (&normal)[3],
    float (&value)[3]) {
  const float t0 = normal[2] * normal[2];
  const float t1 = 0.9461747f * t0 + -0.31539157f;
  const float t2 = 1.9843135f * normal[2] * (normal[2] * (1.8658817f * t0 + -1.119529f)) - 1.0062306f * t1;
  const float t3 = normal[2] * (-4.683326f * t0 + 2.0071397f);
  const float t4 = t3 * normal[1];
  const float t5 = t3 * normal[0];
  const float t6 = 3.3116114f * t0 + -0.47308734f;
  const float t7 = normal[1] * normal[0];
  const float t8 = t7 + t7;
  const float t9 = t6 * t8;
  const float t10 = radiance[20][0] * t2 + radiance[19][0] * t4 + radiance[21][0] * t5 + radiance[18][0] * t9;
  const float t11 = normal[0] * normal[0] - normal[1] * normal[1];
  const float t12 = t6 * t11;
  const float t13 = -1.7701308f * normal[2];
  const float t14 = normal[0] * t8 + normal[1] * t11;
  const float t15 = t13 * t14;
  const float t16 = normal[0] * t11 - normal[1] * t8;
  const float t17 = t13 * t16;
  const float t18 = t10 + radiance[22][0] * t12 + radiance[17][0] * t15 + radiance[23][0] * t17;
  const float t19 = 0.6258357f * (normal[0] * t14 + normal[1] * t16);
  const float t20 = 0.6258357f * (normal[0] * t16 - normal[1] * t14);
  const float t21 = radiance[0][0] * 0.2820948f + (t18 + radiance[16][0] * t19 + radiance[24][0] * t20) * -0.041666668f;
  const float t22 = 0.48860252f * normal[2];
  const float t23 = -0.48860252f * normal[1];
  const float t24 = -0.48860252f * normal[0];
  const float t25 = (radiance[2][0] * t22 + radiance[1][0] * t23 + radiance[3][0] * t24) * 0.6666667f;
  const float t26 = -1.0925485f * normal[2];
  const float t27 = t26 * normal[1];
  const float t28 = t26 * normal[0];
  const float t29 = 0.54627424f * t8;
  const float t30 = radiance[6][0] * t1 + radiance[5][0] * t27 + radiance[7][0] * t28 + radiance[4][0] * t29;
  const float t31 = 0.54627424f * t11;
  value[0] = t21 + t25 + (t30 + radiance[8][0] * t31) * 0.25f;
  const float t32 = radiance[20][1] * t2 + radiance[19][1] * t4 + radiance[21][1] * t5 + radiance[18][1] * t9;
  const float t33 = t32 + radiance[22][1] * t12 + radiance[17][1] * t15 + radiance[23][1] * t17;
  const float t34 = radiance[0][1] * 0.2820948f + (t33 + radiance[16][1] * t19 + radiance[24][1] * t20) * -0.041666668f;
  const float t35 = (radiance[2][1] * t22 + radiance[1][1] * t23 + radiance[3][1] * t24) * 0.6666667f;
  const float t36 = radiance[6][1] * t1 + radiance[5][1] * t27 + radiance[7][1] * t28 + radiance[4][1] * t29;
  value[1] = t34 + t35 + (t36 + radiance[8][1] * t31) * 0.25f;
  const float t37 = radiance[20][2] * t2 + radiance[19][2] * t4 + radiance[21][2] * t5 + radiance[18][2] * t9;
  const float t38 = t37 + radiance[22][2] * t12 + radiance[17][2] * t15 + radiance[23][2] * t17;
  const float t39 = radiance[0][2] * 0.2820948f + (t38 + radiance[16][2] * t19 + radiance[24][2] * t20) * -0.041666668f;
  const float t40 = (radiance[2][2] * t22 + radiance[1][2] * t23 + radiance[3][2] * t24) * 0.6666667f;
  const float t41 = radiance[6][2] * t1 + radiance[5][2] * t27 + radiance[7][2] * t28 + radiance[4][2] * t29;
  value[2] = t39 + t40 + (t41 + radiance[8][2] * t31) * 0.25f;
}
#endif

#ifndef ZONAL_ORIENT_2
#define ZONAL_ORIENT_2
// A zonal lobe turned to an axis, a unit vector.
// 9 operations: 0 additions, 9 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_orient_2(const float (&zh)[2], const float (&axis)[3], float (&sh)[4]) {
  sh[0] = 3.5449078f * zh[0] * 0.2820948f;
  const float t0 = 2.0466535f * zh[1];
  sh[1] = t0 * (-0.48860252f * axis[1]);
  sh[2] = t0 * (0.48860252f * axis[2]);
  sh[3] = t0 * (-0.48860252f * axis[0]);
}
#endif

#ifndef ZONAL_ORIENT_3
#define ZONAL_ORIENT_3
// A zonal lobe turned to an axis, a unit vector.
// 28 operations: 3 additions, 25 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_orient_3(const float (&zh)[3], const float (&axis)[3], float (&sh)[9]) {
  sh[0] = 3.5449078f * zh[0] * 0.2820948f;
  const float t0 = 2.0466535f * zh[1];
  sh[1] = t0 * (-0.48860252f * axis[1]);
  sh[2] = t0 * (0.48860252f * axis[2]);
  sh[3] = t0 * (-0.48860252f * axis[0]);
  const float t1 = 1.585331f * zh[2];
  const float t2 = axis[1] * axis[0];
  sh[4] = t1 * (0.54627424f * (t2 + t2));
  const float t3 = -1.0925485f * axis[2];
  sh[5] = t1 * (t3 * axis[1]);
  sh[6] = t1 * (0.9461747f * (axis[2] * axis[2]) + -0.31539157f);
  sh[7] = t1 * (t3 * axis[0]);
  sh[8] = t1 * (0.54627424f * (axis[0] * axis[0] - axis[1] * axis[1]));
}
#endif

#ifndef ZONAL_ORIENT_4
#define ZONAL_ORIENT_4
// A zonal lobe turned to an axis, a unit vector.
// 54 operations: 7 additions, 47 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_orient_4(const float (&zh)[4], const float (&axis)[3], float (&sh)[16]) {
  sh[0] = 3.5449078f * zh[0] * 0.2820948f;
  const float t0 = 2.0466535f * zh[1];
  sh[1] = t0 * (-0.48860252f * axis[1]);
  sh[2] = t0 * (0.48860252f * axis[2]);
  sh[3] = t0 * (-0.48860252f * axis[0]);
  const float t1 = 1.585331f * zh[2];
  const float t2 = axis[1] * axis[0];
  const float t3 = t2 + t2;
  sh[4] = t1 * (0.54627424f * t3);
  const float t4 = -1.0925485f * axis[2];
  sh[5] = t1 * (t4 * axis[1]);
  const float t5 = axis[2] * axis[2];
  sh[6] = t1 * (0.9461747f * t5 + -0.31539157f);
  sh[7] = t1 * (t4 * axis[0]);
  const float t6 = axis[0] * axis[0] - axis[1] * axis[1];
  sh[8] = t1 * (0.54627424f * t6);
  const float t7 = 1.3398491f * zh[3];
  sh[9] = t7 * (-0.5900436f * (axis[0] * t3 + axis[1] * t6));
  const float t8 = 1.4453057f * axis[2];
  sh[10] = t7 * (t8 * t3);
  const float t9 = -2.285229f * t5 + 0.4570458f;
  sh[11] = t7 * (t9 * axis[1]);
  sh[12] = t7 * (axis[2] * (1.8658817f * t5 + -1.119529f));
  sh[13] = t7 * (t9 * axis[0]);
  sh[14] = t7 * (t8 * t6);
  sh[15] = t7 * (-0.5900436f * (axis[0] * t6 - axis[1] * t3));
}
#endif

#ifndef ZONAL_ORIENT_5
#define ZONAL_ORIENT_5
// A zonal lobe turned to an axis, a unit vector.
// 88 operations: 12 additions, 76 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_orient_5(const float (&zh)[5], const float (&axis)[3], float (&sh)[25]) {
  sh[0] = 3.5449078f * zh[0] * 0.2820948f;
  const float t0 = 2.0466535f * zh[1];
  sh[1] = t0 * (-0.48860252f * axis[1]);
  sh[2] = t0 * (0.48860252f * axis[2]);
  sh[3] = t0 * (-0.48860252f * axis[0]);
  const float t1 = 1.585331f * zh[2];
  const float t2 = axis[1] * axis[0];
  const float t3 = t2 + t2;
  sh[4] = t1 * (0.54627424f * t3);
  const float t4 = -1.0925485f * axis[2];
  sh[5] = t1 * (t4 * axis[1]);
  const float t5 = axis[2] * axis[2];
  const float t6 = 0.9461747f * t5 + -0.31539157f;
  sh[6] = t1 * t6;
  sh[7] = t1 * (t4 * axis[0]);
  const float t7 = axis[0] * axis[0] - axis[1] * axis[1];
  sh[8] = t1 * (0.54627424f * t7);
  const float t8 = 1.3398491f * zh[3];
  const float t9 = axis[0] * t3 + axis[1] * t7;
  sh[9] = t8 * (-0.5900436f * t9);
  const float t10 = 1.4453057f * axis[2];
  sh[10] = t8 * (t10 * t3);
  const float t11 = -2.285229f * t5 + 0.4570458f;
  sh[11] = t8 * (t11 * axis[1]);
  const float t12 = axis[2] * (1.8658817f * t5 + -1.119529f);
  sh[12] = t8 * t12;
  sh[13] = t8 * (t11 * axis[0]);
  sh[14] = t8 * (t10 * t7);
  const float t13 = axis[0] * t7 - axis[1] * t3;
  sh[15] = t8 * (-0.5900436f * t13);
  const float t14 = 1.1816359f * zh[4];
  sh[16] = t14 * (0.6258357f * (axis[0] * t9 + axis[1] * t13));
  const float t15 = -1.7701308f * axis[2];
  sh[17] = t14 * (t15 * t9);
  const float t16 = 3.3116114f * t5 + -0.47308734f;
  sh[18] = t14 * (t16 * t3);
  const float t17 = axis[2] * (-4.683326f * t5 + 2.0071397f);
  sh[19] = t14 * (t17 * axis[1]);
  sh[20] = t14 * (1.9843135f * axis[2] * t12 - 1.0062306f * t6);
  sh[21] = t14 * (t17 * axis[0]);
  sh[22] = t14 * (t16 * t7);
  sh[23] = t14 * (t15 * t13);
  sh[24] = t14 * (0.6258357f * (axis[0] * t13 - axis[1] * t9));
}
#endif

#ifndef ZONAL_ORIENT_COLOUR_2
#define ZONAL_ORIENT_COLOUR_2
// A zonal lobe turned to an axis, a unit vector. For colours.
// 21 operations: 0 additions, 21 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_orient_colour_2(const float (&zh)[2][3], const float (&axis)[3], float (&sh)[4][3]) {
  sh[0][0] = 3.5449078f * zh[0][0] * 0.2820948f;
  sh[0][1] = 3.5449078f * zh[0][1] * 0.2820948f;
  sh[0][2] = 3.5449078f * zh[0][2] * 0.2820948f;
  const float t0 = 2.0466535f * zh[1][0];
  const float t1 = -0.48860252f * axis[1];
  sh[1][0] = t0 * t1;
  const float t2 = 2.0466535f * zh[1][1];
  sh[1][1] = t2 * t1;
  const float t3 = 2.0466535f * zh[1][2];
  sh[1][2] = t3 * t1;
  const float t4 = 0.48860252f * axis[2];
  sh[2][0] = t0 * t4;
  sh[2][1] = t2 * t4;
  sh[2][2] = t3 * t4;
  const float t5 = -0.48860252f * axis[0];
  sh[3][0] = t0 * t5;
  sh[3][1] = t2 * t5;
  sh[3][2] = t3 * t5;
}
#endif

#ifndef ZONAL_ORIENT_COLOUR_3
#define ZONAL_ORIENT_COLOUR_3
// A zonal lobe turned to an axis, a unit vector. For colours.
// 52 operations: 3 additions, 49 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_orient_colour_3(const float (&zh)[3][3], const float (&axis)[3], float (&sh)[9][3]) {
  sh[0][0] = 3.5449078f * zh[0][0] * 0.2820948f;
  sh[0][1] = 3.5449078f * zh[0][1] * 0.2820948f;
  sh[0][2] = 3.5449078f * zh[0][2] * 0.2820948f;
  const float t0 = 2.0466535f * zh[1][0];
  const float t1 = -0.48860252f * axis[1];
  sh[1][0] = t0 * t1;
  const float t2 = 2.0466535f * zh[1][1];
  sh[1][1] = t2 * t1;
  const float t3 = 2.0466535f * zh[1][2];
  sh[1][2] = t3 * t1;
  const float t4 = 0.48860252f * axis[2];
  sh[2][0] = t0 * t4;
  sh[2][1] = t2 * t4;
  sh[2][2] = t3 * t4;
  const float t5 = -0.48860252f * axis[0];
  sh[3][0] = t0 * t5;
  sh[3][1] = t2 * t5;
  sh[3][2] = t3 * t5;
  const float t6 = 1.585331f * zh[2][0];
  const float t7 = axis[1] * axis[0];
  const float t8 = 0.54627424f * (t7 + t7);
  sh[4][0] = t6 * t8;
  const float t9 = 1.585331f * zh[2][1];
  sh[4][1] = t9 * t8;
  const float t10 = 1.585331f * zh[2][2];
  sh[4][2] = t10 * t8;
  const float t11 = -1.0925485f * axis[2];
  const float t12 = t11 * axis[1];
  sh[5][0] = t6 * t12;
  sh[5][1] = t9 * t12;
  sh[5][2] = t10 * t12;
  const float t13 = 0.9461747f * (axis[2] * axis[2]) + -0.31539157f;
  sh[6][0] = t6 * t13;
  sh[6][1] = t9 * t13;
  sh[6][2] = t10 * t13;
  const float t14 = t11 * axis[0];
  sh[7][0] = t6 * t14;
  sh[7][1] = t9 * t14;
  sh[7][2] = t10 * t14;
  const float t15 = 0.54627424f * (axis[0] * axis[0] - axis[1] * axis[1]);
  sh[8][0] = t6 * t15;
  sh[8][1] = t9 * t15;
  sh[8][2] = t10 * t15;
}
#endif

#ifndef ZONAL_ORIENT_COLOUR_4
#define ZONAL_ORIENT_COLOUR_4
// A zonal lobe turned to an axis, a unit vector. For colours.
// 94 operations: 7 additions, 87 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_orient_colour_4(const float (&zh)[4][3], const float (&axis)[3], float (&sh)[16][3]) {
  sh[0][0] = 3.5449078f * zh[0][0] * 0.2820948f;
  sh[0][1] = 3.5449078f * zh[0][1] * 0.2820948f;
  sh[0][2] = 3.5449078f * zh[0][2] * 0.2820948f;
  const float t0 = 2.0466535f * zh[1][0];
  const float t1 = -0.48860252f * axis[1];
  sh[1][0] = t0 * t1;
  const float t2 = 2.0466535f * zh[1][1];
  sh[1][1] = t2 * t1;
  const float t3 = 2.0466535f * zh[1][2];
  sh[1][2] = t3 * t1;
  const float t4 = 0.48860252f * axis[2];
  sh[2][0] = t0 * t4;
  sh[2][1] = t2 * t4;
  sh[2][2] = t3 * t4;
  const float t5 = -0.48860252f * axis[0];
  sh[3][0] = t0 * t5;
  sh[3][1] = t2 * t5;
  sh[3][2] = t3 * t5;
  const float t6 = 1.585331f * zh[2][0];
  const float t7 = axis[1] * axis[0];
  const float t8 = t7 + t7;
  const float t9 = 0.54627424f * t8;
  sh[4][0] = t6 * t9;
  const float t10 = 1.585331f * zh[2][1];
  sh[4][1] = t10 * t9;
  const float t11 = 1.585331f * zh[2][2];
  sh[4][2] = t11 * t9;
  const float t12 = -1.0925485f * axis[2];
  const float t13 = t12 * axis[1];
  sh[5][0] = t6 * t13;
  sh[5][1] = t10 * t13;
  sh[5][2] = t11 * t13;
  const float t14 = axis[2] * axis[2];
  const float t15 = 0.9461747f * t14 + -0.31539157f;
  sh[6][0] = t6 * t15;
  sh[6][1] = t10 * t15;
  sh[6][2] = t11 * t15;
  const float t16 = t12 * axis[0];
  sh[7][0] = t6 * t16;
  sh[7][1] = t10 * t16;
  sh[7][2] = t11 * t16;
  const float t17 = axis[0] * axis[0] - axis[1] * axis[1];
  const float t18 = 0.54627424f * t17;
  sh[8][0] = t6 * t18;
  sh[8][1] = t10 * t18;
  sh[8][2] = t11 * t18;
  const float t19 = 1.3398491f * zh[3][0];
  const float t20 = -0.5900436f * (axis[0] * t8 + axis[1] * t17);
  sh[9][0] = t19 * t20;
  const float t21 = 1.3398491f * zh[3][1];
  sh[9][1] = t21 * t20;
  const float t22 = 1.3398491f * zh[3][2];
  sh[9][2] = t22 * t20;
  const float t23 = 1.4453057f * axis[2];
  const float t24 = t23 * t8;
  sh[10][0] = t19 * t24;
  sh[10][1] = t21 * t24;
  sh[10][2] = t22 * t24;
  const float t25 = -2.285229f * t14 + 0.4570458f;
  const float t26 = t25 * axis[1];
  sh[11][0] = t19 * t26;
  sh[11][1] = t21 * t26;
  sh[11][2] = t22 * t26;
  const float t27 = axis[2] * (1.8658817f * t14 + -1.119529f);
  sh[12][0] = t19 * t27;
  sh[12][1] = t21 * t27;
  sh[12][2] = t22 * t27;
  const float t28 = t25 * axis[0];
  sh[13][0] = t19 * t28;
  sh[13][1] = t21 * t28;
  sh[13][2] = t22 * t28;
  const float t29 = t23 * t17;
  sh[14][0] = t19 * t29;
  sh[14][1] = t21 * t29;
  sh[14][2] = t22 * t29;
  const float t30 = -0.5900436f * (axis[0] * t17 - axis[1] * t8);
  sh[15][0] = t19 * t30;
  sh[15][1] = t21 * t30;
  sh[15][2] = t22 * t30;
}
#endif

#ifndef ZONAL_ORIENT_COLOUR_5
#define ZONAL_ORIENT_COLOUR_5
// A zonal lobe turned to an axis, a unit vector. For colours.
// 148 operations: 12 additions, 136 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_orient_colour_5(const float (&zh)[5][3], const float (&axis)[3], float (&sh)[25][3]) {
  sh[0][0] = 3.5449078f * zh[0][0] * 0.2820948f;
  sh[0][1] = 3.5449078f * zh[0][1] * 0.2820948f;
  sh[0][2] = 3.5449078f * zh[0][2] * 0.2820948f;
  const float t0 = 2.0466535f * zh[1][0];
  const float t1 = -0.48860252f * axis[1];
  sh[1][0] = t0 * t1;
  const float t2 = 2.0466535f * zh[1][1];
  sh[1][1] = t2 * t1;
  const float t3 = 2.0466535f * zh[1][2];
  sh[1][2] = t3 * t1;
  const float t4 = 0.48860252f * axis[2];
  sh[2][0] = t0 * t4;
  sh[2][1] = t2 * t4;
  sh[2][2] = t3 * t4;
  const float t5 = -0.48860252f * axis[0];
  sh[3][0] = t0 * t5;
  sh[3][1] = t2 * t5;
  sh[3][2] = t3 * t5;
  const float t6 = 1.585331f * zh[2][0];
  const float t7 = axis[1] * axis[0];
  const float t8 = t7 + t7;
  const float t9 = 0.54627424f * t8;
  sh[4][0] = t6 * t9;
  const float t10 = 1.585331f * zh[2][1];
  sh[4][1] = t10 * t9;
  const float t11 = 1.585331f * zh[2][2];
  sh[4][2] = t11 * t9;
  const float t12 = -1.0925485f * axis[2];
  const float t13 = t12 * axis[1];
  sh[5][0] = t6 * t13;
  sh[5][1] = t10 * t13;
  sh[5][2] = t11 * t13;
  const float t14 = axis[2] * axis[2];
  const float t15 = 0.9461747f * t14 + -0.31539157f;
  sh[6][0] = t6 * t15;
  sh[6][1] = t10 * t15;
  sh[6][2] = t11 * t15;
  const float t16 = t12 * axis[0];
  sh[7][0] = t6 * t16;
  sh[7][1] = t10 * t16;
  sh[7][2] = t11 * t16;
  const float t17 = axis[0] * axis[0] - axis[1] * axis[1];
  const float t18 = 0.54627424f * t17;
  sh[8][0] = t6 * t18;
  sh[8][1] = t10 * t18;
  sh[8][2] = t11 * t18;
  const float t19 = 1.3398491f * zh[3][0];
  const float t20 = axis[0] * t8 + axis[1] * t17;
  const float t21 = -0.5900436f * t20;
  sh[9][0] = t19 * t21;
  const float t22 = 1.3398491f * zh[3][1];
  sh[9][1] = t22 * t21;
  const float t23 = 1.3398491f * zh[3][2];
  sh[9][2] = t23 * t21;
  const float t24 = 1.4453057f * axis[2];
  const float t25 = t24 * t8;
  sh[10][0] = t19 * t25;
  sh[10][1] = t22 * t25;
  sh[10][2] = t23 * t25;
  const float t26 = -2.285229f * t14 + 0.4570458f;
  const float t27 = t26 * axis[1];
  sh[11][0] = t19 * t27;
  sh[11][1] = t22 * t27;
  sh[11][2] = t23 * t27;
  const float t28 = axis[2] * (1.8658817f * t14 + -1.119529f);
  sh[12][0] = t19 * t28;
  sh[12][1] = t22 * t28;
  sh[12][2] = t23 * t28;
  const float t29 = t26 * axis[0];
  sh[13][0] = t19 * t29;
  sh[13][1] = t22 * t29;
  sh[13][2] = t23 * t29;
  const float t30 = t24 * t17;
  sh[14][0] = t19 * t30;
  sh[14][1] = t22 * t30;
  sh[14][2] = t23 * t30;
  const float t31 = axis[0] * t17 - axis[1] * t8;
  const float t32 = -0.5900436f * t31;
  sh[15][0] = t19 * t32;
  sh[15][1] = t22 * t32;
  sh[15][2] = t23 * t32;
  const float t33 = 1.1816359f * zh[4][0];
  const float t34 = 0.6258357f * (axis[0] * t20 + axis[1] * t31);
  sh[16][0] = t33 * t34;
  const float t35 = 1.1816359f * zh[4][1];
  sh[16][1] = t35 * t34;
  const float t36 = 1.1816359f * zh[4][2];
  sh[16][2] = t36 * t34;
  const float t37 = -1.7701308f * axis[2];
  const float t38 = t37 * t20;
  sh[17][0] = t33 * t38;
  sh[17][1] = t35 * t38;
  sh[17][2] = t36 * t38;
  const float t39 = 3.3116114f * t14 + -0.47308734f;
  const float t40 = t39 * t8;
  sh[18][0] = t33 * t40;
  sh[18][1] = t35 * t40;
  sh[18][2] = t36 * t40;
  const float t41 = axis[2] * (-4.683326f * t14 + 2.0071397f);
  const float t42 = t41 * axis[1];
  sh[19][0] = t33 * t42;
  sh[19][1] = t35 * t42;
  sh[19][2] = t36 * t42;
  const float t43 = 1.9843135f * axis[2] * t28 - 1.0062306f * t15;
  sh[20][0] = t33 * t43;
  sh[20][1] = t35 * t43;
  sh[20][2] = t36 * t43;
  const float t44 = t41 * axis[0];
  sh[21][0] = t33 * t44;
  sh[21][1] = t35 * t44;
  sh[21][2] = t36 * t44;
  const float t45 = t39 * t17;
  sh[22][0] = t33 * t45;
  sh[22][1] = t35 * t45;
  sh[22][2] = t36 * t45;
  const float t46 = t37 * t31;
  sh[23][0] = t33 * t46;
  sh[23][1] = t35 * t46;
  sh[23][2] = t36 * t46;
  const float t47 = 0.6258357f * (axis[0] * t31 - axis[1] * t20);
  sh[24][0] = t33 * t47;
  sh[24][1] = t35 * t47;
  sh[24][2] = t36 * t47;
}
#endif

#ifndef ZONAL_DOT_2
#define ZONAL_DOT_2
// The integral of a product: the sum of the products of coefficients.
// 7 operations: 3 additions, 4 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_dot_2(const float (&a)[4], const float (&b)[4]) {
  const float value = a[0] * b[0] + a[1] * b[1] + (a[2] * b[2] + a[3] * b[3]);
  return value;
}
#endif

#ifndef ZONAL_DOT_3
#define ZONAL_DOT_3
// The integral of a product: the sum of the products of coefficients.
// 17 operations: 8 additions, 9 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_dot_3(const float (&a)[9], const float (&b)[9]) {
  const float t0 = a[0] * b[0] + a[4] * b[4] + a[8] * b[8] + (a[1] * b[1] + a[5] * b[5]) + (a[2] * b[2] + a[6] * b[6] + (a[3] * b[3] + a[7] * b[7]));
  const float value = t0;
  return value;
}
#endif

#ifndef ZONAL_DOT_4
#define ZONAL_DOT_4
// The integral of a product: the sum of the products of coefficients.
// 31 operations: 15 additions, 16 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_dot_4(const float (&a)[16], const float (&b)[16]) {
  const float t0 = a[0] * b[0] + a[4] * b[4] + a[8] * b[8] + a[12] * b[12] + (a[1] * b[1] + a[5] * b[5] + a[9] * b[9] + a[13] * b[13]);
  const float t1 = a[2] * b[2] + a[6] * b[6] + a[10] * b[10] + a[14] * b[14] + (a[3] * b[3] + a[7] * b[7] + a[11] * b[11] + a[15] * b[15]);
  const float value = t0 + t1;
  return value;
}
#endif

#ifndef ZONAL_DOT_5
#define ZONAL_DOT_5
// The integral of a product: the sum of the products of coefficients.
// 49 operations: 24 additions, 25 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_dot_5(const float (&a)[25], const float (&b)[25]) {
  const float t0 = a[0] * b[0] + a[4] * b[4] + a[8] * b[8] + a[12] * b[12] + a[16] * b[16] + a[20] * b[20];
  const float t1 = a[1] * b[1] + a[5] * b[5] + a[9] * b[9] + a[13] * b[13] + a[17] * b[17] + a[21] * b[21];
  const float t2 = a[2] * b[2] + a[6] * b[6] + a[10] * b[10] + a[14] * b[14] + a[18] * b[18];
  const float t3 = a[3] * b[3] + a[7] * b[7] + a[11] * b[11] + a[15] * b[15] + a[19] * b[19];
  const float value = t0 + a[24] * b[24] + t1 + (t2 + a[22] * b[22] + (t3 + a[23] * b[23]));
  return value;
}
#endif

#ifndef ZONAL_DOT_COLOUR_2
#define ZONAL_DOT_COLOUR_2
// The integral of a product: the sum of the products of coefficients. For colours.
// 21 operations: 9 additions, 12 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_dot_colour_2(const float (&a)[4][3], const float (&b)[4], float (&value)[3]) {
  value[0] = a[0][0] * b[0] + a[1][0] * b[1] + (a[2][0] * b[2] + a[3][0] * b[3]);
  value[1] = a[0][1] * b[0] + a[1][1] * b[1] + (a[2][1] * b[2] + a[3][1] * b[3]);
  value[2] = a[0][2] * b[0] + a[1][2] * b[1] + (a[2][2] * b[2] + a[3][2] * b[3]);
}
#endif

#ifndef ZONAL_DOT_COLOUR_3
#define ZONAL_DOT_COLOUR_3
// The integral of a product: the sum of the products of coefficients. For colours.
// 51 operations: 24 additions, 27 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_dot_colour_3(const float (&a)[9][3], const float (&b)[9], float (&value)[3]) {
  const float t0 = a[0][0] * b[0] + a[4][0] * b[4] + a[8][0] * b[8] + (a[1][0] * b[1] + a[5][0] * b[5]);
  const float t1 = t0 + (a[2][0] * b[2] + a[6][0] * b[6] + (a[3][0] * b[3] + a[7][0] * b[7]));
  value[0] = t1;
  const float t2 = a[0][1] * b[0] + a[4][1] * b[4] + a[8][1] * b[8] + (a[1][1] * b[1] + a[5][1] * b[5]);
  const float t3 = t2 + (a[2][1] * b[2] + a[6][1] * b[6] + (a[3][1] * b[3] + a[7][1] * b[7]));
  value[1] = t3;
  const float t4 = a[0][2] * b[0] + a[4][2] * b[4] + a[8][2] * b[8] + (a[1][2] * b[1] + a[5][2] * b[5]);
  const float t5 = t4 + (a[2][2] * b[2] + a[6][2] * b[6] + (a[3][2] * b[3] + a[7][2] * b[7]));
  value[2] = t5;
}
#endif

#ifndef ZONAL_DOT_COLOUR_4
#define ZONAL_DOT_COLOUR_4
// The integral of a product: the sum of the products of coefficients. For colours.
// 93 operations: 45 additions, 48 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_dot_colour_4(const float (&a)[16][3], const float (&b)[16], float (&value)[3]) {
  const float t0 = a[0][0] * b[0] + a[4][0] * b[4] + a[8][0] * b[8] + a[12][0] * b[12] + (a[1][0] * b[1] + a[5][0] * b[5] + a[9][0] * b[9] + a[13][0] * b[13]);
  const float t1 = a[2][0] * b[2] + a[6][0] * b[6] + a[10][0] * b[10] + a[14][0] * b[14] + (a[3][0] * b[3] + a[7][0] * b[7] + a[11][0] * b[11] + a[15][0] * b[15]);
  value[0] = t0 + t1;
  const float t2 = a[0][1] * b[0] + a[4][1] * b[4] + a[8][1] * b[8] + a[12][1] * b[12] + (a[1][1] * b[1] + a[5][1] * b[5] + a[9][1] * b[9] + a[13][1] * b[13]);
  const float t3 = a[2][1] * b[2] + a[6][1] * b[6] + a[10][1] * b[10] + a[14][1] * b[14] + (a[3][1] * b[3] + a[7][1] * b[7] + a[11][1] * b[11] + a[15][1] * b[15]);
  value[1] = t2 + t3;
  const float t4 = a[0][2] * b[0] + a[4][2] * b[4] + a[8][2] * b[8] + a[12][2] * b[12] + (a[1][2] * b[1] + a[5][2] * b[5] + a[9][2] * b[9] + a[13][2] * b[13]);
  const float t5 = a[2][2] * b[2] + a[6][2] * b[6] + a[10][2] * b[10] + a[14][2] * b[14] + (a[3][2] * b[3] + a[7][2] * b[7] + a[11][2] * b[11] + a[15][2] * b[15]);
  value[2] = t4 + t5;
}
#endif

#ifndef ZONAL_DOT_COLOUR_5
#define ZONAL_DOT_COLOUR_5
// The integral of a product: the sum of the products of coefficients. For colours.
// 147 operations: 72 additions, 75 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_dot_colour_5(const float (&a)[25][3], const float (&b)[25], float (&value)[3]) {
  const float t0 = a[0][0] * b[0] + a[4][0] * b[4] + a[8][0] * b[8] + a[12][0] * b[12] + a[16][0] * b[16];
  const float t1 = a[1][0] * b[1] + a[5][0] * b[5] + a[9][0] * b[9] + a[13][0] * b[13] + a[17][0] * b[17];
  const float t2 = a[2][0] * b[2] + a[6][0] * b[6] + a[10][0] * b[10] + a[14][0] * b[14] + a[18][0] * b[18];
  const float t3 = a[3][0] * b[3] + a[7][0] * b[7] + a[11][0] * b[11] + a[15][0] * b[15] + a[19][0] * b[19];
  const float t4 = t0 + a[20][0] * b[20] + a[24][0] * b[24] + (t1 + a[21][0] * b[21]) + (t2 + a[22][0] * b[22] + (t3 + a[23][0] * b[23]));
  value[0] = t4;
  const float t5 = a[0][1] * b[0] + a[4][1] * b[4] + a[8][1] * b[8] + a[12][1] * b[12] + a[16][1] * b[16];
  const float t6 = a[1][1] * b[1] + a[5][1] * b[5] + a[9][1] * b[9] + a[13][1] * b[13] + a[17][1] * b[17];
  const float t7 = a[2][1] * b[2] + a[6][1] * b[6] + a[10][1] * b[10] + a[14][1] * b[14] + a[18][1] * b[18];
  const float t8 = a[3][1] * b[3] + a[7][1] * b[7] + a[11][1] * b[11] + a[15][1] * b[15] + a[19][1] * b[19];
  const float t9 = t5 + a[20][1] * b[20] + a[24][1] * b[24] + (t6 + a[21][1] * b[21]) + (t7 + a[22][1] * b[22] + (t8 + a[23][1] * b[23]));
  value[1] = t9;
  const float t10 = a[0][2] * b[0] + a[4][2] * b[4] + a[8][2] * b[8] + a[12][2] * b[12] + a[16][2] * b[16];
  const float t11 = a[1][2] * b[1] + a[5][2] * b[5] + a[9][2] * b[9] + a[13][2] * b[13] + a[17][2] * b[17];
  const float t12 = a[2][2] * b[2] + a[6][2] * b[6] + a[10][2] * b[10] + a[14][2] * b[14] + a[18][2] * b[18];
  const float t13 = a[3][2] * b[3] + a[7][2] * b[7] + a[11][2] * b[11] + a[15][2] * b[15] + a[19][2] * b[19];
  const float t14 = t10 + a[20][2] * b[20] + a[24][2] * b[24] + (t11 + a[21][2] * b[21]) + (t12 + a[22][2] * b[22] + (t13 + a[23][2] * b[23]));
  value[2] = t14;
}
#endif

#ifndef ZONAL_DOT_COLOURS_2
#define ZONAL_DOT_COLOURS_2
// The integral of a product: the sum of the products of coefficients. For colours by colours.
// 21 operations: 9 additions, 12 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_dot_colours_2(const float (&a)[4][3], const float (&b)[4][3], float (&value)[3]) {
  const float t0 = a[0][0] * b[0][0] + a[1][0] * b[1][0] + (a[2][0] * b[2][0] + a[3][0] * b[3][0]);
  value[0] = t0;
  const float t1 = a[0][1] * b[0][1] + a[1][1] * b[1][1] + (a[2][1] * b[2][1] + a[3][1] * b[3][1]);
  value[1] = t1;
  const float t2 = a[0][2] * b[0][2] + a[1][2] * b[1][2] + (a[2][2] * b[2][2] + a[3][2] * b[3][2]);
  value[2] = t2;
}
#endif

#ifndef ZONAL_DOT_COLOURS_3
#define ZONAL_DOT_COLOURS_3
// The integral of a product: the sum of the products of coefficients. For colours by colours.
// 51 operations: 24 additions, 27 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_dot_colours_3(const float (&a)[9][3], const float (&b)[9][3], float (&value)[3]) {
  const float t0 = a[0][0] * b[0][0] + a[4][0] * b[4][0] + a[8][0] * b[8][0] + (a[1][0] * b[1][0] + a[5][0] * b[5][0]);
  const float t1 = a[2][0] * b[2][0] + a[6][0] * b[6][0] + (a[3][0] * b[3][0] + a[7][0] * b[7][0]);
  value[0] = t0 + t1;
  const float t2 = a[0][1] * b[0][1] + a[4][1] * b[4][1] + a[8][1] * b[8][1] + (a[1][1] * b[1][1] + a[5][1] * b[5][1]);
  const float t3 = a[2][1] * b[2][1] + a[6][1] * b[6][1] + (a[3][1] * b[3][1] + a[7][1] * b[7][1]);
  value[1] = t2 + t3;
  const float t4 = a[0][2] * b[0][2] + a[4][2] * b[4][2] + a[8][2] * b[8][2] + (a[1][2] * b[1][2] + a[5][2] * b[5][2]);
  const float t5 = a[2][2] * b[2][2] + a[6][2] * b[6][2] + (a[3][2] * b[3][2] + a[7][2] * b[7][2]);
  value[2] = t4 + t5;
}
#endif

#ifndef ZONAL_DOT_COLOURS_4
#define ZONAL_DOT_COLOURS_4
// The integral of a product: the sum of the products of coefficients. For colours by colours.
// 93 operations: 45 additions, 48 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_dot_colours_4(const float (&a)[16][3], const float (&b)[16][3], float (&value)[3]) {
  const float t0 = a[0][0] * b[0][0] + a[4][0] * b[4][0] + a[8][0] * b[8][0] + a[12][0] * b[12][0];
  const float t1 = a[1][0] * b[1][0] + a[5][0] * b[5][0] + a[9][0] * b[9][0] + a[13][0] * b[13][0];
  const float t2 = a[2][0] * b[2][0] + a[6][0] * b[6][0] + a[10][0] * b[10][0] + a[14][0] * b[14][0];
  const float t3 = a[3][0] * b[3][0] + a[7][0] * b[7][0] + a[11][0] * b[11][0] + a[15][0] * b[15][0];
  value[0] = t0 + t1 + (t2 + t3);
  const float t4 = a[0][1] * b[0][1] + a[4][1] * b[4][1] + a[8][1] * b[8][1] + a[12][1] * b[12][1];
  const float t5 = a[1][1] * b[1][1] + a[5][1] * b[5][1] + a[9][1] * b[9][1] + a[13][1] * b[13][1];
  const float t6 = a[2][1] * b[2][1] + a[6][1] * b[6][1] + a[10][1] * b[10][1] + a[14][1] * b[14][1];
  const float t7 = a[3][1] * b[3][1] + a[7][1] * b[7][1] + a[11][1] * b[11][1] + a[15][1] * b[15][1];
  value[1] = t4 + t5 + (t6 + t7);
  const float t8 = a[0][2] * b[0][2] + a[4][2] * b[4][2] + a[8][2] * b[8][2] + a[12][2] * b[12][2];
  const float t9 = a[1][2] * b[1][2] + a[5][2] * b[5][2] + a[9][2] * b[9][2] + a[13][2] * b[13][2];
  const float t10 = a[2][2] * b[2][2] + a[6][2] * b[6][2] + a[10][2] * b[10][2] + a[14][2] * b[14][2];
  const float t11 = a[3][2] * b[3][2] + a[7][2] * b[7][2] + a[11][2] * b[11][2] + a[15][2] * b[15][2];
  value[2] = t8 + t9 + (t10 + t11);
}
#endif

#ifndef ZONAL_DOT_COLOURS_5
#define ZONAL_DOT_COLOURS_5
// The integral of a product: the sum of the products of coefficients. For colours by colours.
// 147 operations: 72 additions, 75 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_dot_colours_5(const float (&a)[25][3], const float (&b)[25][3], float (&value)[3]) {
  const float t0 = a[0][0] * b[0][0] + a[4][0] * b[4][0] + a[8][0] * b[8][0] + a[12][0] * b[12][0];
  const float t1 = a[1][0] * b[1][0] + a[5][0] * b[5][0] + a[9][0] * b[9][0] + a[13][0] * b[13][0];
  const float t2 = t0 + a[16][0] * b[16][0] + a[20][0] * b[20][0] + a[24][0] * b[24][0] + (t1 + a[17][0] * b[17][0] + a[21][0] * b[21][0]);
  const float t3 = a[2][0] * b[2][0] + a[6][0] * b[6][0] + a[10][0] * b[10][0] + a[14][0] * b[14][0];
  const float t4 = a[3][0] * b[3][0] + a[7][0] * b[7][0] + a[11][0] * b[11][0] + a[15][0] * b[15][0];
  const float t5 = t3 + a[18][0] * b[18][0] + a[22][0] * b[22][0] + (t4 + a[19][0] * b[19][0] + a[23][0] * b[23][0]);
  value[0] = t2 + t5;
  const float t6 = a[0][1] * b[0][1] + a[4][1] * b[4][1] + a[8][1] * b[8][1] + a[12][1] * b[12][1];
  const float t7 = a[1][1] * b[1][1] + a[5][1] * b[5][1] + a[9][1] * b[9][1] + a[13][1] * b[13][1];
  const float t8 = t6 + a[16][1] * b[16][1] + a[20][1] * b[20][1] + a[24][1] * b[24][1] + (t7 + a[17][1] * b[17][1] + a[21][1] * b[21][1]);
  const float t9 = a[2][1] * b[2][1] + a[6][1] * b[6][1] + a[10][1] * b[10][1] + a[14][1] * b[14][1];
  const float t10 = a[3][1] * b[3][1] + a[7][1] * b[7][1] + a[11][1] * b[11][1] + a[15][1] * b[15][1];
  const float t11 = t9 + a[18][1] * b[18][1] + a[22][1] * b[22][1] + (t10 + a[19][1] * b[19][1] + a[23][1] * b[23][1]);
  value[1] = t8 + t11;
  const float t12 = a[0][2] * b[0][2] + a[4][2] * b[4][2] + a[8][2] * b[8][2] + a[12][2] * b[12][2];
  const float t13 = a[1][2] * b[1][2] + a[5][2] * b[5][2] + a[9][2] * b[9][2] + a[13][2] * b[13][2];
  const float t14 = t12 + a[16][2] * b[16][2] + a[20][2] * b[20][2] + a[24][2] * b[24][2] + (t13 + a[17][2] * b[17][2] + a[21][2] * b[21][2]);
  const float t15 = a[2][2] * b[2][2] + a[6][2] * b[6][2] + a[10][2] * b[10][2] + a[14][2] * b[14][2];
  const float t16 = a[3][2] * b[3][2] + a[7][2] * b[7][2] + a[11][2] * b[11][2] + a[15][2] * b[15][2];
  const float t17 = t15 + a[18][2] * b[18][2] + a[22][2] * b[22][2] + (t16 + a[19][2] * b[19][2] + a[23][2] * b[23][2]);
  value[2] = t14 + t17;
}
#endif

#ifndef ZONAL_CONVOLVE_2
#define ZONAL_CONVOLVE_2
// Convolution with a zonal kernel.
// 6 operations: 0 additions, 6 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_convolve_2(const float (&sh)[4], const float (&kernel)[2], float (&result)[4]) {
  result[0] = sh[0] * (3.5449078f * kernel[0]);
  const float t0 = 2.0466535f * kernel[1];
  result[1] = sh[1] * t0;
  result[2] = sh[2] * t0;
  result[3] = sh[3] * t0;
}
#endif

#ifndef ZONAL_CONVOLVE_3
#define ZONAL_CONVOLVE_3
// Convolution with a zonal kernel.
// 12 operations: 0 additions, 12 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_convolve_3(const float (&sh)[9], const float (&kernel)[3], float (&result)[9]) {
  result[0] = sh[0] * (3.5449078f * kernel[0]);
  const float t0 = 2.0466535f * kernel[1];
  result[1] = sh[1] * t0;
  result[2] = sh[2] * t0;
  result[3] = sh[3] * t0;
  const float t1 = 1.585331f * kernel[2];
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
ZONAL_FUNCTION void zonal_convolve_4(const float (&sh)[16], const float (&kernel)[4], float (&result)[16]) {
  result[0] = sh[0] * (3.5449078f * kernel[0]);
  const float t0 = 2.0466535f * kernel[1];
  result[1] = sh[1] * t0;
  result[2] = sh[2] * t0;
  result[3] = sh[3] * t0;
  const float t1 = 1.585331f * kernel[2];
  result[4] = sh[4] * t1;
  result[5] = sh[5] * t1;
  result[6] = sh[6] * t1;
  result[7] = sh[7] * t1;
  result[8] = sh[8] * t1;
  const float t2 = 1.3398491f * kernel[3];
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
ZONAL_FUNCTION void zonal_convolve_5(const float (&sh)[25], const float (&kernel)[5], float (&result)[25]) {
  result[0] = sh[0] * (3.5449078f * kernel[0]);
  const float t0 = 2.0466535f * kernel[1];
  result[1] = sh[1] * t0;
  result[2] = sh[2] * t0;
  result[3] = sh[3] * t0;
  const float t1 = 1.585331f * kernel[2];
  result[4] = sh[4] * t1;
  result[5] = sh[5] * t1;
  result[6] = sh[6] * t1;
  result[7] = sh[7] * t1;
  result[8] = sh[8] * t1;
  const float t2 = 1.3398491f * kernel[3];
  result[9] = sh[9] * t2;
  result[10] = sh[10] * t2;
  result[11] = sh[11] * t2;
  result[12] = sh[12] * t2;
  result[13] = sh[13] * t2;
  result[14] = sh[14] * t2;
  result[15] = sh[15] * t2;
  const float t3 = 1.1816359f * kernel[4];
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
ZONAL_FUNCTION void zonal_convolve_colour_2(const float (&sh)[4][3], const float (&kernel)[2],
    float (&result)[4][3]) {
  const float t0 = 3.5449078f * kernel[0];
  result[0][0] = sh[0][0] * t0;
  result[0][1] = sh[0][1] * t0;
  result[0][2] = sh[0][2] * t0;
  const float t1 = 2.0466535f * kernel[1];
  result[1][0] = sh[1][0] * t1;
  result[1][1] = sh[1][1] * t1;
  result[1][2] = sh[1][2] * t1;
  result[2][0] = sh[2][0] * t1;
  result[2][1] = sh[2][1] * t1;
  result[2][2] = sh[2][2] * t1;
  result[3][0] = sh[3][0] * t1;
  result[3][1] = sh[3][1] * t1;
  result[3][2] = sh[3][2] * t1;
}
#endif

#ifndef ZONAL_CONVOLVE_COLOUR_3
#define ZONAL_CONVOLVE_COLOUR_3
// Convolution with a zonal kernel. For colours.
// 30 operations: 0 additions, 30 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_convolve_colour_3(const float (&sh)[9][3], const float (&kernel)[3],
    float (&result)[9][3]) {
  const float t0 = 3.5449078f * kernel[0];
  result[0][0] = sh[0][0] * t0;
  result[0][1] = sh[0][1] * t0;
  result[0][2] = sh[0][2] * t0;
  const float t1 = 2.0466535f * kernel[1];
  result[1][0] = sh[1][0] * t1;
  result[1][1] = sh[1][1] * t1;
  result[1][2] = sh[1][2] * t1;
  result[2][0] = sh[2][0] * t1;
  result[2][1] = sh[2][1] * t1;
  result[2][2] = sh[2][2] * t1;
  result[3][0] = sh[3][0] * t1;
  result[3][1] = sh[3][1] * t1;
  result[3][2] = sh[3][2] * t1;
  const float t2 = 1.585331f * kernel[2];
  result[4][0] = sh[4][0] * t2;
  result[4][1] = sh[4][1] * t2;
  result[4][2] = sh[4][2] * t2;
  result[5][0] = sh[5][0] * t2;
  result[5][1] = sh[5][1] * t2;
  result[5][2] = sh[5][2] * t2;
  result[6][0] = sh[6][0] * t2;
  result[6][1] = sh[6][1] * t2;
  result[6][2] = sh[6][2] * t2;
  result[7][0] = sh[7][0] * t2;
  result[7][1] = sh[7][1] * t2;
  result[7][2] = sh[7][2] * t2;
  result[8][0] = sh[8][0] * t2;
  result[8][1] = sh[8][1] * t2;
  result[8][2] = sh[8][2] * t2;
}
#endif

#ifndef ZONAL_CONVOLVE_COLOUR_4
#define ZONAL_CONVOLVE_COLOUR_4
// Convolution with a zonal kernel. For colours.
// 52 operations: 0 additions, 52 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_convolve_colour_4(const float (&sh)[16][3], const float (&kernel)[4],
    float (&result)[16][3]) {
  const float t0 = 3.5449078f * kernel[0];
  result[0][0] = sh[0][0] * t0;
  result[0][1] = sh[0][1] * t0;
  result[0][2] = sh[0][2] * t0;
  const float t1 = 2.0466535f * kernel[1];
  result[1][0] = sh[1][0] * t1;
  result[1][1] = sh[1][1] * t1;
  result[1][2] = sh[1][2] * t1;
  result[2][0] = sh[2][0] * t1;
  result[2][1] = sh[2][1] * t1;
  result[2][2] = sh[2][2] * t1;
  result[3][0] = sh[3][0] * t1;
  result[3][1] = sh[3][1] * t1;
  result[3][2] = sh[3][2] * t1;
  const float t2 = 1.585331f * kernel[2];
  result[4][0] = sh[4][0] * t2;
  result[4][1] = sh[4][1] * t2;
  result[4][2] = sh[4][2] * t2;
  result[5][0] = sh[5][0] * t2;
  result[5][1] = sh[5][1] * t2;
  result[5][2] = sh[5][2] * t2;
  result[6][0] = sh[6][0] * t2;
  result[6][1] = sh[6][1] * t2;
  result[6][2] = sh[6][2] * t2;
  result[7][0] = sh[7][0] * t2;
  result[7][1] = sh[7][1] * t2;
  result[7][2] = sh[7][2] * t2;
  result[8][0] = sh[8][0] * t2;
  result[8][1] = sh[8][1] * t2;
  result[8][2] = sh[8][2] * t2;
  const float t3 = 1.3398491f * kernel[3];
  result[9][0] = sh[9][0] * t3;
  result[9][1] = sh[9][1] * t3;
  result[9][2] = sh[9][2] * t3;
  result[10][0] = sh[10][0] * t3;
  result[10][1] = sh[10][1] * t3;
  result[10][2] = sh[10][2] * t3;
  result[11][0] = sh[11][0] * t3;
  result[11][1] = sh[11][1] * t3;
  result[11][2] = sh[11][2] * t3;
  result[12][0] = sh[12][0] * t3;
  result[12][1] = sh[12][1] * t3;
  result[12][2] = sh[12][2] * t3;
  result[13][0] = sh[13][0] * t3;
  result[13][1] = sh[13][1] * t3;
  result[13][2] = sh[13][2] * t3;
  result[14][0] = sh[14][0] * t3;
  result[14][1] = sh[14][1] * t3;
  result[14][2] = sh[14][2] * t3;
  result[15][0] = sh[15][0] * t3;
  result[15][1] = sh[15][1] * t3;
  result[15][2] = sh[15][2] * t3;
}
#endif

#ifndef ZONAL_CONVOLVE_COLOUR_5
#define ZONAL_CONVOLVE_COLOUR_5
// Convolution with a zonal kernel. For colours.
// 80 operations: 0 additions, 80 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_convolve_colour_5(const float (&sh)[25][3], const float (&kernel)[5],
    float (&result)[25][3]) {
  const float t0 = 3.5449078f * kernel[0];
  result[0][0] = sh[0][0] * t0;
  result[0][1] = sh[0][1] * t0;
  result[0][2] = sh[0][2] * t0;
  const float t1 = 2.0466535f * kernel[1];
  result[1][0] = sh[1][0] * t1;
  result[1][1] = sh[1][1] * t1;
  result[1][2] = sh[1][2] * t1;
  result[2][0] = sh[2][0] * t1;
  result[2][1] = sh[2][1] * t1;
  result[2][2] = sh[2][2] * t1;
  result[3][0] = sh[3][0] * t1;
  result[3][1] = sh[3][1] * t1;
  result[3][2] = sh[3][2] * t1;
  const float t2 = 1.585331f * kernel[2];
  result[4][0] = sh[4][0] * t2;
  result[4][1] = sh[4][1] * t2;
  result[4][2] = sh[4][2] * t2;
  result[5][0] = sh[5][0] * t2;
  result[5][1] = sh[5][1] * t2;
  result[5][2] = sh[5][2] * t2;
  result[6][0] = sh[6][0] * t2;
  result[6][1] = sh[6][1] * t2;
  result[6][2] = sh[6][2] * t2;
  result[7][0] = sh[7][0] * t2;
  result[7][1] = sh[7][1] * t2;
  result[7][2] = sh[7][2] * t2;
  result[8][0] = sh[8][0] * t2;
  result[8][1] = sh[8][1] * t2;
  result[8][2] = sh[8][2] * t2;
  const float t3 = 1.3398491f * kernel[3];
  result[9][0] = sh[9][0] * t3;
  result[9][1] = sh[9][1] * t3;
  result[9][2] = sh[9][2] * t3;
  result[10][0] = sh[10][0] * t3;
  result[10][1] = sh[10][1] * t3;
  result[10][2] = sh[10][2] * t3;
  result[11][0] = sh[11][0] * t3;
  result[11][1] = sh[11][1] * t3;
  result[11][2] = sh[11][2] * t3;
  result[12][0] = sh[12][0] * t3;
  result[12][1] = sh[12][1] * t3;
  result[12][2] = sh[12][2] * t3;
  result[13][0] = sh[13][0] * t3;
  result[13][1] = sh[13][1] * t3;
  result[13][2] = sh[13][2] * t3;
  result[14][0] = sh[14][0] * t3;
  result[14][1] = sh[14][1] * t3;
  result[14][2] = sh[14][2] * t3;
  result[15][0] = sh[15][0] * t3;
  result[15][1] = sh[15][1] * t3;
  result[15][2] = sh[15][2] * t3;
  const float t4 = 1.1816359f * kernel[4];
  result[16][0] = sh[16][0] * t4;
  result[16][1] = sh[16][1] * t4;
  result[16][2] = sh[16][2] * t4;
  result[17][0] = sh[17][0] * t4;
  result[17][1] = sh[17][1] * t4;
  result[17][2] = sh[17][2] * t4;
  result[18][0] = sh[18][0] * t4;
  result[18][1] = sh[18][1] * t4;
  result[18][2] = sh[18][2] * t4;
  result[19][0] = sh[19][0] * t4;
  result[19][1] = sh[19][1] * t4;
  result[19][2] = sh[19][2] * t4;
  result[20][0] = sh[20][0] * t4;
  result[20][1] = sh[20][1] * t4;
  result[20][2] = sh[20][2] * t4;
  result[21][0] = sh[21][0] * t4;
  result[21][1] = sh[21][1] * t4;
  result[21][2] = sh[21][2] * t4;
  result[22][0] = sh[22][0] * t4;
  result[22][1] = sh[22][1] * t4;
  result[22][2] = sh[22][2] * t4;
  result[23][0] = sh[23][0] * t4;
  result[23][1] = sh[23][1] * t4;
  result[23][2] = sh[23][2] * t4;
  result[24][0] = sh[24][0] * t4;
  result[24][1] = sh[24][1] * t4;
  result[24][2] = sh[24][2] * t4;
}
#endif

#ifndef ZONAL_LAMBERT_2
#define ZONAL_LAMBERT_2
// Zonal coefficients of the clamped cosine over pi.
// 0 operations: 0 additions, 0 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_lambert_2(float (&z)[2]) {
  z[0] = 0.2820948f;
  z[1] = 0.325735f;
}
#endif

#ifndef ZONAL_LAMBERT_3
#define ZONAL_LAMBERT_3
// Zonal coefficients of the clamped cosine over pi.
// 0 operations: 0 additions, 0 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_lambert_3(float (&z)[3]) {
  z[0] = 0.2820948f;
  z[1] = 0.325735f;
  z[2] = 0.15769579f;
}
#endif

#ifndef ZONAL_LAMBERT_4
#define ZONAL_LAMBERT_4
// Zonal coefficients of the clamped cosine over pi.
// 0 operations: 0 additions, 0 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_lambert_4(float (&z)[4]) {
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
ZONAL_FUNCTION void zonal_lambert_5(float (&z)[5]) {
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
ZONAL_FUNCTION void zonal_cap_2(const float (&cap)[2], float (&z)[2]) {
  const float t0 = fabsf(cap[0]);
  const float t1 = cap[1] * cap[1];
  const float t2 = 1.0f + t0;
  const float t3 = 0.88622695f * (2.0f * (0.0f < cap[0] ? (t0 < 0.5f ? 1.0f - t0 : t1 / t2) : t2));
  z[0] = t3;
  z[1] = 1.5349901f * t1;
}
#endif

#ifndef ZONAL_CAP_3
#define ZONAL_CAP_3
// Zonal coefficients of a spherical cap, by cosine and sine of its half angle.
// 22 operations: 6 additions, 7 multiplications, 1 divisions, 0 square roots, 8 comparisons and choices.
ZONAL_FUNCTION void zonal_cap_3(const float (&cap)[2], float (&z)[3]) {
  const bool is_0 = 0.0f < cap[0];
  const float t1 = fabsf(cap[0]);
  const float t2 = cap[1] * cap[1];
  const float t3 = 1.0f + t1;
  const float t4 = t1 < 0.5f ? 1.0f - t1 : t2 / t3;
  z[0] = 0.88622695f * (2.0f * (is_0 ? t4 : t3));
  z[1] = 1.5349901f * t2;
  const float t5 = 0.33333334f < t1 ? t2 : 0.0f;
  z[2] = 1.9816637f * ((is_0 ? 1.0f : -1.0f) * (t5 + (t2 - t5 + -(t4 * t2))));
}
#endif

#ifndef ZONAL_CAP_4
#define ZONAL_CAP_4
// Zonal coefficients of a spherical cap, by cosine and sine of its half angle.
// 29 operations: 9 additions, 11 multiplications, 1 divisions, 0 square roots, 8 comparisons and choices.
ZONAL_FUNCTION void zonal_cap_4(const float (&cap)[2], float (&z)[4]) {
  const bool is_0 = 0.0f < cap[0];
  const float t1 = fabsf(cap[0]);
  const float t2 = cap[1] * cap[1];
  const float t3 = 1.0f + t1;
  const float t4 = t1 < 0.5f ? 1.0f - t1 : t2 / t3;
  z[0] = 0.88622695f * (2.0f * (is_0 ? t4 : t3));
  z[1] = 1.5349901f * t2;
  const float t5 = 0.625f < t1 ? t2 : 0.0f;
  const float t6 = -(t4 * t2);
  const float t7 = t2 - t5 + t6;
  const float t8 = t5 + t7;
  z[2] = 1.9816637f * ((is_0 ? 1.0f : -1.0f) * t8);
  z[3] = 2.344736f * (t5 + (t7 + (0.25f * t6 - 1.25f * (t4 * t8))));
}
#endif

#ifndef ZONAL_CAP_5
#define ZONAL_CAP_5
// Zonal coefficients of a spherical cap, by cosine and sine of its half angle.
// 37 operations: 12 additions, 16 multiplications, 1 divisions, 0 square roots, 8 comparisons and choices.
ZONAL_FUNCTION void zonal_cap_5(const float (&cap)[2], float (&z)[5]) {
  const bool is_0 = 0.0f < cap[0];
  const float t1 = fabsf(cap[0]);
  const float t2 = cap[1] * cap[1];
  const float t3 = 1.0f + t1;
  const float t4 = t1 < 0.5f ? 1.0f - t1 : t2 / t3;
  z[0] = 0.88622695f * (2.0f * (is_0 ? t4 : t3));
  z[1] = 1.5349901f * t2;
  const float t5 = is_0 ? 1.0f : -1.0f;
  const float t6 = 0.76f < t1 ? t2 : 0.0f;
  const float t7 = -(t4 * t2);
  const float t8 = t2 - t6 + t7;
  const float t9 = t6 + t8;
  z[2] = 1.9816637f * (t5 * t9);
  const float t10 = 0.25f * t7 - 1.25f * (t4 * t9);
  const float t11 = t8 + t10;
  const float t12 = t6 + t11;
  z[3] = 2.344736f * t12;
  z[4] = 2.6586807f * (t5 * (t6 + (t11 + (0.4f * t10 - 1.4f * (t4 * t12)))));
}
#endif

#ifndef ZONAL_CAP_UP_TO_HEMISPHERE_2
#define ZONAL_CAP_UP_TO_HEMISPHERE_2
// The same up to the hemisphere, in fewer operations.
// 6 operations: 2 additions, 3 multiplications, 1 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_cap_up_to_hemisphere_2(const float (&cap)[2], float (&z)[2]) {
  const float t0 = cap[1] * cap[1];
  const float t1 = t0 / (1.0f + cap[0]);
  z[0] = 0.88622695f * (t1 + t1);
  z[1] = 1.5349901f * t0;
}
#endif

#ifndef ZONAL_CAP_UP_TO_HEMISPHERE_3
#define ZONAL_CAP_UP_TO_HEMISPHERE_3
// The same up to the hemisphere, in fewer operations.
// 10 operations: 4 additions, 5 multiplications, 1 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_cap_up_to_hemisphere_3(const float (&cap)[2], float (&z)[3]) {
  const float t0 = cap[1] * cap[1];
  const float t1 = t0 / (1.0f + cap[0]);
  z[0] = 0.88622695f * (t1 + t1);
  z[1] = 1.5349901f * t0;
  z[2] = 1.9816637f * (t0 + -(t1 * t0));
}
#endif

#ifndef ZONAL_CAP_UP_TO_HEMISPHERE_4
#define ZONAL_CAP_UP_TO_HEMISPHERE_4
// The same up to the hemisphere, in fewer operations.
// 16 operations: 6 additions, 9 multiplications, 1 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_cap_up_to_hemisphere_4(const float (&cap)[2], float (&z)[4]) {
  const float t0 = cap[1] * cap[1];
  const float t1 = t0 / (1.0f + cap[0]);
  z[0] = 0.88622695f * (t1 + t1);
  z[1] = 1.5349901f * t0;
  const float t2 = -(t1 * t0);
  const float t3 = t0 + t2;
  z[2] = 1.9816637f * t3;
  z[3] = 2.344736f * (t3 + (0.25f * t2 - 1.25f * (t1 * t3)));
}
#endif

#ifndef ZONAL_CAP_UP_TO_HEMISPHERE_5
#define ZONAL_CAP_UP_TO_HEMISPHERE_5
// The same up to the hemisphere, in fewer operations.
// 22 operations: 8 additions, 13 multiplications, 1 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_cap_up_to_hemisphere_5(const float (&cap)[2], float (&z)[5]) {
  const float t0 = cap[1] * cap[1];
  const float t1 = t0 / (1.0f + cap[0]);
  z[0] = 0.88622695f * (t1 + t1);
  z[1] = 1.5349901f * t0;
  const float t2 = -(t1 * t0);
  const float t3 = t0 + t2;
  z[2] = 1.9816637f * t3;
  const float t4 = 0.25f * t2 - 1.25f * (t1 * t3);
  const float t5 = t3 + t4;
  z[3] = 2.344736f * t5;
  z[4] = 2.6586807f * (t5 + (0.4f * t4 - 1.4f * (t1 * t5)));
}
#endif

#ifndef ZONAL_SPHERE_CAP_2
#define ZONAL_SPHERE_CAP_2
// Zonal coefficients of the cap that a sphere covers, seen from a distance.
// 15 operations: 4 additions, 6 multiplications, 2 divisions, 1 square roots, 2 comparisons and choices.
ZONAL_FUNCTION void zonal_sphere_cap_2(float distance, float radius, float (&z)[2]) {
  const float t0 = 1.0f / distance;
  const float t1 = radius * t0;
  const float t2 = 1.0f < t1 ? 1.0f : t1;
  const float t3 = t2 * t2;
  const float t4 = distance - radius;
  const float t5 = t3 / (1.0f + sqrtf((t4 < 0.0f ? 0.0f : t4) * t0 * (1.0f + t2)));
  z[0] = 0.88622695f * (t5 + t5);
  z[1] = 1.5349901f * t3;
}
#endif

#ifndef ZONAL_SPHERE_CAP_3
#define ZONAL_SPHERE_CAP_3
// Zonal coefficients of the cap that a sphere covers, seen from a distance.
// 19 operations: 6 additions, 8 multiplications, 2 divisions, 1 square roots, 2 comparisons and choices.
ZONAL_FUNCTION void zonal_sphere_cap_3(float distance, float radius, float (&z)[3]) {
  const float t0 = 1.0f / distance;
  const float t1 = radius * t0;
  const float t2 = 1.0f < t1 ? 1.0f : t1;
  const float t3 = t2 * t2;
  const float t4 = distance - radius;
  const float t5 = t3 / (1.0f + sqrtf((t4 < 0.0f ? 0.0f : t4) * t0 * (1.0f + t2)));
  z[0] = 0.88622695f * (t5 + t5);
  z[1] = 1.5349901f * t3;
  z[2] = 1.9816637f * (t3 + -(t5 * t3));
}
#endif

#ifndef ZONAL_SPHERE_CAP_4
#define ZONAL_SPHERE_CAP_4
// Zonal coefficients of the cap that a sphere covers, seen from a distance.
// 25 operations: 8 additions, 12 multiplications, 2 divisions, 1 square roots, 2 comparisons and choices.
ZONAL_FUNCTION void zonal_sphere_cap_4(float distance, float radius, float (&z)[4]) {
  const float t0 = 1.0f / distance;
  const float t1 = radius * t0;
  const float t2 = 1.0f < t1 ? 1.0f : t1;
  const float t3 = t2 * t2;
  const float t4 = distance - radius;
  const float t5 = t3 / (1.0f + sqrtf((t4 < 0.0f ? 0.0f : t4) * t0 * (1.0f + t2)));
  z[0] = 0.88622695f * (t5 + t5);
  z[1] = 1.5349901f * t3;
  const float t6 = -(t5 * t3);
  const float t7 = t3 + t6;
  z[2] = 1.9816637f * t7;
  z[3] = 2.344736f * (t7 + (0.25f * t6 - 1.25f * (t5 * t7)));
}
#endif

#ifndef ZONAL_SPHERE_CAP_5
#define ZONAL_SPHERE_CAP_5
// Zonal coefficients of the cap that a sphere covers, seen from a distance.
// 31 operations: 10 additions, 16 multiplications, 2 divisions, 1 square roots, 2 comparisons and choices.
ZONAL_FUNCTION void zonal_sphere_cap_5(float distance, float radius, float (&z)[5]) {
  const float t0 = 1.0f / distance;
  const float t1 = radius * t0;
  const float t2 = 1.0f < t1 ? 1.0f : t1;
  const float t3 = t2 * t2;
  const float t4 = distance - radius;
  const float t5 = t3 / (1.0f + sqrtf((t4 < 0.0f ? 0.0f : t4) * t0 * (1.0f + t2)));
  z[0] = 0.88622695f * (t5 + t5);
  z[1] = 1.5349901f * t3;
  const float t6 = -(t5 * t3);
  const float t7 = t3 + t6;
  z[2] = 1.9816637f * t7;
  const float t8 = 0.25f * t6 - 1.25f * (t5 * t7);
  const float t9 = t7 + t8;
  z[3] = 2.344736f * t9;
  z[4] = 2.6586807f * (t9 + (0.4f * t8 - 1.4f * (t5 * t9)));
}
#endif

#ifndef ZONAL_PHONG_2
#define ZONAL_PHONG_2
// Zonal coefficients of the cosine power that integrates to 1.
// 4 operations: 2 additions, 1 multiplications, 1 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_phong_2(float exponent, float (&z)[2]) {
  z[0] = 0.2820948f;
  z[1] = 0.48860252f * ((exponent + 1.0f) / (exponent + 2.0f));
}
#endif

#ifndef ZONAL_PHONG_3
#define ZONAL_PHONG_3
// Zonal coefficients of the cosine power that integrates to 1.
// 7 operations: 3 additions, 2 multiplications, 2 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_phong_3(float exponent, float (&z)[3]) {
  z[0] = 0.2820948f;
  z[1] = 0.48860252f * ((exponent + 1.0f) / (exponent + 2.0f));
  z[2] = 0.63078314f * (exponent / (exponent + 3.0f));
}
#endif

#ifndef ZONAL_PHONG_4
#define ZONAL_PHONG_4
// Zonal coefficients of the cosine power that integrates to 1.
// 12 operations: 5 additions, 4 multiplications, 3 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_phong_4(float exponent, float (&z)[4]) {
  z[0] = 0.2820948f;
  const float t0 = (exponent + 1.0f) / (exponent + 2.0f);
  z[1] = 0.48860252f * t0;
  z[2] = 0.63078314f * (exponent / (exponent + 3.0f));
  z[3] = 0.7463527f * (t0 * ((exponent - 1.0f) / (exponent + 4.0f)));
}
#endif

#ifndef ZONAL_PHONG_5
#define ZONAL_PHONG_5
// Zonal coefficients of the cosine power that integrates to 1.
// 17 operations: 7 additions, 6 multiplications, 4 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_phong_5(float exponent, float (&z)[5]) {
  z[0] = 0.2820948f;
  const float t0 = (exponent + 1.0f) / (exponent + 2.0f);
  z[1] = 0.48860252f * t0;
  const float t1 = exponent / (exponent + 3.0f);
  z[2] = 0.63078314f * t1;
  z[3] = 0.7463527f * (t0 * ((exponent - 1.0f) / (exponent + 4.0f)));
  z[4] = 0.8462844f * (t1 * ((exponent - 2.0f) / (exponent + 5.0f)));
}
#endif

#ifndef ZONAL_SPHERICAL_GAUSSIAN_2
#define ZONAL_SPHERICAL_GAUSSIAN_2
// Zonal coefficients of exp(sharpness (cos theta - 1)).
// 162 operations: 52 additions, 52 multiplications, 20 divisions, 1 square roots, 37 comparisons and choices.
ZONAL_FUNCTION void zonal_spherical_gaussian_2(float sharpness, float (&z)[2]) {
  const float t0 = sharpness / (16.0f + sqrtf(272.0f + sharpness * sharpness));
  const float t1 = sharpness / (31.0f + sharpness * t0);
  const float t2 = sharpness / (29.0f + sharpness * t1);
  const float t3 = sharpness / (27.0f + sharpness * t2);
  const float t4 = sharpness / (25.0f + sharpness * t3);
  const float t5 = sharpness / (23.0f + sharpness * t4);
  const float t6 = sharpness / (21.0f + sharpness * t5);
  const float t7 = sharpness / (19.0f + sharpness * t6);
  const float t8 = sharpness / (17.0f + sharpness * t7);
  const float t9 = sharpness / (15.0f + sharpness * t8);
  const float t10 = sharpness / (13.0f + sharpness * t9);
  const float t11 = sharpness / (11.0f + sharpness * t10);
  const float t12 = sharpness / (9.0f + sharpness * t11);
  const float t13 = sharpness / (7.0f + sharpness * t12);
  const float t14 = sharpness / (5.0f + sharpness * t13);
  const float t15 = sharpness / (3.0f + sharpness * t14);
  const float t16 = 23.0f + t4 * (25.0f + t3 * (27.0f + t2 * (29.0f + t1 * (31.0f + t0 * 33.0f))));
  const float t17 = 13.0f + t9 * (15.0f + t8 * (17.0f + t7 * (19.0f + t6 * (21.0f + t5 * t16))));
  const float t18 = 3.0f + t14 * (5.0f + t13 * (7.0f + t12 * (9.0f + t11 * (11.0f + t10 * t17))));
  const float t19 = sharpness < 1.0f ? 1.0f : sharpness;
  const float t20 = -2.0f * t19;
  const float t21 = fabsf(t20);
  const float t22 = 105.35837f < t21 ? 105.35837f : t21;
  const bool is_23 = 64.0f <= t22;
  const bool is_24 = t20 < 0.0f;
  const float t25 = is_23 ? t22 - 64.0f : t22;
  const bool is_26 = 32.0f <= t25;
  const float t27 = is_26 ? t25 - 32.0f : t25;
  const bool is_28 = 16.0f <= t27;
  const float t29 = is_28 ? t27 - 16.0f : t27;
  const bool is_30 = 8.0f <= t29;
  const float t31 = is_30 ? t29 - 8.0f : t29;
  const bool is_32 = 4.0f <= t31;
  const float t33 = is_32 ? t31 - 4.0f : t31;
  const bool is_34 = 2.0f <= t33;
  const float t35 = is_34 ? t33 - 2.0f : t33;
  const bool is_36 = 1.0f <= t35;
  const float t37 = is_36 ? t35 - 1.0f : t35;
  const bool is_38 = 0.5f <= t37;
  const float t39 = is_38 ? t37 - 0.5f : t37;
  const bool is_40 = 0.25f <= t39;
  const float t41 = is_26 ? 1.2664166e-14f : 1.0f;
  const float t42 = is_28 ? t41 * 1.12535176e-07f : t41;
  const float t43 = is_30 ? t42 * 0.00033546262f : t42;
  const float t44 = is_32 ? t43 * 0.01831564f : t43;
  const float t45 = is_34 ? t44 * 0.13533528f : t44;
  const float t46 = is_36 ? t45 * 0.36787945f : t45;
  const float t47 = is_38 ? t46 * 0.60653067f : t46;
  const float t48 = is_40 ? t39 - 0.25f : t39;
  const float t49 = 0.16666667f - t48 * (0.041666668f - t48 * (0.008333334f - t48 * 0.0013888889f));
  const float t50 = (is_40 ? t47 * 0.7788008f : t47) * (1.0f - t48 * (1.0f - t48 * (0.5f - t48 * t49)));
  const float t51 = is_24 ? t50 : 1.0f / t50;
  const float t52 = is_23 ? t51 * (is_24 ? 1.6038109e-28f : 6.235149e+27f) : t51;
  const float t53 = sharpness < 1.0f ? 1.0f / (1.0f + t15 * t18) : (1.0f - t52) / (t19 + t19);
  z[0] = 3.5449078f * t53;
  const float t54 = 6.1399603f * (2.0f < sharpness ? ((1.0f + t52) * 0.5f - t53) / t19 : t53 * t15);
  z[1] = t54;
}
#endif

#ifndef ZONAL_SPHERICAL_GAUSSIAN_3
#define ZONAL_SPHERICAL_GAUSSIAN_3
// Zonal coefficients of exp(sharpness (cos theta - 1)).
// 188 operations: 61 additions, 63 multiplications, 25 divisions, 1 square roots, 38 comparisons and choices.
ZONAL_FUNCTION void zonal_spherical_gaussian_3(float sharpness, float (&z)[3]) {
  const float t0 = sharpness / (20.0f + sqrtf(420.0f + sharpness * sharpness));
  const float t1 = sharpness / (39.0f + sharpness * t0);
  const float t2 = sharpness / (37.0f + sharpness * t1);
  const float t3 = sharpness / (35.0f + sharpness * t2);
  const float t4 = sharpness / (33.0f + sharpness * t3);
  const float t5 = sharpness / (31.0f + sharpness * t4);
  const float t6 = sharpness / (29.0f + sharpness * t5);
  const float t7 = sharpness / (27.0f + sharpness * t6);
  const float t8 = sharpness / (25.0f + sharpness * t7);
  const float t9 = sharpness / (23.0f + sharpness * t8);
  const float t10 = sharpness / (21.0f + sharpness * t9);
  const float t11 = sharpness / (19.0f + sharpness * t10);
  const float t12 = sharpness / (17.0f + sharpness * t11);
  const float t13 = sharpness / (15.0f + sharpness * t12);
  const float t14 = sharpness / (13.0f + sharpness * t13);
  const float t15 = sharpness / (11.0f + sharpness * t14);
  const float t16 = sharpness / (9.0f + sharpness * t15);
  const float t17 = sharpness / (7.0f + sharpness * t16);
  const float t18 = sharpness / (5.0f + sharpness * t17);
  const float t19 = sharpness / (3.0f + sharpness * t18);
  const float t20 = 31.0f + t4 * (33.0f + t3 * (35.0f + t2 * (37.0f + t1 * (39.0f + t0 * 41.0f))));
  const float t21 = 21.0f + t9 * (23.0f + t8 * (25.0f + t7 * (27.0f + t6 * (29.0f + t5 * t20))));
  const float t22 = t14 * (13.0f + t13 * (15.0f + t12 * (17.0f + t11 * (19.0f + t10 * t21))));
  const float t23 = t19 * (3.0f + t18 * (5.0f + t17 * (7.0f + t16 * (9.0f + t15 * (11.0f + t22)))));
  const float t24 = sharpness < 1.0f ? 1.0f : sharpness;
  const float t25 = -2.0f * t24;
  const float t26 = fabsf(t25);
  const float t27 = 105.35837f < t26 ? 105.35837f : t26;
  const bool is_28 = 64.0f <= t27;
  const bool is_29 = t25 < 0.0f;
  const float t30 = is_28 ? t27 - 64.0f : t27;
  const bool is_31 = 32.0f <= t30;
  const float t32 = is_31 ? t30 - 32.0f : t30;
  const bool is_33 = 16.0f <= t32;
  const float t34 = is_33 ? t32 - 16.0f : t32;
  const bool is_35 = 8.0f <= t34;
  const float t36 = is_35 ? t34 - 8.0f : t34;
  const bool is_37 = 4.0f <= t36;
  const float t38 = is_37 ? t36 - 4.0f : t36;
  const bool is_39 = 2.0f <= t38;
  const float t40 = is_39 ? t38 - 2.0f : t38;
  const bool is_41 = 1.0f <= t40;
  const float t42 = is_41 ? t40 - 1.0f : t40;
  const bool is_43 = 0.5f <= t42;
  const float t44 = is_43 ? t42 - 0.5f : t42;
  const bool is_45 = 0.25f <= t44;
  const float t46 = is_31 ? 1.2664166e-14f : 1.0f;
  const float t47 = is_33 ? t46 * 1.12535176e-07f : t46;
  const float t48 = is_35 ? t47 * 0.00033546262f : t47;
  const float t49 = is_37 ? t48 * 0.01831564f : t48;
  const float t50 = is_39 ? t49 * 0.13533528f : t49;
  const float t51 = is_41 ? t50 * 0.36787945f : t50;
  const float t52 = is_43 ? t51 * 0.60653067f : t51;
  const float t53 = is_45 ? t44 - 0.25f : t44;
  const float t54 = 0.16666667f - t53 * (0.041666668f - t53 * (0.008333334f - t53 * 0.0013888889f));
  const float t55 = (is_45 ? t52 * 0.7788008f : t52) * (1.0f - t53 * (1.0f - t53 * (0.5f - t53 * t54)));
  const float t56 = is_29 ? t55 : 1.0f / t55;
  const float t57 = is_28 ? t56 * (is_29 ? 1.6038109e-28f : 6.235149e+27f) : t56;
  const float t58 = sharpness < 1.0f ? 1.0f / (1.0f + t23) : (1.0f - t57) / (t24 + t24);
  z[0] = 3.5449078f * t58;
  const bool is_59 = 4.5f < sharpness;
  const float t60 = ((1.0f + t57) * 0.5f - t58) / t24;
  const float t61 = t58 * t19;
  z[1] = 6.1399603f * (is_59 ? t60 : t61);
  z[2] = 7.926655f * (is_59 ? t58 - 3.0f / t24 * t60 : t61 * t18);
}
#endif

#ifndef ZONAL_SPHERICAL_GAUSSIAN_4
#define ZONAL_SPHERICAL_GAUSSIAN_4
// Zonal coefficients of exp(sharpness (cos theta - 1)).
// 214 operations: 70 additions, 74 multiplications, 30 divisions, 1 square roots, 39 comparisons and choices.
ZONAL_FUNCTION void zonal_spherical_gaussian_4(float sharpness, float (&z)[4]) {
  const float t0 = sharpness / (24.0f + sqrtf(600.0f + sharpness * sharpness));
  const float t1 = sharpness / (47.0f + sharpness * t0);
  const float t2 = sharpness / (45.0f + sharpness * t1);
  const float t3 = sharpness / (43.0f + sharpness * t2);
  const float t4 = sharpness / (41.0f + sharpness * t3);
  const float t5 = sharpness / (39.0f + sharpness * t4);
  const float t6 = sharpness / (37.0f + sharpness * t5);
  const float t7 = sharpness / (35.0f + sharpness * t6);
  const float t8 = sharpness / (33.0f + sharpness * t7);
  const float t9 = sharpness / (31.0f + sharpness * t8);
  const float t10 = sharpness / (29.0f + sharpness * t9);
  const float t11 = sharpness / (27.0f + sharpness * t10);
  const float t12 = sharpness / (25.0f + sharpness * t11);
  const float t13 = sharpness / (23.0f + sharpness * t12);
  const float t14 = sharpness / (21.0f + sharpness * t13);
  const float t15 = sharpness / (19.0f + sharpness * t14);
  const float t16 = sharpness / (17.0f + sharpness * t15);
  const float t17 = sharpness / (15.0f + sharpness * t16);
  const float t18 = sharpness / (13.0f + sharpness * t17);
  const float t19 = sharpness / (11.0f + sharpness * t18);
  const float t20 = sharpness / (9.0f + sharpness * t19);
  const float t21 = sharpness / (7.0f + sharpness * t20);
  const float t22 = sharpness / (5.0f + sharpness * t21);
  const float t23 = sharpness / (3.0f + sharpness * t22);
  const float t24 = 39.0f + t4 * (41.0f + t3 * (43.0f + t2 * (45.0f + t1 * (47.0f + t0 * 49.0f))));
  const float t25 = 29.0f + t9 * (31.0f + t8 * (33.0f + t7 * (35.0f + t6 * (37.0f + t5 * t24))));
  const float t26 = t14 * (21.0f + t13 * (23.0f + t12 * (25.0f + t11 * (27.0f + t10 * t25))));
  const float t27 = 11.0f + t18 * (13.0f + t17 * (15.0f + t16 * (17.0f + t15 * (19.0f + t26))));
  const float t28 = 1.0f + t23 * (3.0f + t22 * (5.0f + t21 * (7.0f + t20 * (9.0f + t19 * t27))));
  const float t29 = sharpness < 1.0f ? 1.0f : sharpness;
  const float t30 = -2.0f * t29;
  const float t31 = fabsf(t30);
  const float t32 = 105.35837f < t31 ? 105.35837f : t31;
  const bool is_33 = 64.0f <= t32;
  const bool is_34 = t30 < 0.0f;
  const float t35 = is_33 ? t32 - 64.0f : t32;
  const bool is_36 = 32.0f <= t35;
  const float t37 = is_36 ? t35 - 32.0f : t35;
  const bool is_38 = 16.0f <= t37;
  const float t39 = is_38 ? t37 - 16.0f : t37;
  const bool is_40 = 8.0f <= t39;
  const float t41 = is_40 ? t39 - 8.0f : t39;
  const bool is_42 = 4.0f <= t41;
  const float t43 = is_42 ? t41 - 4.0f : t41;
  const bool is_44 = 2.0f <= t43;
  const float t45 = is_44 ? t43 - 2.0f : t43;
  const bool is_46 = 1.0f <= t45;
  const float t47 = is_46 ? t45 - 1.0f : t45;
  const bool is_48 = 0.5f <= t47;
  const float t49 = is_48 ? t47 - 0.5f : t47;
  const bool is_50 = 0.25f <= t49;
  const float t51 = is_36 ? 1.2664166e-14f : 1.0f;
  const float t52 = is_38 ? t51 * 1.12535176e-07f : t51;
  const float t53 = is_40 ? t52 * 0.00033546262f : t52;
  const float t54 = is_42 ? t53 * 0.01831564f : t53;
  const float t55 = is_44 ? t54 * 0.13533528f : t54;
  const float t56 = is_46 ? t55 * 0.36787945f : t55;
  const float t57 = is_48 ? t56 * 0.60653067f : t56;
  const float t58 = is_50 ? t49 - 0.25f : t49;
  const float t59 = 0.16666667f - t58 * (0.041666668f - t58 * (0.008333334f - t58 * 0.0013888889f));
  const float t60 = (is_50 ? t57 * 0.7788008f : t57) * (1.0f - t58 * (1.0f - t58 * (0.5f - t58 * t59)));
  const float t61 = is_34 ? t60 : 1.0f / t60;
  const float t62 = is_33 ? t61 * (is_34 ? 1.6038109e-28f : 6.235149e+27f) : t61;
  const float t63 = sharpness < 1.0f ? 1.0f / t28 : (1.0f - t62) / (t29 + t29);
  z[0] = 3.5449078f * t63;
  const bool is_64 = 8.0f < sharpness;
  const float t65 = ((1.0f + t62) * 0.5f - t63) / t29;
  const float t66 = t63 * t23;
  z[1] = 6.1399603f * (is_64 ? t65 : t66);
  const float t67 = t63 - 3.0f / t29 * t65;
  const float t68 = t66 * t22;
  z[2] = 7.926655f * (is_64 ? t67 : t68);
  z[3] = 9.378944f * (is_64 ? t65 - 5.0f / t29 * t67 : t68 * t21);
}
#endif

#ifndef ZONAL_SPHERICAL_GAUSSIAN_5
#define ZONAL_SPHERICAL_GAUSSIAN_5
// Zonal coefficients of exp(sharpness (cos theta - 1)).
// 240 operations: 79 additions, 85 multiplications, 35 divisions, 1 square roots, 40 comparisons and choices.
ZONAL_FUNCTION void zonal_spherical_gaussian_5(float sharpness, float (&z)[5]) {
  const float t0 = sharpness / (28.0f + sqrtf(812.0f + sharpness * sharpness));
  const float t1 = sharpness / (55.0f + sharpness * t0);
  const float t2 = sharpness / (53.0f + sharpness * t1);
  const float t3 = sharpness / (51.0f + sharpness * t2);
  const float t4 = sharpness / (49.0f + sharpness * t3);
  const float t5 = sharpness / (47.0f + sharpness * t4);
  const float t6 = sharpness / (45.0f + sharpness * t5);
  const float t7 = sharpness / (43.0f + sharpness * t6);
  const float t8 = sharpness / (41.0f + sharpness * t7);
  const float t9 = sharpness / (39.0f + sharpness * t8);
  const float t10 = sharpness / (37.0f + sharpness * t9);
  const float t11 = sharpness / (35.0f + sharpness * t10);
  const float t12 = sharpness / (33.0f + sharpness * t11);
  const float t13 = sharpness / (31.0f + sharpness * t12);
  const float t14 = sharpness / (29.0f + sharpness * t13);
  const float t15 = sharpness / (27.0f + sharpness * t14);
  const float t16 = sharpness / (25.0f + sharpness * t15);
  const float t17 = sharpness / (23.0f + sharpness * t16);
  const float t18 = sharpness / (21.0f + sharpness * t17);
  const float t19 = sharpness / (19.0f + sharpness * t18);
  const float t20 = sharpness / (17.0f + sharpness * t19);
  const float t21 = sharpness / (15.0f + sharpness * t20);
  const float t22 = sharpness / (13.0f + sharpness * t21);
  const float t23 = sharpness / (11.0f + sharpness * t22);
  const float t24 = sharpness / (9.0f + sharpness * t23);
  const float t25 = sharpness / (7.0f + sharpness * t24);
  const float t26 = sharpness / (5.0f + sharpness * t25);
  const float t27 = sharpness / (3.0f + sharpness * t26);
  const float t28 = 47.0f + t4 * (49.0f + t3 * (51.0f + t2 * (53.0f + t1 * (55.0f + t0 * 57.0f))));
  const float t29 = 37.0f + t9 * (39.0f + t8 * (41.0f + t7 * (43.0f + t6 * (45.0f + t5 * t28))));
  const float t30 = t14 * (29.0f + t13 * (31.0f + t12 * (33.0f + t11 * (35.0f + t10 * t29))));
  const float t31 = 19.0f + t18 * (21.0f + t17 * (23.0f + t16 * (25.0f + t15 * (27.0f + t30))));
  const float t32 = t23 * (11.0f + t22 * (13.0f + t21 * (15.0f + t20 * (17.0f + t19 * t31))));
  const float t33 = 1.0f / (1.0f + t27 * (3.0f + t26 * (5.0f + t25 * (7.0f + t24 * (9.0f + t32)))));
  const float t34 = sharpness < 1.0f ? 1.0f : sharpness;
  const float t35 = -2.0f * t34;
  const float t36 = fabsf(t35);
  const float t37 = 105.35837f < t36 ? 105.35837f : t36;
  const bool is_38 = 64.0f <= t37;
  const bool is_39 = t35 < 0.0f;
  const float t40 = is_38 ? t37 - 64.0f : t37;
  const bool is_41 = 32.0f <= t40;
  const float t42 = is_41 ? t40 - 32.0f : t40;
  const bool is_43 = 16.0f <= t42;
  const float t44 = is_43 ? t42 - 16.0f : t42;
  const bool is_45 = 8.0f <= t44;
  const float t46 = is_45 ? t44 - 8.0f : t44;
  const bool is_47 = 4.0f <= t46;
  const float t48 = is_47 ? t46 - 4.0f : t46;
  const bool is_49 = 2.0f <= t48;
  const float t50 = is_49 ? t48 - 2.0f : t48;
  const bool is_51 = 1.0f <= t50;
  const float t52 = is_51 ? t50 - 1.0f : t50;
  const bool is_53 = 0.5f <= t52;
  const float t54 = is_53 ? t52 - 0.5f : t52;
  const bool is_55 = 0.25f <= t54;
  const float t56 = is_41 ? 1.2664166e-14f : 1.0f;
  const float t57 = is_43 ? t56 * 1.12535176e-07f : t56;
  const float t58 = is_45 ? t57 * 0.00033546262f : t57;
  const float t59 = is_47 ? t58 * 0.01831564f : t58;
  const float t60 = is_49 ? t59 * 0.13533528f : t59;
  const float t61 = is_51 ? t60 * 0.36787945f : t60;
  const float t62 = is_53 ? t61 * 0.60653067f : t61;
  const float t63 = is_55 ? t54 - 0.25f : t54;
  const float t64 = 0.16666667f - t63 * (0.041666668f - t63 * (0.008333334f - t63 * 0.0013888889f));
  const float t65 = (is_55 ? t62 * 0.7788008f : t62) * (1.0f - t63 * (1.0f - t63 * (0.5f - t63 * t64)));
  const float t66 = is_39 ? t65 : 1.0f / t65;
  const float t67 = is_38 ? t66 * (is_39 ? 1.6038109e-28f : 6.235149e+27f) : t66;
  const float t68 = sharpness < 1.0f ? t33 : (1.0f - t67) / (t34 + t34);
  z[0] = 3.5449078f * t68;
  const bool is_69 = 12.5f < sharpness;
  const float t70 = ((1.0f + t67) * 0.5f - t68) / t34;
  const float t71 = t68 * t27;
  z[1] = 6.1399603f * (is_69 ? t70 : t71);
  const float t72 = t68 - 3.0f / t34 * t70;
  const float t73 = t71 * t26;
  z[2] = 7.926655f * (is_69 ? t72 : t73);
  const float t74 = t70 - 5.0f / t34 * t72;
  const float t75 = t73 * t25;
  z[3] = 9.378944f * (is_69 ? t74 : t75);
  z[4] = 10.634723f * (is_69 ? t72 - 7.0f / t34 * t74 : t75 * t24);
}
#endif

#ifndef ZONAL_PROJECT_SPHERE_2
#define ZONAL_PROJECT_SPHERE_2
// A sphere light of radiance 1, seen from a receiver.
// 51 operations: 9 additions, 20 multiplications, 2 divisions, 2 square roots, 18 comparisons and choices.
ZONAL_FUNCTION void zonal_project_sphere_2(const float (&center)[3], float radius, const float (&receiver)[3],
    float (&sh)[4]) {
  const float t0 = center[0] - receiver[0];
  const float t1 = t0 < -4.611686e+18f ? -4.611686e+18f : t0;
  const float t2 = 4.611686e+18f < t1 ? 4.611686e+18f : t1;
  const float t3 = center[1] - receiver[1];
  const float t4 = t3 < -4.611686e+18f ? -4.611686e+18f : t3;
  const float t5 = 4.611686e+18f < t4 ? 4.611686e+18f : t4;
  const float t6 = center[2] - receiver[2];
  const float t7 = t6 < -4.611686e+18f ? -4.611686e+18f : t6;
  const float t8 = 4.611686e+18f < t7 ? 4.611686e+18f : t7;
  const float t9 = t2 * t2 + t5 * t5 + t8 * t8;
  const float t10 = sqrtf(t9 < 5.421011e-20f ? 5.421011e-20f : t9);
  const float t11 = t10 - radius;
  const float t12 = 1.0f / t10;
  const float t13 = radius * t12;
  const float t14 = 1.0f < t13 ? 1.0f : t13;
  const float t15 = sqrtf((t11 < 0.0f ? 0.0f : t11) * t12 * (1.0f + t14));
  const float t16 = fabsf(t15);
  const float t17 = t14 * t14;
  const float t18 = 1.0f + t16;
  const float t19 = 3.1415927f * (2.0f * (0.0f < t15 ? (t16 < 0.5f ? 1.0f - t16 : t17 / t18) : t18));
  sh[0] = t19 * 0.2820948f;
  const float t20 = 3.1415927f * t17;
  const bool is_21 = t9 < 5.421011e-20f;
  sh[1] = t20 * (-0.48860252f * (is_21 ? 0.0f : t5 * t12));
  sh[2] = t20 * (0.48860252f * (is_21 ? 1.0f : t8 * t12));
  sh[3] = t20 * (-0.48860252f * (is_21 ? 0.0f : t2 * t12));
}
#endif

#ifndef ZONAL_PROJECT_SPHERE_3
#define ZONAL_PROJECT_SPHERE_3
// A sphere light of radiance 1, seen from a receiver.
// 79 operations: 16 additions, 38 multiplications, 2 divisions, 2 square roots, 21 comparisons and choices.
ZONAL_FUNCTION void zonal_project_sphere_3(const float (&center)[3], float radius, const float (&receiver)[3],
    float (&sh)[9]) {
  const float t0 = center[0] - receiver[0];
  const float t1 = t0 < -4.611686e+18f ? -4.611686e+18f : t0;
  const float t2 = 4.611686e+18f < t1 ? 4.611686e+18f : t1;
  const float t3 = center[1] - receiver[1];
  const float t4 = t3 < -4.611686e+18f ? -4.611686e+18f : t3;
  const float t5 = 4.611686e+18f < t4 ? 4.611686e+18f : t4;
  const float t6 = center[2] - receiver[2];
  const float t7 = t6 < -4.611686e+18f ? -4.611686e+18f : t6;
  const float t8 = 4.611686e+18f < t7 ? 4.611686e+18f : t7;
  const float t9 = t2 * t2 + t5 * t5 + t8 * t8;
  const float t10 = sqrtf(t9 < 5.421011e-20f ? 5.421011e-20f : t9);
  const float t11 = t10 - radius;
  const float t12 = 1.0f / t10;
  const float t13 = radius * t12;
  const float t14 = 1.0f < t13 ? 1.0f : t13;
  const float t15 = sqrtf((t11 < 0.0f ? 0.0f : t11) * t12 * (1.0f + t14));
  const bool is_16 = 0.0f < t15;
  const float t17 = fabsf(t15);
  const float t18 = t14 * t14;
  const float t19 = 1.0f + t17;
  const float t20 = t17 < 0.5f ? 1.0f - t17 : t18 / t19;
  sh[0] = 3.1415927f * (2.0f * (is_16 ? t20 : t19)) * 0.2820948f;
  const float t21 = 3.1415927f * t18;
  const bool is_22 = t9 < 5.421011e-20f;
  const float t23 = is_22 ? 0.0f : t5 * t12;
  sh[1] = t21 * (-0.48860252f * t23);
  const float t24 = is_22 ? 1.0f : t8 * t12;
  sh[2] = t21 * (0.48860252f * t24);
  const float t25 = is_22 ? 0.0f : t2 * t12;
  sh[3] = t21 * (-0.48860252f * t25);
  const float t26 = 0.33333334f < t17 ? t18 : 0.0f;
  const float t27 = 3.1415927f * ((is_16 ? 1.0f : -1.0f) * (t26 + (t18 - t26 + -(t20 * t18))));
  const float t28 = t23 * t25;
  sh[4] = t27 * (0.54627424f * (t28 + t28));
  const float t29 = -1.0925485f * t24;
  sh[5] = t27 * (t29 * t23);
  sh[6] = t27 * (0.9461747f * (t24 * t24) + -0.31539157f);
  sh[7] = t27 * (t29 * t25);
  sh[8] = t27 * (0.54627424f * (t25 * t25 - t23 * t23));
}
#endif

#ifndef ZONAL_PROJECT_SPHERE_4
#define ZONAL_PROJECT_SPHERE_4
// A sphere light of radiance 1, seen from a receiver.
// 111 operations: 23 additions, 63 multiplications, 2 divisions, 2 square roots, 21 comparisons and choices.
ZONAL_FUNCTION void zonal_project_sphere_4(const float (&center)[3], float radius, const float (&receiver)[3],
    float (&sh)[16]) {
  const float t0 = center[0] - receiver[0];
  const float t1 = t0 < -4.611686e+18f ? -4.611686e+18f : t0;
  const float t2 = 4.611686e+18f < t1 ? 4.611686e+18f : t1;
  const float t3 = center[1] - receiver[1];
  const float t4 = t3 < -4.611686e+18f ? -4.611686e+18f : t3;
  const float t5 = 4.611686e+18f < t4 ? 4.611686e+18f : t4;
  const float t6 = center[2] - receiver[2];
  const float t7 = t6 < -4.611686e+18f ? -4.611686e+18f : t6;
  const float t8 = 4.611686e+18f < t7 ? 4.611686e+18f : t7;
  const float t9 = t2 * t2 + t5 * t5 + t8 * t8;
  const float t10 = sqrtf(t9 < 5.421011e-20f ? 5.421011e-20f : t9);
  const float t11 = t10 - radius;
  const float t12 = 1.0f / t10;
  const float t13 = radius * t12;
  const float t14 = 1.0f < t13 ? 1.0f : t13;
  const float t15 = sqrtf((t11 < 0.0f ? 0.0f : t11) * t12 * (1.0f + t14));
  const bool is_16 = 0.0f < t15;
  const float t17 = fabsf(t15);
  const float t18 = t14 * t14;
  const float t19 = 1.0f + t17;
  const float t20 = t17 < 0.5f ? 1.0f - t17 : t18 / t19;
  sh[0] = 3.1415927f * (2.0f * (is_16 ? t20 : t19)) * 0.2820948f;
  const float t21 = 3.1415927f * t18;
  const bool is_22 = t9 < 5.421011e-20f;
  const float t23 = is_22 ? 0.0f : t5 * t12;
  sh[1] = t21 * (-0.48860252f * t23);
  const float t24 = is_22 ? 1.0f : t8 * t12;
  sh[2] = t21 * (0.48860252f * t24);
  const float t25 = is_22 ? 0.0f : t2 * t12;
  sh[3] = t21 * (-0.48860252f * t25);
  const float t26 = 0.625f < t17 ? t18 : 0.0f;
  const float t27 = -(t20 * t18);
  const float t28 = t18 - t26 + t27;
  const float t29 = t26 + t28;
  const float t30 = 3.1415927f * ((is_16 ? 1.0f : -1.0f) * t29);
  const float t31 = t23 * t25;
  const float t32 = t31 + t31;
  sh[4] = t30 * (0.54627424f * t32);
  const float t33 = -1.0925485f * t24;
  sh[5] = t30 * (t33 * t23);
  const float t34 = t24 * t24;
  sh[6] = t30 * (0.9461747f * t34 + -0.31539157f);
  sh[7] = t30 * (t33 * t25);
  const float t35 = t25 * t25 - t23 * t23;
  sh[8] = t30 * (0.54627424f * t35);
  const float t36 = 3.1415927f * (t26 + (t28 + (0.25f * t27 - 1.25f * (t20 * t29))));
  sh[9] = t36 * (-0.5900436f * (t25 * t32 + t23 * t35));
  const float t37 = 1.4453057f * t24;
  sh[10] = t36 * (t37 * t32);
  const float t38 = -2.285229f * t34 + 0.4570458f;
  sh[11] = t36 * (t38 * t23);
  sh[12] = t36 * (t24 * (1.8658817f * t34 + -1.119529f));
  sh[13] = t36 * (t38 * t25);
  sh[14] = t36 * (t37 * t35);
  sh[15] = t36 * (-0.5900436f * (t25 * t35 - t23 * t32));
}
#endif

#ifndef ZONAL_PROJECT_SPHERE_5
#define ZONAL_PROJECT_SPHERE_5
// A sphere light of radiance 1, seen from a receiver.
// 152 operations: 31 additions, 96 multiplications, 2 divisions, 2 square roots, 21 comparisons and choices.
ZONAL_FUNCTION void zonal_project_sphere_5(const float (&center)[3], float radius, const float (&receiver)[3],
    float (&sh)[25]) {
  const float t0 = center[0] - receiver[0];
  const float t1 = t0 < -4.611686e+18f ? -4.611686e+18f : t0;
  const float t2 = 4.611686e+18f < t1 ? 4.611686e+18f : t1;
  const float t3 = center[1] - receiver[1];
  const float t4 = t3 < -4.611686e+18f ? -4.611686e+18f : t3;
  const float t5 = 4.611686e+18f < t4 ? 4.611686e+18f : t4;
  const float t6 = center[2] - receiver[2];
  const float t7 = t6 < -4.611686e+18f ? -4.611686e+18f : t6;
  const float t8 = 4.611686e+18f < t7 ? 4.611686e+18f : t7;
  const float t9 = t2 * t2 + t5 * t5 + t8 * t8;
  const float t10 = sqrtf(t9 < 5.421011e-20f ? 5.421011e-20f : t9);
  const float t11 = t10 - radius;
  const float t12 = 1.0f / t10;
  const float t13 = radius * t12;
  const float t14 = 1.0f < t13 ? 1.0f : t13;
  const float t15 = sqrtf((t11 < 0.0f ? 0.0f : t11) * t12 * (1.0f + t14));
  const bool is_16 = 0.0f < t15;
  const float t17 = fabsf(t15);
  const float t18 = t14 * t14;
  const float t19 = 1.0f + t17;
  const float t20 = t17 < 0.5f ? 1.0f - t17 : t18 / t19;
  sh[0] = 3.1415927f * (2.0f * (is_16 ? t20 : t19)) * 0.2820948f;
  const float t21 = 3.1415927f * t18;
  const bool is_22 = t9 < 5.421011e-20f;
  const float t23 = is_22 ? 0.0f : t5 * t12;
  sh[1] = t21 * (-0.48860252f * t23);
  const float t24 = is_22 ? 1.0f : t8 * t12;
  sh[2] = t21 * (0.48860252f * t24);
  const float t25 = is_22 ? 0.0f : t2 * t12;
  sh[3] = t21 * (-0.48860252f * t25);
  const float t26 = is_16 ? 1.0f : -1.0f;
  const float t27 = 0.76f < t17 ? t18 : 0.0f;
  const float t28 = -(t20 * t18);
  const float t29 = t18 - t27 + t28;
  const float t30 = t27 + t29;
  const float t31 = 3.1415927f * (t26 * t30);
  const float t32 = t23 * t25;
  const float t33 = t32 + t32;
  sh[4] = t31 * (0.54627424f * t33);
  const float t34 = -1.0925485f * t24;
  sh[5] = t31 * (t34 * t23);
  const float t35 = t24 * t24;
  const float t36 = 0.9461747f * t35 + -0.31539157f;
  sh[6] = t31 * t36;
  sh[7] = t31 * (t34 * t25);
  const float t37 = t25 * t25 - t23 * t23;
  sh[8] = t31 * (0.54627424f * t37);
  const float t38 = 0.25f * t28 - 1.25f * (t20 * t30);
  const float t39 = t29 + t38;
  const float t40 = t27 + t39;
  const float t41 = 3.1415927f * t40;
  const float t42 = t25 * t33 + t23 * t37;
  sh[9] = t41 * (-0.5900436f * t42);
  const float t43 = 1.4453057f * t24;
  sh[10] = t41 * (t43 * t33);
  const float t44 = -2.285229f * t35 + 0.4570458f;
  sh[11] = t41 * (t44 * t23);
  const float t45 = t24 * (1.8658817f * t35 + -1.119529f);
  sh[12] = t41 * t45;
  sh[13] = t41 * (t44 * t25);
  sh[14] = t41 * (t43 * t37);
  const float t46 = t25 * t37 - t23 * t33;
  sh[15] = t41 * (-0.5900436f * t46);
  const float t47 = 3.1415927f * (t26 * (t27 + (t39 + (0.4f * t38 - 1.4f * (t20 * t40)))));
  sh[16] = t47 * (0.6258357f * (t25 * t42 + t23 * t46));
  const float t48 = -1.7701308f * t24;
  sh[17] = t47 * (t48 * t42);
  const float t49 = 3.3116114f * t35 + -0.47308734f;
  sh[18] = t47 * (t49 * t33);
  const float t50 = t24 * (-4.683326f * t35 + 2.0071397f);
  sh[19] = t47 * (t50 * t23);
  sh[20] = t47 * (1.9843135f * t24 * t45 - 1.0062306f * t36);
  sh[21] = t47 * (t50 * t25);
  sh[22] = t47 * (t49 * t37);
  sh[23] = t47 * (t48 * t46);
  sh[24] = t47 * (0.6258357f * (t25 * t46 - t23 * t42));
}
#endif

#ifndef ZONAL_RECONSTRUCT_WITH_ADJOINT_3
#define ZONAL_RECONSTRUCT_WITH_ADJOINT_3
// A colour in a direction of any length but 0, and a loss's derivatives, given those by the colour.
// 184 operations: 59 additions, 123 multiplications, 1 divisions, 1 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_reconstruct_with_adjoint_3(const float (&sh)[9][3], const float (&direction)[3],
    const float (&by_value)[3], float (&value)[3], float (&by_sh)[9][3], float (&by_direction)[3]) {
  const float t0 = direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2];
  const float t1 = 1.0f / sqrtf(t0);
  const float t2 = direction[1] * t1;
  const float t3 = direction[0] * t1;
  const float t4 = t2 * t3;
  const float t5 = 0.54627424f * (t4 + t4);
  const float t6 = 0.54627424f * (t3 * t3 - t2 * t2);
  const float t7 = -0.48860252f * t2;
  const float t8 = direction[2] * t1;
  const float t9 = -1.0925485f * t8;
  const float t10 = t9 * t2;
  const float t11 = sh[0][0] * 0.2820948f + sh[4][0] * t5 + sh[8][0] * t6 + (sh[1][0] * t7 + sh[5][0] * t10);
  const float t12 = 0.48860252f * t8;
  const float t13 = 0.9461747f * (t8 * t8) + -0.31539157f;
  const float t14 = -0.48860252f * t3;
  const float t15 = t9 * t3;
  const float t16 = t11 + (sh[2][0] * t12 + sh[6][0] * t13 + (sh[3][0] * t14 + sh[7][0] * t15));
  value[0] = t16;
  const float t17 = sh[0][1] * 0.2820948f + sh[4][1] * t5 + sh[8][1] * t6 + (sh[1][1] * t7 + sh[5][1] * t10);
  const float t18 = t17 + (sh[2][1] * t12 + sh[6][1] * t13 + (sh[3][1] * t14 + sh[7][1] * t15));
  value[1] = t18;
  const float t19 = sh[0][2] * 0.2820948f + sh[4][2] * t5 + sh[8][2] * t6 + (sh[1][2] * t7 + sh[5][2] * t10);
  const float t20 = t19 + (sh[2][2] * t12 + sh[6][2] * t13 + (sh[3][2] * t14 + sh[7][2] * t15));
  value[2] = t20;
  by_sh[0][0] = by_value[0] * 0.2820948f;
  by_sh[0][1] = by_value[1] * 0.2820948f;
  by_sh[0][2] = by_value[2] * 0.2820948f;
  by_sh[1][0] = by_value[0] * t7;
  by_sh[1][1] = by_value[1] * t7;
  by_sh[1][2] = by_value[2] * t7;
  by_sh[2][0] = by_value[0] * t12;
  by_sh[2][1] = by_value[1] * t12;
  by_sh[2][2] = by_value[2] * t12;
  by_sh[3][0] = by_value[0] * t14;
  by_sh[3][1] = by_value[1] * t14;
  by_sh[3][2] = by_value[2] * t14;
  by_sh[4][0] = by_value[0] * t5;
  by_sh[4][1] = by_value[1] * t5;
  by_sh[4][2] = by_value[2] * t5;
  by_sh[5][0] = by_value[0] * t10;
  by_sh[5][1] = by_value[1] * t10;
  by_sh[5][2] = by_value[2] * t10;
  by_sh[6][0] = by_value[0] * t13;
  by_sh[6][1] = by_value[1] * t13;
  by_sh[6][2] = by_value[2] * t13;
  by_sh[7][0] = by_value[0] * t15;
  by_sh[7][1] = by_value[1] * t15;
  by_sh[7][2] = by_value[2] * t15;
  by_sh[8][0] = by_value[0] * t6;
  by_sh[8][1] = by_value[1] * t6;
  by_sh[8][2] = by_value[2] * t6;
  const float t21 = by_value[0] * sh[3][0] + by_value[1] * sh[3][1] + by_value[2] * sh[3][2];
  const float t22 = by_value[0] * sh[7][0] + by_value[1] * sh[7][1] + by_value[2] * sh[7][2];
  const float t23 = by_value[0] * sh[8][0] + by_value[1] * sh[8][1] + by_value[2] * sh[8][2];
  const float t24 = 1.0925485f * t23;
  const float t25 = by_value[0] * sh[4][0] + by_value[1] * sh[4][1] + by_value[2] * sh[4][2];
  const float t26 = 1.0925485f * t25;
  const float t27 = -0.48860252f * t21 + t9 * t22 + (t24 * t3 + t26 * t2);
  const float t28 = by_value[0] * sh[1][0] + by_value[1] * sh[1][1] + by_value[2] * sh[1][2];
  const float t29 = by_value[0] * sh[5][0] + by_value[1] * sh[5][1] + by_value[2] * sh[5][2];
  const float t30 = -0.48860252f * t28 + t9 * t29 + (t26 * t3 - t24 * t2);
  const float t31 = by_value[0] * sh[2][0] + by_value[1] * sh[2][1] + by_value[2] * sh[2][2];
  const float t32 = by_value[0] * sh[6][0] + by_value[1] * sh[6][1] + by_value[2] * sh[6][2];
  const float t33 = 0.48860252f * t31 + -1.7320508f * t9 * t32 + (-1.0925485f * t22 * t3 + -1.0925485f * t29 * t2);
  const float t34 = t27 * t3 + t30 * t2 + t33 * t8;
  by_direction[0] = (t27 - t3 * t34) * t1;
  by_direction[1] = (t30 - t2 * t34) * t1;
  by_direction[2] = (t33 - t8 * t34) * t1;
}
#endif

#ifndef ZONAL_RECONSTRUCT_WITH_ADJOINT_4
#define ZONAL_RECONSTRUCT_WITH_ADJOINT_4
// A colour in a direction of any length but 0, and a loss's derivatives, given those by the colour.
// 333 operations: 111 additions, 220 multiplications, 1 divisions, 1 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_reconstruct_with_adjoint_4(const float (&sh)[16][3], const float (&direction)[3],
    const float (&by_value)[3], float (&value)[3], float (&by_sh)[16][3], float (&by_direction)[3]) {
  const float t0 = direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2];
  const float t1 = 1.0f / sqrtf(t0);
  const float t2 = direction[2] * t1;
  const float t3 = t2 * t2;
  const float t4 = t2 * (1.8658817f * t3 + -1.119529f);
  const float t5 = direction[1] * t1;
  const float t6 = direction[0] * t1;
  const float t7 = t5 * t6;
  const float t8 = t7 + t7;
  const float t9 = 0.54627424f * t8;
  const float t10 = t6 * t6 - t5 * t5;
  const float t11 = 0.54627424f * t10;
  const float t12 = -0.48860252f * t5;
  const float t13 = -1.0925485f * t2;
  const float t14 = t13 * t5;
  const float t15 = -2.285229f * t3 + 0.4570458f;
  const float t16 = t15 * t6;
  const float t17 = -0.5900436f * (t6 * t8 + t5 * t10);
  const float t18 = sh[0][0] * 0.2820948f + sh[12][0] * t4 + sh[4][0] * t9 + sh[8][0] * t11 + (sh[1][0] * t12 + sh[5][0] * t14 + sh[13][0] * t16 + sh[9][0] * t17);
  const float t19 = 0.48860252f * t2;
  const float t20 = 0.9461747f * t3 + -0.31539157f;
  const float t21 = 1.4453057f * t2;
  const float t22 = t21 * t8;
  const float t23 = t21 * t10;
  const float t24 = -0.48860252f * t6;
  const float t25 = t13 * t6;
  const float t26 = t15 * t5;
  const float t27 = -0.5900436f * (t6 * t10 - t5 * t8);
  const float t28 = sh[2][0] * t19 + sh[6][0] * t20 + sh[10][0] * t22 + sh[14][0] * t23 + (sh[3][0] * t24 + sh[7][0] * t25 + sh[11][0] * t26 + sh[15][0] * t27);
  value[0] = t18 + t28;
  const float t29 = sh[0][1] * 0.2820948f + sh[12][1] * t4 + sh[4][1] * t9 + sh[8][1] * t11 + (sh[1][1] * t12 + sh[5][1] * t14 + sh[13][1] * t16 + sh[9][1] * t17);
  const float t30 = sh[2][1] * t19 + sh[6][1] * t20 + sh[10][1] * t22 + sh[14][1] * t23 + (sh[3][1] * t24 + sh[7][1] * t25 + sh[11][1] * t26 + sh[15][1] * t27);
  value[1] = t29 + t30;
  const float t31 = sh[0][2] * 0.2820948f + sh[12][2] * t4 + sh[4][2] * t9 + sh[8][2] * t11 + (sh[1][2] * t12 + sh[5][2] * t14 + sh[13][2] * t16 + sh[9][2] * t17);
  const float t32 = sh[2][2] * t19 + sh[6][2] * t20 + sh[10][2] * t22 + sh[14][2] * t23 + (sh[3][2] * t24 + sh[7][2] * t25 + sh[11][2] * t26 + sh[15][2] * t27);
  value[2] = t31 + t32;
  by_sh[0][0] = by_value[0] * 0.2820948f;
  by_sh[0][1] = by_value[1] * 0.2820948f;
  by_sh[0][2] = by_value[2] * 0.2820948f;
  by_sh[1][0] = by_value[0] * t12;
  by_sh[1][1] = by_value[1] * t12;
  by_sh[1][2] = by_value[2] * t12;
  by_sh[2][0] = by_value[0] * t19;
  by_sh[2][1] = by_value[1] * t19;
  by_sh[2][2] = by_value[2] * t19;
  by_sh[3][0] = by_value[0] * t24;
  by_sh[3][1] = by_value[1] * t24;
  by_sh[3][2] = by_value[2] * t24;
  by_sh[4][0] = by_value[0] * t9;
  by_sh[4][1] = by_value[1] * t9;
  by_sh[4][2] = by_value[2] * t9;
  by_sh[5][0] = by_value[0] * t14;
  by_sh[5][1] = by_value[1] * t14;
  by_sh[5][2] = by_value[2] * t14;
  by_sh[6][0] = by_value[0] * t20;
  by_sh[6][1] = by_value[1] * t20;
  by_sh[6][2] = by_value[2] * t20;
  by_sh[7][0] = by_value[0] * t25;
  by_sh[7][1] = by_value[1] * t25;
  by_sh[7][2] = by_value[2] * t25;
  by_sh[8][0] = by_value[0] * t11;
  by_sh[8][1] = by_value[1] * t11;
  by_sh[8][2] = by_value[2] * t11;
  by_sh[9][0] = by_value[0] * t17;
  by_sh[9][1] = by_value[1] * t17;
  by_sh[9][2] = by_value[2] * t17;
  by_sh[10][0] = by_value[0] * t22;
  by_sh[10][1] = by_value[1] * t22;
  by_sh[10][2] = by_value[2] * t22;
  by_sh[11][0] = by_value[0] * t26;
  by_sh[11][1] = by_value[1] * t26;
  by_sh[11][2] = by_value[2] * t26;
  by_sh[12][0] = by_value[0] * t4;
  by_sh[12][1] = by_value[1] * t4;
  by_sh[12][2] = by_value[2] * t4;
  by_sh[13][0] = by_value[0] * t16;
  by_sh[13][1] = by_value[1] * t16;
  by_sh[13][2] = by_value[2] * t16;
  by_sh[14][0] = by_value[0] * t23;
  by_sh[14][1] = by_value[1] * t23;
  by_sh[14][2] = by_value[2] * t23;
  by_sh[15][0] = by_value[0] * t27;
  by_sh[15][1] = by_value[1] * t27;
  by_sh[15][2] = by_value[2] * t27;
  const float t33 = by_value[0] * sh[3][0] + by_value[1] * sh[3][1] + by_value[2] * sh[3][2];
  const float t34 = by_value[0] * sh[7][0] + by_value[1] * sh[7][1] + by_value[2] * sh[7][2];
  const float t35 = by_value[0] * sh[13][0] + by_value[1] * sh[13][1] + by_value[2] * sh[13][2];
  const float t36 = by_value[0] * sh[8][0] + by_value[1] * sh[8][1] + by_value[2] * sh[8][2];
  const float t37 = 2.0f * t21;
  const float t38 = by_value[0] * sh[14][0] + by_value[1] * sh[14][1] + by_value[2] * sh[14][2];
  const float t39 = 1.0925485f * t36 + t37 * t38;
  const float t40 = by_value[0] * sh[4][0] + by_value[1] * sh[4][1] + by_value[2] * sh[4][2];
  const float t41 = by_value[0] * sh[10][0] + by_value[1] * sh[10][1] + by_value[2] * sh[10][2];
  const float t42 = 1.0925485f * t40 + t37 * t41;
  const float t43 = by_value[0] * sh[15][0] + by_value[1] * sh[15][1] + by_value[2] * sh[15][2];
  const float t44 = -1.7701309f * t43;
  const float t45 = by_value[0] * sh[9][0] + by_value[1] * sh[9][1] + by_value[2] * sh[9][2];
  const float t46 = -1.7701309f * t45;
  const float t47 = -0.48860252f * t33 + t13 * t34 + t15 * t35 + (t39 * t6 + t42 * t5) + (t44 * t10 + t46 * t8);
  const float t48 = by_value[0] * sh[1][0] + by_value[1] * sh[1][1] + by_value[2] * sh[1][2];
  const float t49 = by_value[0] * sh[5][0] + by_value[1] * sh[5][1] + by_value[2] * sh[5][2];
  const float t50 = by_value[0] * sh[11][0] + by_value[1] * sh[11][1] + by_value[2] * sh[11][2];
  const float t51 = -0.48860252f * t48 + t13 * t49 + t15 * t50 + (t42 * t6 - t39 * t5) + (t46 * t10 - t44 * t8);
  const float t52 = by_value[0] * sh[2][0] + by_value[1] * sh[2][1] + by_value[2] * sh[2][2];
  const float t53 = by_value[0] * sh[6][0] + by_value[1] * sh[6][1] + by_value[2] * sh[6][2];
  const float t54 = by_value[0] * sh[12][0] + by_value[1] * sh[12][1] + by_value[2] * sh[12][2];
  const float t55 = -3.1622777f * t21;
  const float t56 = (-1.0925485f * t34 + t55 * t35) * t6 + (-1.0925485f * t49 + t55 * t50) * t5;
  const float t57 = 0.48860252f * t52 + -1.7320508f * t13 * t53 + -2.4494898f * t15 * t54 + t56;
  const float t58 = t57 + (1.4453058f * t38 * t10 + 1.4453058f * t41 * t8);
  const float t59 = t47 * t6 + t51 * t5 + t58 * t2;
  by_direction[0] = (t47 - t6 * t59) * t1;
  by_direction[1] = (t51 - t5 * t59) * t1;
  by_direction[2] = (t58 - t2 * t59) * t1;
}
#endif

#ifndef ZONAL_SPLAT_COLOUR_3
#define ZONAL_SPLAT_COLOUR_3
// A splat's colour as a camera sees it: the value, and half more, and at least 0 [Kerbl et al. 2023]. For colours.
// 86 operations: 35 additions, 46 multiplications, 1 divisions, 1 square roots, 3 comparisons and choices.
ZONAL_FUNCTION void zonal_splat_colour_3(const float (&sh)[9][3], const float (&position)[3],
    const float (&camera)[3], float (&value)[3]) {
  const float t0 = position[1] - camera[1];
  const float t1 = position[0] - camera[0];
  const float t2 = position[2] - camera[2];
  const float t3 = 1.0f / sqrtf(t1 * t1 + t0 * t0 + t2 * t2);
  const float t4 = t0 * t3;
  const float t5 = t1 * t3;
  const float t6 = t4 * t5;
  const float t7 = 0.54627424f * (t6 + t6);
  const float t8 = 0.54627424f * (t5 * t5 - t4 * t4);
  const float t9 = -0.48860252f * t4;
  const float t10 = t2 * t3;
  const float t11 = -1.0925485f * t10;
  const float t12 = t11 * t4;
  const float t13 = sh[0][0] * 0.2820948f + sh[4][0] * t7 + sh[8][0] * t8 + (sh[1][0] * t9 + sh[5][0] * t12);
  const float t14 = 0.48860252f * t10;
  const float t15 = 0.9461747f * (t10 * t10) + -0.31539157f;
  const float t16 = -0.48860252f * t5;
  const float t17 = t11 * t5;
  const float t18 = t13 + (sh[2][0] * t14 + sh[6][0] * t15 + (sh[3][0] * t16 + sh[7][0] * t17));
  const float t19 = t18 + 0.5f;
  value[0] = t19 < 0.0f ? 0.0f : t19;
  const float t20 = sh[0][1] * 0.2820948f + sh[4][1] * t7 + sh[8][1] * t8 + (sh[1][1] * t9 + sh[5][1] * t12);
  const float t21 = t20 + (sh[2][1] * t14 + sh[6][1] * t15 + (sh[3][1] * t16 + sh[7][1] * t17));
  const float t22 = t21 + 0.5f;
  value[1] = t22 < 0.0f ? 0.0f : t22;
  const float t23 = sh[0][2] * 0.2820948f + sh[4][2] * t7 + sh[8][2] * t8 + (sh[1][2] * t9 + sh[5][2] * t12);
  const float t24 = t23 + (sh[2][2] * t14 + sh[6][2] * t15 + (sh[3][2] * t16 + sh[7][2] * t17));
  const float t25 = t24 + 0.5f;
  value[2] = t25 < 0.0f ? 0.0f : t25;
}
#endif

#ifndef ZONAL_SPLAT_COLOUR_4
#define ZONAL_SPLAT_COLOUR_4
// A splat's colour as a camera sees it: the value, and half more, and at least 0 [Kerbl et al. 2023]. For colours.
// 146 operations: 60 additions, 81 multiplications, 1 divisions, 1 square roots, 3 comparisons and choices.
ZONAL_FUNCTION void zonal_splat_colour_4(const float (&sh)[16][3], const float (&position)[3],
    const float (&camera)[3], float (&value)[3]) {
  const float t0 = position[2] - camera[2];
  const float t1 = position[0] - camera[0];
  const float t2 = position[1] - camera[1];
  const float t3 = 1.0f / sqrtf(t1 * t1 + t2 * t2 + t0 * t0);
  const float t4 = t0 * t3;
  const float t5 = t4 * t4;
  const float t6 = t4 * (1.8658817f * t5 + -1.119529f);
  const float t7 = t2 * t3;
  const float t8 = t1 * t3;
  const float t9 = t7 * t8;
  const float t10 = t9 + t9;
  const float t11 = 0.54627424f * t10;
  const float t12 = t8 * t8 - t7 * t7;
  const float t13 = 0.54627424f * t12;
  const float t14 = sh[0][0] * 0.2820948f + sh[12][0] * t6 + sh[4][0] * t11 + sh[8][0] * t13;
  const float t15 = -0.48860252f * t7;
  const float t16 = -1.0925485f * t4;
  const float t17 = t16 * t7;
  const float t18 = -2.285229f * t5 + 0.4570458f;
  const float t19 = t18 * t8;
  const float t20 = -0.5900436f * (t8 * t10 + t7 * t12);
  const float t21 = t14 + (sh[1][0] * t15 + sh[5][0] * t17 + sh[13][0] * t19 + sh[9][0] * t20);
  const float t22 = 0.48860252f * t4;
  const float t23 = 0.9461747f * t5 + -0.31539157f;
  const float t24 = 1.4453057f * t4;
  const float t25 = t24 * t10;
  const float t26 = t24 * t12;
  const float t27 = -0.48860252f * t8;
  const float t28 = t16 * t8;
  const float t29 = t18 * t7;
  const float t30 = -0.5900436f * (t8 * t12 - t7 * t10);
  const float t31 = sh[2][0] * t22 + sh[6][0] * t23 + sh[10][0] * t25 + sh[14][0] * t26 + (sh[3][0] * t27 + sh[7][0] * t28 + sh[11][0] * t29 + sh[15][0] * t30);
  const float t32 = t21 + t31 + 0.5f;
  value[0] = t32 < 0.0f ? 0.0f : t32;
  const float t33 = sh[0][1] * 0.2820948f + sh[12][1] * t6 + sh[4][1] * t11 + sh[8][1] * t13;
  const float t34 = t33 + (sh[1][1] * t15 + sh[5][1] * t17 + sh[13][1] * t19 + sh[9][1] * t20);
  const float t35 = sh[2][1] * t22 + sh[6][1] * t23 + sh[10][1] * t25 + sh[14][1] * t26 + (sh[3][1] * t27 + sh[7][1] * t28 + sh[11][1] * t29 + sh[15][1] * t30);
  const float t36 = t34 + t35 + 0.5f;
  value[1] = t36 < 0.0f ? 0.0f : t36;
  const float t37 = sh[0][2] * 0.2820948f + sh[12][2] * t6 + sh[4][2] * t11 + sh[8][2] * t13;
  const float t38 = t37 + (sh[1][2] * t15 + sh[5][2] * t17 + sh[13][2] * t19 + sh[9][2] * t20);
  const float t39 = sh[2][2] * t22 + sh[6][2] * t23 + sh[10][2] * t25 + sh[14][2] * t26 + (sh[3][2] * t27 + sh[7][2] * t28 + sh[11][2] * t29 + sh[15][2] * t30);
  const float t40 = t38 + t39 + 0.5f;
  value[2] = t40 < 0.0f ? 0.0f : t40;
}
#endif

#ifndef ZONAL_SPLAT_WITH_ADJOINT_3
#define ZONAL_SPLAT_WITH_ADJOINT_3
// A splat's colour in the direction from the camera, and a loss's derivatives, given those by the colour.
// 196 operations: 62 additions, 123 multiplications, 1 divisions, 1 square roots, 9 comparisons and choices.
ZONAL_FUNCTION void zonal_splat_with_adjoint_3(const float (&sh)[9][3], const float (&direction)[3],
    const float (&by_value)[3], float (&value)[3], float (&by_sh)[9][3], float (&by_direction)[3]) {
  const float t0 = direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2];
  const float t1 = 1.0f / sqrtf(t0);
  const float t2 = direction[1] * t1;
  const float t3 = direction[0] * t1;
  const float t4 = t2 * t3;
  const float t5 = 0.54627424f * (t4 + t4);
  const float t6 = 0.54627424f * (t3 * t3 - t2 * t2);
  const float t7 = -0.48860252f * t2;
  const float t8 = direction[2] * t1;
  const float t9 = -1.0925485f * t8;
  const float t10 = t9 * t2;
  const float t11 = sh[0][0] * 0.2820948f + sh[4][0] * t5 + sh[8][0] * t6 + (sh[1][0] * t7 + sh[5][0] * t10);
  const float t12 = 0.48860252f * t8;
  const float t13 = 0.9461747f * (t8 * t8) + -0.31539157f;
  const float t14 = -0.48860252f * t3;
  const float t15 = t9 * t3;
  const float t16 = t11 + (sh[2][0] * t12 + sh[6][0] * t13 + (sh[3][0] * t14 + sh[7][0] * t15));
  const float t17 = t16 + 0.5f;
  value[0] = t17 < 0.0f ? 0.0f : t17;
  const float t18 = sh[0][1] * 0.2820948f + sh[4][1] * t5 + sh[8][1] * t6 + (sh[1][1] * t7 + sh[5][1] * t10);
  const float t19 = t18 + (sh[2][1] * t12 + sh[6][1] * t13 + (sh[3][1] * t14 + sh[7][1] * t15));
  const float t20 = t19 + 0.5f;
  value[1] = t20 < 0.0f ? 0.0f : t20;
  const float t21 = sh[0][2] * 0.2820948f + sh[4][2] * t5 + sh[8][2] * t6 + (sh[1][2] * t7 + sh[5][2] * t10);
  const float t22 = t21 + (sh[2][2] * t12 + sh[6][2] * t13 + (sh[3][2] * t14 + sh[7][2] * t15));
  const float t23 = t22 + 0.5f;
  value[2] = t23 < 0.0f ? 0.0f : t23;
  const float t24 = t17 < 0.0f ? 0.0f : by_value[0];
  by_sh[0][0] = t24 * 0.2820948f;
  const float t25 = t20 < 0.0f ? 0.0f : by_value[1];
  by_sh[0][1] = t25 * 0.2820948f;
  const float t26 = t23 < 0.0f ? 0.0f : by_value[2];
  by_sh[0][2] = t26 * 0.2820948f;
  by_sh[1][0] = t24 * t7;
  by_sh[1][1] = t25 * t7;
  by_sh[1][2] = t26 * t7;
  by_sh[2][0] = t24 * t12;
  by_sh[2][1] = t25 * t12;
  by_sh[2][2] = t26 * t12;
  by_sh[3][0] = t24 * t14;
  by_sh[3][1] = t25 * t14;
  by_sh[3][2] = t26 * t14;
  by_sh[4][0] = t24 * t5;
  by_sh[4][1] = t25 * t5;
  by_sh[4][2] = t26 * t5;
  by_sh[5][0] = t24 * t10;
  by_sh[5][1] = t25 * t10;
  by_sh[5][2] = t26 * t10;
  by_sh[6][0] = t24 * t13;
  by_sh[6][1] = t25 * t13;
  by_sh[6][2] = t26 * t13;
  by_sh[7][0] = t24 * t15;
  by_sh[7][1] = t25 * t15;
  by_sh[7][2] = t26 * t15;
  by_sh[8][0] = t24 * t6;
  by_sh[8][1] = t25 * t6;
  by_sh[8][2] = t26 * t6;
  const float t27 = t24 * sh[7][0] + t25 * sh[7][1] + t26 * sh[7][2];
  const float t28 = -0.48860252f * (t24 * sh[3][0] + t25 * sh[3][1] + t26 * sh[3][2]) + t9 * t27;
  const float t29 = 1.0925485f * (t24 * sh[8][0] + t25 * sh[8][1] + t26 * sh[8][2]);
  const float t30 = 1.0925485f * (t24 * sh[4][0] + t25 * sh[4][1] + t26 * sh[4][2]);
  const float t31 = t28 + (t29 * t3 + t30 * t2);
  const float t32 = t24 * sh[5][0] + t25 * sh[5][1] + t26 * sh[5][2];
  const float t33 = -0.48860252f * (t24 * sh[1][0] + t25 * sh[1][1] + t26 * sh[1][2]) + t9 * t32;
  const float t34 = t33 + (t30 * t3 - t29 * t2);
  const float t35 = 0.48860252f * (t24 * sh[2][0] + t25 * sh[2][1] + t26 * sh[2][2]) + -1.7320508f * t9 * (t24 * sh[6][0] + t25 * sh[6][1] + t26 * sh[6][2]);
  const float t36 = t35 + (-1.0925485f * t27 * t3 + -1.0925485f * t32 * t2);
  const float t37 = t31 * t3 + t34 * t2 + t36 * t8;
  by_direction[0] = (t31 - t3 * t37) * t1;
  by_direction[1] = (t34 - t2 * t37) * t1;
  by_direction[2] = (t36 - t8 * t37) * t1;
}
#endif

#ifndef ZONAL_SPLAT_WITH_ADJOINT_4
#define ZONAL_SPLAT_WITH_ADJOINT_4
// A splat's colour in the direction from the camera, and a loss's derivatives, given those by the colour.
// 345 operations: 114 additions, 220 multiplications, 1 divisions, 1 square roots, 9 comparisons and choices.
ZONAL_FUNCTION void zonal_splat_with_adjoint_4(const float (&sh)[16][3], const float (&direction)[3],
    const float (&by_value)[3], float (&value)[3], float (&by_sh)[16][3], float (&by_direction)[3]) {
  const float t0 = direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2];
  const float t1 = 1.0f / sqrtf(t0);
  const float t2 = direction[2] * t1;
  const float t3 = t2 * t2;
  const float t4 = t2 * (1.8658817f * t3 + -1.119529f);
  const float t5 = direction[1] * t1;
  const float t6 = direction[0] * t1;
  const float t7 = t5 * t6;
  const float t8 = t7 + t7;
  const float t9 = 0.54627424f * t8;
  const float t10 = t6 * t6 - t5 * t5;
  const float t11 = 0.54627424f * t10;
  const float t12 = -0.48860252f * t5;
  const float t13 = -1.0925485f * t2;
  const float t14 = t13 * t5;
  const float t15 = -2.285229f * t3 + 0.4570458f;
  const float t16 = t15 * t6;
  const float t17 = -0.5900436f * (t6 * t8 + t5 * t10);
  const float t18 = sh[0][0] * 0.2820948f + sh[12][0] * t4 + sh[4][0] * t9 + sh[8][0] * t11 + (sh[1][0] * t12 + sh[5][0] * t14 + sh[13][0] * t16 + sh[9][0] * t17);
  const float t19 = 0.48860252f * t2;
  const float t20 = 0.9461747f * t3 + -0.31539157f;
  const float t21 = 1.4453057f * t2;
  const float t22 = t21 * t8;
  const float t23 = t21 * t10;
  const float t24 = -0.48860252f * t6;
  const float t25 = t13 * t6;
  const float t26 = t15 * t5;
  const float t27 = -0.5900436f * (t6 * t10 - t5 * t8);
  const float t28 = sh[2][0] * t19 + sh[6][0] * t20 + sh[10][0] * t22 + sh[14][0] * t23 + (sh[3][0] * t24 + sh[7][0] * t25 + sh[11][0] * t26 + sh[15][0] * t27);
  const float t29 = t18 + t28 + 0.5f;
  value[0] = t29 < 0.0f ? 0.0f : t29;
  const float t30 = sh[0][1] * 0.2820948f + sh[12][1] * t4 + sh[4][1] * t9 + sh[8][1] * t11 + (sh[1][1] * t12 + sh[5][1] * t14 + sh[13][1] * t16 + sh[9][1] * t17);
  const float t31 = sh[2][1] * t19 + sh[6][1] * t20 + sh[10][1] * t22 + sh[14][1] * t23 + (sh[3][1] * t24 + sh[7][1] * t25 + sh[11][1] * t26 + sh[15][1] * t27);
  const float t32 = t30 + t31 + 0.5f;
  value[1] = t32 < 0.0f ? 0.0f : t32;
  const float t33 = sh[0][2] * 0.2820948f + sh[12][2] * t4 + sh[4][2] * t9 + sh[8][2] * t11 + (sh[1][2] * t12 + sh[5][2] * t14 + sh[13][2] * t16 + sh[9][2] * t17);
  const float t34 = sh[2][2] * t19 + sh[6][2] * t20 + sh[10][2] * t22 + sh[14][2] * t23 + (sh[3][2] * t24 + sh[7][2] * t25 + sh[11][2] * t26 + sh[15][2] * t27);
  const float t35 = t33 + t34 + 0.5f;
  value[2] = t35 < 0.0f ? 0.0f : t35;
  const float t36 = t29 < 0.0f ? 0.0f : by_value[0];
  by_sh[0][0] = t36 * 0.2820948f;
  const float t37 = t32 < 0.0f ? 0.0f : by_value[1];
  by_sh[0][1] = t37 * 0.2820948f;
  const float t38 = t35 < 0.0f ? 0.0f : by_value[2];
  by_sh[0][2] = t38 * 0.2820948f;
  by_sh[1][0] = t36 * t12;
  by_sh[1][1] = t37 * t12;
  by_sh[1][2] = t38 * t12;
  by_sh[2][0] = t36 * t19;
  by_sh[2][1] = t37 * t19;
  by_sh[2][2] = t38 * t19;
  by_sh[3][0] = t36 * t24;
  by_sh[3][1] = t37 * t24;
  by_sh[3][2] = t38 * t24;
  by_sh[4][0] = t36 * t9;
  by_sh[4][1] = t37 * t9;
  by_sh[4][2] = t38 * t9;
  by_sh[5][0] = t36 * t14;
  by_sh[5][1] = t37 * t14;
  by_sh[5][2] = t38 * t14;
  by_sh[6][0] = t36 * t20;
  by_sh[6][1] = t37 * t20;
  by_sh[6][2] = t38 * t20;
  by_sh[7][0] = t36 * t25;
  by_sh[7][1] = t37 * t25;
  by_sh[7][2] = t38 * t25;
  by_sh[8][0] = t36 * t11;
  by_sh[8][1] = t37 * t11;
  by_sh[8][2] = t38 * t11;
  by_sh[9][0] = t36 * t17;
  by_sh[9][1] = t37 * t17;
  by_sh[9][2] = t38 * t17;
  by_sh[10][0] = t36 * t22;
  by_sh[10][1] = t37 * t22;
  by_sh[10][2] = t38 * t22;
  by_sh[11][0] = t36 * t26;
  by_sh[11][1] = t37 * t26;
  by_sh[11][2] = t38 * t26;
  by_sh[12][0] = t36 * t4;
  by_sh[12][1] = t37 * t4;
  by_sh[12][2] = t38 * t4;
  by_sh[13][0] = t36 * t16;
  by_sh[13][1] = t37 * t16;
  by_sh[13][2] = t38 * t16;
  by_sh[14][0] = t36 * t23;
  by_sh[14][1] = t37 * t23;
  by_sh[14][2] = t38 * t23;
  by_sh[15][0] = t36 * t27;
  by_sh[15][1] = t37 * t27;
  by_sh[15][2] = t38 * t27;
  const float t39 = t36 * sh[7][0] + t37 * sh[7][1] + t38 * sh[7][2];
  const float t40 = -0.48860252f * (t36 * sh[3][0] + t37 * sh[3][1] + t38 * sh[3][2]) + t13 * t39;
  const float t41 = t36 * sh[13][0] + t37 * sh[13][1] + t38 * sh[13][2];
  const float t42 = 2.0f * t21;
  const float t43 = t36 * sh[14][0] + t37 * sh[14][1] + t38 * sh[14][2];
  const float t44 = 1.0925485f * (t36 * sh[8][0] + t37 * sh[8][1] + t38 * sh[8][2]) + t42 * t43;
  const float t45 = t36 * sh[10][0] + t37 * sh[10][1] + t38 * sh[10][2];
  const float t46 = 1.0925485f * (t36 * sh[4][0] + t37 * sh[4][1] + t38 * sh[4][2]) + t42 * t45;
  const float t47 = -1.7701309f * (t36 * sh[15][0] + t37 * sh[15][1] + t38 * sh[15][2]);
  const float t48 = -1.7701309f * (t36 * sh[9][0] + t37 * sh[9][1] + t38 * sh[9][2]);
  const float t49 = t40 + t15 * t41 + (t44 * t6 + t46 * t5) + (t47 * t10 + t48 * t8);
  const float t50 = t36 * sh[5][0] + t37 * sh[5][1] + t38 * sh[5][2];
  const float t51 = -0.48860252f * (t36 * sh[1][0] + t37 * sh[1][1] + t38 * sh[1][2]) + t13 * t50;
  const float t52 = t36 * sh[11][0] + t37 * sh[11][1] + t38 * sh[11][2];
  const float t53 = t51 + t15 * t52 + (t46 * t6 - t44 * t5) + (t48 * t10 - t47 * t8);
  const float t54 = 0.48860252f * (t36 * sh[2][0] + t37 * sh[2][1] + t38 * sh[2][2]) + -1.7320508f * t13 * (t36 * sh[6][0] + t37 * sh[6][1] + t38 * sh[6][2]);
  const float t55 = -2.4494898f * t15 * (t36 * sh[12][0] + t37 * sh[12][1] + t38 * sh[12][2]);
  const float t56 = -3.1622777f * t21;
  const float t57 = (-1.0925485f * t39 + t56 * t41) * t6 + (-1.0925485f * t50 + t56 * t52) * t5;
  const float t58 = t54 + t55 + t57 + (1.4453058f * t43 * t10 + 1.4453058f * t45 * t8);
  const float t59 = t49 * t6 + t53 * t5 + t58 * t2;
  by_direction[0] = (t49 - t6 * t59) * t1;
  by_direction[1] = (t53 - t5 * t59) * t1;
  by_direction[2] = (t58 - t2 * t59) * t1;
}
#endif

#ifndef ZONAL_ROTATE_ABOUT_Z_2
#define ZONAL_ROTATE_ABOUT_Z_2
// A function turned about z, from x towards y.
// 6 operations: 2 additions, 4 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_rotate_about_z_2(const float (&sh)[4], const float (&angle)[2], float (&result)[4]) {
  result[0] = sh[0];
  result[1] = angle[0] * sh[1] + angle[1] * sh[3];
  result[2] = sh[2];
  result[3] = angle[0] * sh[3] - angle[1] * sh[1];
}
#endif

#ifndef ZONAL_ROTATE_ABOUT_Z_3
#define ZONAL_ROTATE_ABOUT_Z_3
// A function turned about z, from x towards y.
// 23 operations: 8 additions, 15 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_rotate_about_z_3(const float (&sh)[9], const float (&angle)[2], float (&result)[9]) {
  result[0] = sh[0];
  result[1] = angle[0] * sh[1] + angle[1] * sh[3];
  result[2] = sh[2];
  result[3] = angle[0] * sh[3] - angle[1] * sh[1];
  const float t0 = angle[0] * angle[0] - angle[1] * angle[1];
  const float t1 = angle[0] * angle[1];
  const float t2 = t1 + t1;
  result[4] = t0 * sh[4] + t2 * sh[8];
  result[5] = angle[0] * sh[5] + angle[1] * sh[7];
  result[6] = sh[6];
  result[7] = angle[0] * sh[7] - angle[1] * sh[5];
  result[8] = t0 * sh[8] - t2 * sh[4];
}
#endif

#ifndef ZONAL_PREPARE_ROTATION_2
#define ZONAL_PREPARE_ROTATION_2
// What rotate takes: cosines and sines of m = 1, 2, ... of three turns. By a quaternion, w first, of any length but 0.
// 45 operations: 10 additions, 18 multiplications, 3 divisions, 2 square roots, 12 comparisons and choices.
ZONAL_FUNCTION void zonal_prepare_rotation_2(const float (&quaternion)[4], float (&turns)[6]) {
  const float t0 = quaternion[0] * quaternion[0] + quaternion[3] * quaternion[3];
  const bool is_1 = 1.1754944e-38f < t0;
  const float t2 = is_1 ? 1.0f / sqrtf(is_1 ? t0 : 1.0f) : 0.0f;
  const bool is_3 = 0.0f < t2;
  const float t4 = is_3 ? quaternion[0] * t2 : 1.0f;
  const float t5 = quaternion[1] * quaternion[1] + quaternion[2] * quaternion[2];
  const bool is_6 = 1.1754944e-38f < t5;
  const float t7 = is_6 ? 1.0f / sqrtf(is_6 ? t5 : 1.0f) : 0.0f;
  const bool is_8 = 0.0f < t7;
  const float t9 = is_8 ? quaternion[2] * t7 : 1.0f;
  const float t10 = t4 * t9;
  const float t11 = is_3 ? quaternion[3] * t2 : 0.0f;
  const float t12 = is_8 ? -(quaternion[1] * t7) : 0.0f;
  const float t13 = t11 * t12;
  turns[0] = t10 + t13;
  const float t14 = t11 * t9;
  const float t15 = t4 * t12;
  turns[1] = t14 - t15;
  const float t16 = 1.0f / (t0 + t5);
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
ZONAL_FUNCTION void zonal_prepare_rotation_3(const float (&quaternion)[4], float (&turns)[12]) {
  const float t0 = quaternion[0] * quaternion[0] + quaternion[3] * quaternion[3];
  const bool is_1 = 1.1754944e-38f < t0;
  const float t2 = is_1 ? 1.0f / sqrtf(is_1 ? t0 : 1.0f) : 0.0f;
  const bool is_3 = 0.0f < t2;
  const float t4 = is_3 ? quaternion[0] * t2 : 1.0f;
  const float t5 = quaternion[1] * quaternion[1] + quaternion[2] * quaternion[2];
  const bool is_6 = 1.1754944e-38f < t5;
  const float t7 = is_6 ? 1.0f / sqrtf(is_6 ? t5 : 1.0f) : 0.0f;
  const bool is_8 = 0.0f < t7;
  const float t9 = is_8 ? quaternion[2] * t7 : 1.0f;
  const float t10 = t4 * t9;
  const float t11 = is_3 ? quaternion[3] * t2 : 0.0f;
  const float t12 = is_8 ? -(quaternion[1] * t7) : 0.0f;
  const float t13 = t11 * t12;
  const float t14 = t10 + t13;
  turns[0] = t14;
  const float t15 = t11 * t9;
  const float t16 = t4 * t12;
  const float t17 = t15 - t16;
  turns[1] = t17;
  turns[2] = t14 * t14 - t17 * t17;
  const float t18 = t14 * t17;
  turns[3] = t18 + t18;
  const float t19 = 1.0f / (t0 + t5);
  const float t20 = (t0 - t5) * t19;
  turns[4] = t20;
  const float t21 = -(2.0f * (t0 * t2) * (t5 * t7) * t19);
  turns[5] = t21;
  turns[6] = t20 * t20 - t21 * t21;
  const float t22 = t20 * t21;
  turns[7] = t22 + t22;
  const float t23 = t10 - t13;
  turns[8] = t23;
  const float t24 = t15 + t16;
  turns[9] = t24;
  turns[10] = t23 * t23 - t24 * t24;
  const float t25 = t23 * t24;
  turns[11] = t25 + t25;
}
#endif

#ifndef ZONAL_ROTATE_2
#define ZONAL_ROTATE_2
// A function rotated, as prepare_rotation prepares it.
// 22 operations: 10 additions, 12 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_rotate_2(const float (&sh)[4], const float (&turns)[6], float (&result)[4]) {
  result[0] = sh[0];
  const float t0 = -(-(turns[0] * sh[1] + turns[1] * sh[3]));
  const float t1 = turns[0] * sh[3] - turns[1] * sh[1];
  const float t2 = -sh[2];
  const float t3 = turns[2] * t1 - turns[3] * t2;
  result[1] = turns[4] * t0 + turns[5] * t3;
  result[2] = -(turns[2] * t2 + turns[3] * t1);
  result[3] = turns[4] * t3 - turns[5] * t0;
}
#endif

#ifndef ZONAL_ROTATE_3
#define ZONAL_ROTATE_3
// A function rotated, as prepare_rotation prepares it.
// 74 operations: 26 additions, 48 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_rotate_3(const float (&sh)[9], const float (&turns)[12], float (&result)[9]) {
  result[0] = sh[0];
  const float t0 = -(-(turns[0] * sh[1] + turns[1] * sh[3]));
  const float t1 = turns[0] * sh[3] - turns[1] * sh[1];
  const float t2 = -sh[2];
  const float t3 = turns[4] * t1 - turns[5] * t2;
  result[1] = turns[8] * t0 + turns[9] * t3;
  result[2] = -(turns[4] * t2 + turns[5] * t1);
  result[3] = turns[8] * t3 - turns[9] * t0;
  const float t4 = -1.0f * (turns[2] * sh[4] + turns[3] * sh[8]);
  const float t5 = turns[0] * sh[5] + turns[1] * sh[7];
  const float t6 = -1.0f * (turns[4] * t4 - turns[5] * t5);
  const float t7 = turns[2] * sh[8] - turns[3] * sh[4];
  const float t8 = -0.5f * sh[6] + -0.8660254f * t7;
  const float t9 = -0.8660254f * sh[6] + 0.5f * t7;
  const float t10 = -1.0f * (turns[0] * sh[7] - turns[1] * sh[5]);
  const float t11 = turns[6] * t9 - turns[7] * t10;
  const float t12 = -0.8660254f * t8 + 0.5f * t11;
  result[4] = turns[10] * t6 + turns[11] * t12;
  const float t13 = turns[4] * t5 + turns[5] * t4;
  const float t14 = -1.0f * (turns[6] * t10 + turns[7] * t9);
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
ZONAL_FUNCTION void zonal_rotate_colour_2(const float (&sh)[4][3], const float (&turns)[6], float (&result)[4][3]) {
  result[0][0] = sh[0][0];
  result[0][1] = sh[0][1];
  result[0][2] = sh[0][2];
  const float t0 = -(-(turns[0] * sh[1][0] + turns[1] * sh[3][0]));
  const float t1 = turns[0] * sh[3][0] - turns[1] * sh[1][0];
  const float t2 = -sh[2][0];
  const float t3 = turns[2] * t1 - turns[3] * t2;
  result[1][0] = turns[4] * t0 + turns[5] * t3;
  const float t4 = -(-(turns[0] * sh[1][1] + turns[1] * sh[3][1]));
  const float t5 = turns[0] * sh[3][1] - turns[1] * sh[1][1];
  const float t6 = -sh[2][1];
  const float t7 = turns[2] * t5 - turns[3] * t6;
  result[1][1] = turns[4] * t4 + turns[5] * t7;
  const float t8 = -(-(turns[0] * sh[1][2] + turns[1] * sh[3][2]));
  const float t9 = turns[0] * sh[3][2] - turns[1] * sh[1][2];
  const float t10 = -sh[2][2];
  const float t11 = turns[2] * t9 - turns[3] * t10;
  result[1][2] = turns[4] * t8 + turns[5] * t11;
  result[2][0] = -(turns[2] * t2 + turns[3] * t1);
  result[2][1] = -(turns[2] * t6 + turns[3] * t5);
  result[2][2] = -(turns[2] * t10 + turns[3] * t9);
  result[3][0] = turns[4] * t3 - turns[5] * t0;
  result[3][1] = turns[4] * t7 - turns[5] * t4;
  result[3][2] = turns[4] * t11 - turns[5] * t8;
}
#endif

#ifndef ZONAL_ROTATE_COLOUR_3
#define ZONAL_ROTATE_COLOUR_3
// A function rotated, as prepare_rotation prepares it. For colours.
// 222 operations: 78 additions, 144 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_rotate_colour_3(const float (&sh)[9][3], const float (&turns)[12], float (&result)[9][3]) {
  result[0][0] = sh[0][0];
  result[0][1] = sh[0][1];
  result[0][2] = sh[0][2];
  const float t0 = -(-(turns[0] * sh[1][0] + turns[1] * sh[3][0]));
  const float t1 = turns[0] * sh[3][0] - turns[1] * sh[1][0];
  const float t2 = -sh[2][0];
  const float t3 = turns[4] * t1 - turns[5] * t2;
  result[1][0] = turns[8] * t0 + turns[9] * t3;
  const float t4 = -(-(turns[0] * sh[1][1] + turns[1] * sh[3][1]));
  const float t5 = turns[0] * sh[3][1] - turns[1] * sh[1][1];
  const float t6 = -sh[2][1];
  const float t7 = turns[4] * t5 - turns[5] * t6;
  result[1][1] = turns[8] * t4 + turns[9] * t7;
  const float t8 = -(-(turns[0] * sh[1][2] + turns[1] * sh[3][2]));
  const float t9 = turns[0] * sh[3][2] - turns[1] * sh[1][2];
  const float t10 = -sh[2][2];
  const float t11 = turns[4] * t9 - turns[5] * t10;
  result[1][2] = turns[8] * t8 + turns[9] * t11;
  result[2][0] = -(turns[4] * t2 + turns[5] * t1);
  result[2][1] = -(turns[4] * t6 + turns[5] * t5);
  result[2][2] = -(turns[4] * t10 + turns[5] * t9);
  result[3][0] = turns[8] * t3 - turns[9] * t0;
  result[3][1] = turns[8] * t7 - turns[9] * t4;
  result[3][2] = turns[8] * t11 - turns[9] * t8;
  const float t12 = -1.0f * (turns[2] * sh[4][0] + turns[3] * sh[8][0]);
  const float t13 = turns[0] * sh[5][0] + turns[1] * sh[7][0];
  const float t14 = -1.0f * (turns[4] * t12 - turns[5] * t13);
  const float t15 = turns[2] * sh[8][0] - turns[3] * sh[4][0];
  const float t16 = -0.5f * sh[6][0] + -0.8660254f * t15;
  const float t17 = -0.8660254f * sh[6][0] + 0.5f * t15;
  const float t18 = -1.0f * (turns[0] * sh[7][0] - turns[1] * sh[5][0]);
  const float t19 = turns[6] * t17 - turns[7] * t18;
  const float t20 = -0.8660254f * t16 + 0.5f * t19;
  result[4][0] = turns[10] * t14 + turns[11] * t20;
  const float t21 = -1.0f * (turns[2] * sh[4][1] + turns[3] * sh[8][1]);
  const float t22 = turns[0] * sh[5][1] + turns[1] * sh[7][1];
  const float t23 = -1.0f * (turns[4] * t21 - turns[5] * t22);
  const float t24 = turns[2] * sh[8][1] - turns[3] * sh[4][1];
  const float t25 = -0.5f * sh[6][1] + -0.8660254f * t24;
  const float t26 = -0.8660254f * sh[6][1] + 0.5f * t24;
  const float t27 = -1.0f * (turns[0] * sh[7][1] - turns[1] * sh[5][1]);
  const float t28 = turns[6] * t26 - turns[7] * t27;
  const float t29 = -0.8660254f * t25 + 0.5f * t28;
  result[4][1] = turns[10] * t23 + turns[11] * t29;
  const float t30 = -1.0f * (turns[2] * sh[4][2] + turns[3] * sh[8][2]);
  const float t31 = turns[0] * sh[5][2] + turns[1] * sh[7][2];
  const float t32 = -1.0f * (turns[4] * t30 - turns[5] * t31);
  const float t33 = turns[2] * sh[8][2] - turns[3] * sh[4][2];
  const float t34 = -0.5f * sh[6][2] + -0.8660254f * t33;
  const float t35 = -0.8660254f * sh[6][2] + 0.5f * t33;
  const float t36 = -1.0f * (turns[0] * sh[7][2] - turns[1] * sh[5][2]);
  const float t37 = turns[6] * t35 - turns[7] * t36;
  const float t38 = -0.8660254f * t34 + 0.5f * t37;
  result[4][2] = turns[10] * t32 + turns[11] * t38;
  const float t39 = turns[4] * t13 + turns[5] * t12;
  const float t40 = -1.0f * (turns[6] * t18 + turns[7] * t17);
  result[5][0] = turns[8] * t39 + turns[9] * t40;
  const float t41 = turns[4] * t22 + turns[5] * t21;
  const float t42 = -1.0f * (turns[6] * t27 + turns[7] * t26);
  result[5][1] = turns[8] * t41 + turns[9] * t42;
  const float t43 = turns[4] * t31 + turns[5] * t30;
  const float t44 = -1.0f * (turns[6] * t36 + turns[7] * t35);
  result[5][2] = turns[8] * t43 + turns[9] * t44;
  result[6][0] = -0.5f * t16 + -0.8660254f * t19;
  result[6][1] = -0.5f * t25 + -0.8660254f * t28;
  result[6][2] = -0.5f * t34 + -0.8660254f * t37;
  result[7][0] = turns[8] * t40 - turns[9] * t39;
  result[7][1] = turns[8] * t42 - turns[9] * t41;
  result[7][2] = turns[8] * t44 - turns[9] * t43;
  result[8][0] = turns[10] * t20 - turns[11] * t14;
  result[8][1] = turns[10] * t29 - turns[11] * t23;
  result[8][2] = turns[10] * t38 - turns[11] * t32;
}
#endif

#ifndef ZONAL_PRODUCT_2
#define ZONAL_PRODUCT_2
// The product of two functions, of which the first bands are kept.
// 22 operations: 6 additions, 16 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_product_2(const float (&a)[4], const float (&b)[4], float (&result)[4]) {
  const float t0 = a[0] * b[0] * 0.2820948f + a[2] * b[2] * 0.2820948f + (a[3] * b[3] + a[1] * b[1]) * 0.2820948f;
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
ZONAL_FUNCTION void zonal_product_3(const float (&a)[9], const float (&b)[9], float (&result)[9]) {
  const float t0 = a[2] * b[2];
  const float t1 = a[6] * b[6];
  const float t2 = a[3] * b[3];
  const float t3 = a[1] * b[1];
  const float t4 = t2 + t3;
  const float t5 = a[0] * b[0] * 0.2820948f + t0 * 0.2820948f + t1 * 0.2820948f + t4 * 0.2820948f;
  const float t6 = a[7] * b[7];
  const float t7 = a[5] * b[5];
  const float t8 = t6 + t7;
  const float t9 = a[8] * b[8] + a[4] * b[4];
  result[0] = t5 + t8 * 0.2820948f + t9 * 0.2820948f;
  const float t10 = (a[1] * b[0] + a[0] * b[1]) * 0.2820948f + (a[1] * b[6] + a[6] * b[1]) * -0.12615663f;
  const float t11 = t10 + (a[5] * b[2] + a[2] * b[5]) * 0.21850969f + (a[4] * b[3] + a[3] * b[4] - (a[8] * b[1] + a[1] * b[8])) * 0.21850969f;
  result[1] = t11;
  const float t12 = (a[2] * b[0] + a[0] * b[2]) * 0.2820948f + (a[6] * b[2] + a[2] * b[6]) * 0.25231326f;
  const float t13 = t12 + (a[7] * b[3] + a[3] * b[7] + (a[5] * b[1] + a[1] * b[5])) * 0.21850969f;
  result[2] = t13;
  const float t14 = (a[3] * b[0] + a[0] * b[3]) * 0.2820948f + (a[3] * b[6] + a[6] * b[3]) * -0.12615663f;
  const float t15 = t14 + (a[7] * b[2] + a[2] * b[7]) * 0.21850969f + (a[8] * b[3] + a[3] * b[8] + (a[4] * b[1] + a[1] * b[4])) * 0.21850969f;
  result[3] = t15;
  const float t16 = (a[1] * b[3] + a[3] * b[1]) * 0.21850969f + (a[5] * b[7] + a[7] * b[5]) * 0.15607835f;
  const float t17 = t16 + (a[4] * b[0] + a[0] * b[4]) * 0.2820948f + (a[4] * b[6] + a[6] * b[4]) * -0.18022375f;
  result[4] = t17;
  const float t18 = (a[1] * b[2] + a[2] * b[1]) * 0.21850969f + (a[5] * b[0] + a[0] * b[5]) * 0.2820948f;
  const float t19 = t18 + (a[5] * b[6] + a[6] * b[5]) * 0.090111874f + (a[4] * b[7] + a[7] * b[4] - (a[8] * b[5] + a[5] * b[8])) * 0.15607835f;
  result[5] = t19;
  const float t20 = t0 * 0.25231326f + (a[6] * b[0] + a[0] * b[6]) * 0.2820948f + t1 * 0.18022375f;
  result[6] = t20 + t4 * -0.12615663f + t8 * 0.090111874f + t9 * -0.18022375f;
  const float t21 = (a[3] * b[2] + a[2] * b[3]) * 0.21850969f + (a[7] * b[0] + a[0] * b[7]) * 0.2820948f;
  const float t22 = t21 + (a[7] * b[6] + a[6] * b[7]) * 0.090111874f + (a[8] * b[7] + a[7] * b[8] + (a[4] * b[5] + a[5] * b[4])) * 0.15607835f;
  result[7] = t22;
  const float t23 = (t2 - t3) * 0.21850969f + (t6 - t7) * 0.15607835f + (a[8] * b[0] + a[0] * b[8]) * 0.2820948f;
  result[8] = t23 + (a[8] * b[6] + a[6] * b[8]) * -0.18022375f;
}
#endif

#ifndef ZONAL_PRODUCT_COLOUR_2
#define ZONAL_PRODUCT_COLOUR_2
// The product of two functions, of which the first bands are kept. For colours.
// 66 operations: 18 additions, 48 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_product_colour_2(const float (&a)[4][3], const float (&b)[4], float (&result)[4][3]) {
  const float t0 = a[0][0] * b[0] * 0.2820948f + a[2][0] * b[2] * 0.2820948f + (a[3][0] * b[3] + a[1][0] * b[1]) * 0.2820948f;
  result[0][0] = t0;
  const float t1 = a[0][1] * b[0] * 0.2820948f + a[2][1] * b[2] * 0.2820948f + (a[3][1] * b[3] + a[1][1] * b[1]) * 0.2820948f;
  result[0][1] = t1;
  const float t2 = a[0][2] * b[0] * 0.2820948f + a[2][2] * b[2] * 0.2820948f + (a[3][2] * b[3] + a[1][2] * b[1]) * 0.2820948f;
  result[0][2] = t2;
  result[1][0] = (a[1][0] * b[0] + a[0][0] * b[1]) * 0.2820948f;
  result[1][1] = (a[1][1] * b[0] + a[0][1] * b[1]) * 0.2820948f;
  result[1][2] = (a[1][2] * b[0] + a[0][2] * b[1]) * 0.2820948f;
  result[2][0] = (a[2][0] * b[0] + a[0][0] * b[2]) * 0.2820948f;
  result[2][1] = (a[2][1] * b[0] + a[0][1] * b[2]) * 0.2820948f;
  result[2][2] = (a[2][2] * b[0] + a[0][2] * b[2]) * 0.2820948f;
  result[3][0] = (a[3][0] * b[0] + a[0][0] * b[3]) * 0.2820948f;
  result[3][1] = (a[3][1] * b[0] + a[0][1] * b[3]) * 0.2820948f;
  result[3][2] = (a[3][2] * b[0] + a[0][2] * b[3]) * 0.2820948f;
}
#endif

#ifndef ZONAL_PRODUCT_COLOUR_3
#define ZONAL_PRODUCT_COLOUR_3
// The product of two functions, of which the first bands are kept. For colours.
// 543 operations: 213 additions, 330 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_product_colour_3(const float (&a)[9][3], const float (&b)[9], float (&result)[9][3]) {
  const float t0 = a[2][0] * b[2];
  const float t1 = a[6][0] * b[6];
  const float t2 = a[3][0] * b[3];
  const float t3 = a[1][0] * b[1];
  const float t4 = t2 + t3;
  const float t5 = a[0][0] * b[0] * 0.2820948f + t0 * 0.2820948f + t1 * 0.2820948f + t4 * 0.2820948f;
  const float t6 = a[7][0] * b[7];
  const float t7 = a[5][0] * b[5];
  const float t8 = t6 + t7;
  const float t9 = a[8][0] * b[8] + a[4][0] * b[4];
  result[0][0] = t5 + t8 * 0.2820948f + t9 * 0.2820948f;
  const float t10 = a[2][1] * b[2];
  const float t11 = a[6][1] * b[6];
  const float t12 = a[3][1] * b[3];
  const float t13 = a[1][1] * b[1];
  const float t14 = t12 + t13;
  const float t15 = a[0][1] * b[0] * 0.2820948f + t10 * 0.2820948f + t11 * 0.2820948f + t14 * 0.2820948f;
  const float t16 = a[7][1] * b[7];
  const float t17 = a[5][1] * b[5];
  const float t18 = t16 + t17;
  const float t19 = a[8][1] * b[8] + a[4][1] * b[4];
  result[0][1] = t15 + t18 * 0.2820948f + t19 * 0.2820948f;
  const float t20 = a[2][2] * b[2];
  const float t21 = a[6][2] * b[6];
  const float t22 = a[3][2] * b[3];
  const float t23 = a[1][2] * b[1];
  const float t24 = t22 + t23;
  const float t25 = a[0][2] * b[0] * 0.2820948f + t20 * 0.2820948f + t21 * 0.2820948f + t24 * 0.2820948f;
  const float t26 = a[7][2] * b[7];
  const float t27 = a[5][2] * b[5];
  const float t28 = t26 + t27;
  const float t29 = a[8][2] * b[8] + a[4][2] * b[4];
  result[0][2] = t25 + t28 * 0.2820948f + t29 * 0.2820948f;
  const float t30 = (a[1][0] * b[0] + a[0][0] * b[1]) * 0.2820948f + (a[1][0] * b[6] + a[6][0] * b[1]) * -0.12615663f;
  const float t31 = (a[4][0] * b[3] + a[3][0] * b[4] - (a[8][0] * b[1] + a[1][0] * b[8])) * 0.21850969f;
  result[1][0] = t30 + (a[5][0] * b[2] + a[2][0] * b[5]) * 0.21850969f + t31;
  const float t32 = (a[1][1] * b[0] + a[0][1] * b[1]) * 0.2820948f + (a[1][1] * b[6] + a[6][1] * b[1]) * -0.12615663f;
  const float t33 = (a[4][1] * b[3] + a[3][1] * b[4] - (a[8][1] * b[1] + a[1][1] * b[8])) * 0.21850969f;
  result[1][1] = t32 + (a[5][1] * b[2] + a[2][1] * b[5]) * 0.21850969f + t33;
  const float t34 = (a[1][2] * b[0] + a[0][2] * b[1]) * 0.2820948f + (a[1][2] * b[6] + a[6][2] * b[1]) * -0.12615663f;
  const float t35 = (a[4][2] * b[3] + a[3][2] * b[4] - (a[8][2] * b[1] + a[1][2] * b[8])) * 0.21850969f;
  result[1][2] = t34 + (a[5][2] * b[2] + a[2][2] * b[5]) * 0.21850969f + t35;
  const float t36 = (a[2][0] * b[0] + a[0][0] * b[2]) * 0.2820948f + (a[6][0] * b[2] + a[2][0] * b[6]) * 0.25231326f;
  const float t37 = (a[7][0] * b[3] + a[3][0] * b[7] + (a[5][0] * b[1] + a[1][0] * b[5])) * 0.21850969f;
  result[2][0] = t36 + t37;
  const float t38 = (a[2][1] * b[0] + a[0][1] * b[2]) * 0.2820948f + (a[6][1] * b[2] + a[2][1] * b[6]) * 0.25231326f;
  const float t39 = (a[7][1] * b[3] + a[3][1] * b[7] + (a[5][1] * b[1] + a[1][1] * b[5])) * 0.21850969f;
  result[2][1] = t38 + t39;
  const float t40 = (a[2][2] * b[0] + a[0][2] * b[2]) * 0.2820948f + (a[6][2] * b[2] + a[2][2] * b[6]) * 0.25231326f;
  const float t41 = (a[7][2] * b[3] + a[3][2] * b[7] + (a[5][2] * b[1] + a[1][2] * b[5])) * 0.21850969f;
  result[2][2] = t40 + t41;
  const float t42 = (a[3][0] * b[0] + a[0][0] * b[3]) * 0.2820948f + (a[3][0] * b[6] + a[6][0] * b[3]) * -0.12615663f;
  const float t43 = (a[8][0] * b[3] + a[3][0] * b[8] + (a[4][0] * b[1] + a[1][0] * b[4])) * 0.21850969f;
  result[3][0] = t42 + (a[7][0] * b[2] + a[2][0] * b[7]) * 0.21850969f + t43;
  const float t44 = (a[3][1] * b[0] + a[0][1] * b[3]) * 0.2820948f + (a[3][1] * b[6] + a[6][1] * b[3]) * -0.12615663f;
  const float t45 = (a[8][1] * b[3] + a[3][1] * b[8] + (a[4][1] * b[1] + a[1][1] * b[4])) * 0.21850969f;
  result[3][1] = t44 + (a[7][1] * b[2] + a[2][1] * b[7]) * 0.21850969f + t45;
  const float t46 = (a[3][2] * b[0] + a[0][2] * b[3]) * 0.2820948f + (a[3][2] * b[6] + a[6][2] * b[3]) * -0.12615663f;
  const float t47 = (a[8][2] * b[3] + a[3][2] * b[8] + (a[4][2] * b[1] + a[1][2] * b[4])) * 0.21850969f;
  result[3][2] = t46 + (a[7][2] * b[2] + a[2][2] * b[7]) * 0.21850969f + t47;
  const float t48 = (a[1][0] * b[3] + a[3][0] * b[1]) * 0.21850969f + (a[5][0] * b[7] + a[7][0] * b[5]) * 0.15607835f;
  const float t49 = t48 + (a[4][0] * b[0] + a[0][0] * b[4]) * 0.2820948f + (a[4][0] * b[6] + a[6][0] * b[4]) * -0.18022375f;
  result[4][0] = t49;
  const float t50 = (a[1][1] * b[3] + a[3][1] * b[1]) * 0.21850969f + (a[5][1] * b[7] + a[7][1] * b[5]) * 0.15607835f;
  const float t51 = t50 + (a[4][1] * b[0] + a[0][1] * b[4]) * 0.2820948f + (a[4][1] * b[6] + a[6][1] * b[4]) * -0.18022375f;
  result[4][1] = t51;
  const float t52 = (a[1][2] * b[3] + a[3][2] * b[1]) * 0.21850969f + (a[5][2] * b[7] + a[7][2] * b[5]) * 0.15607835f;
  const float t53 = t52 + (a[4][2] * b[0] + a[0][2] * b[4]) * 0.2820948f + (a[4][2] * b[6] + a[6][2] * b[4]) * -0.18022375f;
  result[4][2] = t53;
  const float t54 = (a[1][0] * b[2] + a[2][0] * b[1]) * 0.21850969f + (a[5][0] * b[0] + a[0][0] * b[5]) * 0.2820948f;
  const float t55 = (a[4][0] * b[7] + a[7][0] * b[4] - (a[8][0] * b[5] + a[5][0] * b[8])) * 0.15607835f;
  result[5][0] = t54 + (a[5][0] * b[6] + a[6][0] * b[5]) * 0.090111874f + t55;
  const float t56 = (a[1][1] * b[2] + a[2][1] * b[1]) * 0.21850969f + (a[5][1] * b[0] + a[0][1] * b[5]) * 0.2820948f;
  const float t57 = (a[4][1] * b[7] + a[7][1] * b[4] - (a[8][1] * b[5] + a[5][1] * b[8])) * 0.15607835f;
  result[5][1] = t56 + (a[5][1] * b[6] + a[6][1] * b[5]) * 0.090111874f + t57;
  const float t58 = (a[1][2] * b[2] + a[2][2] * b[1]) * 0.21850969f + (a[5][2] * b[0] + a[0][2] * b[5]) * 0.2820948f;
  const float t59 = (a[4][2] * b[7] + a[7][2] * b[4] - (a[8][2] * b[5] + a[5][2] * b[8])) * 0.15607835f;
  result[5][2] = t58 + (a[5][2] * b[6] + a[6][2] * b[5]) * 0.090111874f + t59;
  const float t60 = t0 * 0.25231326f + (a[6][0] * b[0] + a[0][0] * b[6]) * 0.2820948f + t1 * 0.18022375f;
  result[6][0] = t60 + t4 * -0.12615663f + t8 * 0.090111874f + t9 * -0.18022375f;
  const float t61 = t10 * 0.25231326f + (a[6][1] * b[0] + a[0][1] * b[6]) * 0.2820948f + t11 * 0.18022375f;
  result[6][1] = t61 + t14 * -0.12615663f + t18 * 0.090111874f + t19 * -0.18022375f;
  const float t62 = t20 * 0.25231326f + (a[6][2] * b[0] + a[0][2] * b[6]) * 0.2820948f + t21 * 0.18022375f;
  result[6][2] = t62 + t24 * -0.12615663f + t28 * 0.090111874f + t29 * -0.18022375f;
  const float t63 = (a[3][0] * b[2] + a[2][0] * b[3]) * 0.21850969f + (a[7][0] * b[0] + a[0][0] * b[7]) * 0.2820948f;
  const float t64 = (a[8][0] * b[7] + a[7][0] * b[8] + (a[4][0] * b[5] + a[5][0] * b[4])) * 0.15607835f;
  result[7][0] = t63 + (a[7][0] * b[6] + a[6][0] * b[7]) * 0.090111874f + t64;
  const float t65 = (a[3][1] * b[2] + a[2][1] * b[3]) * 0.21850969f + (a[7][1] * b[0] + a[0][1] * b[7]) * 0.2820948f;
  const float t66 = (a[8][1] * b[7] + a[7][1] * b[8] + (a[4][1] * b[5] + a[5][1] * b[4])) * 0.15607835f;
  result[7][1] = t65 + (a[7][1] * b[6] + a[6][1] * b[7]) * 0.090111874f + t66;
  const float t67 = (a[3][2] * b[2] + a[2][2] * b[3]) * 0.21850969f + (a[7][2] * b[0] + a[0][2] * b[7]) * 0.2820948f;
  const float t68 = (a[8][2] * b[7] + a[7][2] * b[8] + (a[4][2] * b[5] + a[5][2] * b[4])) * 0.15607835f;
  result[7][2] = t67 + (a[7][2] * b[6] + a[6][2] * b[7]) * 0.090111874f + t68;
  const float t69 = (t2 - t3) * 0.21850969f + (t6 - t7) * 0.15607835f + (a[8][0] * b[0] + a[0][0] * b[8]) * 0.2820948f;
  result[8][0] = t69 + (a[8][0] * b[6] + a[6][0] * b[8]) * -0.18022375f;
  const float t70 = (t12 - t13) * 0.21850969f + (t16 - t17) * 0.15607835f + (a[8][1] * b[0] + a[0][1] * b[8]) * 0.2820948f;
  result[8][1] = t70 + (a[8][1] * b[6] + a[6][1] * b[8]) * -0.18022375f;
  const float t71 = (t22 - t23) * 0.21850969f + (t26 - t27) * 0.15607835f + (a[8][2] * b[0] + a[0][2] * b[8]) * 0.2820948f;
  result[8][2] = t71 + (a[8][2] * b[6] + a[6][2] * b[8]) * -0.18022375f;
}
#endif

#ifndef ZONAL_TRIPLE_PRODUCT_2
#define ZONAL_TRIPLE_PRODUCT_2
// The integral of the product of three functions.
// 29 operations: 9 additions, 20 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_triple_product_2(const float (&a)[4], const float (&b)[4], const float (&c)[4]) {
  const float t0 = a[0] * b[0] * 0.2820948f + a[2] * b[2] * 0.2820948f + (a[3] * b[3] + a[1] * b[1]) * 0.2820948f;
  const float t1 = (a[2] * b[0] + a[0] * b[2]) * 0.2820948f * c[2] + (a[3] * b[0] + a[0] * b[3]) * 0.2820948f * c[3];
  const float value = t0 * c[0] + (a[1] * b[0] + a[0] * b[1]) * 0.2820948f * c[1] + t1;
  return value;
}
#endif

#ifndef ZONAL_TRIPLE_PRODUCT_3
#define ZONAL_TRIPLE_PRODUCT_3
// The integral of the product of three functions.
// 198 operations: 79 additions, 119 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_triple_product_3(const float (&a)[9], const float (&b)[9], const float (&c)[9]) {
  const float t0 = a[2] * b[2];
  const float t1 = a[6] * b[6];
  const float t2 = a[3] * b[3];
  const float t3 = a[1] * b[1];
  const float t4 = t2 + t3;
  const float t5 = a[0] * b[0] * 0.2820948f + t0 * 0.2820948f + t1 * 0.2820948f + t4 * 0.2820948f;
  const float t6 = a[7] * b[7];
  const float t7 = a[5] * b[5];
  const float t8 = t6 + t7;
  const float t9 = a[8] * b[8] + a[4] * b[4];
  const float t10 = (a[1] * b[3] + a[3] * b[1]) * 0.21850969f + (a[5] * b[7] + a[7] * b[5]) * 0.15607835f;
  const float t11 = t10 + (a[4] * b[0] + a[0] * b[4]) * 0.2820948f + (a[4] * b[6] + a[6] * b[4]) * -0.18022375f;
  const float t12 = (t2 - t3) * 0.21850969f + (t6 - t7) * 0.15607835f + (a[8] * b[0] + a[0] * b[8]) * 0.2820948f;
  const float t13 = (t5 + t8 * 0.2820948f + t9 * 0.2820948f) * c[0] + t11 * c[4] + (t12 + (a[8] * b[6] + a[6] * b[8]) * -0.18022375f) * c[8];
  const float t14 = (a[1] * b[0] + a[0] * b[1]) * 0.2820948f + (a[1] * b[6] + a[6] * b[1]) * -0.12615663f;
  const float t15 = t14 + (a[5] * b[2] + a[2] * b[5]) * 0.21850969f + (a[4] * b[3] + a[3] * b[4] - (a[8] * b[1] + a[1] * b[8])) * 0.21850969f;
  const float t16 = (a[1] * b[2] + a[2] * b[1]) * 0.21850969f + (a[5] * b[0] + a[0] * b[5]) * 0.2820948f;
  const float t17 = t16 + (a[5] * b[6] + a[6] * b[5]) * 0.090111874f + (a[4] * b[7] + a[7] * b[4] - (a[8] * b[5] + a[5] * b[8])) * 0.15607835f;
  const float t18 = (a[2] * b[0] + a[0] * b[2]) * 0.2820948f + (a[6] * b[2] + a[2] * b[6]) * 0.25231326f;
  const float t19 = t18 + (a[7] * b[3] + a[3] * b[7] + (a[5] * b[1] + a[1] * b[5])) * 0.21850969f;
  const float t20 = t0 * 0.25231326f + (a[6] * b[0] + a[0] * b[6]) * 0.2820948f + t1 * 0.18022375f;
  const float t21 = (t20 + t4 * -0.12615663f + t8 * 0.090111874f + t9 * -0.18022375f) * c[6];
  const float t22 = (a[3] * b[0] + a[0] * b[3]) * 0.2820948f + (a[3] * b[6] + a[6] * b[3]) * -0.12615663f;
  const float t23 = t22 + (a[7] * b[2] + a[2] * b[7]) * 0.21850969f + (a[8] * b[3] + a[3] * b[8] + (a[4] * b[1] + a[1] * b[4])) * 0.21850969f;
  const float t24 = (a[3] * b[2] + a[2] * b[3]) * 0.21850969f + (a[7] * b[0] + a[0] * b[7]) * 0.2820948f;
  const float t25 = t24 + (a[7] * b[6] + a[6] * b[7]) * 0.090111874f + (a[8] * b[7] + a[7] * b[8] + (a[4] * b[5] + a[5] * b[4])) * 0.15607835f;
  const float t26 = t13 + (t15 * c[1] + t17 * c[5]) + (t19 * c[2] + t21 + (t23 * c[3] + t25 * c[7]));
  const float value = t26;
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_SEVEN_VECTORS
#define ZONAL_RECONSTRUCT_SEVEN_VECTORS
// Irradiance over pi of one channel of Unity's or Unreal's seven vectors, at a normal.
// 23 operations: 9 additions, 14 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_reconstruct_seven_vectors(const float (&a)[4], const float (&b)[4], float c,
    const float (&normal)[3]) {
  const float t0 = b[0] * (normal[0] * normal[1]) + b[1] * (normal[1] * normal[2]) + b[2] * (normal[2] * normal[2]);
  const float t1 = a[0] * normal[0] + a[1] * normal[1] + a[2] * normal[2] + a[3] + (t0 + b[3] * (normal[2] * normal[0]));
  const float value = t1 + c * (normal[0] * normal[0] - normal[1] * normal[1]);
  return value;
}
#endif

#ifndef ZONAL_RECONSTRUCT_NINE_POLYNOMIALS_COLOUR
#define ZONAL_RECONSTRUCT_NINE_POLYNOMIALS_COLOUR
// Irradiance over pi of Babylon.js' polynomial, x y z xx yy zz yz zx xy, at a normal. For colours.
// 57 operations: 24 additions, 33 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_reconstruct_nine_polynomials_colour(const float (&polynomial)[9][3],
    const float (&normal)[3], float (&value)[3]) {
  const float t0 = polynomial[0][0] * normal[0] + polynomial[1][0] * normal[1] + polynomial[2][0] * normal[2];
  const float t1 = normal[0] * normal[0];
  const float t2 = normal[1] * normal[1];
  const float t3 = normal[2] * normal[2];
  const float t4 = t0 + polynomial[3][0] * t1 + polynomial[4][0] * t2 + polynomial[5][0] * t3;
  const float t5 = normal[1] * normal[2];
  const float t6 = normal[2] * normal[0];
  const float t7 = normal[0] * normal[1];
  const float t8 = t4 + polynomial[6][0] * t5 + polynomial[7][0] * t6 + polynomial[8][0] * t7;
  value[0] = t8;
  const float t9 = polynomial[0][1] * normal[0] + polynomial[1][1] * normal[1] + polynomial[2][1] * normal[2];
  const float t10 = t9 + polynomial[3][1] * t1 + polynomial[4][1] * t2 + polynomial[5][1] * t3;
  const float t11 = t10 + polynomial[6][1] * t5 + polynomial[7][1] * t6 + polynomial[8][1] * t7;
  value[1] = t11;
  const float t12 = polynomial[0][2] * normal[0] + polynomial[1][2] * normal[1] + polynomial[2][2] * normal[2];
  const float t13 = t12 + polynomial[3][2] * t1 + polynomial[4][2] * t2 + polynomial[5][2] * t3;
  const float t14 = t13 + polynomial[6][2] * t5 + polynomial[7][2] * t6 + polynomial[8][2] * t7;
  value[2] = t14;
}
#endif

#ifndef ZONAL_RECONSTRUCT_POLYNOMIALS_COLOUR
#define ZONAL_RECONSTRUCT_POLYNOMIALS_COLOUR
// The value of plain polynomials, 1 y z x xy yz 3zz-1 xz xx-yy, as Filament's shaders and Unity's nine have it. For colours.
// 57 operations: 26 additions, 31 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_reconstruct_polynomials_colour(const float (&polynomials)[9][3], const float (&normal)[3],
    float (&value)[3]) {
  const float t0 = polynomials[0][0] + polynomials[1][0] * normal[1] + polynomials[2][0] * normal[2];
  const float t1 = normal[0] * normal[1];
  const float t2 = normal[1] * normal[2];
  const float t3 = t0 + polynomials[3][0] * normal[0] + polynomials[4][0] * t1 + polynomials[5][0] * t2;
  const float t4 = 3.0f * (normal[2] * normal[2]) - 1.0f;
  const float t5 = normal[0] * normal[2];
  const float t6 = normal[0] * normal[0] - normal[1] * normal[1];
  const float t7 = t3 + polynomials[6][0] * t4 + polynomials[7][0] * t5 + polynomials[8][0] * t6;
  value[0] = t7;
  const float t8 = polynomials[0][1] + polynomials[1][1] * normal[1] + polynomials[2][1] * normal[2];
  const float t9 = t8 + polynomials[3][1] * normal[0] + polynomials[4][1] * t1 + polynomials[5][1] * t2;
  const float t10 = t9 + polynomials[6][1] * t4 + polynomials[7][1] * t5 + polynomials[8][1] * t6;
  value[1] = t10;
  const float t11 = polynomials[0][2] + polynomials[1][2] * normal[1] + polynomials[2][2] * normal[2];
  const float t12 = t11 + polynomials[3][2] * normal[0] + polynomials[4][2] * t1 + polynomials[5][2] * t2;
  const float t13 = t12 + polynomials[6][2] * t4 + polynomials[7][2] * t5 + polynomials[8][2] * t6;
  value[2] = t13;
}
#endif

#ifndef ZONAL_LINEAR_AXIS
#define ZONAL_LINEAR_AXIS
// Where the light of two bands comes from, a unit vector; z where from nowhere.
// 16 operations: 4 additions, 3 multiplications, 3 divisions, 1 square roots, 5 comparisons and choices.
ZONAL_FUNCTION void zonal_linear_axis(const float (&radiance)[4], float (&axis)[3]) {
  const float t0 = -radiance[3];
  const float t1 = -radiance[1];
  const float t2 = t0 * t0 + t1 * t1 + radiance[2] * radiance[2];
  const bool is_3 = t2 < 1e-30f;
  const float t4 = sqrtf(t2 < 1e-30f ? 1e-30f : t2);
  axis[0] = is_3 ? 0.0f : t0 / t4;
  axis[1] = is_3 ? 0.0f : t1 / t4;
  axis[2] = is_3 ? 1.0f : radiance[2] / t4;
}
#endif

#ifndef ZONAL_HALLUCINATE_ZH3
#define ZONAL_HALLUCINATE_ZH3
// ZH3's quadratic coefficient, guessed from two bands and their axis.
// 13 operations: 5 additions, 5 multiplications, 1 divisions, 0 square roots, 2 comparisons and choices.
ZONAL_FUNCTION float zonal_hallucinate_zh3(const float (&radiance)[4], const float (&axis)[3]) {
  const float t0 = fabsf(-radiance[3] * axis[0] + -radiance[1] * axis[1] + radiance[2] * axis[2]);
  const float t1 = t0 * (0.08f + 0.6f * (t0 / (radiance[0] < 1e-30f ? 1e-30f : radiance[0])));
  const float zonal = t1;
  return zonal;
}
#endif

#ifndef ZONAL_HALLUCINATE_ZH3_COLOUR
#define ZONAL_HALLUCINATE_ZH3_COLOUR
// ZH3's quadratic coefficient, guessed from two bands and their axis. For colours.
// 39 operations: 15 additions, 15 multiplications, 3 divisions, 0 square roots, 6 comparisons and choices.
ZONAL_FUNCTION void zonal_hallucinate_zh3_colour(const float (&radiance)[4][3], const float (&axis)[3],
    float (&zonal)[3]) {
  const float t0 = -radiance[3][0] * axis[0] + -radiance[1][0] * axis[1] + radiance[2][0] * axis[2];
  const float t1 = fabsf(t0);
  const float t2 = 0.08f + 0.6f * (t1 / (radiance[0][0] < 1e-30f ? 1e-30f : radiance[0][0]));
  zonal[0] = t1 * t2;
  const float t3 = -radiance[3][1] * axis[0] + -radiance[1][1] * axis[1] + radiance[2][1] * axis[2];
  const float t4 = fabsf(t3);
  const float t5 = 0.08f + 0.6f * (t4 / (radiance[0][1] < 1e-30f ? 1e-30f : radiance[0][1]));
  zonal[1] = t4 * t5;
  const float t6 = -radiance[3][2] * axis[0] + -radiance[1][2] * axis[1] + radiance[2][2] * axis[2];
  const float t7 = fabsf(t6);
  const float t8 = 0.08f + 0.6f * (t7 / (radiance[0][2] < 1e-30f ? 1e-30f : radiance[0][2]));
  zonal[2] = t7 * t8;
}
#endif

#ifndef ZONAL_IRRADIANCE_ZH3
#define ZONAL_IRRADIANCE_ZH3
// Irradiance over pi of ZH3, radiance of two bands and one quadratic about an axis.
// 23 operations: 7 additions, 16 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_irradiance_zh3(const float (&radiance)[4], float zonal, const float (&axis)[3],
    const float (&normal)[3]) {
  const float t0 = radiance[2] * (0.48860252f * normal[2]) + radiance[1] * (-0.48860252f * normal[1]);
  const float t1 = radiance[0] * 0.2820948f + (t0 + radiance[3] * (-0.48860252f * normal[0])) * 0.6666667f;
  const float t2 = axis[0] * normal[0] + axis[1] * normal[1] + axis[2] * normal[2];
  const float value = t1 + 0.25f * (zonal * (0.31539157f * (3.0f * t2 * t2 - 1.0f)));
  return value;
}
#endif

#ifndef ZONAL_IRRADIANCE_ZH3_COLOUR
#define ZONAL_IRRADIANCE_ZH3_COLOUR
// Irradiance over pi of ZH3, radiance of two bands and one quadratic about an axis. For colours.
// 45 operations: 15 additions, 30 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION void zonal_irradiance_zh3_colour(const float (&radiance)[4][3], const float (&zonal)[3],
    const float (&axis)[3], const float (&normal)[3], float (&value)[3]) {
  const float t0 = 0.48860252f * normal[2];
  const float t1 = -0.48860252f * normal[1];
  const float t2 = -0.48860252f * normal[0];
  const float t3 = (radiance[2][0] * t0 + radiance[1][0] * t1 + radiance[3][0] * t2) * 0.6666667f;
  const float t4 = axis[0] * normal[0] + axis[1] * normal[1] + axis[2] * normal[2];
  const float t5 = 0.31539157f * (3.0f * t4 * t4 - 1.0f);
  value[0] = radiance[0][0] * 0.2820948f + t3 + 0.25f * (zonal[0] * t5);
  const float t6 = (radiance[2][1] * t0 + radiance[1][1] * t1 + radiance[3][1] * t2) * 0.6666667f;
  value[1] = radiance[0][1] * 0.2820948f + t6 + 0.25f * (zonal[1] * t5);
  const float t7 = (radiance[2][2] * t0 + radiance[1][2] * t1 + radiance[3][2] * t2) * 0.6666667f;
  value[2] = radiance[0][2] * 0.2820948f + t7 + 0.25f * (zonal[2] * t5);
}
#endif

#ifndef ZONAL_IRRADIANCE_NONLINEAR
#define ZONAL_IRRADIANCE_NONLINEAR
// Irradiance over pi of radiance of two bands, Geomerics' positive curve.
// 157 operations: 43 additions, 41 multiplications, 7 divisions, 1 square roots, 65 comparisons and choices.
ZONAL_FUNCTION float zonal_irradiance_nonlinear(const float (&radiance)[4], const float (&normal)[3]) {
  const float t0 = -radiance[3];
  const float t1 = -radiance[1];
  const float t2 = t0 * t0 + t1 * t1 + radiance[2] * radiance[2];
  const bool is_3 = t2 < 1e-30f;
  const float t4 = sqrtf(t2 < 1e-30f ? 1e-30f : t2);
  const float t5 = 0.57735026f * (is_3 ? 0.0f : t4) / (radiance[0] < 1e-30f ? 1e-30f : radiance[0]);
  const float t6 = 1.0f < t5 ? 1.0f : t5;
  const float t7 = 1.0f + t6;
  const float t8 = (1.0f - t6) / t7;
  const float t9 = t7 + t6;
  const float t10 = (is_3 ? 0.0f : t0 / t4) * normal[0] + (is_3 ? 0.0f : t1 / t4) * normal[1];
  const float t11 = 0.5f + 0.5f * (t10 + (is_3 ? 1.0f : radiance[2] / t4) * normal[2]);
  const float t12 = t11 < 0.0f ? 0.0f : t11;
  const float t13 = 1.0f < t12 ? 1.0f : t12;
  const float t14 = t13 < 1.0842022e-19f ? 1.0842022e-19f : t13;
  const bool is_15 = t14 < 2.3283064e-10f;
  const float t16 = is_15 ? t14 * 4294967296.0f : t14;
  const bool is_17 = t16 < 1.5258789e-05f;
  const float t18 = is_17 ? t16 * 65536.0f : t16;
  const bool is_19 = t18 < 0.00390625f;
  const float t20 = is_19 ? t18 * 256.0f : t18;
  const bool is_21 = t20 < 0.0625f;
  const float t22 = is_21 ? t20 * 16.0f : t20;
  const bool is_23 = t22 < 0.25f;
  const float t24 = is_23 ? t22 * 4.0f : t22;
  const bool is_25 = t24 < 0.5f;
  const float t26 = is_25 ? t24 * 2.0f : t24;
  const bool is_27 = t26 < 0.70710677f;
  const float t28 = is_15 ? -32.0f : 0.0f;
  const float t29 = is_17 ? t28 - 16.0f : t28;
  const float t30 = is_19 ? t29 - 8.0f : t29;
  const float t31 = is_21 ? t30 - 4.0f : t30;
  const float t32 = is_23 ? t31 - 2.0f : t31;
  const float t33 = is_25 ? t32 - 1.0f : t32;
  const float t34 = is_27 ? t26 + t26 : t26;
  const float t35 = (t34 - 1.0f) / (t34 + 1.0f);
  const float t36 = t35 * t35;
  const float t37 = (((0.11111111f * t36 + 0.14285715f) * t36 + 0.2f) * t36 + 0.33333334f) * t36;
  const float t38 = t9 * ((is_27 ? t33 - 1.0f : t33) * 0.6931472f + (t35 + t35) * (t37 + 1.0f));
  const float t39 = fabsf(t38);
  const float t40 = 105.35837f < t39 ? 105.35837f : t39;
  const bool is_41 = 64.0f <= t40;
  const bool is_42 = t38 < 0.0f;
  const float t43 = is_41 ? t40 - 64.0f : t40;
  const bool is_44 = 32.0f <= t43;
  const float t45 = is_44 ? t43 - 32.0f : t43;
  const bool is_46 = 16.0f <= t45;
  const float t47 = is_46 ? t45 - 16.0f : t45;
  const bool is_48 = 8.0f <= t47;
  const float t49 = is_48 ? t47 - 8.0f : t47;
  const bool is_50 = 4.0f <= t49;
  const float t51 = is_50 ? t49 - 4.0f : t49;
  const bool is_52 = 2.0f <= t51;
  const float t53 = is_52 ? t51 - 2.0f : t51;
  const bool is_54 = 1.0f <= t53;
  const float t55 = is_54 ? t53 - 1.0f : t53;
  const bool is_56 = 0.5f <= t55;
  const float t57 = is_56 ? t55 - 0.5f : t55;
  const bool is_58 = 0.25f <= t57;
  const float t59 = is_44 ? 1.2664166e-14f : 1.0f;
  const float t60 = is_46 ? t59 * 1.12535176e-07f : t59;
  const float t61 = is_48 ? t60 * 0.00033546262f : t60;
  const float t62 = is_50 ? t61 * 0.01831564f : t61;
  const float t63 = is_52 ? t62 * 0.13533528f : t62;
  const float t64 = is_54 ? t63 * 0.36787945f : t63;
  const float t65 = is_56 ? t64 * 0.60653067f : t64;
  const float t66 = is_58 ? t57 - 0.25f : t57;
  const float t67 = 0.16666667f - t66 * (0.041666668f - t66 * (0.008333334f - t66 * 0.0013888889f));
  const float t68 = (is_58 ? t65 * 0.7788008f : t65) * (1.0f - t66 * (1.0f - t66 * (0.5f - t66 * t67)));
  const float t69 = is_42 ? t68 : 1.0f / t68;
  const float t70 = (1.0f - t8) * (t9 + 1.0f) * (is_41 ? t69 * (is_42 ? 1.6038109e-28f : 6.235149e+27f) : t69);
  const float value = (radiance[0] < 0.0f ? 0.0f : radiance[0]) * 0.2820948f * (t8 + t70);
  return value;
}
#endif

#ifndef ZONAL_IRRADIANCE_NONLINEAR_COLOUR
#define ZONAL_IRRADIANCE_NONLINEAR_COLOUR
// Irradiance over pi of radiance of two bands, Geomerics' positive curve. For colours.
// 471 operations: 129 additions, 123 multiplications, 21 divisions, 3 square roots, 195 comparisons and choices.
ZONAL_FUNCTION void zonal_irradiance_nonlinear_colour(const float (&radiance)[4][3], const float (&normal)[3],
    float (&value)[3]) {
  const float t0 = -radiance[3][0];
  const float t1 = -radiance[1][0];
  const float t2 = t0 * t0 + t1 * t1 + radiance[2][0] * radiance[2][0];
  const bool is_3 = t2 < 1e-30f;
  const float t4 = sqrtf(t2 < 1e-30f ? 1e-30f : t2);
  const float t5 = 0.57735026f * (is_3 ? 0.0f : t4) / (radiance[0][0] < 1e-30f ? 1e-30f : radiance[0][0]);
  const float t6 = 1.0f < t5 ? 1.0f : t5;
  const float t7 = 1.0f + t6;
  const float t8 = (1.0f - t6) / t7;
  const float t9 = t7 + t6;
  const float t10 = (is_3 ? 0.0f : t0 / t4) * normal[0] + (is_3 ? 0.0f : t1 / t4) * normal[1];
  const float t11 = 0.5f + 0.5f * (t10 + (is_3 ? 1.0f : radiance[2][0] / t4) * normal[2]);
  const float t12 = t11 < 0.0f ? 0.0f : t11;
  const float t13 = 1.0f < t12 ? 1.0f : t12;
  const float t14 = t13 < 1.0842022e-19f ? 1.0842022e-19f : t13;
  const bool is_15 = t14 < 2.3283064e-10f;
  const float t16 = is_15 ? t14 * 4294967296.0f : t14;
  const bool is_17 = t16 < 1.5258789e-05f;
  const float t18 = is_17 ? t16 * 65536.0f : t16;
  const bool is_19 = t18 < 0.00390625f;
  const float t20 = is_19 ? t18 * 256.0f : t18;
  const bool is_21 = t20 < 0.0625f;
  const float t22 = is_21 ? t20 * 16.0f : t20;
  const bool is_23 = t22 < 0.25f;
  const float t24 = is_23 ? t22 * 4.0f : t22;
  const bool is_25 = t24 < 0.5f;
  const float t26 = is_25 ? t24 * 2.0f : t24;
  const bool is_27 = t26 < 0.70710677f;
  const float t28 = is_15 ? -32.0f : 0.0f;
  const float t29 = is_17 ? t28 - 16.0f : t28;
  const float t30 = is_19 ? t29 - 8.0f : t29;
  const float t31 = is_21 ? t30 - 4.0f : t30;
  const float t32 = is_23 ? t31 - 2.0f : t31;
  const float t33 = is_25 ? t32 - 1.0f : t32;
  const float t34 = is_27 ? t26 + t26 : t26;
  const float t35 = (t34 - 1.0f) / (t34 + 1.0f);
  const float t36 = t35 * t35;
  const float t37 = (((0.11111111f * t36 + 0.14285715f) * t36 + 0.2f) * t36 + 0.33333334f) * t36;
  const float t38 = t9 * ((is_27 ? t33 - 1.0f : t33) * 0.6931472f + (t35 + t35) * (t37 + 1.0f));
  const float t39 = fabsf(t38);
  const float t40 = 105.35837f < t39 ? 105.35837f : t39;
  const bool is_41 = 64.0f <= t40;
  const bool is_42 = t38 < 0.0f;
  const float t43 = is_41 ? t40 - 64.0f : t40;
  const bool is_44 = 32.0f <= t43;
  const float t45 = is_44 ? t43 - 32.0f : t43;
  const bool is_46 = 16.0f <= t45;
  const float t47 = is_46 ? t45 - 16.0f : t45;
  const bool is_48 = 8.0f <= t47;
  const float t49 = is_48 ? t47 - 8.0f : t47;
  const bool is_50 = 4.0f <= t49;
  const float t51 = is_50 ? t49 - 4.0f : t49;
  const bool is_52 = 2.0f <= t51;
  const float t53 = is_52 ? t51 - 2.0f : t51;
  const bool is_54 = 1.0f <= t53;
  const float t55 = is_54 ? t53 - 1.0f : t53;
  const bool is_56 = 0.5f <= t55;
  const float t57 = is_56 ? t55 - 0.5f : t55;
  const bool is_58 = 0.25f <= t57;
  const float t59 = is_44 ? 1.2664166e-14f : 1.0f;
  const float t60 = is_46 ? t59 * 1.12535176e-07f : t59;
  const float t61 = is_48 ? t60 * 0.00033546262f : t60;
  const float t62 = is_50 ? t61 * 0.01831564f : t61;
  const float t63 = is_52 ? t62 * 0.13533528f : t62;
  const float t64 = is_54 ? t63 * 0.36787945f : t63;
  const float t65 = is_56 ? t64 * 0.60653067f : t64;
  const float t66 = is_58 ? t57 - 0.25f : t57;
  const float t67 = 0.16666667f - t66 * (0.041666668f - t66 * (0.008333334f - t66 * 0.0013888889f));
  const float t68 = (is_58 ? t65 * 0.7788008f : t65) * (1.0f - t66 * (1.0f - t66 * (0.5f - t66 * t67)));
  const float t69 = is_42 ? t68 : 1.0f / t68;
  const float t70 = (1.0f - t8) * (t9 + 1.0f) * (is_41 ? t69 * (is_42 ? 1.6038109e-28f : 6.235149e+27f) : t69);
  const float t71 = (radiance[0][0] < 0.0f ? 0.0f : radiance[0][0]) * 0.2820948f * (t8 + t70);
  value[0] = t71;
  const float t72 = -radiance[3][1];
  const float t73 = -radiance[1][1];
  const float t74 = t72 * t72 + t73 * t73 + radiance[2][1] * radiance[2][1];
  const bool is_75 = t74 < 1e-30f;
  const float t76 = sqrtf(t74 < 1e-30f ? 1e-30f : t74);
  const float t77 = 0.57735026f * (is_75 ? 0.0f : t76) / (radiance[0][1] < 1e-30f ? 1e-30f : radiance[0][1]);
  const float t78 = 1.0f < t77 ? 1.0f : t77;
  const float t79 = 1.0f + t78;
  const float t80 = (1.0f - t78) / t79;
  const float t81 = t79 + t78;
  const float t82 = (is_75 ? 0.0f : t72 / t76) * normal[0] + (is_75 ? 0.0f : t73 / t76) * normal[1];
  const float t83 = 0.5f + 0.5f * (t82 + (is_75 ? 1.0f : radiance[2][1] / t76) * normal[2]);
  const float t84 = t83 < 0.0f ? 0.0f : t83;
  const float t85 = 1.0f < t84 ? 1.0f : t84;
  const float t86 = t85 < 1.0842022e-19f ? 1.0842022e-19f : t85;
  const bool is_87 = t86 < 2.3283064e-10f;
  const float t88 = is_87 ? t86 * 4294967296.0f : t86;
  const bool is_89 = t88 < 1.5258789e-05f;
  const float t90 = is_89 ? t88 * 65536.0f : t88;
  const bool is_91 = t90 < 0.00390625f;
  const float t92 = is_91 ? t90 * 256.0f : t90;
  const bool is_93 = t92 < 0.0625f;
  const float t94 = is_93 ? t92 * 16.0f : t92;
  const bool is_95 = t94 < 0.25f;
  const float t96 = is_95 ? t94 * 4.0f : t94;
  const bool is_97 = t96 < 0.5f;
  const float t98 = is_97 ? t96 * 2.0f : t96;
  const bool is_99 = t98 < 0.70710677f;
  const float t100 = is_87 ? -32.0f : 0.0f;
  const float t101 = is_89 ? t100 - 16.0f : t100;
  const float t102 = is_91 ? t101 - 8.0f : t101;
  const float t103 = is_93 ? t102 - 4.0f : t102;
  const float t104 = is_95 ? t103 - 2.0f : t103;
  const float t105 = is_97 ? t104 - 1.0f : t104;
  const float t106 = is_99 ? t98 + t98 : t98;
  const float t107 = (t106 - 1.0f) / (t106 + 1.0f);
  const float t108 = t107 * t107;
  const float t109 = (((0.11111111f * t108 + 0.14285715f) * t108 + 0.2f) * t108 + 0.33333334f) * t108;
  const float t110 = (is_99 ? t105 - 1.0f : t105) * 0.6931472f + (t107 + t107) * (t109 + 1.0f);
  const float t111 = t81 * t110;
  const float t112 = fabsf(t111);
  const float t113 = 105.35837f < t112 ? 105.35837f : t112;
  const bool is_114 = 64.0f <= t113;
  const bool is_115 = t111 < 0.0f;
  const float t116 = is_114 ? t113 - 64.0f : t113;
  const bool is_117 = 32.0f <= t116;
  const float t118 = is_117 ? t116 - 32.0f : t116;
  const bool is_119 = 16.0f <= t118;
  const float t120 = is_119 ? t118 - 16.0f : t118;
  const bool is_121 = 8.0f <= t120;
  const float t122 = is_121 ? t120 - 8.0f : t120;
  const bool is_123 = 4.0f <= t122;
  const float t124 = is_123 ? t122 - 4.0f : t122;
  const bool is_125 = 2.0f <= t124;
  const float t126 = is_125 ? t124 - 2.0f : t124;
  const bool is_127 = 1.0f <= t126;
  const float t128 = is_127 ? t126 - 1.0f : t126;
  const bool is_129 = 0.5f <= t128;
  const float t130 = is_129 ? t128 - 0.5f : t128;
  const bool is_131 = 0.25f <= t130;
  const float t132 = is_117 ? 1.2664166e-14f : 1.0f;
  const float t133 = is_119 ? t132 * 1.12535176e-07f : t132;
  const float t134 = is_121 ? t133 * 0.00033546262f : t133;
  const float t135 = is_123 ? t134 * 0.01831564f : t134;
  const float t136 = is_125 ? t135 * 0.13533528f : t135;
  const float t137 = is_127 ? t136 * 0.36787945f : t136;
  const float t138 = is_129 ? t137 * 0.60653067f : t137;
  const float t139 = is_131 ? t130 - 0.25f : t130;
  const float t140 = 0.16666667f - t139 * (0.041666668f - t139 * (0.008333334f - t139 * 0.0013888889f));
  const float t141 = (is_131 ? t138 * 0.7788008f : t138) * (1.0f - t139 * (1.0f - t139 * (0.5f - t139 * t140)));
  const float t142 = is_115 ? t141 : 1.0f / t141;
  const float t143 = (1.0f - t80) * (t81 + 1.0f) * (is_114 ? t142 * (is_115 ? 1.6038109e-28f : 6.235149e+27f) : t142);
  const float t144 = (radiance[0][1] < 0.0f ? 0.0f : radiance[0][1]) * 0.2820948f * (t80 + t143);
  value[1] = t144;
  const float t145 = -radiance[3][2];
  const float t146 = -radiance[1][2];
  const float t147 = t145 * t145 + t146 * t146 + radiance[2][2] * radiance[2][2];
  const bool is_148 = t147 < 1e-30f;
  const float t149 = sqrtf(t147 < 1e-30f ? 1e-30f : t147);
  const float t150 = 0.57735026f * (is_148 ? 0.0f : t149) / (radiance[0][2] < 1e-30f ? 1e-30f : radiance[0][2]);
  const float t151 = 1.0f < t150 ? 1.0f : t150;
  const float t152 = 1.0f + t151;
  const float t153 = (1.0f - t151) / t152;
  const float t154 = t152 + t151;
  const float t155 = (is_148 ? 0.0f : t145 / t149) * normal[0] + (is_148 ? 0.0f : t146 / t149) * normal[1];
  const float t156 = 0.5f + 0.5f * (t155 + (is_148 ? 1.0f : radiance[2][2] / t149) * normal[2]);
  const float t157 = t156 < 0.0f ? 0.0f : t156;
  const float t158 = 1.0f < t157 ? 1.0f : t157;
  const float t159 = t158 < 1.0842022e-19f ? 1.0842022e-19f : t158;
  const bool is_160 = t159 < 2.3283064e-10f;
  const float t161 = is_160 ? t159 * 4294967296.0f : t159;
  const bool is_162 = t161 < 1.5258789e-05f;
  const float t163 = is_162 ? t161 * 65536.0f : t161;
  const bool is_164 = t163 < 0.00390625f;
  const float t165 = is_164 ? t163 * 256.0f : t163;
  const bool is_166 = t165 < 0.0625f;
  const float t167 = is_166 ? t165 * 16.0f : t165;
  const bool is_168 = t167 < 0.25f;
  const float t169 = is_168 ? t167 * 4.0f : t167;
  const bool is_170 = t169 < 0.5f;
  const float t171 = is_170 ? t169 * 2.0f : t169;
  const bool is_172 = t171 < 0.70710677f;
  const float t173 = is_160 ? -32.0f : 0.0f;
  const float t174 = is_162 ? t173 - 16.0f : t173;
  const float t175 = is_164 ? t174 - 8.0f : t174;
  const float t176 = is_166 ? t175 - 4.0f : t175;
  const float t177 = is_168 ? t176 - 2.0f : t176;
  const float t178 = is_170 ? t177 - 1.0f : t177;
  const float t179 = is_172 ? t171 + t171 : t171;
  const float t180 = (t179 - 1.0f) / (t179 + 1.0f);
  const float t181 = t180 * t180;
  const float t182 = (((0.11111111f * t181 + 0.14285715f) * t181 + 0.2f) * t181 + 0.33333334f) * t181;
  const float t183 = (is_172 ? t178 - 1.0f : t178) * 0.6931472f + (t180 + t180) * (t182 + 1.0f);
  const float t184 = t154 * t183;
  const float t185 = fabsf(t184);
  const float t186 = 105.35837f < t185 ? 105.35837f : t185;
  const bool is_187 = 64.0f <= t186;
  const bool is_188 = t184 < 0.0f;
  const float t189 = is_187 ? t186 - 64.0f : t186;
  const bool is_190 = 32.0f <= t189;
  const float t191 = is_190 ? t189 - 32.0f : t189;
  const bool is_192 = 16.0f <= t191;
  const float t193 = is_192 ? t191 - 16.0f : t191;
  const bool is_194 = 8.0f <= t193;
  const float t195 = is_194 ? t193 - 8.0f : t193;
  const bool is_196 = 4.0f <= t195;
  const float t197 = is_196 ? t195 - 4.0f : t195;
  const bool is_198 = 2.0f <= t197;
  const float t199 = is_198 ? t197 - 2.0f : t197;
  const bool is_200 = 1.0f <= t199;
  const float t201 = is_200 ? t199 - 1.0f : t199;
  const bool is_202 = 0.5f <= t201;
  const float t203 = is_202 ? t201 - 0.5f : t201;
  const bool is_204 = 0.25f <= t203;
  const float t205 = is_190 ? 1.2664166e-14f : 1.0f;
  const float t206 = is_192 ? t205 * 1.12535176e-07f : t205;
  const float t207 = is_194 ? t206 * 0.00033546262f : t206;
  const float t208 = is_196 ? t207 * 0.01831564f : t207;
  const float t209 = is_198 ? t208 * 0.13533528f : t208;
  const float t210 = is_200 ? t209 * 0.36787945f : t209;
  const float t211 = is_202 ? t210 * 0.60653067f : t210;
  const float t212 = is_204 ? t203 - 0.25f : t203;
  const float t213 = 0.16666667f - t212 * (0.041666668f - t212 * (0.008333334f - t212 * 0.0013888889f));
  const float t214 = (is_204 ? t211 * 0.7788008f : t211) * (1.0f - t212 * (1.0f - t212 * (0.5f - t212 * t213)));
  const float t215 = is_188 ? t214 : 1.0f / t214;
  const float t216 = (1.0f - t153) * (t154 + 1.0f) * (is_187 ? t215 * (is_188 ? 1.6038109e-28f : 6.235149e+27f) : t215);
  const float t217 = (radiance[0][2] < 0.0f ? 0.0f : radiance[0][2]) * 0.2820948f * (t153 + t216);
  value[2] = t217;
}
#endif

#ifndef ZONAL_IRRADIANCE_SIX_FLOATS
#define ZONAL_IRRADIANCE_SIX_FLOATS
// Irradiance over pi, RGB, of luminance on two bands with Co and Cg.
// 24 operations: 7 additions, 11 multiplications, 1 divisions, 0 square roots, 5 comparisons and choices.
ZONAL_FUNCTION void zonal_irradiance_six_floats(const float (&luminance)[4], float co, float cg,
    const float (&normal)[3], float (&colour)[3]) {
  const float t0 = luminance[2] * (0.48860252f * normal[2]) + luminance[1] * (-0.48860252f * normal[1]);
  const float t1 = luminance[0] * 0.2820948f + (t0 + luminance[3] * (-0.48860252f * normal[0])) * 0.6666667f;
  const float t2 = t1 < 0.0f ? 0.0f : t1;
  const float t3 = 0.5f * (t2 / (luminance[0] < 1e-30f ? 1e-30f : luminance[0]));
  const float t4 = t3 * cg;
  const float t5 = t2 - t4;
  const float t6 = t3 * co;
  const float t7 = t5 + t6;
  colour[0] = t7 < 0.0f ? 0.0f : t7;
  const float t8 = t2 + t4;
  colour[1] = t8 < 0.0f ? 0.0f : t8;
  const float t9 = t5 - t6;
  colour[2] = t9 < 0.0f ? 0.0f : t9;
}
#endif

#ifndef ZONAL_IRRADIANCE_SIX_FLOATS_NONLINEAR
#define ZONAL_IRRADIANCE_SIX_FLOATS_NONLINEAR
// The same by Geomerics' positive curve.
// 168 operations: 47 additions, 44 multiplications, 8 divisions, 1 square roots, 68 comparisons and choices.
ZONAL_FUNCTION void zonal_irradiance_six_floats_nonlinear(const float (&luminance)[4], float co, float cg,
    const float (&normal)[3], float (&colour)[3]) {
  const float t0 = -luminance[3];
  const float t1 = -luminance[1];
  const float t2 = t0 * t0 + t1 * t1 + luminance[2] * luminance[2];
  const bool is_3 = t2 < 1e-30f;
  const float t4 = sqrtf(t2 < 1e-30f ? 1e-30f : t2);
  const float t5 = luminance[0] < 1e-30f ? 1e-30f : luminance[0];
  const float t6 = 0.57735026f * (is_3 ? 0.0f : t4) / t5;
  const float t7 = 1.0f < t6 ? 1.0f : t6;
  const float t8 = 1.0f + t7;
  const float t9 = (1.0f - t7) / t8;
  const float t10 = t8 + t7;
  const float t11 = (is_3 ? 0.0f : t0 / t4) * normal[0] + (is_3 ? 0.0f : t1 / t4) * normal[1];
  const float t12 = 0.5f + 0.5f * (t11 + (is_3 ? 1.0f : luminance[2] / t4) * normal[2]);
  const float t13 = t12 < 0.0f ? 0.0f : t12;
  const float t14 = 1.0f < t13 ? 1.0f : t13;
  const float t15 = t14 < 1.0842022e-19f ? 1.0842022e-19f : t14;
  const bool is_16 = t15 < 2.3283064e-10f;
  const float t17 = is_16 ? t15 * 4294967296.0f : t15;
  const bool is_18 = t17 < 1.5258789e-05f;
  const float t19 = is_18 ? t17 * 65536.0f : t17;
  const bool is_20 = t19 < 0.00390625f;
  const float t21 = is_20 ? t19 * 256.0f : t19;
  const bool is_22 = t21 < 0.0625f;
  const float t23 = is_22 ? t21 * 16.0f : t21;
  const bool is_24 = t23 < 0.25f;
  const float t25 = is_24 ? t23 * 4.0f : t23;
  const bool is_26 = t25 < 0.5f;
  const float t27 = is_26 ? t25 * 2.0f : t25;
  const bool is_28 = t27 < 0.70710677f;
  const float t29 = is_16 ? -32.0f : 0.0f;
  const float t30 = is_18 ? t29 - 16.0f : t29;
  const float t31 = is_20 ? t30 - 8.0f : t30;
  const float t32 = is_22 ? t31 - 4.0f : t31;
  const float t33 = is_24 ? t32 - 2.0f : t32;
  const float t34 = is_26 ? t33 - 1.0f : t33;
  const float t35 = is_28 ? t27 + t27 : t27;
  const float t36 = (t35 - 1.0f) / (t35 + 1.0f);
  const float t37 = t36 * t36;
  const float t38 = (((0.11111111f * t37 + 0.14285715f) * t37 + 0.2f) * t37 + 0.33333334f) * t37;
  const float t39 = t10 * ((is_28 ? t34 - 1.0f : t34) * 0.6931472f + (t36 + t36) * (t38 + 1.0f));
  const float t40 = fabsf(t39);
  const float t41 = 105.35837f < t40 ? 105.35837f : t40;
  const bool is_42 = 64.0f <= t41;
  const bool is_43 = t39 < 0.0f;
  const float t44 = is_42 ? t41 - 64.0f : t41;
  const bool is_45 = 32.0f <= t44;
  const float t46 = is_45 ? t44 - 32.0f : t44;
  const bool is_47 = 16.0f <= t46;
  const float t48 = is_47 ? t46 - 16.0f : t46;
  const bool is_49 = 8.0f <= t48;
  const float t50 = is_49 ? t48 - 8.0f : t48;
  const bool is_51 = 4.0f <= t50;
  const float t52 = is_51 ? t50 - 4.0f : t50;
  const bool is_53 = 2.0f <= t52;
  const float t54 = is_53 ? t52 - 2.0f : t52;
  const bool is_55 = 1.0f <= t54;
  const float t56 = is_55 ? t54 - 1.0f : t54;
  const bool is_57 = 0.5f <= t56;
  const float t58 = is_57 ? t56 - 0.5f : t56;
  const bool is_59 = 0.25f <= t58;
  const float t60 = is_45 ? 1.2664166e-14f : 1.0f;
  const float t61 = is_47 ? t60 * 1.12535176e-07f : t60;
  const float t62 = is_49 ? t61 * 0.00033546262f : t61;
  const float t63 = is_51 ? t62 * 0.01831564f : t62;
  const float t64 = is_53 ? t63 * 0.13533528f : t63;
  const float t65 = is_55 ? t64 * 0.36787945f : t64;
  const float t66 = is_57 ? t65 * 0.60653067f : t65;
  const float t67 = is_59 ? t58 - 0.25f : t58;
  const float t68 = 0.16666667f - t67 * (0.041666668f - t67 * (0.008333334f - t67 * 0.0013888889f));
  const float t69 = (is_59 ? t66 * 0.7788008f : t66) * (1.0f - t67 * (1.0f - t67 * (0.5f - t67 * t68)));
  const float t70 = is_43 ? t69 : 1.0f / t69;
  const float t71 = (1.0f - t9) * (t10 + 1.0f) * (is_42 ? t70 * (is_43 ? 1.6038109e-28f : 6.235149e+27f) : t70);
  const float t72 = (luminance[0] < 0.0f ? 0.0f : luminance[0]) * 0.2820948f * (t9 + t71);
  const float t73 = 0.5f * (t72 / t5);
  const float t74 = t73 * cg;
  const float t75 = t72 - t74;
  const float t76 = t73 * co;
  const float t77 = t75 + t76;
  colour[0] = t77 < 0.0f ? 0.0f : t77;
  const float t78 = t72 + t74;
  colour[1] = t78 < 0.0f ? 0.0f : t78;
  const float t79 = t75 - t76;
  colour[2] = t79 < 0.0f ? 0.0f : t79;
}
#endif

#ifndef ZONAL_IRRADIANCE_BYTES_2
#define ZONAL_IRRADIANCE_BYTES_2
// Irradiance over pi of radiance that stands as whole numbers -127 to 127 times one scale.
// 12 operations: 3 additions, 9 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_irradiance_bytes_2(float scale, const float (&stored)[4], const float (&normal)[3]) {
  const float t0 = stored[2] * (0.48860252f * normal[2]) + stored[1] * (-0.48860252f * normal[1]);
  const float t1 = stored[0] * 0.2820948f + 0.6666667f * (t0 + stored[3] * (-0.48860252f * normal[0]));
  const float value = scale * t1;
  return value;
}
#endif

#ifndef ZONAL_IRRADIANCE_BYTES_3
#define ZONAL_IRRADIANCE_BYTES_3
// Irradiance over pi of radiance that stands as whole numbers -127 to 127 times one scale.
// 36 operations: 11 additions, 25 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
ZONAL_FUNCTION float zonal_irradiance_bytes_3(float scale, const float (&stored)[9], const float (&normal)[3]) {
  const float t0 = stored[2] * (0.48860252f * normal[2]) + stored[1] * (-0.48860252f * normal[1]);
  const float t1 = stored[0] * 0.2820948f + 0.6666667f * (t0 + stored[3] * (-0.48860252f * normal[0]));
  const float t2 = -1.0925485f * normal[2];
  const float t3 = stored[6] * (0.9461747f * (normal[2] * normal[2]) + -0.31539157f) + stored[5] * (t2 * normal[1]);
  const float t4 = normal[1] * normal[0];
  const float t5 = t3 + stored[7] * (t2 * normal[0]) + stored[4] * (0.54627424f * (t4 + t4));
  const float t6 = stored[8] * (0.54627424f * (normal[0] * normal[0] - normal[1] * normal[1]));
  const float value = scale * (t1 + 0.25f * (t5 + t6));
  return value;
}
#endif
