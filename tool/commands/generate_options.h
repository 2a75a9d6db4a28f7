// Options of `generate`.
#pragma once

#include "tool/analysis/parallel_option.h"
#include "tool/bundle/bundle.h"
#include "tool/options/code_options.h"
#include "tool/options/pass_options.h"
#include "tool/options/recording_options.h"
#include "tool/options/source_options.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace symreal::tool {

inline constexpr char const *no_derivatives_in_wrapper =
    "--wrapper defines the original's function, which has no place for derivatives";

struct GenerateOptions {
  SourceOptions source;
  PassOptions passes;
  EmitterOptions emitter;
  LanguageOption language;
  BundleOption bundle;
  DifferentiateOption differentiate;
  ParallelOption parallel;
  RerollOption reroll;
  VectorOption vector;
  std::string output, graph_file;
  std::vector<std::string> dump;
  bool dumps(std::string_view stage) const { return std::ranges::find(dump, stage) != dump.end(); }
  DecisionsOption decisions;
  FrozenOption frozen;
  std::string depfile;
  std::string recorded = "source";
  bool records_instructions() const { return recorded == "instructions"; }
  bool check = false, wrapper = false, statistics = false, json = false, write_config = false;

  void add_to(CLI::App &command);
  // Fails for options that contradict each other.
  void require_sense(CLI::App const &command) const;
  // Checks the outputs before the work is done.
  void require_outputs() const;
};

} // namespace symreal::tool
