# Compiles a file that defines min and max as macros before it includes the library.
string(REPLACE "|" ";-idirafter" system_dirs "${system_dirs}")  # not -isystem, which breaks on /usr/include
execute_process(COMMAND_ERROR_IS_FATAL ANY COMMAND ${compiler} -fsyntax-only -std=c++17 -I${include_dir} ${system_dirs}
  ${file})
