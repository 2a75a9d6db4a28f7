# The headers that a program sees, in one directory as when they are installed: those of the sources, two of the table of
# macros, and two that are made of the names in all of them.
set(SYMREAL_HEADERS ${PROJECT_BINARY_DIR}/runtime/include)
file(GLOB SYMREAL_HEADER_FILES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/engine/include/symreal/*
  ${PROJECT_SOURCE_DIR}/runtime/include/symreal/*)
file(GLOB SYMREAL_OLD_LINKS ${SYMREAL_HEADERS}/symreal/*)
foreach(link ${SYMREAL_OLD_LINKS})
  if(IS_SYMLINK ${link})
    file(REMOVE ${link})
  endif()
endforeach()
file(MAKE_DIRECTORY ${SYMREAL_HEADERS}/symreal)
foreach(header ${SYMREAL_HEADER_FILES})
  get_filename_component(name ${header} NAME)
  file(CREATE_LINK ${header} ${SYMREAL_HEADERS}/symreal/${name} SYMBOLIC)
endforeach()
foreach(name reading complex)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/runtime/include/${name} ${SYMREAL_HEADERS}/${name} SYMBOLIC)
endforeach()
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(made ${SYMREAL_HEADERS}/symreal/)
set(SYMREAL_MACROS ${made}macros.h ${made}real.h)
set(SYMREAL_HIDDEN_NAMES ${made}names_hide.h ${made}names_show.h)
add_custom_command(OUTPUT ${SYMREAL_MACROS}
  COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/cmake/mode_macros.py ${PROJECT_SOURCE_DIR}/runtime/macros.def ${made}
  DEPENDS ${PROJECT_SOURCE_DIR}/cmake/mode_macros.py ${PROJECT_SOURCE_DIR}/runtime/macros.def VERBATIM)
add_custom_command(OUTPUT ${SYMREAL_HIDDEN_NAMES}
  COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/cmake/hide_names.py ${CMAKE_CXX_COMPILER} ${SYMREAL_HEADERS}
  DEPENDS ${PROJECT_SOURCE_DIR}/cmake/hide_names.py ${SYMREAL_HEADER_FILES} ${SYMREAL_MACROS} VERBATIM)
add_custom_target(symreal_hidden_names ALL DEPENDS ${SYMREAL_HIDDEN_NAMES})

# What each room that uses them is compiled with.
add_library(symreal_headers INTERFACE)
target_include_directories(symreal_headers INTERFACE ${PROJECT_SOURCE_DIR} ${SYMREAL_HEADERS})
target_compile_definitions(symreal_headers INTERFACE SYMREAL_VERSION="${PROJECT_VERSION}")
# The formatting library is compiled in engine/support/formatting.cpp, in this namespace.
target_compile_definitions(symreal_headers INTERFACE
  "FMT_BEGIN_NAMESPACE=namespace fmt{inline namespace symreal{" "FMT_END_NAMESPACE=}}")
