// Objects of static storage duration of the running program, which a function can change without a pointer argument;
// and the end of the object, static or other, at an address.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace symreal::memory {

struct StaticObject {
  std::string name; // linker name, without_tags
  char *begin;
  std::size_t size;
  bool is_of_one_file; // no other file can name it
};

// Writable static objects by address, from the symbol tables of the executable and of shared libraries other than the
// system's, without those of the runtime, the standard library and the compiler. Empty for an executable without a
// symbol table.
std::vector<StaticObject> find_static_objects();

// Objects that are read-only once the program is loaded, the runtime's and the compiler's among them.
std::vector<StaticObject> find_constants();

// Removes the ABI tag of the newer standard library's types, which compilers attach to different names.
std::string without_tags(std::string name);

// Source name of a static variable of C: gcc calls a function-local one `name.1`, Clang `function.name`. Returns other
// names, those of C++ among them, unchanged.
std::string name_in_c(std::string const &linker_name);

// Object whose initialisation this compiler guard records; empty for other names.
std::string guarded_by(std::string const &name);
// Whether the temporary's life is extended by the reference, judged by their linker names.
bool is_kept_alive_by(std::string_view temporary, std::string_view reference);

// The byte behind the static object or heap block around the address; on the stack, the end of the callers' frames; for
// an unknown address, the end of its word.
char const *object_end(void const *address);

// The constant that the address lies in. One without a symbol, a literal, has all that lies between its neighbours.
struct Constant {
  char const *begin, *end;
};
Constant constant_around(void const *address);

} // namespace symreal::memory
