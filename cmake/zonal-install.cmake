include(CMakePackageConfigHelpers)

# Headers and scripts only: nothing depends on the architecture, hence share.
set(package_dir ${CMAKE_INSTALL_DATADIR}/cmake/zonal)

install(TARGETS zonal EXPORT zonal-targets)
install(EXPORT zonal-targets NAMESPACE zonal:: DESTINATION ${package_dir} COMPONENT zonal)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/zonal DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT zonal)

configure_package_config_file(cmake/zonal-config.cmake.in zonal-config.cmake INSTALL_DESTINATION ${package_dir})
configure_file(cmake/zonal-config-version.cmake.in zonal-config-version.cmake @ONLY)
install(FILES
    ${CMAKE_CURRENT_BINARY_DIR}/zonal-config.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/zonal-config-version.cmake
    ${PROJECT_SOURCE_DIR}/cmake/zonal-render-dependencies.cmake
    ${PROJECT_SOURCE_DIR}/cmake/zonal-shader.cmake
  DESTINATION ${package_dir} COMPONENT zonal)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT zonal)
