#include "runtime/replay/replay_code.h"

#include "engine/graph/graph_binary.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <string>
#include <unistd.h>

namespace symreal::replay {

ReplayCode::ReplayCode() {
  char const *code = std::getenv("SYMREAL_REPLAY_CODE"), *graph = std::getenv("SYMREAL_REPLAY_GRAPH");
  if (!code || !graph) return;
  char const *prefix = std::getenv("SYMREAL_REPLAY_PREFIX");
  prefix_ = prefix ? prefix : "";
  library_ = dlopen(code, RTLD_NOW | RTLD_LOCAL);
  if (!library_) {
    std::fprintf(stderr, "%s\n", dlerror());
    std::abort();
  }
  graph_ = read_binary_graph(graph);
}

template <class Function> static Function *find(void *library, std::string const &name) {
  void *function = library ? dlsym(library, name.c_str()) : nullptr;
  if (!function) std::abort();
  return std::bit_cast<Function *>(function);
}

int ReplayCode::compute(Head const &head, double const *inputs, double const *parameters, double *outputs) const {
  std::string const name = prefix_ + "compute";
  std::vector<double> constants(head.constant_count + 1);
  find<void(double const *, double *)>(library_, prefix_ + "preprocess")(parameters, constants.data());
  if (head.guard_count != 0)
    return find<int(double const *, double const *, double *)>(library_, name)(inputs, constants.data(), outputs);
  find<void(double const *, double const *, double *)>(library_, name)(inputs, constants.data(), outputs);
  return 0;
}

void ReplayCode::run_generated(Head &head) const {
  head.failed = compute(head, shared_code_inputs(&head), shared_parameters(&head), shared_code_outputs(&head));
}

void ReplayCode::answer_calls(Head &head, int commands, int answers) const {
  using Thunk = void(double const *, double *);
  std::vector<Thunk *> thunks;
  for (std::size_t k = 0; k < graph_.externals.size(); ++k)
    thunks.push_back(find<Thunk>(library_, "symreal_call_" + std::to_string(k)));
  constexpr int done = 0; // as the status of a fork
  for (std::uint32_t function; read(commands, &function, sizeof function) == sizeof function;) {
    if (function == no_function) return;
    alarm(head.seconds);
    thunks.at(function)(shared_arguments(&head), shared_results(&head));
    if (write(answers, &done, sizeof done) != sizeof done) return;
  }
}

void ReplayCode::run_graph(Head &head) const {
  CallExternal const call = [this](std::size_t function, std::span<double const> arguments, std::span<double> results) {
    auto *thunk = find<void(double const *, double *)>(library_, "symreal_call_" + std::to_string(function));
    thunk(arguments.data(), results.data());
  };
  Evaluation const result = evaluate_sample(graph_, {shared_inputs(&head), head.input_count},
                                            {shared_parameters(&head), head.parameter_count}, call);
  head.premises = result.premises;
  head.failing_guard = static_cast<std::uint32_t>(result.failing_guard);
  std::copy(result.outputs.begin(), result.outputs.end(), shared_outputs(&head));
}

} // namespace symreal::replay
