// A header that several sources include is rewritten once, so they must agree about it. They need not compile the same
// parts: what counts is what two of them compile and would rewrite in different ways.
#pragma once

#include "rewrite/facts/facts.h"

#include <set>
#include <vector>

namespace symreal::rewrite {

class Configurations {
public:
  // What a source tells about the files that it includes.
  void add(std::string const &source, Facts const &facts);
  // Adds what is contradictory: to the diagnostics, or, where a conversion can go by its context, to what is shared.
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
    std::map<std::size_t, std::string> types; // what stands there then
    std::map<Key, std::string> wraps;
    std::map<std::size_t, ClassFact> members;
    std::vector<bool> reached;
    bool same(View const &other) const;
  };
  View view(std::string const &path, Facts const &facts) const;
  void compare(std::string const &path, FileFact const &file, View const &one, View const &other);
  void compare_wraps(std::string const &path, FileFact const &file, View const &one, View const &other);
  void contradiction(FileFact const &file, std::size_t offset, std::string message);

  std::map<std::string, std::vector<View>> views_; // by real path; sources that see the same count once
  std::set<Span> shared_;
  std::vector<Diagnostic> found_;
};

} // namespace symreal::rewrite
