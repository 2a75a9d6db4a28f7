// Declarations of the standard library's templates and types that our headers name. The headers that define them are
// the program's to include, where it uses them: they take most of the time of compiling a small source.
#pragma once

#include <iosfwd> // std::string as well

#ifdef __GLIBCXX__
#include <bits/algorithmfwd.h>

namespace std {
template <class> struct hash;
template <class> struct atomic;
template <class> struct atomic_ref;
enum class memory_order : int;
template <class, class> class basic_string_view;
struct input_iterator_tag;
struct output_iterator_tag;
} // namespace std
#else
#include <algorithm>
#include <atomic>
#include <iterator>
#include <string>
#endif
