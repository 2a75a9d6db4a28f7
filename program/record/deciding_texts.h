// What a program decides on, in the words of its source, by the place where it does.
#pragma once

#include "rewrite/rewrite.h"

#include <map>
#include <string>
#include <vector>

namespace symreal::program {

class DecidingTexts {
public:
  // The texts must outlive this.
  explicit DecidingTexts(std::vector<rewrite::DecidingText> const &texts);

  // The condition, or the operand of the conversion, that a decision at this place is about; null: not known.
  // `recorded`: it in terms of the kernel.
  rewrite::DecidingText const *condition(Place const &place, std::string const &recorded) const;
  rewrite::DecidingText const *conversion(Place const &place) const;

private:
  using Position = std::pair<unsigned, unsigned>;
  struct File {
    std::map<Position, rewrite::DecidingText const *> by_keyword;
    std::multimap<Position, rewrite::DecidingText const *> conditions, conversions; // by their begin
  };
  std::map<std::string, File> files_;
};

// A condition, or "the conversion of x", that was recorded in terms of the kernel's inputs.
struct SaidDecision {
  std::string text;     // as the source says it, if that is known
  std::string recorded; // in terms of the inputs, where that tells more
};
SaidDecision said_by_source(std::string const &recorded, Place const &place, DecidingTexts const &texts);

} // namespace symreal::program
