// Which sources a program consists of: those that define what its start reaches, from symbol to symbol, as a linker
// finds them. Of the others most need not be read: a source that defines a function has its name in its text.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace symreal::rewrite {

struct SourceLinks {
  std::map<std::string, std::set<std::string>> links; // as Facts::links
  std::map<std::string, std::string> words;           // as Facts::linked_words
};

// Sources that can be asked for, each by its number.
struct Candidates {
  std::vector<std::string> names; // of all, for diagnostics
  std::function<std::string(std::size_t)> text;
  std::function<std::vector<SourceLinks>(std::vector<std::size_t> const &)> read; // several at once
};

struct ReachableSources {
  std::set<std::size_t> sources;
  std::set<std::string> symbols; // that are reached, defined there or not
};

// Throws bad_option where several sources define what is reached, and no one of them is among `begin`.
ReachableSources reachable_sources(Candidates const &candidates, std::set<std::size_t> const &begin);

} // namespace symreal::rewrite
