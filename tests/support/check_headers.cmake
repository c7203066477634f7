# Compiles with `compiler` as C++ of `standard`, warnings being errors: every header alone, or, unless `how` is alone, all
# of them one after another.
if(NOT compiler)
  message("skipped: this compiler is not installed")
  return()
endif()
string(REPLACE " " ";" flags "${flags}")
string(REPLACE "|" ";-idirafter" system_dirs "${system_dirs}")  # not -isystem, which breaks on /usr/include
if(how STREQUAL "alone")
  file(GLOB std_units ${units}/std/*.cpp)
  file(GLOB render_units ${units}/render/*.cpp)
else()
  set(render_units ${units}/all_headers.cpp)
endif()
if(standard EQUAL 23)
  set(standard 2b)  # as older compilers call it
endif()
set(command ${compiler} -fsyntax-only -std=c++${standard} ${flags} -I${include_dir})
if(std_units)
  execute_process(COMMAND ${command} ${std_units} COMMAND_ERROR_IS_FATAL ANY)
endif()
execute_process(COMMAND ${command} ${system_dirs} ${render_units} COMMAND_ERROR_IS_FATAL ANY)
