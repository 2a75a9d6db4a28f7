// Annotations of a thread that are under way (annotations.cpp).
#pragma once

#include "runtime/memory/memory_image.h"

#include <symreal/annotate.h>

#include <string>
#include <vector>

namespace symreal::trace {

struct Annotations {
  // A private copy of read-only data. It lives as long as the program: a pointer to it may be anywhere.
  struct Copy {
    char *begin;
    std::size_t size;
    char const *original;
  };
  // An object that is looked up when a function is entered and read when it returns.
  struct Later {
    std::string label;
    SourcePlace place;
    std::vector<memory::Known> bytes;
  };

  std::vector<Copy> copies;
  std::vector<Later> later;
  bool is_later = false;   // the objects that follow are read when the function returns
  Kind kind = Kind::input; // of the object that is walked through
};

} // namespace symreal::trace
