# field-render's cases. The grids are grid-render's.
set(program field-render)
set(small --grid box.grid --size 16x12)
set(inputs_program grid-render)
include(${CMAKE_CURRENT_LIST_DIR}/cases.cmake)

# ---- Arguments ------------------------------------------------------------------------------------------------------

program_case("no grid" 2 "" "${program}: --grid is required" $<TARGET_FILE:field-render>)
refused("unknown interpolation" "--interpolation: 'taylor' is not one of trilinear.hermite" --interpolation taylor)
refused("unknown reference" "--reference: 'sun' is not one of projector.spots" --reference sun)
foreach(bands 0 7 many)
  refused("bands ${bands}" "--bands: '${bands}' is not in 1...6" --bands ${bands})
endforeach()
refused("comparison with nothing" "--compare needs --reference" --compare out)
refused("two modes" "--compare excludes --out" --compare out --out x.png)
refused("unknown material" "--material: the scene has no 'gold', but table, ball, knot, vase" --material gold=matte:1,1,1)
refused("unknown spec" "--material: 'chalk' is none of .*" --material table=chalk)
refused("box inside out" "--box: the low corner must be below the high one on every axis" --reference spots
  --box 1,1,1,0,2,2)

# ---- Files ----------------------------------------------------------------------------------------------------------

refused("grid missing" "nowhere.grid: no such file" --grid nowhere.grid)
refused("grid that is none" "box.obj: is no grid.*" --grid box.obj)
refused("grid truncated" "truncated.grid: is damaged.*" --grid truncated.grid)
refused("object missing" "nowhere.obj: no such file" --object nowhere.obj)
refused("scene missing" "nowhere.obj: no such file" --scene nowhere.obj --reference spots)
refused("out in no folder" "nowhere/x.png: cannot be written .*" --out nowhere/x.png)
refused("report on the grid" "./box.grid: is read, and cannot be written as well" --report ./box.grid)
program_case("full output" 1 "x.png" "${program}: standard output: cannot be written .No space left on device."
  sh -c "$<TARGET_FILE:field-render> --grid box.grid --size 16x12 --out x.png >/dev/full")

# ---- What works -----------------------------------------------------------------------------------------------------

renders("help" "" "" --help)
renders("comparison" "out out/difference.png out/grid.exr out/grid.png out/reference.exr out/reference.png x.json"
  "" --reference projector --compare out --samples 1 --report x.json --interpolation hermite)
renders("reference alone" "x.exr" "" --reference spots --samples 1 --out x.exr --object table)
renders("OBJ" "field-render.png" "" --object textured.obj --quiet)

stops(--grid box.grid --reference projector --samples 65536)
shows_progress(--threads 1 --grid ${work_dir}/inputs/box.grid --reference spots --samples 64 --size 160x128)
set_tests_properties("${program}: narrow terminal" PROPERTIES FIXTURES_REQUIRED ${program}_inputs)

example_test(field_render_test.cpp)
