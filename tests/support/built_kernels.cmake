# Compiles `source` by `compiler` as C++17 for the least processor, warnings being errors, and runs it.
if(NOT compiler)
  message("skipped: this compiler is not installed")
  return()
endif()
string(REPLACE " " ";" flags "${flags}")
string(REPLACE "|" ";-idirafter" system_dirs "${system_dirs}")  # not -isystem, which breaks on /usr/include
execute_process(COMMAND ${compiler} -std=c++17 -O1 -DNDEBUG ${flags} -I${include_dir} ${system_dirs} ${source}
  -o ${program} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${program} COMMAND_ERROR_IS_FATAL ANY)
