# hvl-render's cases.
set(program hvl-render)
set(small --size 16x12 --lights 4 --spp 1)
include(${CMAKE_CURRENT_LIST_DIR}/cases.cmake)

# ---- Arguments ------------------------------------------------------------------------------------------------------

refused("unknown option" "The following argument was not expected: --foo" --foo)
refused("stray argument" "The following argument was not expected: box.obj" box.obj)
refused("option without its value" "--method needs a value" --method)
refused("unknown method" "--method: 'magic' is not one of vpl.vsl.vsgl.vsgl-2024.hvl.hvl-zonal.path" --method magic)
foreach(bands 0 6 100 -1 abc 5.5)
  refused("bands ${bands}" "--bands: '${bands}' is not one of .*" --bands ${bands})
  refused("emission bands ${bands}" "--emission-bands: '${bands}' is not one of .*" --emission-bands ${bands})
endforeach()
foreach(lights 0 -4 10000001 many)
  refused("lights ${lights}" "--lights: '${lights}' is not in 1...10000000" --lights ${lights})
endforeach()
foreach(size 0x0 -5x10 10x-1 640 640x 640x512x3 axb 99999x1)
  refused("size ${size}" "--size: '${size}' is not a size such as .*" --size ${size})
endforeach()
foreach(radius 0 -1 nan inf r3)
  refused("radius ${radius}" "--radius: '${radius}' is neither .*" --radius ${radius})
endforeach()
refused("radius factor nan" "--radius-factor: 'nan' is not in .*" --radius-factor nan)
refused("spp 0" "--spp: '0' is not in 1...1000000" --spp 0)
refused("bounces 0" "--bounces: '0' is not in 1...64" --bounces 0)
refused("antialias 0" "--antialias: '0' is not in 1...16" --antialias 0)
refused("threads -1" "--threads: '-1' is not in 0...1024" --threads -1)
refused("exposure nan" "--exposure: 'nan' is not in -30...30" --exposure nan)
refused("horizon unknown" "--horizon: 'x' is not one of .*" --horizon x)
refused("camera of two coordinates" "--camera: '1,2' is not a point x,y,z .*" --camera 1,2)
foreach(point camera:1,2,nan camera:1e20,0,0 target:0,inf,0 light:0,0,-3e8 light-target:1e20,1,1)
  string(REGEX MATCH "^([^:]*):(.*)$" point ${point})
  refused("${CMAKE_MATCH_1} ${CMAKE_MATCH_2}"
    "--${CMAKE_MATCH_1}: '${CMAKE_MATCH_2}' is not a point x,y,z of coordinates up to 1e8"
    --${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
endforeach()
refused("camera at its target" "--camera and --target are the same point" --camera 1,1,1 --target 1,1.0000001,1)
refused("camera next to the origin" "--camera and --target are the same point" --camera 0,0,0 --target 0,0,1e-20)
refused("light at its target" "--light and --light-target are the same point" --light 1,1,1 --light-target 1,1,1)
refused("up unknown" "--up: 'x' is not one of y.z" --up x)
refused("field of view 0" "--fov: '0' is not in 1...170 degrees" --fov 0)
refused("compare paths with paths" "--compare renders paths beside another method: choose one" --compare out --method path)
refused("two numbers of lights" "--lights excludes --time-budget" --time-budget 1)
foreach(budget 0 -1 nan soon)
  refused("time budget ${budget}" "--time-budget: .*" --time-budget ${budget})
endforeach()
foreach(option vpl-clamp vsl-samples vsgl-texels)
  refused("${option} -1" "--${option}: '-1' is not in .*" --${option} -1)
endforeach()
refused("option of another method" "--vsl-samples means nothing to --method vpl" --method vpl --vsl-samples 9)
refused("cache of no table" "--material-cache means nothing to --method vpl" --method vpl --material-cache x)
foreach(tolerance -1 2 nan little)
  refused("tolerance ${tolerance}" "--tolerance: '${tolerance}' is not in 0...1" --tolerance ${tolerance})
endforeach()
refused("tolerance of vpl" "--tolerance means nothing to --method vpl" --method vpl --tolerance 0.1)
refused("tolerance of 4 bands" "--tolerance: not for --bands 4: these numbers of bands are not compiled in" --bands 4
  --tolerance 0.1)
program_case("tolerance in a time" 2 "" "hvl-render: --time-budget excludes --tolerance" $<TARGET_FILE:hvl-render>
  --tolerance 0.1 --time-budget 1)
foreach(option --check=0.5 --explain)
  string(REGEX REPLACE "=.*" "" name ${option})
  refused("${name} of no plan" "${name} means nothing without --tolerance" ${option})
endforeach()
refused("map too large" "--lights and --vsgl-texels ask for a map of 1024000 texels across, more than 3200"
  --method vsgl --lights 1000000 --vsgl-texels 1024)
# Not as a number of base eight, which a zero in front is in C.
refused("lights with a zero in front" "--lights and --vsgl-texels ask for a map of 1024000 texels across, more than 3200"
  --method vsgl --lights 01000000 --vsgl-texels 1024)
refused("bands of no band" "--bands means nothing to --method vsgl" --method vsgl --bands 3)
refused("bands of hvl-zonal" "--bands: '21' is not one of 1.2.3.4.5.7.9, which --method hvl has" --bands 21)
refused("bands of hvl" "--bands: '4' is not one of 3.5.7.9.15.21, which --method hvl-zonal has" --method hvl-zonal --bands 4)

# ---- Materials ------------------------------------------------------------------------------------------------------

refused("material without a spec" "--material: 'gold' is not NAME=SPEC" --material gold)
refused("material of no scene" "--material: the scene has no 'brass', but plaster, .*" --material brass=gold)
foreach(spec brass gold:0 gold:2 gold:x matte matte:1,1 matte:1,1,2 plastic:1,1,1 phong:1,1,1,-1)
  refused("material ${spec}" "--material: '${spec}' is none of matte:R,G,B .*" --material gold=${spec})
endforeach()
foreach(file nowhere.binary nowhere.bsdf folder.obj/x.binary)
  refused("material ${file}" "${file}: .*" --material gold=${file})
endforeach()
refused("material of another format" "scenes.binary: is no MERL file: .*" --material gold=scenes.binary)

# ---- Scenes ---------------------------------------------------------------------------------------------------------

refused("scene missing" "nowhere.obj: no such file" --scene nowhere.obj)
program_case("scene without a name" 2 "" "hvl-render: --scene: the name is empty"
  sh -c "'$<TARGET_FILE:hvl-render>' --scene ''")
refused("scene that is a folder" "folder.obj: is not a file" --scene folder.obj)
foreach(scene empty no_faces no_area edge)
  refused("scene ${scene}" "${scene}.obj: no triangles in it" --scene ${scene}.obj)
endforeach()
foreach(scene nan infinite far short_vertex garbage)
  refused("scene ${scene}" "${scene}.obj:[23]?: not three finite coordinates up to 1e8" --scene ${scene}.obj)
endforeach()
refused("scene index_beyond" "index_beyond.obj:4: a face names vertex 9 of 3" --scene index_beyond.obj)
foreach(scene index_before:-9 index_zero:0 index_word:a)
  string(REGEX MATCH "^([^:]*):(.*)$" scene ${scene})
  refused("scene ${CMAKE_MATCH_1}" "${CMAKE_MATCH_1}.obj:4: '${CMAKE_MATCH_2}' names no vertex"
    --scene ${CMAKE_MATCH_1}.obj)
endforeach()
renders("scene missing_mtl" "x.png" "hvl-render: warning: missing_mtl.obj: no material file nowhere.mtl; .* grey"
  --scene missing_mtl.obj --out x.png)

# ---- Files ----------------------------------------------------------------------------------------------------------

refused("out in no folder" "nowhere/x.png: cannot be written .*" --out nowhere/x.png)
refused("out below a file" "box.obj/x.png: cannot be written .*" --out box.obj/x.png)
refused("out on a folder" "folder.png: is not a regular file" --out folder.png)
refused("out of no known format" "--out: 'x.jpg' does not end in .png or .exr" --out x.jpg)
refused("report in no folder" "nowhere/x.json: cannot be written .*" --out x.png --report nowhere/x.json)
refused("report on a pipe" "pipe: is not a regular file" --out x.png --report pipe)
refused("report on the picture" "x.png: two outputs cannot be one file" --out x.png --report ./x.png)
refused("compare in no folder" "nowhere/out: cannot be made a directory .*" --compare nowhere/out)
refused("compare below a file" "box.obj: cannot be made a directory .*" --compare box.obj)
refused("compare without a scene" "nowhere.obj: no such file" --compare out --scene nowhere.obj)
refused("compare without a report" "nowhere/x.json: cannot be written .*" --compare out --report nowhere/x.json)
refused("reference missing" "nowhere.exr: no such file" --out x.png --reference nowhere.exr)
refused("reference that is a folder" "folder.png: is not a file" --out x.png --reference folder.png)
refused("reference of another size" "other_size.exr: is 12x16, not 16x12" --out x.png --reference other_size.exr)
refused("reference truncated" "truncated.exr: cannot be read as OpenEXR .*" --out x.png --reference truncated.exr)
refused("reference of no format" "box.obj: cannot be read as OpenEXR .*" --out x.png --reference box.obj)

guards_its_output()
refused("out on the reference" "reference.exr: is read, and cannot be written as well"
  --out reference.exr --reference reference.exr)

# ---- What works -----------------------------------------------------------------------------------------------------

renders("help" "" "" --help)
renders("comparison" "out out/difference.png out/hvl.exr out/hvl.png out/reference.exr out/reference.png" ""
  --compare out)
renders("quiet picture and report" "x.exr x.json" "" --scene box.obj --out x.exr --report x.json --reference reference.exr --quiet)
renders("OBJ by both methods" "out out/difference.png out/hvl.exr out/hvl.png out/reference.exr out/reference.png" ""
  --scene box.obj --compare out --horizon exact --bounces 3)
renders("no second horizon" "x.png" "" --scene box.obj --out x.png --horizon none --visibility centre)
renders("within a tolerance" "x.json x.png" "" --scene box.obj --out x.png --report x.json --lights 400 --tolerance 0.02
  --explain)
if(TARGET zonal-glsl)
  program_case("a shader of the plan" 0 "x.glsl x.json x.png" "" sh -c "'$<TARGET_FILE:hvl-render>' --scene box.obj \
    --size 16x12 --out x.png --report x.json --lights 400 --tolerance 0.02 && \
    '$<TARGET_FILE:zonal-glsl>' --plan x.json -o x.glsl && grep -q zonal_gather_planned x.glsl")
endif()
renders("comparison within a tolerance" "out out/difference.png out/hvl.exr out/hvl.png out/reference.exr out/reference.png"
  "" --scene box.obj --lights 400 --tolerance 0.02 --compare out --visibility centre --horizon none)
renders("textures within a tolerance" "x.png" "hvl-render: warning: virtual lights on 'tile' and other glossy reliefs .*"
  --scene textured.obj --lights 400 --tolerance 0.02 --out x.png)
renders("no lights within a tolerance" "x.png" "hvl-render: warning: nothing in view is lit, and the picture black"
  --scene box.obj --no-stage --light 0,50,0 --light-target 0,100,0 --tolerance 0.01 --out x.png)
renders("OBJ without the stage" "x.png" "" --scene triangle.obj --no-stage --out x.png --method path)
renders("the last of two equal options" "y.png" "" --scene box.obj --out x.png --out y.png)

foreach(method vpl vsl vsgl vsgl-2024 hvl-zonal)
  renders("${method}" "x.png" "" --scene box.obj --method ${method} --out x.png --visibility centre)
  set(compared out/difference.png out/${method}.exr out/${method}.png out/reference.exr out/reference.png)
  list(SORT compared)
  list(JOIN compared " " compared)
  renders("comparison of ${method}" "out ${compared}" "" --scene box.obj --method ${method} --compare out)
endforeach()
foreach(method vpl vsl vsgl vsgl-2024 hvl hvl-zonal)
  renders("textures by ${method}" "x.png" "hvl-render: warning: virtual lights on 'tile' and other glossy reliefs .*"
    --scene textured.obj --method ${method} --out x.png)
endforeach()
renders("textures by paths" "x.png" "" --scene textured.obj --method path --out x.png)
foreach(scene atrium-diffuse atrium-glossy furnace)
  renders("${scene}" "x.png" "" --scene ${scene} --out x.png)
endforeach()
renders("courtyard" "x.png" "hvl-render: warning: virtual lights on 'light tile' and other glossy .*"
  --scene courtyard --out x.png)
renders("atrium-bumped" "x.png" "" --scene atrium-bumped --out x.png)
renders("other materials" "x.exr" "" --out x.exr --material gold=copper:0.1 --material *=plastic:0.1,0.2,0.3,0.4)
renders("multiple scattering" "x.exr" "" --out x.exr --multiple-scattering --material gold=copper:1)
program_case("time budget of many texels" 0 "x.png" "" $<TARGET_FILE:hvl-render>
  --size 32x24 --method vsgl --vsgl-texels 128 --time-budget 0.01 --out x.png --quiet)
# What is black is said to be, and the table has no numbers that are none.
renders("nothing in view" "x.json x.png" "hvl-render: warning: nothing is in view, and the picture black"
  --scene box.obj --no-stage --camera 0,0,1e8 --target 0,0,2e7 --out x.png --report x.json)
renders("nothing lit" "out out/difference.png out/hvl.exr out/hvl.png out/reference.exr out/reference.png"
  "hvl-render: warning: nothing in view is lit, and the picture black"
  --scene box.obj --no-stage --light 0,50,0 --light-target 0,100,0 --compare out)
renders("camera straight up" "x.png" "" --scene box.obj --camera 0.5,9,0.5 --target 0.5,0,0.5 --up z --view outside --out x.png)
program_case("time budget" 0 "x.png" "" $<TARGET_FILE:hvl-render> --size 64x48 --time-budget 0.05 --out x.png --quiet)

stops(--compare out --spp 1000000)
program_case("stopped while it chooses the lights" 130 "" "hvl-render: interrupted, nothing written"
  timeout --preserve-status --kill-after=10 --signal=INT 2 $<TARGET_FILE:hvl-render>
  --size 4096x4096 --method vsl --vsl-samples 1024 --time-budget 80000)
shows_progress(--method path --threads 1 --spp 32 --size 160x128)

# ---- Numbers --------------------------------------------------------------------------------------------------------

example_test(hvl_render_test.cpp)
