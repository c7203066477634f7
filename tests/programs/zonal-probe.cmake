# zonal-probe's cases.
set(program zonal-probe)
add_executable(make_probe_inputs ${CMAKE_CURRENT_LIST_DIR}/zonal-probe/make_inputs.cpp)
zonal_own_target(make_probe_inputs)
target_link_libraries(make_probe_inputs PRIVATE example-basics)
target_include_directories(make_probe_inputs SYSTEM PRIVATE ${ZONAL_STB_INCLUDE_DIR})
set(inputs_command make_probe_inputs)
include(${CMAKE_CURRENT_LIST_DIR}/cases.cmake)

# ---- Arguments ------------------------------------------------------------------------------------------------------

refused("no input" "which picture, or coefficients. --help says more")
refused("unknown option" "The following argument was not expected: --foo" sky.exr --foo)
refused("two inputs" "The following argument was not expected: sky.png" sky.exr sky.png)
foreach(bands 0 11 abc)
  refused("bands ${bands}" "--bands: '${bands}' is not in 1...10" sky.exr --bands ${bands})
endforeach()
refused("bands of unity" "--bands: unity stores at most 3 bands, not 4" sky.exr --bands 4 --convention unity)
refused("bands that unity has no room for" "--bands: unity stores at most 3 bands, not 5" five.json --convention unity)
refused("bands that are not there" "--bands: unity.json has 3, not 4" unity.json --bands 4)
refused("unknown convention" "--convention: 'untiy' is no convention; did you mean unity. --list names them all"
  sky.exr --convention untiy)
refused("unknown convention to read" "--from: 'Three.jz' is no convention; did you mean threejs. .*"
  nine.txt --from Three.jz)
refused("quantity of unity" "--quantity: unity stores irradiance over pi, not radiance"
  sky.exr --convention unity --quantity radiance)
refused("unknown quantity" "--quantity: 'luminance' is not one of .*" sky.exr --quantity luminance)
refused("unknown mapping" "--mapping: 'latlong' is not one of auto, equirectangular, .*" sky.exr --mapping latlong)
refused("mapping of coefficients" "--mapping means nothing to coefficients" unity.json --mapping octahedral)
refused("planes of a picture" "--planes means nothing to a picture" sky.exr --planes)
foreach(frame up x,y,y)
  refused("frame ${frame}" "--frame: '${frame}' is not one of picture, opengl, .*" sky.exr --frame ${frame})
endforeach()
foreach(turn up left:90 up:90, up:nan)
  refused("rotate ${turn}" "--rotate: '${turn}' is not turns such as up:90,right:-20" sky.exr --rotate ${turn})
endforeach()
foreach(window boxcar auto:3 hann:0)
  refused("window ${window}" "--window: '${window}' is not one of none, hann, sinc, laplacian, auto, .*" sky.exr --window ${window})
endforeach()
refused("unknown format" "--format: 'xml' is not one of text.json.cpp.glsl.hlsl" sky.exr --format xml)
refused("name that is none" "--name: '9x' is not a name such as probe" sky.exr --name 9x)

# ---- Files ----------------------------------------------------------------------------------------------------------

refused("missing picture" "nowhere.exr: no such file" nowhere.exr --out x.txt)
refused("folder" "folder.png: is not a file" folder.png --out x.txt)
refused("empty EXR" "empty.exr: cannot be read as OpenEXR .*" empty.exr --out x.txt)
refused("empty PNG" "empty.png: cannot be read as a picture .*" empty.png --out x.txt)
refused("truncated EXR" "truncated.exr: cannot be read as OpenEXR .*" truncated.exr --out x.txt --preview x.png)
refused("text named PNG" "text.png: cannot be read as a picture .*" text.png --out x.txt)
refused("shape of no mapping" "odd.exr: a picture of 17 x 12: no mapping .*; name one by --mapping" odd.exr --out x.txt)
refused("mapping that does not fit" "sky.exr: no vertical cross, 24 x 12: .*" sky.exr --mapping vertical-cross)
refused("missing list" "nowhere.txt: no such file" nowhere.txt --from unity)
refused("empty list" "empty.txt: is empty" empty.txt --from unity)
refused("nobody's list" "nine.txt: whose numbers are these. --from NAME .*" nine.txt)
refused("eight numbers" "eight.txt: holds 8 numbers, which is neither N.N nor .*" eight.txt --from unity)
refused("NaN in a list" "nan.txt: 'nan' is no finite number" nan.txt --from unity --out x.txt)
refused("infinity in a list" "infinite.txt: 'inf' is no finite number" infinite.txt --from unity --out x.txt)
refused("bytes in a list" "bytes.txt: '.+' is no number" bytes.txt --from unity)
refused("words in a list" "words.txt: 'one' is no number" words.txt --from unity)
refused("NaN in JSON" "nan_json.txt: cannot be read as JSON .*" nan_json.txt --out x.txt)
refused("null in JSON" "null.json: 'null' among the coefficients is no number" null.json --out x.txt)
refused("eight coefficients" "eight.json: holds 8 coefficients, which is not N.N .*" eight.json)
refused("bands that do not fit" "bands.json: says 2 bands, and holds 9 coefficients" bands.json)
refused("bands beyond the convention" "many.json: 4 bands; unity stores at most 3" many.json)
refused("misspelt convention" "misspelt.json: 'threesj' is no convention; did you mean threejs. .*" misspelt.json)
refused("JSON that is cut off" "cut.json: cannot be read as JSON .*" cut.json)
refused("JSON of something else" "other.json: has no .convention." other.json)
refused("JSON of another convention" "unity.json: says that its numbers are of unity, not of zonal" unity.json --from zonal)
refused("out in no folder" "nowhere/x.txt: cannot be written .*" sky.exr --out nowhere/x.txt --preview x.png)
refused("preview in no folder" "nowhere/x.png: cannot be written .*" sky.exr --out x.txt --preview nowhere/x.png)
refused("preview as JPEG" "--preview: 'x.jpg' does not end in .png" sky.exr --preview x.jpg)
refused("out on the input" "./sky.exr: is read, and cannot be written as well" sky.exr --out ./sky.exr)
refused("two outputs in one" "x.png: two outputs cannot be one file" sky.exr --out x.png --preview ./x.png)
program_case("full output" 1 "x.png" "${program}: standard output: cannot be written .No space left on device."
  sh -c "'$<TARGET_FILE:${program}>' sky.exr --preview x.png >/dev/full")

# ---- What works -----------------------------------------------------------------------------------------------------

renders("help" "" "" --help)
renders("list" "" "" --list)
foreach(kind exr hdr png jpg)
  renders("reads ${kind}" "x.json" "" sky.${kind} --convention unity --quantity irradiance --format json --out x.json)
endforeach()
renders("all at once" "x.hlsl x.png" "" sky.exr --bands 3 --mapping auto --quantity irradiance --convention unity
  --rotate up:90,right:-20 --window auto --window-by luminance --format hlsl --preview x.png --out x.hlsl)
renders("coefficients with a preview" "x.png" "" nine.txt --from Three.js --planes --window sinc:4 --preview x.png)

# ---- What it writes, compiled ---------------------------------------------------------------------------------------

# text_of(<name> <format> <argument>...): a part of zonal_probe_texts.hpp, of the coefficients in random.txt.
set(texts ${CMAKE_CURRENT_BINARY_DIR}/zonal_probe_texts)
set(random ${CMAKE_CURRENT_LIST_DIR}/zonal-probe/random.txt)
function(text_of name format)
  set(file ${texts}/${name}.${format})
  add_custom_command(OUTPUT ${file}
    COMMAND zonal-probe ${random} --from zonal --format ${format} --name ${name} ${ARGN} --out ${file}
    DEPENDS zonal-probe ${random})
  set(text_files ${text_files} ${file} PARENT_SCOPE)
endfunction()
file(MAKE_DIRECTORY ${texts})
text_of(unity cpp --bands 3 --convention unity)
text_of(unity_vectors hlsl --bands 3 --convention unity)
text_of(filament glsl --bands 3 --convention filament_shader)
text_of(splats glsl --convention gaussian_splatting)
text_of(e3nn_norm hlsl --convention e3nn_norm)
text_of(fuma glsl --convention fuma)

find_package(Catch2 QUIET)
if(NOT TARGET Catch2::Catch2)
  return()
endif()
example_test(zonal_probe_test.cpp)
set_source_files_properties(${text_files} PROPERTIES HEADER_FILE_ONLY ON)
target_sources(test_zonal_probe PRIVATE ${text_files})
target_include_directories(test_zonal_probe PRIVATE ${texts})
target_include_directories(test_zonal_probe SYSTEM PRIVATE ${ZONAL_STB_INCLUDE_DIR})
target_compile_definitions(test_zonal_probe PRIVATE
  ZONAL_PROBE_TEST_DATA="${CMAKE_CURRENT_LIST_DIR}/zonal-probe")
