# Kernels for a graphics processor, compiled by nvcc as C++ of `standard` and looked at: a constant that is read from the
# host's memory becomes a load from an absolute address, and a function that is the host's alone an error or an extern.
if(NOT nvcc)
  message("skipped: nvcc is not installed")
  return()
endif()
string(REPLACE "|" ";" system_dirs "${system_dirs}")
foreach(dir IN LISTS system_dirs)
  if(dir AND NOT dir STREQUAL "/usr/include")  # which the compiler has, and in its own place
    list(APPEND includes -I${dir})
  endif()
endforeach()
file(MAKE_DIRECTORY ${work_dir})
# 20012: GLM marks what it defaults.
execute_process(COMMAND ${nvcc} -std=c++${standard} --expt-relaxed-constexpr -DNDEBUG -Werror all-warnings
  -diag-suppress 20012 -I${include_dir} ${includes} -ptx ${file} -o ${work_dir}/kernels.ptx
  RESULT_VARIABLE result ERROR_VARIABLE errors OUTPUT_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "does not compile:\n${output}${errors}")
endif()

file(READ ${work_dir}/kernels.ptx ptx)
string(REGEX MATCHALL "\\.visible \\.entry [^(]+" kernels "${ptx}")
list(LENGTH kernels count)
string(REGEX MATCHALL "(ld|st)\\.[a-z0-9.]+[^;\n]*\\[-?[0-9][^\n]*" absolute "${ptx}")
string(REGEX MATCHALL "\\.extern [^\n]*" externs "${ptx}")
message("${count} kernels, loads from absolute addresses: '${absolute}', externs: '${externs}'")
if(count LESS 5 OR absolute OR externs)
  message(FATAL_ERROR "not what a kernel should be")
endif()
