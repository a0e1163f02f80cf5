# cmake -DASSETS=NAME=FILE+FILE,NAME=FILE... -DOUTPUT=FILE.cpp -P embed.cmake: writes the definitions that page.hpp
# declares. Files of one name are put together in their order.
string(REPLACE "," ";" assets "${ASSETS}")
set(source "#include \"rubreport/page.hpp\"\n\nnamespace rubsweep::page {\n")
foreach(asset IN LISTS assets)
  string(REPLACE "=" ";" asset "${asset}")
  list(GET asset 0 name)
  list(GET asset 1 files)
  string(REPLACE "+" ";" files "${files}")
  set(bytes "")
  set(joined "${OUTPUT}.${name}")
  execute_process(COMMAND ${CMAKE_COMMAND} -E cat ${files} OUTPUT_FILE "${joined}" COMMAND_ERROR_IS_FATAL ANY)
  file(READ "${joined}" bytes HEX)
  file(SHA256 "${joined}" digest)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
  string(APPEND source "\nstatic constexpr char ${name}_text[] = {${bytes}};\n"
    "const Asset ${name}{{${name}_text, sizeof ${name}_text}, \"${digest}\"};\n")
endforeach()
file(WRITE "${OUTPUT}" "${source}\n}  // namespace rubsweep::page\n")
