# `cpack -G DEB` and `cpack -G TGZ` in a build tree: the packages rubsweep, rubsweep-dev and python3-rubsweep, or one archive of all.
set(CPACK_PACKAGE_NAME rubsweep)
set(CPACK_PACKAGE_VENDOR "The rubsweep developers")
# Debian asks for an address; the project has none.
set(CPACK_PACKAGE_CONTACT "The rubsweep developers <developers@rubsweep.invalid>")
set(CPACK_RESOURCE_FILE_README ${PROJECT_SOURCE_DIR}/README.md)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
# Folders that an installation makes are everybody's to read, whoever builds.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

# The first line of each description is its summary.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_COMPONENTS_ALL programs development python)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_ARCHIVE_COMPONENT_INSTALL OFF)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE gzip)

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME rubsweep)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS "python3 (>= 3.9)")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS "gnuplot-nox | gnuplot, fonts-dejavu-core, libhdf5-103-1")
if(MPI_CXX_FOUND)
  string(APPEND CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS ", openmpi-bin")
endif()
set(CPACK_COMPONENT_PROGRAMS_DESCRIPTION "maps of the motions of rotors that rub on their casings
A rotor that touches its casing can fall back to quiet whirling or stay in a
violent motion, depending on speed, unbalance and the kick that started it.
rubsweep maps where rub persists and which motion it becomes; its sister
programs look at one cell, follow motions along parameters, and draw.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME rubsweep-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# Packages that rubsweepConfig.cmake looks for, as scripts/bootstrap.sh installs it.
string(CONCAT CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libboost1.81-dev, libboost-program-options1.81-dev, libeigen3-dev, libfftw3-dev, libtbb-dev, "
  "libyaml-cpp-dev, libfmt-dev, zlib1g-dev, libtomlplusplus-dev, nlohmann-json3-dev, libceres-dev, "
  "libsndfile1-dev, nettle-dev, pkg-config")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS rubsweep)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "library of rubsweep: headers, archives, CMake package
Headers and static libraries of the simulator of rotors that rub, and a CMake
package that finds them: find_package(rubsweep COMPONENTS core), then
rubsweep::core, or maps, analysis and measurement. examples/ has whole programs on it.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-rubsweep)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "rubsweep (>= ${PROJECT_VERSION}), python3 (>= 3.9), python3-pandas, python3-xarray")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS python3-matplotlib)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "maps of the motions of rotors that rub, from Python
Runs the programs of rubsweep, and returns a map as an xarray Dataset with
units, motions, branches, basins, recordings, fits and diagnoses as pandas
tables, and bad input as exceptions that carry file, line and key.")
include(CPack)
