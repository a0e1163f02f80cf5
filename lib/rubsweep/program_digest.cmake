# cmake -DFOLDER=map -DNAME=map_digest -DFILES=A,B,... -DOUTPUT=FILE.cpp -P program_digest.cmake: writes the definition of
# NAME, which a header declares in the namespace of FOLDER.
string(REPLACE "," ";" files "${FILES}")
set(digests "")
foreach(file IN LISTS files)
  file(SHA1 "${file}" digest)
  string(APPEND digests "${digest}")
endforeach()
string(SHA1 digest "${digests}")
string(REPLACE "/" "::" namespace "${FOLDER}")
file(WRITE "${OUTPUT}" "namespace rubsweep::${namespace} {\n\n\
extern const char* const ${NAME};\nconst char* const ${NAME} = \"${digest}\";\n\n\
}  // namespace rubsweep::${namespace}\n")
