# check_symbols.cmake refuses an object that defines what others may define too, and takes one that does not.
file(MAKE_DIRECTORY ${work_dir})
file(WRITE ${work_dir}/melts.cpp "extern const int kernels_avx2 = 1;
namespace zonal { inline namespace avx2_fma { void own() {} } }\n")
file(WRITE ${work_dir}/leaks.cpp "#include <vector>
void grow(std::vector<float>& numbers, float number) { numbers.push_back(number); }\n")
foreach(unit melts leaks)
  execute_process(COMMAND ${compiler} -std=c++17 -O2 -c ${work_dir}/${unit}.cpp -o ${work_dir}/${unit}.o
    COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CMAKE_COMMAND} -Dnm=${nm} -Dobjects=${work_dir}/melts.o,${work_dir}/${unit}.o -P ${check}
    RESULT_VARIABLE ${unit} ERROR_VARIABLE said)
endforeach()
if(NOT melts EQUAL 0 OR leaks EQUAL 0 OR NOT said MATCHES "leaks.o defines.*_M_realloc_insert")
  message(FATAL_ERROR "melts: ${melts}, leaks: ${leaks}\n${said}")
endif()
