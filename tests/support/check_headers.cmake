# Compiles with `compiler` as C++ of `standard`, warnings being errors: every header alone, or, unless `how` is alone, all
# of them one after another.
if(NOT compiler)
  message("skipped: this compiler is not installed")
  return()
endif()
string(REPLACE " " ";" flags "${flags}")
string(REPLACE "|" ";-idirafter" system_dirs "${system_dirs}")  # not -isystem, which breaks on /usr/include
if(standard EQUAL 23)
  set(standard 2b)  # as older compilers call it
endif()
set(command ${compiler} -std=c++${standard} ${flags} -I${include_dir} -fsyntax-only)
if(NOT how STREQUAL "alone")
  execute_process(COMMAND ${command} ${system_dirs} ${units}/all_headers.cpp COMMAND_ERROR_IS_FATAL ANY)
  return()
endif()

# The std-only ones without the folders of GLM and Eigen.
file(GLOB std_units ${units}/std/*.cpp)
execute_process(COMMAND ${command} ${std_units} COMMAND_ERROR_IS_FATAL ANY)
file(GLOB render_units ${units}/render/*.cpp)
execute_process(COMMAND ${command} ${system_dirs} ${render_units} COMMAND_ERROR_IS_FATAL ANY)
