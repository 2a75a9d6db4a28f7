// Emission state shared by the printers and parts of a file: the plan, the language, and the features used so far.
#pragma once

#include "engine/emit/language/language.h"
#include "engine/emit/language/words.h"
#include "engine/emit/print/spellings.h"
#include "engine/plan/plan.h"

#include <bitset>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// Features that printed functions use, which the rest of the file must provide.
struct UsedFeatures {
  std::bitset<op_count> operations; // printed operations
  std::bitset<op_count> spelled;    // operations whose spelling is printed, also for negated or compared conditions
  std::set<std::string_view> integer_functions; // by their names in the operation table
  std::set<std::size_t> tables, externals;
  bool kept_integer = false, keep_integer = false; // 64-bit integers in arrays of numbers
  bool truths = false;                             // truth-valued variables
  bool hidden = false, value_checks = false;
  bool apart = false;        // parts of functions that compilers must not inline
  bool side_by_side = false; // parts whose loops are vectorised, whatever the rest of the file permits
  bool not_finite = false;   // infinities or NaNs among the constants

  void add(UsedFeatures const &other) {
    operations |= other.operations;
    spelled |= other.spelled;
    integer_functions.insert(other.integer_functions.begin(), other.integer_functions.end());
    tables.insert(other.tables.begin(), other.tables.end());
    externals.insert(other.externals.begin(), other.externals.end());
    kept_integer |= other.kept_integer;
    keep_integer |= other.keep_integer;
    truths |= other.truths;
    hidden |= other.hidden;
    value_checks |= other.value_checks;
    apart |= other.apart;
    side_by_side |= other.side_by_side;
    not_finite |= other.not_finite;
  }
};

struct Emission {
  Plan const &plan;
  Language const &language;
  EmitOptions const &options;
  std::set<std::string> local_names = {}; // names in the functions other than variables
  Spellings spellings{language};
  std::vector<std::string> bridges = bridge_names(*plan.graph, language); // per function of the graph
  UsedFeatures uses = {};

  Graph const &graph() const { return *plan.graph; }
  // Whether compilers must not fuse a multiplication and an addition. In mode fast this holds only for exact
  // operations.
  bool forbids_fusion() const { return options.mode != FloatingPoint::fast || !graph().node_exact.empty(); }
  // Name of an interface function.
  std::string name(std::string const &function) const {
    return language.names.spelled(language.has_namespace ? function : prefixed(options, function));
  }
  // Name of a table of constants.
  std::string table_name(std::size_t number) const { return language.names.spelled("table_" + std::to_string(number)); }
};

} // namespace symreal
