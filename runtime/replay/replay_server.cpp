#include "runtime/replay/replay_server.h"

#include "runtime/replay/branch_counters.h"
#include "runtime/replay/replay_code.h"
#include "runtime/replay/replay_protocol.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <iterator>
#include <string>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace symreal::replay {
namespace {

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

void tell_left(Head &head, std::vector<memory::Change> const &changes) {
  head.left_count = static_cast<std::uint32_t>(std::min(changes.size(), std::size(head.left)));
  for (std::size_t k = 0; k < head.left_count; ++k) head.left[k] = left_behind(changes[k]);
}

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
  for (Command command; read(connection.commands, &command, 1) == 1;) {
    head->state = State::begun;
    head->left_count = head->effect_count = head->unnamed_count = head->calls_done = 0;
    head->returned = 0;
    head->unexamined[0] = 0;
    pid_t child = fork();
    if (child == 0) {
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
    if (write(connection.answers, &status, sizeof status) != sizeof status) break;
  }
  branches.write();
  _exit(0);
}

[[noreturn]] void finish(State state) {
  shared->state = state;
  if (state == State::complete) counters->add();
  _exit(0);
}

void give(double *number, double const *values, std::uint32_t &met, std::uint32_t count) {
  if (met == count || !number) finish(State::wrong_shape);
  *number = values[met++];
}

} // namespace

LeftBehind left_behind(memory::Change const &change) {
  LeftBehind left = {change.size, change.first, change.end, 0, change.region, {}};
  left.now = std::hash<std::string_view>()({change.object + change.first, change.end - change.first});
  left.name[change.name.copy(left.name, sizeof left.name - 1)] = 0;
  return left;
}

bool replay_begin(std::string_view kernel, Memory const &memory) {
  char const *address = std::getenv("SYMREAL_REPLAY"), *wanted = std::getenv("SYMREAL_REPLAY_KERNEL");
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

void replay_returned(std::uint64_t hash) {
  if (shared && shared->calls_done == 0) shared->returned = hash;
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
