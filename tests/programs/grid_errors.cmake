# The mean absolute errors that grid-render reports of the atrium, as the gradient paper finds them: Hermite's is less
# than half the trilinear one on the same 8^3 grid, and less than that of a trilinear grid in the same memory.
#   cmake -Dprogram=<grid-render> -Dfolder=<folder> -P grid_errors.cmake
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
execute_process(COMMAND ${program} --quiet --size 96x80 --antialias 1 --compare out --report report.json
  WORKING_DIRECTORY ${folder} COMMAND_ERROR_IS_FATAL ANY)
file(READ ${folder}/report.json report)

foreach(pass trilinear taylor hermite trilinear-equal-memory)
  foreach(quantity mae linear_mae_relative_to_mean)
    string(JSON error GET "${report}" passes ${pass} errors ${quantity})
    string(JSON share GET "${report}" passes ${pass} errors ${quantity}_over_trilinear)
    message("${pass}: ${quantity} ${error}, ${share} of the trilinear")
    set(${pass}_${quantity} ${error})
    set(${pass}_${quantity}_share ${share})
  endforeach()
endforeach()

foreach(quantity mae linear_mae_relative_to_mean)
  if(NOT hermite_${quantity}_share LESS 0.5)
    message(SEND_ERROR "Hermite's ${quantity} is not less than half the trilinear")
  endif()
  if(NOT hermite_${quantity} LESS trilinear-equal-memory_${quantity})
    message(SEND_ERROR "Hermite's ${quantity} is not less than that of equal memory")
  endif()
  # Without an error to compare all of this would say nothing.
  if(NOT trilinear_${quantity} GREATER 0.001 OR NOT hermite_${quantity} GREATER 0)
    message(SEND_ERROR "no error where there must be one")
  endif()
endforeach()
file(REMOVE_RECURSE ${folder})
