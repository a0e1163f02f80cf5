# Installs the build tree BUILD to a new prefix, then uses it as others would: builds and runs project/ and EXAMPLES against
# it with the same GENERATOR, COMPILER and FLAGS, and asks the installed program for its VERSION.
set(work ${BUILD}/consumer)
file(REMOVE_RECURSE ${work})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${work}/prefix)
# build(SOURCE NAME [OPTIONS...]): SOURCE, a project of its own, built in ${work}/NAME.
function(build source name)
  run(${CMAKE_COMMAND} -S ${source} -B ${work}/${name} -G ${GENERATOR}
    -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${FLAGS}
    -D CMAKE_PREFIX_PATH=${work}/prefix ${ARGN})
  run(${CMAKE_COMMAND} --build ${work}/${name})
endfunction()
build(${CMAKE_CURRENT_LIST_DIR}/project build)
# The core part must build without the packages that only other parts need.
set(absent Ceres TBB yaml-cpp nlohmann_json tomlplusplus ZLIB)
list(TRANSFORM absent REPLACE "(.+)" "-DCMAKE_DISABLE_FIND_PACKAGE_\\1=ON")
build(${EXAMPLES} one_cell_alone -DPARTS=core ${absent})
build(${EXAMPLES} examples)

# The examples must print the same results as the programs.
set(config ${EXAMPLES}/../configs/minimal.yaml)
run(${work}/examples/map ${config} ${work}/map)
run(${work}/prefix/bin/rubsweep ${config} --set kick.force_n=250 --output ${work}/map_of_program --quiet)
file(READ ${work}/map/map.csv map)
file(READ ${work}/map_of_program/map.csv map_of_program)
if(NOT map STREQUAL map_of_program)
  message(FATAL_ERROR "The example's map is not that of rubsweep")
endif()
run(${work}/examples/branch ${config} 70 0.2 60 80)
set(branch "${output}")
run(${work}/prefix/bin/rubbranch ${config} --cell 70,0.2 --along speed_hz --from 60 --to 80 --output ${work}/branch)
string(REGEX REPLACE "^[0-9]+ orbits\n" "" branch "${branch}")
string(FIND "${output}" "${branch}" place)
if(place EQUAL -1 OR branch STREQUAL "")
  message(FATAL_ERROR "The example says of the branch:\n${branch}rubbranch says:\n${output}")
endif()

run(${work}/build/consumer)
if(NOT output STREQUAL "2 cells, the last at 240 Hz\n")
  message(FATAL_ERROR "The consumer printed:\n${output}")
endif()

# pkg-config must find the same files, wherever the prefix is.
find_program(pkg_config NAMES pkgconf pkg-config REQUIRED)
file(GLOB_RECURSE pc ${work}/prefix/*/rubsweep.pc)
get_filename_component(pc ${pc} DIRECTORY)
set(ENV{PKG_CONFIG_PATH} ${pc})
run(${pkg_config} --modversion rubsweep)
if(NOT output STREQUAL "${VERSION}\n")
  message(FATAL_ERROR "pkg-config says version ${output}")
endif()
run(${pkg_config} --cflags --libs rubsweep)
separate_arguments(words UNIX_COMMAND "${output}")
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
run(${COMPILER} ${flags} -std=c++20 -O1 ${EXAMPLES}/one_cell.cpp -o ${work}/one_cell ${words})
run(${work}/one_cell 50)
string(FIND "${output}" "class non_contact, proof rest" place)
if(place EQUAL -1)
  message(FATAL_ERROR "one_cell by pkg-config printed:\n${output}")
endif()

run(${work}/examples/one_cell)
string(CONCAT expected
  "The rotor at 70 Hz, eccentricity 0.163 mm: after 53 revolutions it rubs in a rhythm of 2 revolutions.\n"
  "class subharmonic, order 2, proof floquet: a periodic orbit that is proven to attract the motion\n"
  "largest displacement 1.86 mm, in contact 14.1 % of the time\n")
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "one_cell printed:\n${output}")
endif()
run(${work}/examples/one_cell 50)
string(FIND "${output}" "class non_contact, proof rest" place)
if(place EQUAL -1)
  message(FATAL_ERROR "one_cell 50 printed:\n${output}")
endif()

run(${work}/prefix/bin/rubsweep --version)
string(FIND "${output}" "${VERSION}" place)
if(place EQUAL -1)
  message(FATAL_ERROR "rubsweep --version does not name ${VERSION}:\n${output}")
endif()

# An installed program draws with the package that is installed beside it, and rubplot is a program, too.
find_program(gnuplot gnuplot)
if(gnuplot)
  set(draw ${work}/prefix/bin/rubtrace ${EXAMPLES}/../configs/minimal.yaml --campbell 0:100 --output ${work}/campbell
    --figure ${work}/campbell.png)
  run(${draw})
  run(${work}/prefix/bin/rubplot campbell ${work}/campbell --output ${work}/again.pdf)
  file(GLOB_RECURSE script ${work}/prefix/*/rubsweep/rubplot/templates/campbell.gp)
  file(REMOVE ${script} ${work}/campbell.png)
  execute_process(COMMAND ${draw} RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if(status EQUAL 0 OR NOT script OR EXISTS ${work}/campbell.png)
    message(FATAL_ERROR "rubtrace did not draw with the installed ${script}")
  endif()
endif()
