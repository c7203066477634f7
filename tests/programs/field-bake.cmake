# field-bake's cases.
set(program field-bake)
set(small --grid 4 --bands 3)
set(few --sets 1)
set(inputs_program igi-render)
include(${CMAKE_CURRENT_LIST_DIR}/cases.cmake)

# What they bake: eight probes of a box, and sequences that are damaged.
add_test(NAME "field-bake: sequences of the cases" COMMAND
  ${programs_dir}/make_sequences.sh $<TARGET_FILE:field-capture> ${work_dir}/inputs)
set_tests_properties("field-bake: sequences of the cases" PROPERTIES
  FIXTURES_SETUP field-bake_inputs DEPENDS "field-bake: inputs of the cases")

# ---- Arguments ------------------------------------------------------------------------------------------------------

refused("no sequence" "sequence is required")
foreach(grid 1 0 1025 8x8 8x8x8x8 axbxc 4x1x4)
  refused("grid ${grid}" "--grid: '${grid}' is not a resolution such as 8 or 8x8x8, each number 2 to 1024"
    s/sequence.txt --grid ${grid})
endforeach()
foreach(box 0,0,0 0,0,0,1,1 a,b,c,d,e,f)
  refused("box ${box}" "--box: '${box}' is not a box such as -0.5,1,2,0.5,2,3" s/sequence.txt --box ${box})
endforeach()
refused("box inside out" "the grid's x axis goes from 1.0+ to 0.0+, which leaves no space between" s/sequence.txt --box 1,1,1,0,2,2)
refused("box of no number" "--box: '0,0,0,1,1,nan' is not a box such as .*" s/sequence.txt --box 0,0,0,1,1,nan)
refused("bands 1" "--bands: '1' is not one of 2.3.4.5.6" s/sequence.txt --bands 1)
refused("thin -1" "--thin: '-1' is not in 0...2" s/sequence.txt --thin -1)
refused("thin by distance alone" "--thin-distance requires --thin" s/sequence.txt --thin-distance 1)
refused("memory 0" "--memory: '0' is not in 1...1048576" s/sequence.txt --memory 0)
refused("gradients of the paper's steps" "--gradients: the paper's steps have none" s/sequence.txt --gradients --path space)

# ---- Files ----------------------------------------------------------------------------------------------------------

refused("sequence missing" "nowhere.txt: No such file or directory" nowhere.txt)
refused("sequence that is none" "box.obj: line [0-9]+ is no item of a sequence: .*" box.obj)
refused("sequence of nothing" "s/empty.txt: has no probes" s/empty.txt)
refused("position that is no number" "s/nan.txt: line 2 has no number where one should be: nan" s/nan.txt)
refused("position missing" "s/short.txt: line 2 lacks the probe's picture or position: .*" s/short.txt)
refused("all probes at one place" "the grid's x axis goes from .* which leaves no space between; the box is that of the probes, where --box names no other"
  s/one-place.txt)
refused("one probe" "the grid's x axis goes from .* which leaves no space between; the box is that of the probes, where --box names no other"
  s/one.txt)
program_case("far from the box" 2 "work work/samples-0.zonal"
  "field-bake: s/sequence.txt: no ray of any probe comes near the box"
  $<TARGET_FILE:field-bake> ${small} s/sequence.txt --box 1000,1000,1000,1001,1001,1001 --work work)
refused("first picture missing" "s/nowhere.exr: no such file"
  s/missing.txt --box 0,0,0,1,1,1)
refused("first picture empty" "s/empty.exr: cannot be read as OpenEXR .*"
  s/empty-picture.txt --box 0,0,0,1,1,1)
refused("picture of no mapping" "s/../odd.exr: a picture of 17 x 12: no mapping has this shape as a rule; name one"
  s/odd.txt --box 0,0,0,1,1,1)
refused("grid over the sequence" "s/sequence.txt: is read, and cannot be written as well" s/sequence.txt --out s/sequence.txt)
refused("grid over a picture" "s/probe-00003.exr: is read, and cannot be written as well" s/sequence.txt --out s/probe-00003.exr)
refused("grid in no folder" "nowhere/x.grid: cannot be written .*" s/sequence.txt --out nowhere/x.grid)

# What is done by then stays, for the next run.
program_case("a later picture missing" 2 "" "field-bake: s/nowhere.exr: cannot be read .No such file or directory."
  $<TARGET_FILE:field-bake> ${small} s/later-missing.txt)
program_case("a later picture damaged" 2 "work" "field-bake: s/../truncated.exr: cannot be read as OpenEXR .*"
  $<TARGET_FILE:field-bake> ${small} s/later-damaged.txt --work work)
program_case("samples cut off are made again" 0 "a.grid b.grid work work/samples-0.zonal" ""
  sh -c "$<TARGET_FILE:field-bake> --quiet --grid 4 s/sequence.txt --out a.grid --work work --keep-work && head -c 3000 work/samples-0.zonal > cut && mv cut work/samples-0.zonal && $<TARGET_FILE:field-bake> --quiet --grid 4 s/sequence.txt --out b.grid --work work --keep-work && cmp a.grid b.grid")
program_case("sums cut off" 2 "work work/samples-0.zonal work/sums.zonal" "field-bake: work/sums.zonal: .*"
  sh -c "$<TARGET_FILE:field-bake> --quiet --grid 4 s/sequence.txt --out a.grid --work work --keep-work && rm a.grid && echo ZONALSUM > work/sums.zonal && $<TARGET_FILE:field-bake> --quiet --grid 4 s/sequence.txt --out a.grid --work work")
program_case("folder of work that holds more" 0 "work work/mine x.grid" ""
  sh -c "mkdir work && touch work/mine && $<TARGET_FILE:field-bake> --quiet --grid 4 s/sequence.txt --out x.grid --work work")
program_case("full output" 1 "x.grid" "field-bake: standard output: cannot be written .No space left on device."
  sh -c "$<TARGET_FILE:field-bake> --grid 4 s/sequence.txt --out x.grid >/dev/full")
# Files of at most 8 KiB: a disk that is full.
program_case("no space for the samples" 2 "work" "field-bake: work/samples-0.zonal: cannot be written .File too large."
  bash -c "trap '' XFSZ && ulimit -f 8 && $<TARGET_FILE:field-bake> --quiet --grid 4 s/sequence.txt --out x.grid --work work")

# ---- What works -----------------------------------------------------------------------------------------------------

renders("help" "" "" --help)
renders("defaults" "field.grid" "" s/sequence.txt)
renders("gradients and report" "x.grid x.json" "" s/sequence.txt --gradients --bands 5 --out x.grid --report x.json)
renders("16 bits" "x.grid" "" s/sequence.txt --half --out x.grid)
renders("thinned" "x.grid" "" s/sequence.txt --thin 2 --thin-distance 10 --out x.grid)
renders("paper's steps" "x.grid" "" s/sequence.txt --path space --out x.grid)
renders("mean and nearest" "x.grid" "" s/sequence.txt --estimate mean --repair nearest --out x.grid)
renders("one probe in a box" "x.grid" "" s/one.txt --box -1,-1,-1,1,1,1 --out x.grid)
renders("pictures of two kinds" "x.grid" "" s/mixed.txt --out x.grid)

add_test(NAME "field-bake: killed at any moment, the bytes are the same" COMMAND
  ${programs_dir}/kill_and_go_on.sh $<TARGET_FILE:field-bake> ${work_dir}/inputs/s/many.txt ${work_dir}/killed)
set_tests_properties("field-bake: killed at any moment, the bytes are the same" PROPERTIES
  FIXTURES_REQUIRED field-bake_inputs TIMEOUT 120)

if(MPI_CXX_FOUND AND MPIEXEC_EXECUTABLE)
  foreach(ranks 2 3)
    program_case("${ranks} ranks of MPI" 0 "all.grid part.grid" ""
      ${programs_dir}/compare_ranks.sh $<TARGET_FILE:field-bake> ${MPIEXEC_EXECUTABLE} ${ranks})
    program_case("${ranks} ranks of MPI that cannot go on" 2 "" "field-bake: nowhere.txt: No such file or directory"
      ${programs_dir}/ranks_fail.sh $<TARGET_FILE:field-bake> ${MPIEXEC_EXECUTABLE} ${ranks})
  endforeach()
else()
  message(STATUS "no tests of field-bake on several ranks, for want of: MPI")
endif()

foreach(signal_status INT:130 TERM:143)
  string(REPLACE ":" ";" signal_status ${signal_status})
  list(GET signal_status 0 signal)
  list(GET signal_status 1 status)
  program_case("stopped by SIG${signal}" ${status} "work work/samples-0.zonal work/sums.zonal"
    "field-bake: interrupted, the same command goes on from here"
    timeout --preserve-status --kill-after=10 --signal=${signal} 1 $<TARGET_FILE:field-bake> s/many.txt --grid 64
    --path space --work work)
endforeach()
shows_progress(--threads 1 ${work_dir}/inputs/s/many.txt --grid 32 --path space)
set_tests_properties("field-bake: narrow terminal" PROPERTIES FIXTURES_REQUIRED field-bake_inputs)
