# grid-render's cases.
set(program grid-render)
set(small --size 16x12 --antialias 1 --grid 2)
include(${CMAKE_CURRENT_LIST_DIR}/cases.cmake)

# ---- Arguments ------------------------------------------------------------------------------------------------------

refused("unknown interpolation" "--interpolation: 'cubic' is not one of none.trilinear.taylor.hermite"
  --interpolation cubic)
refused("two modes" "--compare excludes --interpolation" --compare out --interpolation taylor)
foreach(bands 0 4 abc)
  refused("bands ${bands}" "--bands: '${bands}' is not one of 3.5.7.9" --bands ${bands})
endforeach()
foreach(bands 0 10)
  refused("lobe bands ${bands}" "--lobe-bands: '${bands}' is not in 1...9" --lobe-bands ${bands})
endforeach()
foreach(lights 0 -4 many)
  refused("lights ${lights}" "--lights: '${lights}' is not in 1...100000" --lights ${lights})
endforeach()
foreach(grid 1 33 8x8 8x8x8x8)
  refused("grid ${grid}" "--grid: '${grid}' is not a resolution such as .*" --grid ${grid})
endforeach()
refused("lights and a texture" "--texture excludes --lights" --lights 4 --texture reference.exr)
refused("quadtree without a texture" "--quadtree-error requires --texture" --quadtree-error 0.1)
refused("quadtree error nan" "--quadtree-error: 'nan' is not in 0...1000" --texture reference.exr --quadtree-error nan)
refused("texture size 0" "--texture-size: '0' is not in 1...512" --texture reference.exr --texture-size 0)

refused("unknown shape" "--shape: 'cube' is not one of spheres.triangles.triangle-spheres" --shape cube)
refused("two comparisons" "--compare excludes --compare-shapes" --compare out --compare-shapes out)
refused("a shape and all of them" "--compare-shapes excludes --shape" --compare-shapes out --shape triangles)
foreach(arguments "--shape;triangles" "--shape;triangle-spheres" "--compare-shapes;out")
  refused("bands for ${arguments}" "--bands: '7' is not one of 5.9, as triangles need" --bands 7 ${arguments})
endforeach()
foreach(option save load)
  program_case("${option} without a grid" 2 "" "grid-render: --${option}-grid: --interpolation none has no grid"
    $<TARGET_FILE:grid-render> --interpolation none --${option}-grid box.grid)
endforeach()
program_case("grid both saved and loaded" 2 "" "grid-render: --save-grid excludes --load-grid"
  $<TARGET_FILE:grid-render> --load-grid box.grid --save-grid x.grid)
refused("visibility without paths" "--visibility requires --paths" --visibility)
refused("paths and an interpolation" "--interpolation excludes --paths" --paths 4 --interpolation hermite)
refused("paths and a file" "--save-grid excludes --paths" --paths 4 --save-grid x.grid)
refused("no paths" "--paths: '0' is not in 1...65536" --paths 0)
refused("resolution of a loaded grid" "--grid excludes --load-grid" --load-grid box.grid)

foreach(tolerance -1 2 nan little)
  refused("tolerance ${tolerance}" "--tolerance: '${tolerance}' is not in 0...1" --tolerance ${tolerance})
endforeach()
foreach(option interpolation:taylor compare:out compare-shapes:out shape:triangles paths:4 save-grid:x.grid load-grid:box.grid)
  string(REPLACE ":" ";--tolerance;0.1;" option ${option})
  list(GET option 0 name)
  list(GET option 3 value)
  program_case("tolerance and ${name}" 2 "" "grid-render: --[a-z-]+ excludes --[a-z-]+" $<TARGET_FILE:grid-render>
    --tolerance 0.1 --${name} ${value})
endforeach()
refused("tolerance and a resolution" "--[a-z]+ excludes --[a-z]+" --tolerance 0.1)
refused("explanation of nothing" "--explain requires --tolerance" --explain)

# ---- Files ----------------------------------------------------------------------------------------------------------

refused("scene missing" "nowhere.obj: no such file" --scene nowhere.obj)
refused("scene nan" "nan.obj:[0-9]+: not three finite coordinates up to 1e8" --scene nan.obj)
refused("texture missing" "nowhere.png: no such file" --texture nowhere.png)
refused("texture that is a folder" "folder.png: is not a file" --texture folder.png)
refused("texture of no format" "box.obj: cannot be read as a picture .*" --texture box.obj)
refused("texture truncated" "truncated.exr: cannot be read as OpenEXR .*" --texture truncated.exr)
refused("texture that is black" "black.png: is black, and lights nothing" --texture black.png)
refused("out in no folder" "nowhere/x.png: cannot be written .*" --out nowhere/x.png)
refused("report on the picture" "x.png: two outputs cannot be one file" --out x.png --report ./x.png)
refused("report on a picture of the comparison" "out/taylor.exr: two outputs cannot be one file"
  --compare out --report out/taylor.exr)
refused("compare below a file" "box.obj: cannot be made a directory .*" --compare box.obj)
refused("compare without a texture" "nowhere.png: no such file" --compare out --texture nowhere.png)

refused("save in no folder" "nowhere/x.grid: cannot be written .*" --save-grid nowhere/x.grid)
refused("save on a folder" "folder.png: is not a regular file" --save-grid folder.png)
refused("save on the picture" "./x.png: two outputs cannot be one file" --out ./x.png --save-grid x.png)
program_case("load missing" 2 "" "grid-render: nowhere.grid: No such file or directory"
  $<TARGET_FILE:grid-render> --load-grid nowhere.grid)
foreach(load "no grid:box.obj:is no grid" "truncated:truncated.grid:is damaged: .*"
    "of other bands:box.grid:has 5 bands, not 3" "of another scene:triangle.grid:is of another scene: .*")
  string(REGEX MATCH "^([^:]*):([^:]*):(.*)$" load "${load}")
  set(name ${CMAKE_MATCH_1})
  set(file ${CMAKE_MATCH_2})
  set(what ${CMAKE_MATCH_3})
  set(bands 5)
  if(name STREQUAL "of other bands")
    set(bands 3)
  endif()
  program_case("load ${name}" 2 "" "grid-render: ${file}: ${what}"
    $<TARGET_FILE:grid-render> --scene box.obj --bands ${bands} --load-grid ${file})
endforeach()

guards_its_output()
refused("out on the texture" "reference.exr: is read, and cannot be written as well"
  --out reference.exr --texture ./reference.exr)

# ---- What works -----------------------------------------------------------------------------------------------------

foreach(pass hermite taylor trilinear trilinear-equal-memory)
  list(APPEND compared out/${pass}-difference.png out/${pass}.exr out/${pass}.png)
endforeach()
list(APPEND compared out/reference.exr out/reference.png)
list(SORT compared)
list(JOIN compared " " compared)
renders("help" "" "" --help)
renders("comparison" "out ${compared} x.json" "" --scene box.obj --compare out --report x.json --bands 3)
renders("picture without a grid" "x.png" "" --scene box.obj --interpolation none --bands 9 --out x.png)
renders("textures" "x.png" "" --scene textured.obj --out x.png)
renders("flat scene without the stage" "grid-render.png" "" --scene triangle.obj --no-stage --quiet)
renders("lit by a picture" "x.exr" "" --scene box.obj --texture reference.exr --quadtree-error 0.2 --out x.exr)

program_case("within a tolerance" 0 "x.json x.png" "" $<TARGET_FILE:grid-render> --size 64x48 --scene box.obj --lights 200
  --tolerance 0.02 --explain --out x.png --report x.json)
program_case("no grid within a tolerance" 0 "x.png" "" sh -c "'$<TARGET_FILE:grid-render>' --size 16x12 --scene box.obj \
  --lights 4 --tolerance 0.0000001 --explain --out x.png | grep -q 'no grid within it takes less time'")
renders("triangles" "x.png" "" --scene box.obj --lights 4 --shape triangles --out x.png)
renders("triangle spheres of a picture" "x.png" ""
  --scene box.obj --texture reference.exr --texture-size 4 --shape triangle-spheres --bands 9 --out x.png)
# A grid has its gradients in the file, whatever it was saved by.
foreach(shape spheres triangles)
  program_case("${shape} saved and loaded" 0 "a.exr b.exr x.grid" "" ${programs_dir}/save_and_load.sh
    $<TARGET_FILE:grid-render> --shape ${shape} --lights 4 --grid 2x3x4)
endforeach()

stops(--compare out --lights 100000)
shows_progress(--interpolation none --threads 1 --lights 2000 --size 160x128)

# ---- Numbers --------------------------------------------------------------------------------------------------------

add_test(NAME "grid-render: errors in the atrium" COMMAND ${CMAKE_COMMAND} -Dprogram=$<TARGET_FILE:grid-render>
  -Dfolder=${work_dir}/errors -P ${programs_dir}/grid_errors.cmake)
set_tests_properties("grid-render: errors in the atrium" PROPERTIES TIMEOUT 60)

add_test(NAME "grid-render: errors of the shapes" COMMAND ${CMAKE_COMMAND} -Dprogram=$<TARGET_FILE:grid-render>
  -Dfolder=${work_dir}/shapes -P ${programs_dir}/grid_shapes.cmake)
set_tests_properties("grid-render: errors of the shapes" PROPERTIES TIMEOUT 60)

add_test(NAME "grid-render: leak through the wall of the rooms" COMMAND ${CMAKE_COMMAND}
  -Dprogram=$<TARGET_FILE:grid-render> -Dfolder=${work_dir}/leak -P ${programs_dir}/grid_leak.cmake)
set_tests_properties("grid-render: leak through the wall of the rooms" PROPERTIES TIMEOUT 120)

example_test(grid_render_test.cpp)
