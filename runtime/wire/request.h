// Request of the tool to a program that it runs: entries `name=value`, which request.def lists.
//
// The environment variable SYMREAL_REQUEST is the number of an inherited descriptor; the file behind it begins with a
// head, and each entry ends in a zero byte. In a program that is run by hand the variable has the entries themselves,
// separated by ';': SYMREAL_REQUEST='decisions=guard'. The program reads them before its first constructor: a kernel
// must not be seen to read a file, and nothing here uses the heap.
#pragma once

#include <string>
#include <string_view>

namespace symreal::wire {

enum class Entry {
#define REQUEST(name, meaning) name,
#include "runtime/wire/request.def"
#undef REQUEST
};

// Value of an entry of this process; null if it is absent. The text lives as long as the process.
char const *requested(Entry entry);

inline constexpr char const *request_variable = "SYMREAL_REQUEST";

// The request of a process to be started.
class Request {
public:
  void set(Entry entry, std::string_view value);
  bool is_empty() const { return text_.empty(); }
  // Content of the file.
  std::string content() const;

private:
  std::string text_; // the entries
};

} // namespace symreal::wire
