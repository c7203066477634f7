# Every reader of files and command line under libFuzzer, a few seconds in all; of the programs, what is built of them.
foreach(program hvl-render igi-render grid-render field-bake field-capture field-render)
  list(APPEND fuzzed $<TARGET_FILE:${program}-parts>)
endforeach()
list(APPEND fuzzed $<TARGET_FILE:zonal-glsl-parts> $<TARGET_FILE:zonal-shader-functions>
  $<TARGET_FILE:zonal-probe-parts> $<TARGET_FILE:example-shared> $<TARGET_FILE:example-basics> $<TARGET_FILE:embree>
  $<TARGET_FILE:TBB::tbb>)
list(JOIN fuzzed "|" fuzzed)
set(name "fuzz: every reader of files and command line")
add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -Dcompiler=${ZONAL_CLANGXX} -Dsource_dir=${PROJECT_SOURCE_DIR}
  -Dsystem_dirs=|$<JOIN:$<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>,|> -Dlibraries=${fuzzed}
  -Dtarget=$<$<BOOL:${ZONAL_NATIVE}>:-march=native> -Dwork_dir=${CMAKE_CURRENT_BINARY_DIR}/fuzz -Dlimit=-runs=2000
  -P ${PROJECT_SOURCE_DIR}/tests/support/fuzz.cmake)
set_tests_properties(${name} PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:" TIMEOUT 900)
