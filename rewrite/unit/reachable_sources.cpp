#include "rewrite/unit/reachable_sources.h"

#include "engine/diagnostics/diagnostic.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace symreal::rewrite {
namespace {

std::set<std::string> words_of(std::string const &text) {
  auto const in_word = [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; };
  std::set<std::string> words;
  for (auto at = text.begin(); at != text.end();) {
    auto const begin = std::find_if(at, text.end(), in_word);
    at = std::find_if_not(begin, text.end(), in_word);
    if (begin != at) words.emplace(begin, at);
  }
  return words;
}

constexpr char const *at_start = ""; // code that each source runs at the program's start

class ReachableSearch {
public:
  ReachableSearch(Candidates const &candidates, std::set<std::size_t> const &begin)
      : candidates_(candidates),
        begin_(begin) {}

  ReachableSources run() {
    words_["main"] = "main";
    read(begin_);
    for (std::size_t const source : begin_) choose(source);
    reach("main");
    while (!missing_.empty()) {
      std::set<std::size_t> wanted;
      for (std::string const &symbol : missing_) with_word(words_.at(symbol), wanted);
      read(wanted);
      for (std::string const &symbol : std::exchange(missing_, {})) resolve(symbol);
      if (wanted.empty()) break;
    }
    return std::move(found_);
  }

private:
  void read(std::set<std::size_t> const &sources) {
    std::vector<std::size_t> const numbers(sources.begin(), sources.end());
    std::vector<SourceLinks> found = numbers.empty() ? std::vector<SourceLinks>() : candidates_.read(numbers);
    for (std::size_t k = 0; k < found.size(); ++k) {
      for (auto const &[symbol, needs] : found[k].links)
        if (symbol != at_start) definers_[symbol].push_back(numbers[k]);
      words_.merge(found[k].words);
      links_.emplace(numbers[k], std::move(found[k]));
    }
  }

  // Adds the unread sources whose text contains the word.
  void with_word(std::string const &word, std::set<std::size_t> &sources) {
    if (!texts_read_) {
      for (std::size_t k = 0; k < candidates_.names.size(); ++k)
        for (std::string const &one : words_of(candidates_.text(k))) by_word_[one].insert(k);
      texts_read_ = true;
    }
    for (std::size_t const source : by_word_[word])
      if (!links_.contains(source)) sources.insert(source);
  }

  void choose(std::size_t source) {
    if (found_.sources.insert(source).second) reach_needs(source, at_start);
  }
  void reach(std::string const &symbol) {
    if (found_.symbols.insert(symbol).second) resolve(symbol);
  }
  void resolve(std::string const &symbol) {
    auto const definers = definers_.find(symbol);
    if (definers == definers_.end()) {
      missing_.insert(symbol);
      return;
    }
    std::size_t const source = definer(symbol, definers->second);
    choose(source);
    reach_needs(source, symbol);
  }
  void reach_needs(std::size_t source, std::string const &symbol) {
    SourceLinks const &links = links_.at(source);
    if (auto const needs = links.links.find(symbol); needs != links.links.end())
      for (std::string const &one : needs->second) reach(one);
  }

  std::size_t definer(std::string const &symbol, std::vector<std::size_t> const &definers) const {
    if (definers.size() == 1) return definers.front();
    for (std::size_t const source : definers)
      if (begin_.contains(source)) return source;
    std::string list;
    for (std::size_t const source : definers)
      list += (list.empty() ? "" : source == definers.back() ? " and " : ", ") + candidates_.names[source];
    fail(DiagnosticId::bad_option, {},
         "--reachable: '" + words_.at(symbol) + "' is defined in " + list +
             "; name the one that belongs to the program among the sources");
  }

  Candidates const &candidates_;
  std::set<std::size_t> const &begin_;
  std::map<std::size_t, SourceLinks> links_; // of those that are read
  std::map<std::string, std::vector<std::size_t>> definers_;
  std::map<std::string, std::string> words_;
  std::map<std::string, std::set<std::size_t>> by_word_;
  bool texts_read_ = false;
  std::set<std::string> missing_;
  ReachableSources found_;
};

} // namespace

ReachableSources reachable_sources(Candidates const &candidates, std::set<std::size_t> const &begin) {
  return ReachableSearch(candidates, begin).run();
}

} // namespace symreal::rewrite
