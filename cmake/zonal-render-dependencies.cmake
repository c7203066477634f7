# Finds what zonal::render links, glm::glm and Eigen3::Eigen; sets zonal_render_missing to the names of those not found.
# The build and the installed package both use this file.
set(zonal_render_missing "")

if(NOT TARGET Eigen3::Eigen)
  find_package(Eigen3 CONFIG QUIET)
endif()
if(NOT TARGET Eigen3::Eigen)
  list(APPEND zonal_render_missing Eigen3)
endif()

if(NOT TARGET glm::glm)
  find_package(glm CONFIG QUIET)
endif()
if(NOT TARGET glm::glm)
  # Some of glm's config files set a variable only, and some packages have no config file.
  find_path(ZONAL_GLM_INCLUDE_DIR glm/glm.hpp HINTS ${GLM_INCLUDE_DIRS})
  mark_as_advanced(ZONAL_GLM_INCLUDE_DIR)
  if(ZONAL_GLM_INCLUDE_DIR)
    add_library(glm::glm INTERFACE IMPORTED)
    target_include_directories(glm::glm INTERFACE "${ZONAL_GLM_INCLUDE_DIR}")
  else()
    list(APPEND zonal_render_missing glm)
  endif()
endif()
