# Writes a source that holds files as bytes: cmake -DOUTPUT=assets.cpp -DFOLDER=tool/html "-DFILES=a,b" -P embed.cmake
# The first file is the first asset. A string literal would be too long for some compilers.
string(REPLACE "," ";" files "${FILES}")
set(source "#include \"tool/html/page.h\"\n\nnamespace symreal::tool {\n\n")
set(table "")
foreach(file IN LISTS files)
  file(READ ${FOLDER}/${file} bytes HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
  string(MAKE_C_IDENTIFIER ${file} name)
  string(APPEND source "static char const ${name}[] = {${bytes}};\n")
  string(APPEND table "      {\"${file}\", {${name}, sizeof ${name}}},\n")
endforeach()
string(APPEND source "\nstd::span<Asset const> assets() {\n  static Asset const all[] = {\n${table}  };\n  return all;\n}\n\n}\n")
file(WRITE ${OUTPUT} "${source}")
