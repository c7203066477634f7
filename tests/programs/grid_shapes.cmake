# The mean absolute errors of the approximations of lights that grid-render reports of the atrium, as the gradient paper
# finds them: spheres with a cosine stand for triangles far better than bare ones, and interpolating exact triangles
# costs about what interpolating spheres does.
#   cmake -Dprogram=<grid-render> -Dfolder=<folder> -P grid_shapes.cmake
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
execute_process(COMMAND ${program} --quiet --size 48x40 --antialias 1 --lights 128 --compare-shapes out
  --report report.json WORKING_DIRECTORY ${folder} COMMAND_ERROR_IS_FATAL ANY)
file(READ ${folder}/report.json report)

# In 1e-6, for CMake has no fractions.
function(millionths picture reference)
  string(JSON error GET "${report}" comparisons "${picture}-against-${reference}" errors mae)
  execute_process(COMMAND awk "BEGIN { printf \"%d\", 1e6 * ${error} }" OUTPUT_VARIABLE result
    COMMAND_ERROR_IS_FATAL ANY)
  message("${picture} against ${reference}: ${result}e-6")
  set(error ${result} PARENT_SCOPE)
  if(NOT EXISTS ${folder}/out/${picture}-against-${reference}.png OR NOT EXISTS ${folder}/out/${picture}.exr)
    message(SEND_ERROR "no picture of ${picture} against ${reference}")
  endif()
endfunction()
# better(<picture> <reference> <factor> <worse picture> <reference>)
function(better picture reference factor worse_picture worse_reference)
  millionths(${picture} ${reference})
  math(EXPR bound "${factor} * ${error}")
  millionths(${worse_picture} ${worse_reference})
  if(NOT bound LESS error OR NOT error GREATER 0)
    message(SEND_ERROR "not ${factor} times better")
  endif()
endfunction()

better(triangle-spheres triangles 1000 spheres triangles)
# On a grid, gradients within a cell of a light are limited, and in another way for edges than for spheres.
better(triangle-spheres-hermite triangles-hermite 100 spheres-hermite triangles-hermite)
better(triangles-hermite triangles 50 spheres triangles)
better(triangle-spheres-hermite triangles 50 spheres-hermite triangles)
better(spheres-hermite spheres 2 spheres-zonal spheres)
file(REMOVE_RECURSE ${folder})
