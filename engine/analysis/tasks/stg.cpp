#include "engine/analysis/tasks/stg.h"

#include "engine/diagnostics/diagnostic.h"

#include <algorithm>
#include <charconv>
#include <ostream>
#include <queue>
#include <unordered_map>

namespace symreal {

namespace {

// Limits that keep sums of times and derived priorities far from overflow.
constexpr std::uint64_t longest_time = 1'000'000'000, most_tasks = 10'000'000;

struct Word {
  std::string_view text;
  Place place;
};

// Splits the text into lines of words, without comments and empty lines.
class Lines {
public:
  Lines(std::string_view text, std::string const &file) : rest_(text), place_{file, 0, 0} {}

  bool next(std::vector<Word> &words) {
    words.clear();
    while (words.empty() && !rest_.empty()) {
      std::size_t const end = std::min(rest_.find('\n'), rest_.size());
      std::string_view const line = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++place_.line;
      split(line.substr(0, line.find('#')), words);
    }
    return !words.empty();
  }
  Place end() const { return {place_.file, place_.line, 0}; }

private:
  void split(std::string_view line, std::vector<Word> &words) const {
    constexpr std::string_view blank = " \t\r\f\v";
    for (std::size_t at = 0; (at = line.find_first_not_of(blank, at)) != line.npos;) {
      std::size_t const end = std::min(line.find_first_of(blank, at), line.size());
      words.push_back({line.substr(at, end - at), {place_.file, place_.line, static_cast<unsigned>(at + 1)}});
      at = end;
    }
  }
  std::string_view rest_;
  Place place_;
};

[[noreturn]] void malformed(Place const &place, std::string const &message) {
  fail(DiagnosticId::task_graph_syntax, place, message);
}

std::uint64_t number(Word const &word, char const *what, std::uint64_t most) {
  std::uint64_t value = 0;
  auto const [end, failed] = std::from_chars(word.text.data(), word.text.data() + word.text.size(), value);
  if (failed == std::errc::invalid_argument || end != word.text.data() + word.text.size())
    malformed(word.place,
              "'" + std::string(word.text) + "' is not valid as " + what + ", which is a whole number from 0 on");
  if (failed != std::errc() || value > most)
    malformed(word.place, std::string(what) + " " + std::string(word.text) + " is more than " + std::to_string(most));
  return value;
}

struct StgRow {
  std::uint64_t id;
  Time duration;
  Place place;
  std::vector<Word> before_words;
  std::vector<std::uint32_t> before; // row numbers
};

StgRow read_row(std::vector<Word> const &words) {
  StgRow row{number(words[0], "id", ~std::uint64_t{0}), 0, words[0].place, {}, {}};
  if (words.size() < 3)
    malformed(words.back().place, "task " + std::to_string(row.id) + " lacks " +
                                      (words.size() < 2 ? "a processing time and " : "") +
                                      "the number of its predecessors");
  row.duration = static_cast<Time>(number(words[1], "processing time", longest_time));
  std::uint64_t const count = number(words[2], "number of predecessors", most_tasks);
  if (count != words.size() - 3)
    malformed(words[2].place, "task " + std::to_string(row.id) + " has " + std::to_string(count) +
                                  " predecessors, and " + std::to_string(words.size() - 3) + " are listed");
  row.before_words.assign(words.begin() + 3, words.end());
  return row;
}

std::vector<StgRow> read_rows(std::string_view text, std::string const &file) {
  Lines lines(text, file);
  std::vector<Word> words;
  if (!lines.next(words)) malformed(lines.end(), "the number of tasks is missing");
  if (words.size() > 2) malformed(words[2].place, "the number of tasks stands on a line of its own");
  if (words.size() == 2) number(words[1], "number of units", most_tasks); // checked, then ignored
  Word const head = words[0];
  std::uint64_t const count = number(head, "number of tasks", most_tasks);
  std::vector<StgRow> rows;
  while (lines.next(words)) rows.push_back(read_row(words));
  auto const instants = static_cast<std::uint64_t>(std::ranges::count(rows, Time{0}, &StgRow::duration));
  if (rows.size() < count || rows.size() > count + std::min(instants, std::uint64_t{2}))
    malformed(head.place, "the number of tasks is " + std::string(head.text) + ", and " + std::to_string(rows.size()) +
                              " follow; only two that take no time may be left out");
  return rows;
}

void resolve(std::vector<StgRow> &rows) {
  std::unordered_map<std::uint64_t, std::uint32_t> row_of;
  for (std::uint32_t i = 0; i < rows.size(); ++i)
    if (!row_of.emplace(rows[i].id, i).second)
      fail(DiagnosticId::task_graph_syntax, rows[i].place, "two tasks have the id " + std::to_string(rows[i].id),
           {{rows[row_of[rows[i].id]].place, "the other one"}});
  for (StgRow &row : rows)
    for (Word const &word : row.before_words) {
      auto const found = row_of.find(number(word, "id of a predecessor", ~std::uint64_t{0}));
      if (found == row_of.end()) malformed(word.place, "no task has the id " + std::string(word.text));
      row.before.push_back(found->second);
    }
}

// Reports a cycle: each waiting task has a waiting predecessor, so walking back from one leads into a cycle.
[[noreturn]] void fail_with_cycle(std::vector<StgRow> const &rows, std::vector<std::uint32_t> const &waits_for) {
  auto const waits = [&](std::uint32_t row) { return waits_for[row] != 0; };
  std::uint32_t row = 0;
  while (!waits(row)) ++row;
  std::vector<std::uint32_t> path;
  std::vector<char> is_on_path(rows.size());
  for (; !is_on_path[row]; row = *std::ranges::find_if(rows[row].before, waits)) {
    is_on_path[row] = 1;
    path.push_back(row);
  }
  path.erase(path.begin(), std::ranges::find(path, row));
  std::vector<Note> notes;
  for (std::size_t i = 0; i < path.size() && i < 20; ++i) {
    std::uint32_t const before = path[(i + 1) % path.size()];
    auto const place = rows[path[i]]
                           .before_words[static_cast<std::size_t>(std::ranges::find(rows[path[i]].before, before) -
                                                                  rows[path[i]].before.begin())]
                           .place;
    notes.push_back(
        {place, "task " + std::to_string(rows[path[i]].id) + " waits for task " + std::to_string(rows[before].id)});
  }
  std::string const message = path.size() == 1 ? "task " + std::to_string(rows[row].id) + " waits for itself"
                                               : std::to_string(path.size()) + " tasks wait for each other";
  fail(DiagnosticId::task_graph_cycle, rows[row].place, message, std::move(notes));
}

StgTasks sorted(std::vector<StgRow> const &rows) {
  std::vector<std::vector<std::uint32_t>> after(rows.size());
  std::vector<std::uint32_t> waits_for(rows.size());
  std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> ready; // min-heap by text position
  for (std::uint32_t i = 0; i < rows.size(); ++i) {
    for (std::uint32_t before : rows[i].before) after[before].push_back(i);
    waits_for[i] = static_cast<std::uint32_t>(rows[i].before.size());
    if (waits_for[i] == 0) ready.push(i);
  }
  StgTasks result;
  std::vector<TaskId> task_of(rows.size()), before;
  while (!ready.empty()) {
    std::uint32_t const row = ready.top();
    ready.pop();
    before.clear();
    for (std::uint32_t other : rows[row].before) before.push_back(task_of[other]);
    task_of[row] = static_cast<TaskId>(result.tasks.size());
    result.tasks.add(rows[row].duration, before);
    result.id.push_back(rows[row].id);
    for (std::uint32_t other : after[row])
      if (--waits_for[other] == 0) ready.push(other);
  }
  if (result.tasks.size() != rows.size()) fail_with_cycle(rows, waits_for);
  return result;
}

std::vector<TaskId> without_successor(TaskGraph const &graph) {
  Successors const next = successors(graph);
  std::vector<TaskId> result;
  for (TaskId task = 0; task < graph.size(); ++task)
    if (next.of(task).empty()) result.push_back(task);
  return result;
}

// Whether the graph has a single source and a single sink, both of zero duration.
bool has_dummies(TaskGraph const &graph, std::vector<TaskId> const &last) {
  auto const starts = [&](std::size_t task) { return graph.predecessors(static_cast<TaskId>(task)).empty(); };
  if (graph.size() < 2 || last.size() != 1 || last[0] + 1 != graph.size()) return false;
  for (std::size_t task = 1; task < graph.size(); ++task)
    if (starts(task)) return false;
  return graph.duration.front() == 0 && graph.duration.back() == 0;
}

void write_row(std::ostream &out, std::uint64_t id, Time duration, std::vector<std::uint64_t> const &before) {
  out << id << ' ' << duration << ' ' << before.size();
  for (std::uint64_t each : before) out << ' ' << each;
  out << '\n';
}

} // namespace

StgTasks read_stg(std::string_view text, std::string const &file_name) {
  std::vector<StgRow> rows = read_rows(text, file_name);
  resolve(rows);
  return sorted(rows);
}

void write_stg(std::ostream &out, TaskGraph const &graph, std::vector<std::uint64_t> const &id) {
  std::vector<TaskId> const last = without_successor(graph);
  bool const add = !has_dummies(graph, last);
  out << (add ? graph.size() : graph.size() - 2) << '\n';
  if (add) write_row(out, 0, 0, {});
  auto const name = [&](TaskId task) { return !add && !id.empty() ? id[task] : task + std::uint64_t{add}; };
  std::vector<std::uint64_t> before;
  for (TaskId task = 0; task < graph.size(); ++task) {
    before.clear();
    for (TaskId other : graph.predecessors(task)) before.push_back(name(other));
    if (add && before.empty()) before.push_back(0);
    write_row(out, name(task), graph.duration[task], before);
  }
  if (!add) return;
  before.clear();
  for (TaskId task : last) before.push_back(name(task));
  if (before.empty()) before.push_back(0);
  write_row(out, graph.size() + 1, 0, before);
}

} // namespace symreal
