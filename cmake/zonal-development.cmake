# What zonal's own executables share. Nothing of it reaches the targets that others link.

set(ZONAL_WARNINGS -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wdouble-promotion -Wshadow -Werror)

add_library(zonal_warnings INTERFACE)
target_compile_options(zonal_warnings INTERFACE
  $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:${ZONAL_WARNINGS}>)

# GCC 12 takes the undefined registers inside its own AVX-512 intrinsics for uninitialised variables (GCC bug 105593).
target_compile_options(zonal_warnings INTERFACE
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-uninitialized;-Wno-maybe-uninitialized>)

add_library(zonal_native INTERFACE)
if(ZONAL_NATIVE)
  target_compile_options(zonal_native INTERFACE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-march=native>)
endif()

# zonal_own_target(<target>): the settings of every test, benchmark and example.
function(zonal_own_target target)
  target_link_libraries(${target} PRIVATE zonal::render zonal_warnings zonal_native)
  target_compile_features(${target} PRIVATE cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
endfunction()

# zonal_skip(<TESTS|EXAMPLES> <text>): a package is missing; stop if that part is required, say so otherwise.
function(zonal_skip part text)
  if(ZONAL_REQUIRE_${part})
    message(FATAL_ERROR "zonal: ${text}")
  endif()
  message(STATUS "zonal: ${text}")
endfunction()
