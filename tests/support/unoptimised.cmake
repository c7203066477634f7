# What computes the constants must not be there at run time: in a debug build it would run at every call, and be most of
# the time (a root by Newton's method is some 20 divisions).
file(MAKE_DIRECTORY ${work_dir})
execute_process(COMMAND_ERROR_IS_FATAL ANY COMMAND ${compiler} -std=c++17 -O0 -I${include_dir} -c ${file}
  -o ${work_dir}/kernels.o)
execute_process(COMMAND_ERROR_IS_FATAL ANY COMMAND ${nm} -C ${work_dir}/kernels.o OUTPUT_VARIABLE symbols)
if(NOT symbols MATCHES "evaluate_with_hessian")
  message(FATAL_ERROR "the kernels are not there either:\n${symbols}")
endif()
string(REGEX MATCHALL "[^\n]*(constexpr_sqrt|ladder_root|column_slope|factorial|cosine_integral|of_digit|BasisTable|HalfGaussRule|LegendreGrid|GauntTable<[^>]*>::GauntTable|RingTable<[^>]*>::RingTable)[^\n]*" found
  "${symbols}")
if(found)
  message(FATAL_ERROR "computed at run time:\n${found}")
endif()
