// What the code is compiled for, as a namespace: zonal::avx2_fma, zonal::avx512, ...
//
// Packets have other lanes and layouts under other -m flags, and any inline function has other instructions. Two
// translation units compiled by different flags would give both one name, and the linker would keep either. So every
// name of this library stands in an inline namespace of its target, invisible where one target is all there is. To
// pass a type of this library from one target's code to another's does not link; pass numbers.
#pragma once

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512BW__) && defined(__AVX512VL__)
#define ZONAL_TARGET_VECTORS avx512
#elif defined(__AVX512F__)
#define ZONAL_TARGET_VECTORS avx512f
#elif defined(__AVX2__)
#define ZONAL_TARGET_VECTORS avx2
#elif defined(__AVX__)
#define ZONAL_TARGET_VECTORS avx
#elif defined(__SSE4_2__)
#define ZONAL_TARGET_VECTORS sse42
#elif defined(__SSE4_1__)
#define ZONAL_TARGET_VECTORS sse41
#elif defined(__SSSE3__)
#define ZONAL_TARGET_VECTORS ssse3
#elif defined(__SSE3__)
#define ZONAL_TARGET_VECTORS sse3
#elif defined(__ARM_FEATURE_SVE)
#define ZONAL_TARGET_VECTORS sve
#elif defined(__ARM_NEON)
#define ZONAL_TARGET_VECTORS neon
#elif defined(__wasm_simd128__)
#define ZONAL_TARGET_VECTORS simd128
#else
#define ZONAL_TARGET_VECTORS baseline
#endif

#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
#define ZONAL_TARGET_FUSED _fma
#else
#define ZONAL_TARGET_FUSED
#endif

#if defined(EIGEN_DONT_VECTORIZE)
#define ZONAL_TARGET_PACKETS _novec
#else
#define ZONAL_TARGET_PACKETS
#endif

#if defined(__FAST_MATH__)
#define ZONAL_TARGET_MATH _fast
#else
#define ZONAL_TARGET_MATH
#endif

// Kernels that are not constexpr in C++17 for what nvcc compiles; the others it takes by --expt-relaxed-constexpr.
#if defined(__CUDACC__)
#define ZONAL_DEVICE __host__ __device__
#else
#define ZONAL_DEVICE
#endif

#define ZONAL_TARGET_JOINED(a, b, c, d) a##b##c##d
#define ZONAL_TARGET_JOIN(a, b, c, d) ZONAL_TARGET_JOINED(a, b, c, d)

/// The inline namespace that holds the whole library, such as avx2_fma.
#define ZONAL_TARGET \
  ZONAL_TARGET_JOIN(ZONAL_TARGET_VECTORS, ZONAL_TARGET_FUSED, ZONAL_TARGET_PACKETS, ZONAL_TARGET_MATH)
