# Writes a source that holds files as bytes, in their order, and returns them from a function that a header declares:
#   cmake -DOUTPUT=assets.cpp -DHEADER=tool/html/page.h -DFUNCTION=symreal::tool::assets -DFOLDER=tool/html "-DFILES=a,b" -P embed.cmake
# A string literal would be too long for some compilers.
string(REPLACE "," ";" files "${FILES}")
set(source "#include \"${HEADER}\"\n\n")
set(table "")
foreach(file IN LISTS files)
  file(READ ${FOLDER}/${file} bytes HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
  string(MAKE_C_IDENTIFIER ${file} name)
  string(APPEND source "static char const file_${name}[] = {${bytes}};\n")
  string(APPEND table "      {\"${file}\", {file_${name}, sizeof file_${name}}},\n")
endforeach()
string(APPEND source
  "\nstd::span<symreal::Asset const> ${FUNCTION}() {\n  static symreal::Asset const all[] = {\n${table}  };\n  return all;\n}\n")
file(WRITE ${OUTPUT} "${source}")
