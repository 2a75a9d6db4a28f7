# A room is a folder and a target: symreal_room(engine/graph SEES engine/ops) makes the library symreal_engine_graph of the
# sources in engine/graph. A room includes from itself, from the rooms that it names, and from those that these see.
# tests/style/rooms.test compares the includes with what is said here, which `rooms.txt` of the build tree repeats.
function(symreal_room folder)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SEES;SOURCES")
  string(REPLACE "/" "_" target ${folder})
  set(target symreal_${target})
  if(NOT arg_SOURCES)
    file(GLOB arg_SOURCES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
  endif()
  set(sees ${arg_SEES})
  list(TRANSFORM sees REPLACE "/" "_")
  list(TRANSFORM sees PREPEND symreal_)
  if(arg_SOURCES)
    add_library(${target} STATIC ${arg_SOURCES})
    target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR})
    target_link_libraries(${target} PUBLIC ${sees} PRIVATE symreal_options)
  else()
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE ${sees})
  endif()
  list(JOIN arg_SEES " " words)
  set_property(GLOBAL APPEND_STRING PROPERTY SYMREAL_ROOMS "${folder} ${words}\n")
endfunction()

# The files of a room's folder stand in its library itself, where a function that the header declares returns them.
function(symreal_embed target folder function header)
  list(JOIN ARGN "," files)
  list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/${folder}/)
  string(MAKE_C_IDENTIFIER ${folder} name)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}_files.cpp)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${source} -DHEADER=${folder}/${header} -DFUNCTION=${function}
            -DFOLDER=${PROJECT_SOURCE_DIR}/${folder} "-DFILES=${files}" -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    VERBATIM
    DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake)
  target_sources(${target} PRIVATE ${source})
endfunction()

# A room that symbolic programs are linked with. Each gets the same flags, so that they share a precompiled header.
function(symreal_linked_into_programs room)
  set_property(GLOBAL APPEND PROPERTY SYMREAL_LINKED_INTO_PROGRAMS ${room})
  # The values that are folded here must be those of the reference: no contraction, no compile-time libm, NaN payloads
  # kept.
  target_compile_options(${room} PRIVATE -ffp-contract=off -fno-builtin -fno-fast-math)
  # Programs of several shared libraries have it in each, and use one; it is loaded with the program.
  set_target_properties(${room} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${room} PRIVATE -ftls-model=initial-exec)
  target_link_libraries(${room} PUBLIC symreal_headers)
  add_dependencies(${room} symreal_hidden_names)
endfunction()

# The first target precompiles the header, for itself and for the others. Their flags must be its own.
function(symreal_precompiled header first)
  target_precompile_headers(${first} PRIVATE ${header})
  foreach(other ${ARGN})
    target_precompile_headers(${other} REUSE_FROM ${first})
  endforeach()
endfunction()

function(symreal_write_rooms)
  get_property(rooms GLOBAL PROPERTY SYMREAL_ROOMS)
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/rooms.txt CONTENT "${rooms}")
endfunction()
