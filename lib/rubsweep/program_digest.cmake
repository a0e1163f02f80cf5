# cmake -DFOLDER=map -DHEADER=PLACE/NAME.hpp -DFILES=A,B,... -DOUTPUT=FILE.cpp -P program_digest.cmake: writes the
# definition of NAME, which that header declares in the namespace of FOLDER.
string(REPLACE "," ";" files "${FILES}")
set(digests "")
foreach(file IN LISTS files)
  file(SHA1 "${file}" digest)
  string(APPEND digests "${digest}")
endforeach()
string(SHA1 digest "${digests}")
string(REPLACE "/" "::" namespace "${FOLDER}")
get_filename_component(name "${HEADER}" NAME_WE)
file(WRITE "${OUTPUT}" "#include \"${HEADER}\"\n\n\
const char* const rubsweep::${namespace}::${name} = \"${digest}\";\n")
