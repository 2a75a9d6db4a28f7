# symreal_generate(FUNCTION kernel SOURCES source...
#   [TARGET target] [OUT_VAR variable] [OUTPUT file.c] [CHECK]
#   [LANGUAGE c] [PREFIX prefix] [FP finite|strict|fast] [FLAGS flag...] [OPTIONS option...] [RUN_DIRECTORY directory])
#
# Generates the code of one kernel when the build needs it, and again when a source or a header that it includes has
# changed. The files are added to TARGET, with the compiler flags that the result's promise needs, and are listed in the
# variable. FLAGS are the compiler flags of the sources, OPTIONS further options of `symreal generate`. The program runs
# in RUN_DIRECTORY, by default the binary directory.
#
# With CHECK the OUTPUT is a file of the source tree that is committed: nothing is generated, and the test
# symreal_check_<kernel> fails while it is not what the sources give.
function(symreal_generate)
  set(one TARGET FUNCTION LANGUAGE OUT_VAR OUTPUT PREFIX FP RUN_DIRECTORY)
  cmake_parse_arguments(PARSE_ARGV 0 arg CHECK "${one}" "SOURCES;FLAGS;OPTIONS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "symreal_generate does not know: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT arg_FUNCTION OR NOT arg_SOURCES)
    message(FATAL_ERROR "symreal_generate needs FUNCTION and SOURCES")
  endif()
  if(NOT arg_TARGET AND NOT arg_OUT_VAR AND NOT arg_CHECK)
    message(FATAL_ERROR "symreal_generate needs TARGET or OUT_VAR: else nothing uses what it generates")
  endif()
  if(arg_TARGET AND NOT TARGET ${arg_TARGET})
    message(FATAL_ERROR "symreal_generate: there is no target '${arg_TARGET}'")
  endif()
  if(NOT arg_LANGUAGE)
    set(arg_LANGUAGE c)
  endif()
  if(NOT arg_LANGUAGE STREQUAL c)
    message(FATAL_ERROR "symreal_generate: LANGUAGE is c, not '${arg_LANGUAGE}'")
  endif()
  if(NOT arg_RUN_DIRECTORY)
    set(arg_RUN_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}")
  endif()
  if(arg_CHECK AND NOT arg_OUTPUT)
    message(FATAL_ERROR "symreal_generate: CHECK needs OUTPUT, the file that is committed")
  elseif(arg_CHECK)
    get_filename_component(output "${arg_OUTPUT}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
  else()
    if(NOT arg_OUTPUT)
      set(arg_OUTPUT "symreal/${arg_FUNCTION}.c")
    endif()
    get_filename_component(output "${arg_OUTPUT}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_BINARY_DIR}")
  endif()
  string(REGEX REPLACE "\\.c$" ".h" header "${output}")
  get_filename_component(directory "${output}" DIRECTORY)

  set(command generate ${arg_SOURCES} --kernel ${arg_FUNCTION} --lang ${arg_LANGUAGE} -o ${output} --cwd ${arg_RUN_DIRECTORY})
  if(arg_PREFIX)
    list(APPEND command --prefix ${arg_PREFIX})
  endif()
  if(arg_FP)
    list(APPEND command --fp ${arg_FP})
  endif()
  list(APPEND command ${arg_OPTIONS})

  if(arg_CHECK)
    add_test(NAME symreal_check_${arg_FUNCTION} COMMAND Symreal::symreal ${command} --check -- ${arg_FLAGS}
      WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
  else()
    set(dependencies)
    foreach(source IN LISTS arg_SOURCES)
      get_filename_component(path "${source}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
      list(APPEND dependencies "${path}")
    endforeach()
    file(MAKE_DIRECTORY "${directory}")
    add_custom_command(OUTPUT "${output}" "${header}"
      COMMAND Symreal::symreal ${command} --depfile "${output}.d" -- ${arg_FLAGS}
      COMMAND "${CMAKE_COMMAND}" -E touch "${output}" "${header}"
      DEPENDS ${dependencies} "${Symreal_EXECUTABLE}"
      DEPFILE "${output}.d"
      WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
      COMMENT "Generating ${arg_FUNCTION}.c with Symreal"
      COMMAND_EXPAND_LISTS VERBATIM)
  endif()

  if(arg_TARGET)
    target_sources(${arg_TARGET} PRIVATE "${output}" "${header}")
    target_include_directories(${arg_TARGET} PRIVATE "${directory}")
    target_link_libraries(${arg_TARGET} PRIVATE $<$<NOT:$<PLATFORM_ID:Windows>>:m>)
    set_source_files_properties("${output}" TARGET_DIRECTORY ${arg_TARGET} PROPERTIES
      COMPILE_OPTIONS "$<$<C_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=off;-fno-tree-slp-vectorize;-fno-builtin-pow>")
  endif()
  if(arg_OUT_VAR)
    set(${arg_OUT_VAR} "${output}" "${header}" PARENT_SCOPE)
  endif()
endfunction()
