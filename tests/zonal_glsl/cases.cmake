# zonal-glsl as a user meets it: what it says of bad arguments, and what files it leaves.
set(cases_dir ${CMAKE_CURRENT_LIST_DIR})
set(run_case ${PROJECT_SOURCE_DIR}/tests/programs/run_case.sh)
set(work_dir ${CMAKE_CURRENT_BINARY_DIR}/cases)
file(MAKE_DIRECTORY ${work_dir}/inputs/folder.glsl)

# zonal_glsl_case(<name> <exit status> <new files> <pattern of standard error> <argument>...)
function(zonal_glsl_case name status new_files pattern)
  string(MAKE_C_IDENTIFIER "${name}" folder)
  add_test(NAME "zonal-glsl: ${name}" COMMAND
    ${run_case} ${work_dir}/inputs ${work_dir}/${folder} ${status} "${new_files}" "${pattern}"
    $<TARGET_FILE:zonal-glsl> ${ARGN})
  set_tests_properties("zonal-glsl: ${name}" PROPERTIES TIMEOUT 60)
endfunction()
# refused(<name> <pattern> <argument>...): exit status 2, one line, no file.
function(zonal_glsl_refused name pattern)
  zonal_glsl_case("${name}" 2 "" "zonal-glsl: ${pattern}" ${ARGN})
endfunction()

zonal_glsl_refused("no function" "--functions names none .*" -o x.glsl)
zonal_glsl_refused("unknown function" "'magic' is no function .*" --functions evaluate,magic -o x.glsl)
zonal_glsl_refused("unknown selection" "'evaluate:odd' selects neither .*" --functions evaluate:odd -o x.glsl)
zonal_glsl_refused("degree out of range" "'evaluate:degree5' selects neither .*" --functions evaluate:degree5 -o x.glsl)
zonal_glsl_refused("nothing to select from" "'cap:even' has no outputs .*" --functions cap:even -o x.glsl)
zonal_glsl_refused("unknown dialect" "--dialect: 'basic' is not one of glsl450, .*" --functions cap --dialect basic -o x)
foreach(bands 0 11 -1 5.5 many)
  zonal_glsl_refused("bands ${bands}" "--bands: '${bands}' is not in 1...10" --functions cap --bands=${bands} -o x.glsl)
endforeach()
zonal_glsl_refused("bands of a name" "'cap@11': '11' is not in 1...10" --functions evaluate,cap@11 -o x.glsl)
zonal_glsl_refused("more bands than a function has" "'product@7' has at most 6 bands" --functions product@7 -o x.glsl)
zonal_glsl_refused("no bands to a name" "'cap@': '' is not in 1...10" --functions cap@ -o x.glsl)
zonal_glsl_refused("bands where there are none" "'horizon_exact@3' has no bands .*" --functions horizon_exact@3 -o x.glsl)
zonal_glsl_refused("degree out of a name's range" "'evaluate:degree3' selects neither .*"
  --functions evaluate:degree3@3 -o x.glsl)
zonal_glsl_refused("sums to select from" "'add_sphere:even' has no outputs .*" --functions add_sphere:even -o x.glsl)
foreach(prefix 9z_ gl_ a__b a-b_)
  zonal_glsl_refused("prefix ${prefix}" "--prefix: '${prefix}' begins no name .*" --functions cap --prefix ${prefix} -o x)
endforeach()
zonal_glsl_refused("precise in GLSL ES" "--precise: GLSL ES 3.00 has no such word"
  --functions cap --precise --dialect glsles300 -o x.glsl)
zonal_glsl_refused("a flat loop" "'gather' is a loop, .*" --functions gather --flat -o x.glsl)
zonal_glsl_refused("too flat" "zonal_add_sphere_10 would have 307 parameters; WGSL allows 255"
  --functions add_sphere --bands 10 --flat --dialect wgsl -o x.wgsl)
zonal_glsl_refused("a loop in HLSL" "'gather' is a loop, .*" --functions gather --dialect hlsl -o x.hlsl)
zonal_glsl_refused("output in no folder" "nowhere/x.glsl: cannot be written .*" --functions cap -o nowhere/x.glsl)
zonal_glsl_refused("output on a folder" "folder.glsl: is not a regular file" --functions cap -o folder.glsl)
zonal_glsl_refused("unknown option" "The following argument was not expected: --foo" --foo)
zonal_glsl_refused("output on a device" "/dev/null: is not a regular file" --functions cap -o /dev/null)
foreach(output ">/dev/full:cannot be written .No space left on device." ">&-:is closed")
  string(REGEX MATCH "^([^:]*):(.*)$" output "${output}")
  set(redirection ${CMAKE_MATCH_1})
  set(what ${CMAKE_MATCH_2})
  string(MAKE_C_IDENTIFIER "output${redirection}" folder)
  add_test(NAME "zonal-glsl: output ${redirection}" COMMAND
    ${run_case} ${work_dir}/inputs ${work_dir}/${folder} 2 "" "zonal-glsl: standard output: ${what}"
    sh -c "'$<TARGET_FILE:zonal-glsl>' --functions cap ${redirection}")
endforeach()
zonal_glsl_refused("adjoint of a loop" "'gather' is a loop, which has no adjoint" --adjoint gather -o x.glsl)
zonal_glsl_refused("adjoint of no function" "'magic' is no function .*" --adjoint magic -o x.glsl)
zonal_glsl_refused("adjoint of a choice" "--adjoint: zonal_is_same_surface has no derivative by any input"
  --adjoint is_same_surface -o x.glsl)
zonal_glsl_refused("adjoint of sums" "--adjoint: zonal_add_sphere_5 adds to what it is given, .*"
  --adjoint add_sphere -o x.glsl)
zonal_glsl_refused("adjoint of an adjoint" "--adjoint: zonal_splat_with_adjoint_5 has a parameter 'by_value' already"
  --adjoint splat_with_adjoint -o x.glsl)
zonal_glsl_refused("by no input" "--adjoint: zonal_reconstruct_5 has no input 'foo', but sh, direction"
  --adjoint reconstruct --by sh,foo -o x.glsl)
zonal_glsl_refused("by, of nothing" "--by: there is no --adjoint" --functions cap --by half_angle -o x.glsl)
zonal_glsl_case("adjoint" 0 "x.glsl" "" --functions cap --adjoint splat_colour@4,reconstruct_along_colour --by sh
  --bands 3 -o x.glsl)
zonal_glsl_case("list" 0 "" "" --list)
zonal_glsl_case("count" 0 "" "" --count --functions evaluate,evaluate:even,evaluate:degree2,reconstruct_lambert)
zonal_glsl_case("list of another dialect" 0 "" "" --list --dialect wgsl --flat --bands 3)
zonal_glsl_case("one file" 0 "x.glsl" "" --functions evaluate,cap,gather -o x.glsl)

# Plans. bad_plan(<name> <pattern> <text of the plan> <what stands in its place>)
if(nlohmann_json_FOUND)
  set(plan [=[{"horizon": "smoothstep", "coefficient_bits": 16, "emission_bands": 2, "materials": [
    {"name": "clay", "receiving": {"symmetry": "zonal", "bands": 5, "left_out": [[3, 0]]}},
    {"name": "varnish", "receiving": {"symmetry": "mirror", "bands": 3, "left_out": []}}]}]=])
  file(WRITE ${work_dir}/inputs/plan.json "${plan}\n")
  file(WRITE ${work_dir}/inputs/report.json "{\"version\": 1, \"plan\": ${plan}}\n")
  zonal_glsl_case("plan" 0 "x.glsl" "" --plan plan.json -o x.glsl)
  zonal_glsl_case("plan of a report, and more" 0 "x.glsl" "" --plan report.json --functions cap@3 -o x.glsl)
  zonal_glsl_case("count of a plan" 0 "" "" --plan plan.json --count)
  zonal_glsl_refused("plan in HLSL" "'gather_planned' is a loop, .*" --plan plan.json --dialect hlsl -o x.hlsl)
  zonal_glsl_refused("a flat plan" "'gather_planned' is a loop, .*" --plan plan.json --flat -o x.glsl)
  zonal_glsl_refused("no plan" "none.json: cannot be read" --plan none.json -o x.glsl)
  function(bad_plan name pattern from to)
    string(MAKE_C_IDENTIFIER "${name}" file)
    string(REPLACE "${from}" "${to}" text "${plan}")
    if(text STREQUAL plan)
      message(FATAL_ERROR "'${from}' is not in the plan")
    endif()
    file(WRITE ${work_dir}/inputs/${file}.json "${text}\n")
    zonal_glsl_refused("plan, ${name}" "${file}[.]json: ${pattern}" --plan ${file}.json -o x.glsl)
  endfunction()
  bad_plan("cut off" "is no JSON at byte [0-9]+" "left_out\": []}}]}" "left")
  bad_plan("no object" "the plan has no \"horizon\"" "${plan}" "[1, 2]")
  bad_plan("no horizon" "the plan has no \"horizon\"" "horizon" "skyline")
  bad_plan("unknown horizon" "horizon is not one of none, smoothstep, exact" "smoothstep" "far")
  bad_plan("bits" "coefficient_bits is neither 16 nor 32" "16" "24")
  bad_plan("many bits" "coefficient_bits is not a whole number from 16 to 32" "16" "1e300")
  bad_plan("too many bits" "has a number beyond all range" "16" "1e400")
  bad_plan("emission" "emission_bands is 5: shaders have 1 or 3" "\"emission_bands\": 2" "\"emission_bands\": 5")
  bad_plan("half a band" "materials.1..receiving.bands is not a whole number from 1 to 10" "3, \"left" "3.5, \"left")
  bad_plan("bands" "materials.1..receiving.bands is not a whole number from 1 to 10" "3, \"left" "11, \"left")
  bad_plan("no materials" "materials is empty" "[\n    {" "[], \"none\": [\n    {")
  bad_plan("material of no needs" "materials.0. has no \"receiving\"" "\"clay\", \"receiving\"" "\"clay\", \"sending\"")
  bad_plan("anisotropic" "materials.1..receiving.symmetry is none: .*" "mirror" "none")
  bad_plan("order" "materials.0..receiving.left_out.0..1. is not a whole number from 0 to 0" "[[3, 0]]" "[[3, 1]]")
  bad_plan("degree" "materials.0..receiving.left_out.0..0. is not a whole number from 0 to 4" "[[3, 0]]" "[[5, 0]]")
  bad_plan("no pair" "materials.0..receiving.left_out.0. is not a degree and an order" "[[3, 0]]" "[[3]]")
  bad_plan("no list" "materials.0..receiving.left_out is no list" "[[3, 0]]" "3")
endif()

# Fewer outputs, fewer operations; and no more of them than the published schemes take.
add_test(NAME "zonal-glsl: operation counts" COMMAND ${cases_dir}/operation_counts.sh $<TARGET_FILE:zonal-glsl>)
# The same text every time; and every function at every number of bands in less than a second.
add_test(NAME "zonal-glsl: same text, in time" COMMAND ${cases_dir}/same_text.sh $<TARGET_FILE:zonal-glsl>)

# shaders/, for those who copy a file, is what the program writes.
add_test(NAME "zonal-glsl: shaders/ as they are written" COMMAND
  ${cases_dir}/same_shaders.sh $<TARGET_FILE:zonal-glsl> ${PROJECT_SOURCE_DIR} ${CMAKE_CXX_COMPILER} ${work_dir}/copied)
set_tests_properties("zonal-glsl: shaders/ as they are written" PROPERTIES TIMEOUT 60)

# The shaders of the documents, as they stand.
add_test(NAME "zonal-glsl: documents" COMMAND
  ${cases_dir}/compile_documents.sh $<TARGET_FILE:zonal-glsl> ${PROJECT_SOURCE_DIR}/docs/examples ${work_dir}/documents)
set_tests_properties("zonal-glsl: documents" PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 60)

# Every function in every dialect, by a compiler of that dialect.
foreach(dialect glsl450 glsles300 hlsl wgsl cpp)
  add_test(NAME "zonal-glsl: ${dialect} compiles" COMMAND
    ${cases_dir}/compile_dialect.sh $<TARGET_FILE:zonal-glsl> ${dialect} ${CMAKE_CXX_COMPILER} ${work_dir}/${dialect})
  set_tests_properties("zonal-glsl: ${dialect} compiles" PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 300)
endforeach()
