# The headers of the std-only face must include neither GLM nor Eigen, which a compiler may find in its default folders.
file(GLOB std_units ${units}/std/*.cpp)
foreach(unit IN LISTS std_units)
  execute_process(COMMAND ${compiler} -std=c++17 -I${include_dir} -M ${unit}
    OUTPUT_VARIABLE included COMMAND_ERROR_IS_FATAL ANY)
  if(included MATCHES "[^ ]*/(glm|Eigen|boost|tbb)/[^ ]*")
    message(FATAL_ERROR "${unit} includes ${CMAKE_MATCH_0}")
  endif()
endforeach()
