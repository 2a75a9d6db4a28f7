// The objects of static storage duration of the running program: what a function can leave behind without a pointer.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace symreal::memory {

struct StaticObject {
  std::string name; // as the linker knows it, without_tags
  char *begin;
  std::size_t size;
  bool is_of_one_file; // no other file can name it
};

// Those of this thread's program that can be written, by address: of the executable and of the shared libraries that
// are not the system's, from their symbol tables. The runtime's own, the standard library's and the compiler's are left
// out. An executable without a symbol table has none.
std::vector<StaticObject> find_static_objects();

// Objects that cannot be written once the program is loaded, the runtime's and the compiler's among them.
std::vector<StaticObject> find_constants();

// Without the tag for the types of the newer standard library, which compilers add to different names.
std::string without_tags(std::string name);

// A static variable of C as the source has it: gcc makes `name.1` of one in a function, Clang `function.name`. Other
// names, those of C++ among them, are as they were.
std::string name_in_c(std::string const &linker_name);

// The object that the compiler guards with this one, which says whether it is initialised; empty for other names.
std::string guarded_by(std::string const &name);
// Whether the temporary lives as long as the reference, by the names that the linker knows.
bool is_kept_alive_by(std::string_view temporary, std::string_view reference);

} // namespace symreal::memory
