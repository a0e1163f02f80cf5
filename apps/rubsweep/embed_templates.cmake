# cmake "-DFILES=FILE;FILE..." -DOUTPUT=FILE.cpp -P embed_templates.cmake: writes the definitions that templates.hpp declares.
set(source "#include \"rubsweep/templates.hpp\"\n\nnamespace rubsweep::apps::templates {\n\n")
string(APPEND source "const std::array<Text, text_count> texts{{\n")
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME_WE)
  file(READ "${file}" text)
  string(APPEND source "{\"${name}\", R\"yaml(${text})yaml\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "${source}}};\n\n}  // namespace rubsweep::apps::templates\n")
