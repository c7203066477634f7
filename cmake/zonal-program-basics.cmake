# What programs need that render nothing: example-basics, command lines, pictures and files, made where it is first
# included. Sets program_basics_missing. Packages' targets are a folder's own, so each folder of programs includes this.
set(program_basics_missing ${zonal_render_missing})
# Debian's Imath, which OpenEXR brings in, reports at length on a part for Python that it does not install.
set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
foreach(package OpenEXR CLI11 nlohmann_json)
  find_package(${package} QUIET)
  if(NOT ${package}_FOUND)
    list(APPEND program_basics_missing ${package})
  endif()
endforeach()
unset(CMAKE_MESSAGE_LOG_LEVEL)
find_path(ZONAL_STB_INCLUDE_DIR stb_image_write.h PATH_SUFFIXES stb)
mark_as_advanced(ZONAL_STB_INCLUDE_DIR)
if(NOT ZONAL_STB_INCLUDE_DIR)
  list(APPEND program_basics_missing stb)
endif()
if(program_basics_missing OR TARGET example-basics)
  return()
endif()

set(files command_line.cpp image.cpp image_file.cpp input_error.cpp output_file.cpp progress.cpp run_program.cpp stb.cpp
  texture.cpp)
list(TRANSFORM files PREPEND ${PROJECT_SOURCE_DIR}/examples/shared/)
add_library(example-basics STATIC ${files})
zonal_own_target(example-basics)
zonal_joined(example-basics)
target_link_libraries(example-basics PUBLIC CLI11::CLI11 PRIVATE OpenEXR::OpenEXR)
target_include_directories(example-basics PUBLIC ${PROJECT_SOURCE_DIR}/examples)
target_include_directories(example-basics SYSTEM PRIVATE ${ZONAL_STB_INCLUDE_DIR})
if(NOT ZONAL_QUICK)  # as example_small_code
  set_source_files_properties(${PROJECT_SOURCE_DIR}/examples/shared/command_line.cpp PROPERTIES
    COMPILE_OPTIONS $<$<CONFIG:Release>:-O1>)
endif()
