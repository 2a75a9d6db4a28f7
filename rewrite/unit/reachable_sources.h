// Sources of a program: those that define what its start reaches, from symbol to symbol, as a linker finds them. Most
// others need not be read: a source that defines a function has its name in its text.
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

// Available sources, each with its number.
struct Candidates {
  std::vector<std::string> names; // of all, for diagnostics
  std::function<std::string(std::size_t)> text;
  std::function<std::vector<SourceLinks>(std::vector<std::size_t> const &)> read; // several at once
};

struct ReachableSources {
  std::set<std::size_t> sources;
  std::set<std::string> symbols; // reached symbols, with or without a definition
};

// Throws bad_option if several sources define a reached symbol, and none of those sources is in `begin`.
ReachableSources reachable_sources(Candidates const &candidates, std::set<std::size_t> const &begin);

} // namespace symreal::rewrite
