# SPDX-License-Identifier: Apache-2.0
# The whole measurement in small: two lights of our own, one texel of each class.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${BIN}/bin/boxlight_data scene knot ${OUT}/knot.glb)
run(${BIN}/bin/boxlight_data environment gallery ${OUT}/gallery.exr)
run(${BIN}/bin/boxlight_data environment sky ${OUT}/sky.exr)
run(${BIN}/tests/accuracy ${OUT}/knot.glb --light ${OUT}/gallery.exr ${OUT}/sky.exr -o ${OUT}/accuracy.json --quiet --texels 1
    --rotations 1 --light-size 128 --boxes 8 --reference-paths 8192 --clean-paths 2048)
file(READ ${OUT}/accuracy.json text)
string(JSON lit GET "${text}" lights 1 sun_lit)
string(JSON rows LENGTH "${text}" rows)
string(JSON floor GET "${text}" rows 0 soft)
if(NOT lit OR rows LESS 60 OR floor LESS 1e-4 OR floor GREATER .2)
  message(FATAL_ERROR "sun-lit sky: ${lit}, ${rows} rows, error of a thousand diffuse paths under soft light ${floor}")
endif()
