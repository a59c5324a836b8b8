# Writes OUTPUT, a C++ source with the text of every file in FILES as a table of name and content, so that the program
# needs no data files of its own beside it. NAMESPACE and TABLE name what is defined.
set(text "// Written by ui/shaders/embed.cmake from the files named below.\n#include \"ui/gl/embedded.hpp\"\n\nnamespace ui {\n\n")
string(APPEND text "const std::vector<EmbeddedFile>& ${TABLE}() {\n    static const std::vector<EmbeddedFile> files = {\n")
foreach(file ${FILES})
  get_filename_component(name ${file} NAME)
  file(READ ${file} content)
  string(APPEND text "        {\"${name}\", R\"embedded(${content})embedded\"},\n")
endforeach()
string(APPEND text "    };\n    return files;\n}\n\n}  // namespace ui\n")
file(WRITE ${OUTPUT} "${text}")
