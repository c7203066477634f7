# zonal_add_shader(<target> OUTPUT <file> FUNCTIONS <name>... [BANDS <n>] [DIALECT <dialect>] [OPTIONS <option>...])
#
# Writes a file of shader functions by zonal-glsl when <target> is built, and puts its folder on the target's include
# path. The program is the one built beside zonal, or one that is installed.
function(zonal_add_shader target)
  cmake_parse_arguments(PARSE_ARGV 1 shader "" "OUTPUT;BANDS;DIALECT" "FUNCTIONS;OPTIONS")
  if(NOT shader_OUTPUT OR NOT shader_FUNCTIONS OR shader_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "zonal_add_shader(<target> OUTPUT <file> FUNCTIONS <name>... [BANDS <n>] [DIALECT <dialect>])")
  endif()
  if(NOT shader_BANDS)
    set(shader_BANDS 5)
  endif()
  if(NOT shader_DIALECT)
    set(shader_DIALECT glsl450)
  endif()
  if(TARGET zonal-glsl)
    set(program zonal-glsl)
  else()
    find_program(ZONAL_GLSL zonal-glsl REQUIRED)
    set(program ${ZONAL_GLSL})
  endif()
  cmake_path(ABSOLUTE_PATH shader_OUTPUT BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  cmake_path(GET shader_OUTPUT PARENT_PATH folder)
  list(JOIN shader_FUNCTIONS "," names)
  add_custom_command(OUTPUT ${shader_OUTPUT}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND ${program} --bands ${shader_BANDS} --functions ${names} --dialect ${shader_DIALECT} ${shader_OPTIONS}
      -o ${shader_OUTPUT}
    DEPENDS ${program}
    COMMENT "Writing ${shader_OUTPUT}"
    VERBATIM)
  target_sources(${target} PRIVATE ${shader_OUTPUT})
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
