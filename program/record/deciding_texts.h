// Source texts of a program's decisions, by place.
#pragma once

#include "rewrite/rewrite.h"

#include <map>
#include <string>
#include <vector>

namespace symreal::program {

class DecidingTexts {
public:
  // The texts must outlive this object.
  explicit DecidingTexts(std::vector<rewrite::DecidingText> const &texts);

  // The condition, or converted operand, of a decision at this place; null if unknown. `recorded`: the condition in
  // terms of the kernel.
  rewrite::DecidingText const *condition(Place const &place, std::string const &recorded) const;
  rewrite::DecidingText const *conversion(Place const &place) const;

private:
  using Position = std::pair<unsigned, unsigned>;
  struct File {
    std::map<Position, rewrite::DecidingText const *> by_keyword;
    std::multimap<Position, rewrite::DecidingText const *> conditions, conversions; // by begin
  };
  std::map<std::string, File> files_;
};

// A condition, or "the conversion of x", recorded in terms of the kernel's inputs.
struct SaidDecision {
  std::string text;     // source text, if known
  std::string recorded; // text in terms of the inputs, if it tells more
};
SaidDecision said_by_source(std::string const &recorded, Place const &place, DecidingTexts const &texts);

} // namespace symreal::program
