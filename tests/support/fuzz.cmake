# Builds tests/fuzz with libFuzzer and the sanitizers, and runs it: `limit` is libFuzzer's option of how long, from a
# fixed seed; `targets`, if any, are fed one after the other, each so long. `libraries`, if any, have what else takes
# long to compile, tests/fuzz/programs.cpp, and no sanitizers; `target` is the processor flag by which they are built.
# Longer and without these by scripts/fuzz.sh.
if(NOT compiler)
  message("skipped: no clang++ found")
  return()
endif()
string(REPLACE "|" ";-idirafter" system_dirs "${system_dirs}")
find_path(stb_dir stb_image.h PATHS /usr/include /usr/local/include PATH_SUFFIXES stb)
foreach(part cflags libs)
  execute_process(COMMAND pkg-config --${part} OpenEXR OUTPUT_VARIABLE openexr_${part} ERROR_QUIET
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  separate_arguments(openexr_${part} UNIX_COMMAND "${openexr_${part}}")
endforeach()
set(sanitizers -fsanitize=fuzzer,address,undefined,float-cast-overflow -fno-sanitize-recover=all)
if(libraries)
  set(level -O0)  # half the time to compile, and not many inputs
  set(bands 10)  # as the libraries are
else()
  set(level -O1)
  set(bands 3)
endif()
set(flags -std=c++20 ${level} ${target} -g1 -DZONAL_INLINE= -DZONAL_GLSL_MAX_BANDS=${bands} -I${source_dir}/include
  -I${source_dir}/examples -I${source_dir}/tools -I${source_dir}/tools/zonal-glsl ${system_dirs} ${openexr_cflags}
  -idirafter${stb_dir})
file(REMOVE_RECURSE ${work_dir}/corpus)
file(MAKE_DIRECTORY ${work_dir}/corpus)

# can(<what is missing if not> <lines of a file that must compile and link>...)
macro(can missing)
  file(WRITE ${work_dir}/probe.cpp "extern \"C\" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }\n")
  foreach(header ${ARGN})
    file(APPEND ${work_dir}/probe.cpp "#include <${header}>\n")
  endforeach()
  execute_process(COMMAND ${compiler} ${flags} ${sanitizers} ${work_dir}/probe.cpp ${openexr_libs} -o ${work_dir}/probe
    RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
  if(NOT result EQUAL 0)
    message("skipped: ${missing}")
    return()
  endif()
endmacro()
can("${compiler} has no libFuzzer here; Debian: libclang-rt-14-dev")
can("no CLI11, nlohmann-json, OpenEXR or stb" CLI/Version.hpp nlohmann/json_fwd.hpp ImfVersion.h stb_image.h)

set(sources main readers text_readers command_lines)
list(TRANSFORM sources PREPEND ${source_dir}/tests/fuzz/)
list(TRANSFORM sources APPEND .cpp)
if(NOT libraries)
  list(APPEND sources ${source_dir}/tests/fuzz/programs.cpp ${source_dir}/examples/shared/stb.cpp)
  foreach(part request shader_functions basis_functions scene_functions)
    list(APPEND sources ${source_dir}/tools/zonal-glsl/${part}.cpp)
  endforeach()
endif()
string(REPLACE "|" ";" libraries "${libraries}")
foreach(source IN LISTS sources)
  get_filename_component(name ${source} NAME_WE)
  list(APPEND objects ${work_dir}/${name}.o)
  set(tolerated)
  if(name STREQUAL "stb")  # of a PNG without data stb_image copies no bytes, to nowhere
    set(tolerated -fno-sanitize=nonnull-attribute)
  endif()
  execute_process(COMMAND $ENV{CMAKE_CXX_COMPILER_LAUNCHER} ${compiler} ${flags} ${sanitizers} ${tolerated} -c ${source}
    -o ${work_dir}/${name}.o COMMAND_ERROR_IS_FATAL ANY)
endforeach()
# Of what the libraries have as well, the first counts: the one with sanitizers.
execute_process(COMMAND ${compiler} ${sanitizers} ${objects} -Wl,--allow-multiple-definition -Wl,--start-group ${libraries}
  -Wl,--end-group ${openexr_libs} -o ${work_dir}/fuzz COMMAND_ERROR_IS_FATAL ANY)

# run_target(<name, or nothing for all together>)
function(run_target name)
  set(corpus ${work_dir}/corpus/all${name})
  file(MAKE_DIRECTORY ${corpus})
  set(environment ZONAL_SEEDS=${corpus})
  if(name)
    list(APPEND environment ZONAL_TARGET=${name})
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} -E env ${environment} ${work_dir}/fuzz ${corpus} -dict=${corpus}.words
    -seed=1 -print_funcs=0 -max_len=8192 -rss_limit_mb=3000 -timeout=30 -close_fd_mask=1 -artifact_prefix=${work_dir}/
    ${limit}
    WORKING_DIRECTORY ${work_dir} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  file(WRITE ${work_dir}/${name}.log "${output}")
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${output}")
  endif()
  string(REGEX MATCH "Done [0-9]+ runs in [0-9]+ second" done "${output}")
  message("${name}: ${done}(s)")
endfunction()

if(targets STREQUAL "all")
  execute_process(COMMAND ${CMAKE_COMMAND} -E env ZONAL_TARGETS= ${work_dir}/fuzz OUTPUT_VARIABLE targets)
  string(REGEX MATCHALL "[^\n]+" targets "${targets}")
endif()
if(targets)
  string(REPLACE "," ";" targets "${targets}")
  foreach(target IN LISTS targets)
    run_target(${target})
  endforeach()
else()
  run_target("")
endif()
