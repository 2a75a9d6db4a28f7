// Options for the generated code: its languages, its form, its loops and vectors.
#pragma once

#include "engine/emit/languages/languages.h"
#include "engine/ops/floating_point.h"
#include "engine/plan/lanes/lanes.h"
#include "engine/plan/reroll/reroll.h"
#include "engine/plan/schedule/schedule.h"
#include "tool/options/pass_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace symreal::tool {

// Form of the generated code.
struct EmitterOptions {
  std::string prefix, real = "double", sines; // sines: empty if not given
  std::set<std::string, std::less<>> extras;  // optional files (emit/language/language.h)
  std::vector<std::string> debug;             // aids
  bool debugs(std::string_view aid) const { return std::ranges::find(debug, aid) != debug.end(); }
  Nesting nesting() const { return debugs("values") ? Nesting::none : Nesting::bounded; }
  std::string map_file;
  std::string reference; // as in EmitOptions

  void add_to(CLI::App &app);
  // Throws bad_option for an invalid word.
  bool is_single() const;
  // Are sines and cosines of inputs computed side by side? Default in mode fast. Throws bad_option if requested but
  // impossible.
  bool has_angles(FloatingPoint mode) const;
};

// --lang: output languages.
struct LanguageOption {
  std::string text; // names separated by commas, or a special word of the subcommand

  // `others`: special words, separated by '|'.
  void add_to(CLI::App &app, std::string const &usual, std::string others = {});
  // Selected languages; empty for a special word. Throws bad_option for a name that is in no row of languages.def.
  std::vector<Language const *> languages() const;

private:
  bool is_other() const;
  std::string others_;
};

std::vector<Language const *> all_languages();

// Fails for options that name one file if several languages are requested.
void require_one_language(std::vector<Language const *> const &languages, EmitterOptions const &options);

// Fails for a file whose extension belongs to none of the languages.
void require_source_name(std::string const &path, std::vector<Language const *> const &languages);

// --reroll: turns repetitions into loops.
struct RerollOption {
  bool is_given = false;

  void add_to(CLI::App &app);
  // The loops; nullopt if not requested or not found, with a remark why. `text`: their share of the code. `found`:
  // loops that were found already, whose computed values passes then work on.
  std::optional<Rerolled> loops(Plan const &plan, std::optional<Rerolled> const &found, PassOptions const &passes,
                                std::vector<Diagnostic> &remarks, std::string &text) const;
};

// --vector=N: computes operations side by side, as vectors of N numbers.
struct VectorOption {
  unsigned width = 0; // 0: not given

  bool is_given() const { return width != 0; }
  void add_to(CLI::App &app);
  // The vectors; nullopt if not requested or not worthwhile, with a remark why. `text`: their share of the code.
  std::optional<Laned> lanes(Plan const &plan, std::vector<Diagnostic> &remarks, std::string &text) const;
};

} // namespace symreal::tool
