# A file that must not compile, for the reason it states in a line
#   // expect-error: <CMake regular expression over the compiler's output>
# Compiled without ZONAL_MUST_NOT_COMPILE it has to be correct, so that the failure has no other cause.
file(STRINGS ${file} expected REGEX "^// expect-error: ")
string(REPLACE "// expect-error: " "" expected "${expected}")
if(NOT expected)
  message(FATAL_ERROR "${file} has no line '// expect-error: <regular expression>'")
endif()

string(REPLACE "|" ";-idirafter" system_dirs "${system_dirs}")  # not -isystem, which breaks on /usr/include
set(command ${compiler} -fsyntax-only -std=c++17 -Wall -Wextra -Werror -I${include_dir} ${system_dirs})

execute_process(COMMAND ${command} ${file} RESULT_VARIABLE result ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "does not compile even without the offending line:\n${output}")
endif()

execute_process(COMMAND ${command} -DZONAL_MUST_NOT_COMPILE ${file} RESULT_VARIABLE result ERROR_VARIABLE output)
if(result EQUAL 0)
  message(FATAL_ERROR "compiles, and must not")
endif()
# The file's own name must not be what matches.
string(REPLACE "${file}" "" output "${output}")
if(NOT output MATCHES "${expected}")
  message(FATAL_ERROR "fails, but the compiler does not say '${expected}':\n${output}")
endif()
