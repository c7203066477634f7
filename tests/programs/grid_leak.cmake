# What leaks through the wall of the rooms, against paths, with and without visibility, and the error of the rest.
#   cmake -Dprogram=<grid-render> -Dfolder=<folder> -P grid_leak.cmake
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
execute_process(COMMAND ${program} --quiet --scene rooms --lights 4 --bands 3 --paths 64 --grid 12x7x9 --size 120x72
  --antialias 1 --compare out --report report.json WORKING_DIRECTORY ${folder} COMMAND_ERROR_IS_FATAL ANY)
file(READ ${folder}/report.json report)

# In 1e-6, for CMake has no fractions.
function(millionths result)
  string(JSON number GET "${report}" passes ${ARGN})
  execute_process(COMMAND awk "BEGIN { printf \"%d\", 1e6 * ${number} }" OUTPUT_VARIABLE number
    COMMAND_ERROR_IS_FATAL ANY)
  message("${ARGN}: ${number}e-6")
  set(${result} ${number} PARENT_SCOPE)
endfunction()
millionths(plain trilinear leak)
millionths(visible visible leak)
math(EXPR bound "10 * ${visible}")
if(NOT bound LESS plain OR NOT plain GREATER 10000)
  message(SEND_ERROR "less than ten times")
endif()
millionths(plain trilinear errors linear_mae_relative_to_mean)
millionths(visible visible errors linear_mae_relative_to_mean)
math(EXPR bound "105 * ${plain} / 100")
if(NOT visible LESS bound)
  message(SEND_ERROR "the rest has become worse")
endif()
file(REMOVE_RECURSE ${folder})
