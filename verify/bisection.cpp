#include "verify/bisection.h"

#include "engine/graph/evaluate.h"
#include "engine/optimise/passes/rule.h"
#include "runtime/replay/compare.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal::program {

namespace {

class Bisection {
public:
  Bisection(Graph const &graph, PassSettings const &settings, double tolerance, Sample const &sample)
      : settings_(settings),
        tolerance_(tolerance),
        sample_(sample),
        recorded_(outputs_of(graph)) {}

  // The first output that differs from the recorded graph's, if any.
  std::optional<Culprit> compare(Graph const &graph) const {
    std::vector<double> const now = outputs_of(graph);
    for (std::size_t slot = 0; slot < now.size(); ++slot)
      if (!same(recorded_[slot], now[slot], settings_.mode, tolerance_))
        return Culprit{{}, slot, recorded_[slot], now[slot]};
    return std::nullopt;
  }

  // Bisects the number of rewrites that the pass may do.
  void find_rewrite(Graph const &before, NamedPass const &pass, Culprit &culprit) const {
    RewriteLimit all;
    (void)run(before, pass, all);
    std::size_t good = 0, bad = all.done;
    RewriteLimit none{.most = 0};
    if (bad == 0 || compare(run(before, pass, none))) return; // the fault lies outside the pass's rewrites
    while (good + 1 < bad) {
      RewriteLimit limit{.most = good + (bad - good) / 2};
      bool const differs = compare(run(before, pass, limit)).has_value();
      (differs ? bad : good) = limit.most;
    }
    RewriteLimit last{.most = bad};
    if (!compare(run(before, pass, last))) return;
    culprit.rewrites = bad;
    culprit.rule = last.last ? fmt::format("{} -> {}", last.last->pattern_text, last.last->replacement_text)
                             : "constants were evaluated";
    if (!before.node_location.empty()) culprit.location = before.node_location[last.last_node];
  }

private:
  std::vector<double> outputs_of(Graph const &graph) const {
    std::vector<double> const values = evaluate(graph, sample_.inputs, sample_.parameters);
    std::vector<double> outputs;
    for (NodeId result : graph.results) outputs.push_back(values[result]);
    return outputs;
  }

  Graph run(Graph const &graph, NamedPass const &pass, RewriteLimit &limit) const {
    PassSettings settings = settings_;
    settings.limit = &limit;
    return pass.run(graph, settings);
  }

  PassSettings settings_;
  double tolerance_;
  Sample const &sample_;
  std::vector<double> recorded_;
};

} // namespace

std::vector<NamedPass> default_pipeline(FloatingPoint mode) {
  std::vector<NamedPass> passes;
  for (PassInfo const &pass : pass_table())
    if (pass.by_default && pass.runs_in(mode)) passes.push_back({std::string(pass.name), pass.run});
  return passes;
}

std::optional<Culprit> find_culprit(Graph const &graph, std::vector<NamedPass> const &passes,
                                    PassSettings const &settings, double tolerance, Sample const &sample) {
  Bisection const bisection(graph, settings, tolerance, sample);
  Graph before = graph;
  for (NamedPass const &pass : passes) {
    Graph after = pass.run(before, settings);
    if (std::optional<Culprit> culprit = bisection.compare(after)) {
      culprit->pass = pass.name;
      bisection.find_rewrite(before, pass, *culprit);
      return culprit;
    }
    before = std::move(after);
  }
  return std::nullopt;
}

} // namespace symreal::program
