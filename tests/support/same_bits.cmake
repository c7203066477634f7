# Builds tests/same_bits by another compiler, for the least processor and without optimisation, and compares what it
# prints with the file kept. scripts/same_bits.sh does so by all compilers, options and processors that are there.
if(NOT compiler)
  message("skipped: no clang++ found")
  return()
endif()
string(REPLACE "|" ";-idirafter" system_dirs "${system_dirs}")
file(MAKE_DIRECTORY ${work_dir})
execute_process(
  COMMAND ${compiler} -std=c++17 -O0 -ffp-contract=off -DNDEBUG -DZONAL_INLINE= -I${include_dir} ${system_dirs}
    ${source_dir}/main.cpp ${source_dir}/basis.cpp ${source_dir}/scene.cpp ${source_dir}/unwritten.cpp
    -o ${work_dir}/same_bits
  RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "it does not compile")
endif()
execute_process(COMMAND ${work_dir}/same_bits OUTPUT_FILE ${work_dir}/bits.txt RESULT_VARIABLE result)
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${work_dir}/bits.txt ${kept} RESULT_VARIABLE is_other)
if(NOT result EQUAL 0 OR NOT is_other EQUAL 0)
  message(FATAL_ERROR "${work_dir}/bits.txt is not ${kept}")
endif()
execute_process(COMMAND ${work_dir}/same_bits --finite 1000 1 RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "a result is not finite")
endif()
