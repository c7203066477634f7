# What zonal's own executables share. Nothing of it reaches the targets that others link.

set(ZONAL_WARNINGS -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wdouble-promotion -Wshadow -Werror)

add_library(zonal_warnings INTERFACE)
target_compile_options(zonal_warnings INTERFACE
  $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:${ZONAL_WARNINGS}>)

# By it clang++ means from double to long double as well, in which the tests know the truth.
target_compile_options(zonal_warnings INTERFACE $<$<CXX_COMPILER_ID:Clang,AppleClang>:-Wno-double-promotion>)

# GCC 12 takes the undefined registers inside its own AVX-512 intrinsics for uninitialised variables (GCC bug 105593).
target_compile_options(zonal_warnings INTERFACE
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-uninitialized;-Wno-maybe-uninitialized>)

# What more optimisation takes to compile is more than it saves when the tests run, and so is what kernels that melt into
# their callers take (scalar.hpp). test_built_kernels has both always: zonal_optimised.
add_library(zonal_quick INTERFACE)
if(ZONAL_QUICK AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(CMAKE_CXX_FLAGS_RELEASE "-O1 -DNDEBUG")
  target_compile_definitions(zonal_quick INTERFACE ZONAL_INLINE=)
endif()
# At -O1 GCC warns of what lies behind branches that it removes at -O2: of std::vector::erase, for one. The release build
# heeds these warnings.
if(ZONAL_QUICK AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Memory is swept from 0.8 GB on, not from a sixth of that: up to a fifth of the time of a file whose headers are not
  # precompiled, little of others.
  target_compile_options(zonal_quick INTERFACE --param=ggc-min-heapsize=800000)
  foreach(warning array-bounds stringop-overflow stringop-overread restrict free-nonheap-object nonnull
      dangling-pointer use-after-free)
    target_compile_options(zonal_warnings INTERFACE -Wno-${warning})
  endforeach()
endif()

add_library(zonal_native INTERFACE)
if(ZONAL_NATIVE)
  target_compile_options(zonal_native INTERFACE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-march=native>)
endif()

# zonal_own_target(<target>): the settings of every test, benchmark and example.
function(zonal_own_target target)
  target_link_libraries(${target} PRIVATE zonal::render zonal_warnings zonal_native zonal_quick)
  target_compile_features(${target} PRIVATE cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
endfunction()

# zonal_joined(<target>): in the quick build eight files at a time are compiled as one, for most of a small file's time
# goes into headers: a quarter to a half is left. A file includes what it needs all the same, as the release build shows.
function(zonal_joined target)
  if(ZONAL_QUICK)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
endfunction()

# zonal_optimised(<target>): as users build it, whatever the preset.
function(zonal_optimised target)
  target_compile_options(${target} PRIVATE
    $<$<AND:$<CXX_COMPILER_ID:GNU,Clang,AppleClang>,$<CONFIG:Release>>:-O3;-UZONAL_INLINE>)
endfunction()

# zonal_precompiled(<name> <header> [<option>...]): others' headers, parsed once for all targets of the same options that
# say target_precompile_headers(<target> REUSE_FROM <name>).
function(zonal_precompiled name header)
  set(unit ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${unit} CONTENT "// A precompiled header needs a target, and that a file.\n")
  add_library(${name} OBJECT ${unit})
  zonal_own_target(${name})
  target_compile_options(${name} PRIVATE ${ARGN})
  target_precompile_headers(${name} PRIVATE ${header})
endfunction()

# zonal_skip(<TESTS|EXAMPLES> <text>): a package is missing; stop if that part is required, say so otherwise.
function(zonal_skip part text)
  if(ZONAL_REQUIRE_${part})
    message(FATAL_ERROR "zonal: ${text}")
  endif()
  message(STATUS "zonal: ${text}")
endfunction()
