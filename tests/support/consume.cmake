# Configures, builds and tests the project in source_dir, which uses zonal from zonal_prefix or from zonal_source_dir.
file(REMOVE_RECURSE ${build_dir})
set(options -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_MAKE_PROGRAM=${make_program} -DCMAKE_BUILD_TYPE=Release)
if(zonal_prefix)
  list(APPEND options -Dzonal_ROOT=${zonal_prefix})
endif()
if(zonal_dir)
  list(APPEND options -Dzonal_DIR=${zonal_dir})
endif()
if(zonal_source_dir)
  list(APPEND options -DZONAL_SOURCE_DIR=${zonal_source_dir} -DFETCHCONTENT_SOURCE_DIR_ZONAL=${zonal_source_dir})
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -S ${source_dir} -B ${build_dir} -G ${generator} ${options} --no-warn-unused-cli
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${build_dir} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${build_dir} --output-on-failure --no-tests=error
  COMMAND_ERROR_IS_FATAL ANY)
