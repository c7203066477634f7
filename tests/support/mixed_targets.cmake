# Two translation units of different -m flags in one program, either way round and in both link orders.
set(vectors -mavx2 -mfma)
execute_process(COMMAND ${compiler} ${vectors} -x c++ -E - INPUT_FILE /dev/null RESULT_VARIABLE unknown
  OUTPUT_QUIET ERROR_QUIET)
if(unknown)
  message("skipped: this compiler has no ${vectors}")
  return()
endif()
if(EXISTS /proc/cpuinfo)
  file(STRINGS /proc/cpuinfo capable REGEX "^flags.* avx2 " LIMIT_COUNT 1)
endif()
if(NOT capable)
  message("skipped: this machine has no AVX2, or does not say")
  return()
endif()

string(REPLACE "|" ";-idirafter" system_dirs "${system_dirs}")  # not -isystem, which breaks on /usr/include
file(MAKE_DIRECTORY ${work_dir})
foreach(unit main build)
  foreach(target plain vectors)
    execute_process(COMMAND_ERROR_IS_FATAL ANY COMMAND ${compiler} -std=c++17 -O1 ${${target}} -I${include_dir}
      ${system_dirs} -c ${source_dir}/${unit}.cpp -o ${work_dir}/${unit}_${target}.o)
  endforeach()
endforeach()
foreach(objects "main_plain build_vectors" "build_vectors main_plain" "main_vectors build_plain"
    "build_plain main_vectors")
  string(REGEX REPLACE "([^ ]+) ([^ ]+)" "${work_dir}/\\1.o;${work_dir}/\\2.o" files "${objects}")
  execute_process(COMMAND_ERROR_IS_FATAL ANY COMMAND ${compiler} ${files} -o ${work_dir}/program)
  execute_process(COMMAND ${work_dir}/program RESULT_VARIABLE result OUTPUT_VARIABLE output)
  message("${objects}: ${output}")
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "wrong light, linked in this order")
  endif()
endforeach()
