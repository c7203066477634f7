# igi-render's cases.
set(program igi-render)
set(small --size 16x12 --sets 2)
set(few --sets 1)
include(${CMAKE_CURRENT_LIST_DIR}/cases.cmake)

# ---- Arguments ------------------------------------------------------------------------------------------------------

refused("unknown filter" "--filter: 'median' is not one of radiance.irradiance.irradiance-strict.sg.l1.none"
  --filter median)
foreach(pattern 0x4 4x0 -1x4 17x1 4 4x4x4 axb)
  refused("pattern ${pattern}" "--pattern: '${pattern}' is not a pattern such as 4x4, 1x1 to 16x16" --pattern ${pattern})
endforeach()
refused("pattern larger than the picture" "--pattern: a pattern of 16x16 sets, larger than the picture, 16x12"
  --pattern 16x16)
foreach(bands 0 1 6 abc)
  refused("bands ${bands}" "--bands: '${bands}' is not one of 2.3.4.5" --bands ${bands})
endforeach()
refused("unknown window" "--window: 'cosine' is not one of none.hann.sinc" --window cosine)
foreach(sets 0 -1 4097 many)
  refused("sets ${sets}" "--sets: '${sets}' is not in 1...4096" --sets ${sets})
endforeach()
refused("bounces -1" "--bounces: '-1' is not in 0...16" --bounces -1)
refused("least distance nan" "--least-distance: 'nan' is not in 0...1e6 metres" --least-distance nan)
refused("plane distance 2" "--plane-distance: '2' is not in 0...1" --plane-distance 2)
refused("probe and lighting" "--lighting excludes --probe" --lighting spot --probe x.exr)
refused("lighting by no probe" "--lighting probe needs --probe" --lighting probe)
refused("two modes" "--compare excludes --filter" --compare out --filter sg)
refused("too many positions" "--size and --antialias ask for more than 32 million positions" --size 8192x8192)

# ---- Files ----------------------------------------------------------------------------------------------------------

refused("probe missing" "nowhere.exr: no such file" --probe nowhere.exr)
refused("probe of no format" "box.obj: cannot be read as a picture .*" --probe box.obj)
refused("probe truncated" "truncated.exr: cannot be read as OpenEXR .*" --probe truncated.exr)
refused("scene missing" "nowhere.obj: no such file" --scene nowhere.obj)
refused("out in no folder" "nowhere/x.png: cannot be written .*" --out nowhere/x.png)
refused("probe that is black" "black.png: is black, or too bright, and lights nothing" --probe black.png)
refused("probe of no shape" "odd.exr: a picture of 17 x 12: no mapping has this shape as a rule; name one"
  --probe odd.exr)
refused("out on the probe" "reference.exr: is read, and cannot be written as well" --out reference.exr --probe ./reference.exr)
guards_its_output()

# ---- What works -----------------------------------------------------------------------------------------------------

foreach(pass radiance irradiance irradiance-strict sg l1 none)
  list(APPEND compared out/${pass}-difference.png out/${pass}.exr out/${pass}.png)
endforeach()
list(APPEND compared out/reference.exr out/reference.png)
list(SORT compared)
list(JOIN compared " " compared)
renders("help" "" "" --help)
renders("comparison" "out ${compared} x.json" "" --scene box.obj --compare out --report x.json --half)
renders("textures" "x.png" "" --scene textured.obj --lighting area --bands 5 --out x.png)
renders("lit by a cross" "x.exr" "" --scene box.obj --probe reference.exr --out x.exr)
renders("no bounces" "igi-render.png" "" --scene triangle.obj --no-stage --quiet --bounces 0 --pattern 3x5)

stops(--compare out --scene atrium --sets 4096)
shows_progress(--threads 1 --sets 200 --size 160x128)

example_test(igi_render_test.cpp)
