# What the programs share, function by function: tests/programs/shared/*_test.cpp as one Catch2 executable.
find_package(Catch2 QUIET)
if(NOT TARGET Catch2::Catch2)
  return()
endif()
include(Catch)
file(GLOB files CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/shared/*_test.cpp)
add_executable(test_shared ${files})
zonal_own_target(test_shared)
target_link_libraries(test_shared PRIVATE example-shared OpenEXR::OpenEXR
  $<IF:$<TARGET_EXISTS:test_main>,test_main,Catch2::Catch2WithMain>)
target_include_directories(test_shared PRIVATE ${PROJECT_SOURCE_DIR}/tests)
target_precompile_headers(test_shared REUSE_FROM test_precompiled)
catch_discover_tests(test_shared TEST_PREFIX "programs: " PROPERTIES TIMEOUT 120)
