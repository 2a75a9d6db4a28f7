# What is installed, and how it is packed. The tools find the runtime in ../lib/symreal, wherever the prefix lies: its
# headers stand in a directory of their own, since the rewriter must tell them from all others.
include(CMakePackageConfigHelpers)

install(TARGETS symreal symreal-compiler RUNTIME DESTINATION bin)
install(FILES ${PROJECT_BINARY_DIR}/tool/symreal-cc DESTINATION bin)
install(TARGETS symreal_runtime symreal_generate ARCHIVE DESTINATION lib/symreal)
install(TARGETS symreal-record-instructions LIBRARY DESTINATION lib/symreal)
install(DIRECTORY engine/include/ runtime/include/ DESTINATION lib/symreal/include)
install(FILES ${SYMREAL_MACROS} ${SYMREAL_HIDDEN_NAMES} DESTINATION lib/symreal/include/symreal)
install(FILES tool/completion.bash DESTINATION share/bash-completion/completions RENAME symreal)
install(FILES LICENSE README.md DESTINATION share/doc/symreal)
install(DIRECTORY docs DESTINATION share/doc/symreal)

# find_package(Symreal): in the installed tree, and in the build tree.
set(package_paths SYMREAL_TOOL_DIR SYMREAL_RUNTIME_FILE SYMREAL_RUNTIME_HEADERS SYMREAL_CMAKE_DIR)
set(SYMREAL_TOOL_DIR bin)
set(SYMREAL_RUNTIME_FILE lib/symreal/libsymreal_generate.a)
set(SYMREAL_RUNTIME_HEADERS lib/symreal/include)
set(SYMREAL_CMAKE_DIR lib/cmake/Symreal)
configure_package_config_file(cmake/SymrealConfig.cmake.in ${PROJECT_BINARY_DIR}/installed/SymrealConfig.cmake
  INSTALL_DESTINATION lib/cmake/Symreal PATH_VARS ${package_paths})
set(SYMREAL_TOOL_DIR ${PROJECT_BINARY_DIR}/tool)
set(SYMREAL_RUNTIME_FILE ${PROJECT_BINARY_DIR}/runtime/libsymreal_generate.a)
set(SYMREAL_RUNTIME_HEADERS ${PROJECT_BINARY_DIR}/runtime/include)
set(SYMREAL_CMAKE_DIR ${PROJECT_SOURCE_DIR}/cmake)
configure_package_config_file(cmake/SymrealConfig.cmake.in ${PROJECT_BINARY_DIR}/SymrealConfig.cmake
  INSTALL_PREFIX ${PROJECT_BINARY_DIR} INSTALL_DESTINATION . PATH_VARS ${package_paths})
# The tool of a 64-bit host serves a 32-bit target.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/SymrealConfigVersion.cmake COMPATIBILITY SameMinorVersion
  ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/installed/SymrealConfig.cmake ${PROJECT_BINARY_DIR}/SymrealConfigVersion.cmake
  cmake/SymrealGenerate.cmake DESTINATION lib/cmake/Symreal)

# cpack -G DEB
find_package(LLVM 19.1 REQUIRED CONFIG)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME symreal)
set(CPACK_PACKAGE_CONTACT "The Symreal authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The host's compiler, its linker, diff; and Clang's own headers, those of the library that parses with them.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "g++, binutils, diffutils, libclang-common-${LLVM_VERSION_MAJOR}-dev")
include(CPack)
