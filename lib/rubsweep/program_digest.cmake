# cmake -DFOLDER=map -DNAME=NAME -DFILES=A,B,... -DOUTPUT=FILE.cpp -P program_digest.cmake: writes the definition
# of NAME, which rubsweep/FOLDER/NAME.hpp declares.
string(REPLACE "," ";" files "${FILES}")
set(digests "")
foreach(file IN LISTS files)
  file(SHA1 "${file}" digest)
  string(APPEND digests "${digest}")
endforeach()
string(SHA1 digest "${digests}")
string(REPLACE "/" "::" namespace "${FOLDER}")
file(WRITE "${OUTPUT}" "#include \"rubsweep/${FOLDER}/${NAME}.hpp\"\n\n\
const char* const rubsweep::${namespace}::${NAME} = \"${digest}\";\n")
