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
set(compile ${compiler} -std=c++${standard} ${flags} -I${include_dir})
set(command ${compile} -fsyntax-only)
if(NOT how STREQUAL "alone")
  execute_process(COMMAND ${command} ${system_dirs} ${units}/all_headers.cpp COMMAND_ERROR_IS_FATAL ANY)
  return()
endif()

# The std-only ones without the folders of GLM and Eigen.
file(GLOB std_units ${units}/std/*.cpp)
execute_process(COMMAND ${command} ${std_units} COMMAND_ERROR_IS_FATAL ANY)

# Most of the others include scalar/packet.hpp, and with it Eigen, which takes ten times as long as the rest. To these it
# is given precompiled: they have all that it has in any case. Which they are, the compiler says.
file(GLOB render_units ${units}/render/*.cpp)
execute_process(COMMAND ${compile} ${system_dirs} -M ${render_units} OUTPUT_VARIABLE rules COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "\\\\\n" "" rules "${rules}")
string(REGEX MATCHALL "[^\n]+" rules "${rules}")
foreach(unit rule IN ZIP_LISTS render_units rules)
  get_filename_component(name ${unit} NAME_WE)
  if(NOT rule MATCHES "^${name}[.]o:")
    message(FATAL_ERROR "not the rule of ${unit}: ${rule}")
  endif()
  if(rule MATCHES "/scalar/packet[.]hpp" AND NOT name STREQUAL "zonal_scalar_packet_hpp")
    list(APPEND packet_units ${unit})
  else()
    list(APPEND other_units ${unit})
  endif()
endforeach()
execute_process(COMMAND ${command} ${system_dirs} ${other_units} COMMAND_ERROR_IS_FATAL ANY)
set(packet ${units}/packet.hpp)
file(WRITE ${packet} "#include <zonal/scalar/packet.hpp>\n")
execute_process(COMMAND ${compile} ${system_dirs} -x c++-header ${packet} -o ${packet}.gch COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${command} ${system_dirs} -Winvalid-pch -include ${packet} ${packet_units}
  COMMAND_ERROR_IS_FATAL ANY)
list(LENGTH packet_units packets)
list(LENGTH other_units others)
message("${packets} with packet.hpp, ${others} others")
