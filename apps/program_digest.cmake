# cmake -DNAME=NAME -DLIBRARIES=A,B,... -DOUTPUT=FILE.cpp -P program_digest.cmake: writes the definition of NAME.
string(REPLACE "," ";" libraries "${LIBRARIES}")
set(digests "")
foreach(library IN LISTS libraries)
  file(SHA1 "${library}" digest)
  string(APPEND digests "${digest}")
endforeach()
string(SHA1 digest "${digests}")
file(WRITE "${OUTPUT}" "#include \"program_digest.hpp\"\n\n\
const char* const rubsweep::apps::${NAME} = \"${digest}\";\n")
