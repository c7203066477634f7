# Inline functions that are not inlined stand in every object file that calls them, and the linker keeps one of them: the
# first that it sees. If that is std::vector's of a file compiled for AVX-512, the whole program ends on a processor
# without, wherever it grows a vector. So the objects of such files define nothing that another may define too: their
# table of functions, and what has zonal's namespace of their target in its name.
#
# What cannot do without containers is made an object of which nothing but the table is seen:
#   ld -r --force-group-allocation kernels.o -o alone.o && objcopy --keep-global-symbol=kernels_avx512 alone.o
cmake_policy(VERSION 3.22)
string(REPLACE "," ";" objects "${objects}")
foreach(object IN LISTS objects)
  execute_process(COMMAND ${nm} --defined-only --extern-only ${object} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^ \n]+\n" symbols "${symbols}")
  list(TRANSFORM symbols STRIP)
  list(FILTER symbols EXCLUDE REGEX "^kernels_[a-z0-9]+$|5zonal[0-9]+(baseline|s*se|avx)")
  if(symbols)
    list(JOIN symbols "\n  " symbols)
    message(FATAL_ERROR "${object} defines what other files may define too:\n  ${symbols}")
  endif()
endforeach()
