#include "runtime/replay/replay_server.h"

#include "engine/graph/graph.h"
#include "engine/graph/graph_binary.h"
#include "runtime/memory/rollback.h"
#include "runtime/replay/replay_protocol.h"
#include "runtime/wire/request.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <iterator>
#include <string>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

// Symbols of clang's profile library; null in a program without it.
extern "C" {
[[gnu::weak]] char *profile_begin_counters() __asm__("__llvm_profile_begin_counters");
[[gnu::weak]] char *profile_end_counters() __asm__("__llvm_profile_end_counters");
[[gnu::weak]] int profile_write_file() __asm__("__llvm_profile_write_file");
}

namespace symreal::replay {
namespace {

// Branch counters of a program that clang has built with -fprofile-instr-generate. Each sample begins with none; the
// counts of all samples are summed. Other programs have no counters.
class BranchCounters {
public:
  // Construct it before the first fork: earlier counts are left out.
  BranchCounters() {
    if (!profile_begin_counters || !profile_end_counters || !profile_write_file) return;
    counters_ = reinterpret_cast<std::uint64_t *>(profile_begin_counters());
    count_ = static_cast<std::size_t>(reinterpret_cast<std::uint64_t *>(profile_end_counters()) - counters_);
    if (count_ == 0) return;
    void *shared = mmap(nullptr, count_ * sizeof *sums_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, /*fd=*/-1,
                        /*offset=*/0);
    if (shared == MAP_FAILED) std::abort();
    sums_ = static_cast<std::uint64_t *>(shared);
    std::fill_n(counters_, count_, 0);
  }
  // Adds the counts of a sample, at its end.
  void add() const {
    for (std::size_t k = 0; k < count_; ++k) sums_[k] += counters_[k];
  }
  // The sums, to the file that LLVM_PROFILE_FILE names.
  void write() const {
    if (count_ == 0) return;
    std::copy_n(sums_, count_, counters_);
    if (profile_write_file() != 0) std::abort();
  }
  bool are_there() const { return count_ != 0; }

private:
  std::uint64_t *counters_ = nullptr; // those of the program
  std::size_t count_ = 0;
  std::uint64_t *sums_ = nullptr; // in memory that all forks share
};

template <class Function> Function *find(void *library, std::string const &name) {
  void *function = library ? dlsym(library, name.c_str()) : nullptr;
  if (!function) std::abort();
  return std::bit_cast<Function *>(function);
}

// The generated code and the recorded graph of a kernel with external functions.
class ReplayCode {
public:
  // Loads the code that the request names, if any. Ends the process if it cannot be loaded.
  ReplayCode() {
    char const *code = wire::requested(wire::Entry::replay_code), *graph = wire::requested(wire::Entry::replay_graph);
    if (!code || !graph) return;
    char const *prefix = wire::requested(wire::Entry::replay_prefix);
    prefix_ = prefix ? prefix : "";
    library_ = dlopen(code, RTLD_NOW | RTLD_LOCAL);
    if (!library_) {
      std::fprintf(stderr, "%s\n", dlerror());
      std::abort();
    }
    graph_ = read_binary_graph(graph);
  }
  void run_generated(Head &head) const {
    head.failed = compute(head, shared_code_inputs(&head), shared_parameters(&head), shared_code_outputs(&head));
  }
  // 0, or the number of the guard that does not hold.
  int compute(Head const &head, double const *inputs, double const *parameters, double *outputs) const {
    std::string const name = prefix_ + "compute";
    std::vector<double> constants(head.constant_count + 1);
    find<void(double const *, double *)>(library_, prefix_ + "preprocess")(parameters, constants.data());
    if (head.guard_count != 0)
      return find<int(double const *, double const *, double *)>(library_, name)(inputs, constants.data(), outputs);
    find<void(double const *, double const *, double *)>(library_, name)(inputs, constants.data(), outputs);
    return 0;
  }
  void run_graph(Head &head) const {
    CallExternal const call = [this](std::size_t function, std::span<double const> arguments,
                                     std::span<double> results) {
      auto *thunk = find<void(double const *, double *)>(library_, "symreal_call_" + std::to_string(function));
      thunk(arguments.data(), results.data());
    };
    Evaluation const result = evaluate_sample(graph_, {shared_inputs(&head), head.input_count},
                                              {shared_parameters(&head), head.parameter_count}, call);
    head.premises = result.premises;
    head.failing_guard = static_cast<std::uint32_t>(result.failing_guard);
    std::copy(result.outputs.begin(), result.outputs.end(), shared_outputs(&head));
  }
  // Answers calls until the client sends no_function, or has gone.
  void answer_calls(Head &head, int commands, int answers) const {
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

  bool is_there() const { return library_ != nullptr; }

private:
  void *library_ = nullptr;
  std::string prefix_;
  Graph graph_;
};

Head *shared = nullptr; // set while the wanted kernel runs in a fork
ReplayCode const *loaded = nullptr;
BranchCounters const *counters = nullptr;
std::uint32_t inputs_met, parameters_met, outputs_met, links_met; // in this call of the kernel

struct Connection {
  std::string file;
  int commands = -1, answers = -1;
};

bool parse(char const *text, Connection &connection) {
  std::string_view rest = text;
  std::size_t comma = rest.rfind(',');
  std::size_t before = comma == rest.npos ? comma : rest.rfind(',', comma - 1);
  if (before == rest.npos) return false;
  connection.file = rest.substr(0, before);
  connection.commands = std::atoi(text + before + 1);
  connection.answers = std::atoi(text + comma + 1);
  return true;
}

Head *map(std::string const &file) {
  int descriptor = open(file.c_str(), O_RDWR | O_CLOEXEC);
  struct stat status;
  if (descriptor < 0 || fstat(descriptor, &status) != 0) return nullptr;
  void *memory =
      mmap(nullptr, static_cast<std::size_t>(status.st_size), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  close(descriptor);
  return memory == MAP_FAILED ? nullptr : static_cast<Head *>(memory);
}

constexpr unsigned most_given_up = 4; // runs; then each has a fork of its own

void tell_left(Head &head, std::vector<memory::Change> const &changes) {
  head.left_count = static_cast<std::uint32_t>(std::min(changes.size(), std::size(head.left)));
  for (std::size_t k = 0; k < head.left_count; ++k) head.left[k] = left_behind(changes[k]);
}

// Whether the command lets its fork take further ones.
bool leaves_fork(Head const &head) {
  return head.command == Command::original && head.watches_world == 0 && head.examines == 0;
}

void begin_answer(Head &head) {
  head.state = State::begun;
  head.left_count = head.effect_count = head.unnamed_count = head.calls_done = 0;
  head.returned = 0;
  head.unexamined[0] = 0;
}

// A fork that runs the kernel several times, each time from the same state.
class Turns {
public:
  // In the server, before the first fork.
  Turns(Connection connection, Head &head, bool (*refuse_calls)(bool))
      : connection_(std::move(connection)),
        head_(head),
        refuse_calls_(refuse_calls) {}
  bool are_possible() const { return rollback_.is_possible(); }

  // In the fork. Returns before each run of the kernel; false in a fork that makes one run alone.
  bool begin() {
    if (!refuse_calls_(false)) return false;
    rollback_.keep();
    if (head_.command == Command::none) {
      if (read(connection_.commands, &head_.command, 1) != 1) _exit(0);
      if (!leaves_fork(head_)) _exit(0); // the server makes another
      begin_answer(head_);
    }
    alarm(head_.seconds);
    refuse_calls_(true);
    return true;
  }

  // At the end of a run. Returns if it was the last.
  void end() {
    refuse_calls_(false);
    alarm(0);
    head_.command = Command::none;
    if (constexpr int done = 0; write(connection_.answers, &done, sizeof done) == sizeof done) rollback_.go_back();
  }

private:
  Connection connection_;
  Head &head_;
  bool (*refuse_calls_)(bool);
  memory::Rollback rollback_;
};
Turns *turns = nullptr; // in a fork of several runs

// Returns in the forks only.
void serve(Connection const &connection, Head *head, Memory const &memory) {
  std::fflush(nullptr); // once, not in every fork
  static ReplayCode const code;
  loaded = &code;
  static BranchCounters const branches;
  counters = &branches;
  if (branches.are_there()) {
    std::vector<std::uintptr_t> const stack = memory.stack();
    std::copy_n(stack.begin(), std::min(stack.size(), std::size(head->stack)), head->stack);
  }
  if (constexpr int reached = 0; write(connection.answers, &reached, sizeof reached) != sizeof reached) _exit(0);
  static Turns several(connection, *head, memory.refuse_calls);
  bool const are_possible = several.are_possible() && !code.is_there() && !wire::requested(wire::Entry::replay_alone);
  bool is_again = false; // the command was given up
  unsigned given_up = 0;
  while (head->command != Command::none || read(connection.commands, &head->command, 1) == 1) {
    Command const command = head->command;
    bool const leaves = leaves_fork(*head), has_turns = are_possible && leaves && !is_again && given_up < most_given_up;
    begin_answer(*head);
    pid_t child = fork();
    if (child == 0) {
      if (has_turns && several.begin()) return void(turns = &several);
      alarm(head->seconds);
      if (command == Command::functions) {
        code.answer_calls(*head, connection.commands, connection.answers);
        head->state = State::complete;
        _exit(0);
      }
      close(connection.commands);
      close(connection.answers);
      if (command == Command::original) return;
      command == Command::generated ? code.run_generated(*head) : code.run_graph(*head);
      tell_left(*head, memory.changes());
      head->state = State::complete;
      _exit(0);
    }
    int status = -1;
    if (child > 0) waitpid(child, &status, 0);
    if (head->command == Command::none) { // it has answered, and could not go back
      ++given_up;
      continue;
    }
    is_again = has_turns && !(WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM);
    if (is_again) {
      given_up += leaves_fork(*head);
      continue;
    }
    head->command = Command::none;
    if (write(connection.answers, &status, sizeof status) != sizeof status) break;
  }
  branches.write();
  _exit(0);
}

[[noreturn]] void finish(State state) {
  shared->state = state;
  if (state == State::complete) counters->add();
  if (turns) turns->end();
  _exit(0);
}

void give(double *number, double const *values, std::uint32_t &met, std::uint32_t count) {
  if (met == count || !number) finish(State::wrong_shape);
  *number = values[met++];
  if (shared->calls_done == 0 && replay_is_fed()) shared->state = State::inside;
}

std::size_t take_number(std::string_view &text) {
  std::size_t value = 0;
  auto const end = std::from_chars(text.data(), text.data() + text.size(), value).ptr;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

template <class T> T read_as(char const *from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

constexpr std::size_t longest_text = 256; // further characters are ignored

std::string_view bytes_of(char what, char const *at, std::size_t size) {
  switch (what) {
  case 'p': return read_as<void const *>(at) ? "one" : "none";
  case 't': {
    auto const *text = read_as<char const *>(at);
    return text ? std::string_view(text, strnlen(text, longest_text)) : std::string_view("\0", 1);
  }
  case 's': return {read_as<char const *>(at), read_as<std::size_t>(at + sizeof(char const *))};
  default: return {at, size};
  }
}

// A hash of the members of the returned object that are not numbers.
std::uint64_t hash_of_others(char const *object, std::string_view others) {
  std::uint64_t hash = 14695981039346656037u;
  auto const add = [&hash](unsigned char byte) { hash = (hash ^ byte) * 1099511628211u; };
  while (!others.empty()) {
    char const what = others.front();
    others.remove_prefix(1);
    std::size_t const size = take_number(others);
    others.remove_prefix(1); // the sign
    std::size_t const offset = take_number(others);
    others.remove_prefix(1); // the semicolon
    for (char const one : bytes_of(what, object + offset, size)) add(static_cast<unsigned char>(one));
    add(0);
  }
  return hash;
}

} // namespace

LeftBehind left_behind(memory::Change const &change) {
  LeftBehind left = {change.size, change.first, change.end, 0, change.region, {}};
  left.now = std::hash<std::string_view>()({change.object + change.first, change.end - change.first});
  left.name[change.name.copy(left.name, sizeof left.name - 1)] = 0;
  return left;
}

bool replay_begin(std::string_view kernel, Memory const &memory) {
  char const *address = wire::requested(wire::Entry::replay), *wanted = wire::requested(wire::Entry::replay_kernel);
  Connection connection;
  if (shared || !address || !wanted || kernel != wanted || !parse(address, connection)) return false;
  Head *head = map(connection.file);
  if (!head) std::abort();
  memory.prepare();
  serve(connection, head, memory);
  shared = head;
  return true;
}

void replay_input(double *number) {
  if (shared) give(number, shared_inputs(shared, shared->calls_done), inputs_met, shared->input_count);
}

void replay_parameter(double *number) {
  if (shared) give(number, shared_parameters(shared, shared->calls_done), parameters_met, shared->parameter_count);
}

void replay_output(double value) {
  if (!shared) return;
  if (outputs_met == shared->output_count) finish(State::wrong_shape);
  shared_outputs(shared, shared->calls_done)[outputs_met++] = value;
}

void replay_leave() {
  if (shared && shared->state == State::inside) shared->state = State::left;
}

int replay_compute(double const *inputs, double const *parameters, double *outputs) {
  return shared ? loaded->compute(*shared, inputs, parameters, outputs) : -1;
}

void replay_left(std::vector<memory::Change> const &changes) {
  if (shared) tell_left(*shared, changes);
}

bool replay_watches_world() { return shared && shared->watches_world != 0 && shared->calls_done == 0; }

bool replay_changes_formats() { return shared && shared->keeps_formats == 0; }

void replay_effect(Outside kind, std::string_view what) {
  if (!shared || shared->effect_count == std::size(shared->effects)) return;
  OutsideEffect &effect = shared->effects[shared->effect_count++];
  effect.kind = kind;
  effect.what[what.copy(effect.what, sizeof effect.what - 1)] = 0;
}

bool replay_examines() { return shared && shared->examines != 0; }

bool replay_is_fed() {
  return shared && inputs_met == shared->input_count && parameters_met == shared->parameter_count;
}

Ran replay_in_fork(unsigned seconds) {
  shared->state = State::begun;
  shared->calls_done = 0;
  pid_t const child = fork();
  if (child == 0) {
    shared->examines = 0;
    alarm(seconds);
    return Ran::here;
  }
  int status = -1;
  if (child > 0) waitpid(child, &status, 0);
  return status == 0 && shared->state == State::complete ? Ran::well : Ran::badly;
}

std::vector<double> replay_outputs() {
  double const *outputs = shared_outputs(shared);
  return {outputs, outputs + shared->output_count};
}

void replay_unnamed(UnnamedObject const &object) {
  if (shared->unnamed_count < std::size(shared->unnamed)) shared->unnamed[shared->unnamed_count++] = object;
}

void replay_unexamined(std::string_view why) {
  shared->unexamined[why.copy(shared->unexamined, sizeof shared->unexamined - 1)] = 0;
}

void replay_examined() { finish(State::complete); }

void replay_returned(char const *object, std::string_view others) {
  if (shared && shared->calls_done == 0) shared->returned = hash_of_others(object, others);
}

void replay_link(int output) {
  if (shared && links_met < shared->input_count) shared_links(shared)[links_met++] = output;
}

static bool is_complete() {
  return inputs_met == shared->input_count && parameters_met == shared->parameter_count &&
         outputs_met == shared->output_count;
}

bool replay_again() {
  if (!shared || shared->calls_done + 1 >= shared->calls_wanted || !is_complete()) return false;
  ++shared->calls_done;
  shared->state = State::complete; // if the next call fails, this one has not
  inputs_met = parameters_met = outputs_met = 0;
  return true;
}

void replay_end() {
  if (!shared) return;
  bool const is_another = shared->calls_done != 0 && inputs_met == 0;
  if (!is_another && is_complete()) ++shared->calls_done;
  finish(is_another || is_complete() ? State::complete : State::wrong_shape);
}

} // namespace symreal::replay
