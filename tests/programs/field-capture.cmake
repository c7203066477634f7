# field-capture's cases.
set(program field-capture)
set(small --size 8 --probes 2 --samples 1)
set(few --sets 1)
set(inputs_program igi-render)
include(${CMAKE_CURRENT_LIST_DIR}/cases.cmake)

# ---- Arguments ------------------------------------------------------------------------------------------------------

refused("unknown set-up" "--setup: 'sun' is not one of projector.spots" --setup sun)
refused("unknown mapping" "--mapping: 'cube' is not one of equirectangular.+octahedral" --mapping cube)
refused("unknown layout" "--layout: 'line' is not one of grid.planes.random" --layout line)
foreach(probes 0 -1 many)
  refused("probes ${probes}" "--probes: '${probes}' is not in 1...1000000" --probes ${probes})
endforeach()
foreach(box 0,0,0 0,0,0,1,1 a,b,c,d,e,f 0,0,0,1,1,1,1 0,nan,0,1,1,1 0,0,0,1,1,inf)
  refused("box ${box}" "--box: '${box}' is not a box such as -0.5,1,2,0.5,2,3" --box ${box})
endforeach()
refused("box inside out" "--box: the low corner must be below the high one on every axis" --box 1,1,1,0,2,2)
refused("box of nothing" "--box: the low corner must be below the high one on every axis" --box 1,1,1,1,2,2)
refused("size 4" "--size: '4' is not in 8...4096" --size 4)
refused("sphere radius" "--sphere-radius: '-1' is not in 0...1 metres" --sphere-radius -1)
refused("radius of no sphere" "--sphere-radius: only of --mapping mirror-sphere" --mapping octahedral --sphere-radius 0.1)
refused("dead angle of no sphere" "--dead-angle: only of --mapping mirror-sphere" --mapping octahedral --dead-angle 3)
refused("dead angle 91" "--dead-angle: '91' is not in 0...90 degrees" --dead-angle 91)
refused("samples 0" "--samples: '0' is not in 1...65536" --samples 0)

# ---- Files ----------------------------------------------------------------------------------------------------------

refused("scene missing" "nowhere.obj: no such file" --scene nowhere.obj)
refused("out in no folder" "nowhere/x: cannot be made a directory .*" --out nowhere/x)
refused("out that is a file" "box.obj: cannot be made a directory .*" --out box.obj)
set(capture $<TARGET_FILE:field-capture> --quiet --scene box.obj ${small})
list(JOIN capture " " capture)
program_case("folder of other settings" 2 "out out/probe-00000.exr out/sequence.txt out/settings.txt"
  "${program}: out/settings.txt: says that the folder's probes are of other settings; name another folder"
  sh -c "${capture} --probes 1 --out out && ${capture} --probes 1 --seed 2 --out out")
program_case("folder of another program's sequence" 2 "out out/sequence.txt"
  "${program}: out/sequence.txt: is of another program, and is not overwritten"
  sh -c "mkdir out && echo probe > out/sequence.txt && ${capture} --out out")
program_case("once more" 0 "out out/probe-00000.exr out/sequence.txt out/settings.txt" ""
  sh -c "${capture} --probes 1 --out out && : > out/probe-00000.exr && ${capture} --probes 1 --out out && test -s out/probe-00000.exr")
program_case("full output" 1 "out out/probe-00000.exr out/sequence.txt out/settings.txt"
  "${program}: standard output: cannot be written .No space left on device."
  sh -c "$<TARGET_FILE:field-capture> --scene box.obj --size 8 --probes 1 --out out >/dev/full")

function(truth name status new_files pattern)
  program_case("truth: ${name}" ${status} "${new_files}" "${pattern}" $<TARGET_FILE:field-capture> --scene box.obj ${ARGN})
endfunction()
truth("no positions" 2 "" "${program}: nowhere.txt: no such file" --truth nowhere.txt)
truth("positions that are none" 2 "" "${program}: box.obj: line [0-9]+ is no position x y z" --truth box.obj)
program_case("truth: over its positions" 2 "x.txt" "${program}: ./x.txt: is read, and cannot be written as well"
  sh -c "echo 0 0 0 > x.txt && $<TARGET_FILE:field-capture> --scene box.obj --truth x.txt --out ./x.txt")
truth("bands" 2 "" "${program}: --bands: '10' is not in 1...9" --truth box.obj --bands 10)
truth("with pictures" 2 "" "${program}: --size excludes --truth" --truth box.obj --size 8)
program_case("truth: two places" 0 "truth.csv x.txt" ""
  sh -c "printf '# here\\n0 0.5 0\\n0.1 0.5 -1e-1 # there\\n' > x.txt && $<TARGET_FILE:field-capture> --scene box.obj --truth x.txt --truth-samples 64 --bands 2 && test $(wc -l < truth.csv) -eq 3")

# ---- What works -----------------------------------------------------------------------------------------------------

renders("help" "" "" --help)
foreach(layout grid random)
  renders("layout ${layout}" "x x/probe-00000.exr x/sequence.txt x/settings.txt" "" --scene box.obj --layout ${layout}
    --probes 1 --out x)
endforeach()
renders("layout planes" "x x/probe-00000.exr x/probe-00001.exr x/probe-00002.exr x/sequence.txt x/settings.txt" ""
  --scene box.obj --layout planes --probes 3 --out x)
renders("equirectangular, spots" "x x/probe-00000.exr x/sequence.txt x/settings.txt" "" --setup spots --probes 1
  --mapping equirectangular --out x)

foreach(signal_status INT:130 TERM:143)
  string(REPLACE ":" ";" signal_status ${signal_status})
  list(GET signal_status 0 signal)
  list(GET signal_status 1 status)
  program_case("stopped by SIG${signal}" ${status} "out out/settings.txt"
    "${program}: interrupted, 0 of 1 probes are in the folder"
    timeout --preserve-status --kill-after=10 --signal=${signal} 2 $<TARGET_FILE:field-capture> --out out --probes 1
    --size 1024 --samples 1024)
endforeach()
shows_progress(--threads 1 --probes 60 --size 48)

example_test(field_capture_test.cpp)
