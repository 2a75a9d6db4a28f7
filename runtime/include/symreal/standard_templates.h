// Declarations of the standard library's templates and types that our headers name. The headers that define them are
// the program's to include, where it uses them: they take most of the time of compiling a small source.
#pragma once

#include <iosfwd> // std::string as well

#ifdef __GLIBCXX__
#include <bits/algorithmfwd.h>
#ifdef SYMREAL_SOURCE_OF_C
namespace std {
template <class, class> class basic_string_view;
}
#else
#include <string_view> // where it is declared without its default argument, gcc spells that out in __PRETTY_FUNCTION__
#endif

namespace std {
template <class> struct hash;
template <class> struct atomic;
template <class> struct atomic_ref;
enum class memory_order : int;
struct input_iterator_tag;
struct output_iterator_tag;
} // namespace std
#else
#include <algorithm>
#include <atomic>
#include <iterator>
#include <string>
#endif
