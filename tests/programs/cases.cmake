# The programs as a user meets them: what they say of bad input, and what files they leave. A program's own file sets
#   program   its target
#   small     arguments that make it fast
#   few       those that ask for few lights, if not --lights 1
#   inputs_program  the program that makes pictures for the cases, if not this one
#   inputs_command  what makes all that the cases start from, in a folder that follows, if not make_inputs.sh
# and includes this one.
if(NOT few)
  set(few --lights 1)
endif()
if(NOT inputs_program)
  set(inputs_program ${program})
endif()
list(JOIN few " " few_words)
set(programs_dir ${CMAKE_CURRENT_LIST_DIR})
set(work_dir ${CMAKE_CURRENT_BINARY_DIR}/cases)
string(REPEAT a 300 long_name)

if(inputs_command)
  add_test(NAME "${program}: inputs of the cases" COMMAND ${inputs_command} ${work_dir}/inputs)
else()
  add_test(NAME "${program}: inputs of the cases" COMMAND
    ${programs_dir}/make_inputs.sh $<TARGET_FILE:${inputs_program}> ${programs_dir}/scenes ${work_dir}/inputs ${few})
endif()
set_tests_properties("${program}: inputs of the cases" PROPERTIES FIXTURES_SETUP ${program}_inputs)

# program_case(<name> <exit status> <new files> <pattern of standard error> <command>...)
function(program_case name status new_files pattern)
  string(MAKE_C_IDENTIFIER "${name}" folder)
  add_test(NAME "${program}: ${name}" COMMAND
    ${programs_dir}/run_case.sh ${work_dir}/inputs ${work_dir}/${folder} ${status} "${new_files}" "${pattern}" ${ARGN})
  set_tests_properties("${program}: ${name}" PROPERTIES FIXTURES_REQUIRED ${program}_inputs TIMEOUT 60)
endfunction()

# refused(<name> <pattern> <argument>...): exit status 2, one line, no file.
function(refused name pattern)
  program_case("${name}" 2 "" "${program}: ${pattern}" $<TARGET_FILE:${program}> ${small} ${ARGN})
endfunction()

# renders(<name> <new files> <pattern> <argument>...)
function(renders name new_files pattern)
  program_case("${name}" 0 "${new_files}" "${pattern}" $<TARGET_FILE:${program}> ${small} ${ARGN})
endfunction()

# guards_its_output(): standard output that is full or closed is an error, and no output replaces what is read.
function(guards_its_output)
  program_case("full output" 1 "x.png" "${program}: standard output: cannot be written .No space left on device."
    sh -c "'$<TARGET_FILE:${program}>' --scene box.obj ${few_words} --size 16x12 --out x.png >/dev/full")
  program_case("closed output" 1 "" "${program}: standard output: is closed"
    sh -c "'$<TARGET_FILE:${program}>' --scene box.obj ${few_words} --size 16x12 --out x.png >&-")
  refused("report on the scene" "./box.obj: is read, and cannot be written as well" --scene box.obj --report ./box.obj)
  refused("report on a scene's picture" "two pixels.ppm: is read, and cannot be written as well"
    --scene textured.obj --report "two pixels.ppm")
  refused("report of an over-long name" "a+: cannot be written .File name too long." --report ${long_name})
endfunction()

# stops(<argument>...): by a signal in the middle, within a second, and leaves no file. The first number is of seconds.
function(stops)
  foreach(signal_status INT:130 TERM:143)
    string(REPLACE ":" ";" signal_status ${signal_status})
    list(GET signal_status 0 signal)
    list(GET signal_status 1 status)
    program_case("stopped by SIG${signal}" ${status} "" "${program}: interrupted, nothing written"
      timeout --preserve-status --kill-after=10 --signal=${signal} 2 $<TARGET_FILE:${program}> ${ARGN})
  endforeach()
endfunction()

# shows_progress(<argument>...): in a narrow terminal, without wrapping.
function(shows_progress)
  add_test(NAME "${program}: narrow terminal" COMMAND
    ${programs_dir}/narrow_terminal.sh ${work_dir}/narrow_terminal $<TARGET_FILE:${program}> ${ARGN})
  set_tests_properties("${program}: narrow terminal" PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:" TIMEOUT 60)
endfunction()


# example_test(<source>): what the program's parts do, as a Catch2 executable.
function(example_test source)
  find_package(Catch2 QUIET)
  if(NOT TARGET Catch2::Catch2)
    return()
  endif()
  include(Catch)
  string(REPLACE _test.cpp "" name ${source})
  add_executable(test_${name} ${programs_dir}/${source})
  zonal_own_target(test_${name})
  target_link_libraries(test_${name} PRIVATE ${program}-parts
    $<IF:$<TARGET_EXISTS:test_main>,test_main,Catch2::Catch2WithMain>)
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}/examples)
  if(TARGET test_precompiled)  # as it is but for tools, which come before the tests
    target_precompile_headers(test_${name} REUSE_FROM test_precompiled)
  endif()
  catch_discover_tests(test_${name} TEST_PREFIX "${program}: " PROPERTIES TIMEOUT 120)
endfunction()
