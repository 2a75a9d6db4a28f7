#include "engine/plan/plan.h"

#include <algorithm>
#include <array>

namespace symreal {

namespace {

constexpr std::array value_kind_names = {
#define VALUE_KIND(kind, syntax) std::string_view(#kind),
#include "engine/plan/value_kinds.def"
#undef VALUE_KIND
};

struct ArrayInfo {
  std::string_view name;
  Space space;
};

// In the order of the enumerators.
constexpr std::array arrays = {
    ArrayInfo{"parameters", Space::argument}, ArrayInfo{"input", Space::argument},
    ArrayInfo{"constants", Space::argument},  ArrayInfo{"computed_angle", Space::work},
    ArrayInfo{"sine", Space::work},           ArrayInfo{"cosine", Space::work},
    ArrayInfo{"output", Space::result},       ArrayInfo{"memory", Space::work},
    ArrayInfo{"values", Space::constant},
};

constexpr std::array read_by_preprocess = {Array::parameters};
constexpr std::array read_by_compute = {Array::input, Array::constants};

// In the order of the enumerators.
constexpr std::array kinds = {
    FunctionInfo{FunctionKind::preprocess, "preprocess", read_by_preprocess, Array::constants, GuardExit::none, false},
    FunctionInfo{FunctionKind::angles, "angles", read_by_compute, Array::computed_angle, GuardExit::none, true},
    FunctionInfo{FunctionKind::compute, "compute", read_by_compute, Array::output, GuardExit::returns, false},
};

} // namespace

std::string_view name_of(ValueKind kind) { return value_kind_names[static_cast<std::size_t>(kind)]; }

std::optional<ValueKind> find_value_kind(std::string_view name) {
  auto const found = std::ranges::find(value_kind_names, name);
  if (found == value_kind_names.end()) return {};
  return static_cast<ValueKind>(found - value_kind_names.begin());
}

ValueKind kind_of(Op op) {
  return is_wide(op) ? ValueKind::u64 : info(op).has(flag::BOOLEAN) ? ValueKind::truth : ValueKind::f64;
}

std::string_view name_of(Array array) { return arrays[static_cast<std::size_t>(array)].name; }
Space space_of(Array array) { return arrays[static_cast<std::size_t>(array)].space; }

std::optional<Array> find_array(std::string_view name) {
  auto const found = std::ranges::find(arrays, name, &ArrayInfo::name);
  if (found == arrays.end()) return {};
  return static_cast<Array>(found - arrays.begin());
}

std::span<FunctionInfo const> function_kinds() { return kinds; }

bool reads(FunctionKind kind, Array array) {
  bool const begins_with = kind == FunctionKind::compute && (array == Array::sine || array == Array::cosine);
  return begins_with || std::ranges::count(info(kind).reads, array) != 0;
}

PlanFunction const *Plan::find(FunctionKind kind) const {
  auto const found = std::ranges::find(functions, kind, &PlanFunction::kind);
  return found == functions.end() ? nullptr : &*found;
}

PlanFunction &Plan::make(FunctionKind kind) {
  auto const found = std::ranges::lower_bound(functions, kind, {}, &PlanFunction::kind);
  if (found != functions.end() && found->kind == kind) return *found;
  PlanFunction function{kind};
  function.regions.node_count = static_cast<NodeId>(graph->nodes.size());
  return *functions.insert(found, std::move(function));
}

PlanFunction const &Plan::compute() const {
  PlanFunction const *const function = find(FunctionKind::compute);
  internal_check(function != nullptr);
  return *function;
}

bool Plan::has_loops() const {
  return std::ranges::any_of(functions, [](PlanFunction const &function) { return function.loops.has_value(); });
}

lanes::LaneFunction const *Plan::vectors() const {
  for (PlanFunction const &function : functions)
    if (function.lanes) return &*function.lanes;
  return nullptr;
}

std::size_t Plan::extent(Array array) const {
  switch (array) {
  case Array::parameters: return graph->parameter_count();
  case Array::input: return graph->input_count();
  case Array::constants: return constant_count;
  case Array::computed_angle: return angles.computed;
  case Array::sine:
  case Array::cosine: return angles.size();
  case Array::output: return graph->results.size();
  case Array::memory:
  case Array::values: break; // each function's and step's own
  }
  return 0;
}

} // namespace symreal
