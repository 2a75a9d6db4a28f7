// Check that sources agree about the headers they share: a header is rewritten once for all of them. They need not
// compile the same parts: only parts that two of them compile and would rewrite in different ways conflict.
#pragma once

#include "rewrite/facts/facts.h"

#include <set>
#include <vector>

namespace symreal::rewrite {

class Configurations {
public:
  // Adds a source's facts about the files that it includes.
  void add(std::string const &source, Facts const &facts);
  // Reports contradictions: as diagnostics, or, if a conversion can follow its context, as shared spans.
  void report(Facts &facts) const;

private:
  // A file as one source sees it, from here on without its path.
  struct Key {
    std::size_t begin, end;
    Use use;
    auto operator<=>(Key const &) const = default;
  };
  struct View {
    std::string source;
    std::map<std::size_t, std::string> types; // replacement, by offset
    std::map<Key, std::string> wraps;
    std::map<std::size_t, ClassFact> members;
    std::vector<bool> reached;
    bool same(View const &other) const;
  };
  View view(std::string const &path, Facts const &facts) const;
  void compare(std::string const &path, FileFact const &file, View const &one, View const &other);
  void compare_wraps(std::string const &path, FileFact const &file, View const &one, View const &other);
  void contradiction(FileFact const &file, std::size_t offset, std::string message);

  std::map<std::string, std::vector<View>> views_; // by real path; sources with equal views count once
  std::set<Span> shared_;
  std::vector<Diagnostic> found_;
};

} // namespace symreal::rewrite
