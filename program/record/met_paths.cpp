#include "program/record/met_paths.h"

#include "engine/graph/evaluate.h"
#include "engine/graph/names.h"
#include "engine/support/files.h"
#include "engine/support/number.h"
#include "engine/support/text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace symreal::program {
namespace {

struct Cell {
  std::string text;
  unsigned column; // first column, from 1
};

std::vector<Cell> cells_of(std::string_view line) {
  std::vector<Cell> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    std::size_t const end = std::min(line.find(',', begin), line.size());
    std::string_view text = trimmed(line.substr(begin, end - begin));
    auto const column = static_cast<unsigned>(text.empty() ? begin : text.data() - line.data()) + 1;
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    cells.push_back({std::string(text), column});
    begin = end + 1;
  }
  return cells;
}

[[noreturn]] void refuse(std::string const &file, std::size_t line, unsigned column, std::string const &why) {
  fail(DiagnosticId::paths_met_file, {file, static_cast<unsigned>(line), column}, why);
}

// Column of each name. All names must be present; or, if `may_lack`, none.
std::vector<std::size_t> columns_of(std::vector<std::string> const &names, std::vector<Cell> const &header,
                                    bool may_lack, std::string const &file, std::string const &kernel) {
  std::vector<std::size_t> columns;
  std::string missing;
  for (std::string const &name : names) {
    auto const is_it = [&name](Cell const &cell) { return cell.text == name; };
    auto const found = std::ranges::find_if(header, is_it);
    if (found == header.end()) {
      if (missing.empty()) missing = name;
      continue;
    }
    if (auto const again = std::find_if(found + 1, header.end(), is_it); again != header.end())
      refuse(file, 1, again->column, "a second column is called '" + name + "'");
    columns.push_back(static_cast<std::size_t>(found - header.begin()));
  }
  if (missing.empty() || (may_lack && columns.empty())) return columns;
  refuse(file, 1, 1, fmt::format("no column is called '{}', which is one of kernel '{}'", missing, kernel));
}

void read_numbers(std::vector<double> &numbers, std::vector<std::size_t> const &columns, std::vector<Cell> const &cells,
                  std::string const &file, std::size_t line) {
  for (std::size_t k = 0; k < columns.size(); ++k) {
    Cell const &cell = cells[columns[k]];
    std::optional<double> const number = parse_number(cell.text);
    if (!number || !std::isfinite(*number))
      refuse(file, line, cell.column, fmt::format("'{}' is not a finite number", cell.text));
    numbers[k] = *number;
  }
}

} // namespace

std::vector<Sample> read_sample_table(std::string const &file, Graph const &graph) {
  std::string const text = read_file(file);
  Sample const recorded = SampleSource(graph, 1).next();
  std::vector<Sample> samples;
  std::vector<Cell> header;
  std::vector<std::size_t> inputs, parameters;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    std::size_t const end = std::min(text.find('\n', begin), text.size());
    std::string_view const line = std::string_view(text).substr(begin, end - begin);
    begin = end + 1;
    if (trimmed(line).empty() && number != 0) continue;
    std::vector<Cell> const cells = cells_of(line);
    if (number == 0) {
      header = cells;
      inputs = columns_of(element_names(graph.inputs), header, false, file, graph.kernel);
      parameters = columns_of(element_names(graph.parameters), header, true, file, graph.kernel);
      continue;
    }
    if (cells.size() != header.size())
      refuse(file, number + 1, 1, fmt::format("the line has {} cells, and the header {}", cells.size(), header.size()));
    samples.push_back(recorded);
    read_numbers(samples.back().inputs, inputs, cells, file, number + 1);
    read_numbers(samples.back().parameters, parameters, cells, file, number + 1);
  }
  if (samples.empty()) refuse(file, 1, 1, "there is no line of numbers below a header of names");
  return samples;
}

MetPaths::MetPaths(std::string file, Graph const &graph)
    : file_(std::move(file)),
      samples_(read_sample_table(file_, graph)) {
  samples_.push_back(SampleSource(graph, 1).next());
}

void MetPaths::note(RecordedPath &path) const {
  if (calls_program(path.graph))
    fail(DiagnosticId::paths_met_file, {file_},
         fmt::format("kernel '{}' calls functions of the program, so its paths cannot be followed without it",
                     path.graph.kernel));
  for (DecidedStep &step : path.steps) step.is_met[0] = step.is_met[1] = false;
  for (Sample const &sample : samples_) {
    std::vector<double> const values = evaluate(path.graph, sample.inputs, sample.parameters);
    for (DecidedStep &step : path.steps) {
      bool const outcome = values[step.condition] != 0;
      step.is_met[outcome] = true;
      if (!step.is_joined && step.outcome != outcome) break; // the sample leaves the path
    }
  }
}

std::optional<Outcomes> MetPaths::correction(RecordedPath const &path) {
  Outcomes outcomes;
  for (DecidedStep const &step : path.steps) {
    if (step.is_assumed) continue; // assumed decisions have no prescribed outcome
    bool const is_one_sided = step.is_met[0] != step.is_met[1];
    if (is_one_sided && (step.is_joined || !step.is_met[step.outcome])) return outcomes + (step.is_met[1] ? 't' : 'f');
    outcomes += step.is_joined ? 'j' : step.outcome ? 't' : 'f';
  }
  return std::nullopt;
}

void MetPaths::require_inside(Graph const &graph, FloatingPoint mode, Place const &place) const {
  bool const is_some = std::any_of(samples_.begin(), samples_.end() - 1, [&](Sample const &sample) {
    Evaluation const evaluated = evaluate_sample(graph, sample.inputs, sample.parameters);
    return evaluated.premises.hold_in(mode) && evaluated.failing_guard == graph.guards.size();
  });
  if (is_some) return;
  fail(DiagnosticId::paths_outside, {file_, 1, 1},
       fmt::format("none of the {} samples lies within the premises of mode {} and the guards of kernel '{}'",
                   samples(), to_string(mode), graph.kernel),
       {{place, "the kernel is here"}});
}

} // namespace symreal::program
