// Text of symbolic values that a kernel has made and could read back (<symreal/text.h> describes the notes).
//
// Text is identified by its address, for single characters, and by its contents, which survive copies into strings: a
// number of three characters or more, or as many of its first digits, is found in any text, a shorter one only if it is
// all of the text.
#pragma once

#include "runtime/trace/parts/parts.h"

#include <symreal/text.h>

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace symreal::trace {

class TextMarks {
public:
  void begin();
  void end();
  void made(char const *text, std::size_t size, RealNumber value);
  // Text that lies elsewhere than in memory of the program's own.
  void made(std::string_view text, RealNumber value);
  void made_file(std::FILE *file, RealNumber value);
  void made_stream(std::ios const &stream, RealNumber value);

  // The value printed there, or in any text with the same contents; 0 without one.
  RealNumber value_at(char const *text, std::size_t size);
  RealNumber value_in(char const *text, std::size_t size);
  RealNumber value_in_file(std::FILE *file);
  RealNumber value_in_stream(std::ios const &stream);
  // Existing text of a value, whose characters may be read.
  void look(char const *text, std::size_t size);

  void report_read(std::string const &what, RealNumber value, char const *place);

private:
  struct Written {
    std::string text;
    RealNumber value;
  };

  void drop_left();
  RealNumber value_said(std::string_view text) const;

  std::map<char const *, Written> written_; // by where it begins
  std::map<std::string, RealNumber, std::less<>> numbers_;
  std::map<std::string, RealNumber, std::less<>> texts_;
  std::map<std::FILE *, RealNumber> files_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, RealNumber> inodes_; // device and number
  RealNumber in_some_file_ = 0.0;                                        // of an ofstream, whose writes are not seen
  RealNumber last_ = 0.0;
  std::set<std::string> reported_; // places
};

} // namespace symreal::trace
