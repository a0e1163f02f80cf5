# cmake -DFILE=FILE -DHEADER=HEADER -DNAME=NAME -DOUTPUT=FILE.cpp -P embed_text.cmake: writes the definition of the text
# NAME, which HEADER declares, with the content of FILE.
file(READ "${FILE}" text)
file(WRITE "${OUTPUT}" "#include \"${HEADER}\"

namespace rubsweep::apps {

const std::string_view ${NAME} = R\"text(${text})text\";

}  // namespace rubsweep::apps
")
