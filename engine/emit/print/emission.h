// What the printers and the parts of a file share: what is printed, in which language, and what it has used so far.
#pragma once

#include "engine/emit/language/emitted.h"
#include "engine/emit/language/language.h"
#include "engine/emit/language/words.h"
#include "engine/emit/print/bridge_names.h"
#include "engine/emit/print/spellings.h"
#include "engine/plan/lanes/lanes.h"
#include "engine/plan/reroll/reroll.h"
#include "engine/plan/schedule/schedule.h"

#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// Noted while functions are printed: what the rest of the file must provide.
struct Uses {
  std::array<bool, op_count> operations{}; // that are printed
  std::array<bool, op_count> spelled{};    // whose spelling is, besides those a condition that is negated or compared
  std::set<std::string_view> integer_functions; // by their names in the table of operations
  std::set<std::size_t> tables, externals;
  bool kept_integer = false, keep_integer = false; // integers of 64 bits that stand in arrays of numbers
  bool truths = false;                             // variables with truth values
  bool hidden = false, value_checks = false;
  bool apart = false;        // parts of functions that must not be joined again
  bool side_by_side = false; // parts whose loops become vectors, whatever the rest of the file does
  bool not_finite = false;   // infinities and NaNs among the constants

  void add(Uses const &other);
};

struct Emission {
  Schedule const &plan;
  Language const &language;
  EmitOptions const &options;
  Rerolled const *loops = nullptr;        // in place of the statements of the functions that have some
  Laned const *lanes = nullptr;           // function compute with vectors, beside that without
  std::set<std::string> local_names = {}; // that the functions have besides those of their variables
  Spellings spellings{language};
  std::vector<std::string> bridges = bridge_names(*plan.graph, language); // by function of the graph
  Uses uses = {};

  Graph const &graph() const { return *plan.graph; }
  // Whether compilers must not make one operation of a multiplication and an addition. In mode fast only exact
  // operations mind.
  bool forbids_fusion() const { return options.mode != FloatingPoint::fast || !graph().node_exact.empty(); }
  // The name of a function of the interface.
  std::string name(std::string const &function) const {
    return language.names.spelled(language.has_namespace ? function : prefixed(options, function));
  }
};

} // namespace symreal
