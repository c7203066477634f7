# One unit compiled by -mlong-double-64, where the constants of double have no longer type to be computed in.
set(flag -mlong-double-64)
execute_process(COMMAND ${compiler} ${flag} -x c++ -E - INPUT_FILE /dev/null RESULT_VARIABLE unknown
  OUTPUT_QUIET ERROR_QUIET)
if(unknown)
  message("skipped: this compiler has no ${flag}")
  return()
endif()
file(MAKE_DIRECTORY ${work_dir})
execute_process(COMMAND_ERROR_IS_FATAL ANY COMMAND ${compiler} -std=c++17 -O1 -I${include_dir} ${flag}
  -c ${source_dir}/short.cpp -o ${work_dir}/short.o)
execute_process(COMMAND_ERROR_IS_FATAL ANY COMMAND ${compiler} -std=c++17 -O1 -I${include_dir}
  ${source_dir}/main.cpp ${work_dir}/short.o -o ${work_dir}/program)
execute_process(COMMAND_ERROR_IS_FATAL ANY COMMAND ${work_dir}/program)
