# Compiles every header alone with `compiler` as C++ of `standard`, warnings being errors.
if(NOT compiler)
  message("skipped: this compiler is not installed")
  return()
endif()
string(REPLACE " " ";" flags "${flags}")
string(REPLACE "|" ";-idirafter" system_dirs "${system_dirs}")  # not -isystem, which breaks on /usr/include
string(REPLACE 23 2b standard ${standard})                      # as older compilers call it
file(GLOB std_units ${units}/std/*.cpp)
file(GLOB render_units ${units}/render/*.cpp)
set(command ${compiler} -fsyntax-only -std=c++${standard} ${flags} -I${include_dir})
if(std_units)
  execute_process(COMMAND ${command} ${std_units} COMMAND_ERROR_IS_FATAL ANY)
endif()
if(render_units)
  execute_process(COMMAND ${command} ${system_dirs} ${render_units} COMMAND_ERROR_IS_FATAL ANY)
endif()
