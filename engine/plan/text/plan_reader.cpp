#include "engine/graph/graph_text.h"
#include "engine/plan/text/lane_reader.h"
#include "engine/plan/text/loop_reader.h"
#include "engine/plan/text/plan_text.h"
#include "engine/plan/text/statement_reader.h"

#include <algorithm>

namespace symreal {

namespace {

constexpr std::string_view head_of_plan = "symreal-plan", functions_begin = "\nfunction ";

// Position of the first line other than comments and empty lines.
std::size_t head_of(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size() && (text[at] == ';' || text[at] == '\n'))
    at = std::min(text.find('\n', at), text.size() - 1) + 1;
  return at;
}

class PlanReader {
public:
  PlanReader(std::string_view text, std::string const &file_name)
      : file_name_(file_name),
        begin_(std::min(text.find(functions_begin), text.size())),
        graph_(std::make_unique<Graph>(graph_of(text.substr(0, begin_)))),
        names_(*graph_),
        lines_(text.substr(std::min(begin_ + 1, text.size())), file_name,
               static_cast<unsigned>(std::ranges::count(text.substr(0, begin_), '\n')) + 1) {
    plan_.graph = graph_.get();
    plan_.constant_slot.assign(graph_->nodes.size(), no_slot);
    plan_.functions.reserve(function_kinds().size()); // readers point to them
  }

  ReadPlan read() {
    while (!lines_.done()) {
      Line line(lines_.next(), lines_.place());
      if (line.done()) continue;
      read_line(line);
      if (!line.done()) line.unexpected();
    }
    Line end("", lines_.place());
    finish_function(end);
    if (!plan_.find(FunctionKind::preprocess) || !plan_.find(FunctionKind::compute)) refuse_functions(end);
    return {std::move(graph_), std::move(plan_)};
  }

private:
  // The graph; its head has the same version as the plan's. Keeps the lines that the bodies of loops share.
  Graph graph_of(std::string_view text) {
    Lines lines(text, file_name_, 0);
    while (!lines.done()) {
      std::string_view const line = lines.next();
      if (line.starts_with("location ") || line.starts_with("table ")) shared_ += std::string(line) + '\n';
    }
    std::string graph(text);
    graph.replace(head_of(graph), head_of_plan.size(), "symreal-graph");
    return read_graph(graph, file_name_);
  }

  void read_line(Line &line) {
    std::string const head = line.word("a line");
    if (head == "function") return read_function(line);
    if (!statements_) line.error("the lines of a function follow 'function'");
    if (head == "loops" || head == "lanes") {
      if (loops_ || lanes_) line.error("a function has loops or vectors, once");
      statements_->finish(line);
      if (head == "loops")
        loops_.emplace(plan_, plan_.functions.back(), shared_, file_name_, line);
      else
        lanes_.emplace(plan_, plan_.functions.back(), names_, line);
      return;
    }
    bool const is_known = loops_   ? loops_->read(head, line, lines_)
                          : lanes_ ? lanes_->read(head, line)
                                   : statements_->read(head, line);
    if (!is_known) line.error("'" + head + "' begins no line of a plan here");
  }

  void read_function(Line &line) {
    finish_function(line);
    std::string const name = line.word("the function's name");
    auto const found = std::ranges::find(function_kinds(), name, &FunctionInfo::name);
    if (found == function_kinds().end()) refuse_functions(line);
    bool const is_first = plan_.functions.empty();
    if (is_first ? found->kind != FunctionKind::preprocess : plan_.functions.back().kind >= found->kind)
      refuse_functions(line);
    PlanFunction &function = plan_.make(found->kind);
    if (found->fills == Array::output) function.results = graph_->results;
    statements_.emplace(plan_, function, names_, std::move(computed_));
  }

  [[noreturn]] static void refuse_functions(Line const &line) {
    line.error("a plan has the functions preprocess and compute, in this order");
  }

  void finish_function(Line &line) {
    if (!statements_) return;
    if (loops_)
      loops_->finish(line);
    else if (lanes_)
      lanes_->finish(line);
    else
      statements_->finish(line);
    if (info(plan_.functions.back().kind).is_helper) computed_ = statements_->computed();
    loops_.reset();
    lanes_.reset();
    statements_.reset();
  }

  std::string const &file_name_;
  std::size_t begin_;  // of the functions
  std::string shared_; // lines of the graph
  std::unique_ptr<Graph> graph_;
  NodeNames names_;
  Lines lines_;
  Plan plan_{};
  std::vector<char> computed_; // by the helpers of the next function
  std::optional<StatementReader> statements_;
  std::optional<LoopReader> loops_;
  std::optional<LaneReader> lanes_;
};

} // namespace

bool is_plan(std::string_view text) { return text.substr(head_of(text)).starts_with(head_of_plan); }

ReadPlan read_plan(std::string_view text, std::string const &file_name) { return PlanReader(text, file_name).read(); }

} // namespace symreal
