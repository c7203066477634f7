# zonal_add_shader(<target> OUTPUT <file> [FUNCTIONS <name>...] [ADJOINT <name>... [BY <input>...]] [PLAN <file>]
#   [BANDS <n>] [DIALECT <dialect>] [OPTIONS <option>...])
#
# Writes a file of shader functions by zonal-glsl when <target>, of the same folder, is built, and puts the file's folder
# on the target's include path. A target may have several: what they have in common is guarded. A <name> may have a number
# of bands of its own, evaluate@3; those of ADJOINT come with derivatives, by the inputs that BY names; those of PLAN are
# what is left of the gather by a plan, a JSON file (docs/rooms/plan.md), and are written anew when it changes. An <option>
# is one of zonal-glsl, such as --precise.
#
# The program is that of the variable ZONAL_GLSL; else the one built with zonal, by add_subdirectory and FetchContent as
# well; else the one installed with the package; else one on the path. Where a program just built cannot run, when
# compiling for another machine, it is never the second.
function(zonal_add_shader target)
  cmake_parse_arguments(PARSE_ARGV 1 shader "" "OUTPUT;PLAN;BANDS;DIALECT" "FUNCTIONS;ADJOINT;BY;OPTIONS")
  if(NOT shader_OUTPUT OR NOT (shader_FUNCTIONS OR shader_ADJOINT OR shader_PLAN) OR shader_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "zonal_add_shader(<target> OUTPUT <file> [FUNCTIONS <name>...] [ADJOINT <name>... [BY <input>...]] "
      "[PLAN <file>] [BANDS <n>] [DIALECT <dialect>] [OPTIONS <option>...])")
  endif()
  if(shader_BANDS)
    list(PREPEND shader_OPTIONS --bands ${shader_BANDS})
  endif()
  if(shader_PLAN)
    cmake_path(ABSOLUTE_PATH shader_PLAN BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    list(PREPEND shader_OPTIONS --plan ${shader_PLAN})
  endif()
  if(NOT shader_DIALECT)
    set(shader_DIALECT glsl450)
  endif()
  if(ZONAL_GLSL)
    set(program ${ZONAL_GLSL})
  elseif(TARGET zonal-glsl AND NOT CMAKE_CROSSCOMPILING)
    set(program zonal-glsl)
  elseif(TARGET zonal::zonal-glsl)
    set(program zonal::zonal-glsl)
  else()
    find_program(ZONAL_GLSL zonal-glsl)
    mark_as_advanced(ZONAL_GLSL)
    if(NOT ZONAL_GLSL)
      get_property(missing GLOBAL PROPERTY zonal_glsl_missing)
      if(missing)
        set(missing ": it is not built with zonal, for want of ${missing}")
      endif()
      message(FATAL_ERROR "zonal_add_shader finds no program zonal-glsl${missing}. Set ZONAL_GLSL to its path.")
    endif()
    set(program ${ZONAL_GLSL})
  endif()
  cmake_path(ABSOLUTE_PATH shader_OUTPUT BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  cmake_path(GET shader_OUTPUT PARENT_PATH folder)
  foreach(list FUNCTIONS ADJOINT BY)
    if(shader_${list})
      list(JOIN shader_${list} "," names)
      string(TOLOWER ${list} option)
      list(APPEND shader_OPTIONS --${option} ${names})
    endif()
  endforeach()
  add_custom_command(OUTPUT ${shader_OUTPUT}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND ${program} --dialect ${shader_DIALECT} ${shader_OPTIONS} -o ${shader_OUTPUT}
    DEPENDS ${program} ${shader_PLAN}
    COMMENT "Writing ${shader_OUTPUT}"
    VERBATIM)
  target_sources(${target} PRIVATE ${shader_OUTPUT})
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
