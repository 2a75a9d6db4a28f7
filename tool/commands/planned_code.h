// Plans of every run: optimised graph ──schedule──▶ statements ──loops, vectors──▶ plan, in the forms of the languages.
#pragma once

#include "engine/graph/statistics.h"
#include "engine/plan/plan.h"
#include "tool/options/code_options.h"
#include "tool/options/pass_options.h"
#include "tool/output/outputs.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace symreal::tool {

// The request from which plans are made.
struct PlanRequest {
  PassOptions const &passes;
  EmitterOptions const &emitter;
  RerollOption const &reroll;
  VectorOption const &vector;
  std::vector<Language const *> languages;

  bool wishes_angles() const { return emitter.has_angles(passes.floating_point()); }
};

// The plans of a graph's code, and in words its sines and cosines at the start, its loops and its vectors.
struct PlannedCode {
  std::map<PlanForm, Plan> plans = {};
  PlanForm common = {}; // form that suits all languages
  std::string angles = {}, loops = {}, lanes = {};
  std::optional<OperationCounts> looped = {}; // operations of compute inside and outside loops
  std::vector<Diagnostic> remarks = {};

  Plan const &plan() const { return plans.at(common); }
  std::vector<LanguagePlan> of(PlanRequest const &request) const;
};

// `found`: loops that were found before.
PlannedCode planned_code(Plan const &schedule, std::optional<Rerolled> const &found, PlanRequest const &request);

// Code of a plan that was read.
PlannedCode planned_code(Plan const &plan, PlanRequest const &request);

// The schedule as C and C++ print it, if they are among the languages: loops and vectors are searched in it.
Plan with_wished_angles(Plan const &plan, EmitterOptions const &options, FloatingPoint mode,
                        std::vector<Language const *> const &languages);

} // namespace symreal::tool
