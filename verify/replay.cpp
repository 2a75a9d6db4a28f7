#include "verify/replay.h"

#include "engine/graph/graph_binary.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace symreal::program {

using wire::Entry;

static constexpr unsigned seconds_to_answer = 5; // beyond the time limit of a sample

// Server process with its pipes and the shared file.
struct Replay::Server {
  replay::Head *head = nullptr;
  std::size_t size = 0;
  std::uint32_t seconds = 0;       // default time limit of a sample
  int commands = -1, answers = -1; // this process's ends of the pipes
  int stop = -1;                   // closed, it ends the program
  bool is_waiting = false;         // the program answers, and waits for a command
  std::jthread process;
  Outcome outcome{Ending::exited}; // valid once the process has ended

  ~Server() {
    if (commands >= 0) close(commands);  // ends the server
    if (!is_waiting && stop >= 0) end(); // the program may run for ever
    if (process.joinable()) process.join();
    if (stop >= 0) end();
    if (answers >= 0) close(answers);
    if (head) munmap(head, size);
  }

  void share(std::string const &file, Graph const &graph, double time_limit, GeneratedCode const *code,
             std::uint32_t most_calls) {
    replay::Head shape{};
    shape.most_calls = most_calls;
    if (code) {
      shape.constant_count = static_cast<std::uint32_t>(code->banner().constants);
      shape.guard_count = static_cast<std::uint32_t>(code->banner().guards);
      shape.code_input_count = static_cast<std::uint32_t>(code->banner().inputs);
      shape.code_output_count = static_cast<std::uint32_t>(code->banner().outputs);
      for (External const &external : graph.externals) {
        shape.most_arguments = std::max(shape.most_arguments, static_cast<std::uint32_t>(external.argument_count()));
        shape.most_results = std::max(shape.most_results, static_cast<std::uint32_t>(external.result_count()));
      }
    }
    shape.keeps_formats = std::ranges::any_of(
        graph.frozen, [](Frozen const &one) { return one.name.starts_with("std::c") && one.name.ends_with("()"); });
    shape.input_count = static_cast<std::uint32_t>(graph.input_count());
    shape.parameter_count = static_cast<std::uint32_t>(graph.parameter_count());
    shape.output_count = static_cast<std::uint32_t>(graph.output_count());
    shape.seconds = seconds = static_cast<std::uint32_t>(std::ceil(time_limit));
    size = replay::shared_size(shape);
    int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    bool made = descriptor >= 0 && ftruncate(descriptor, static_cast<off_t>(size)) == 0;
    void *memory = made ? mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0) : MAP_FAILED;
    if (descriptor >= 0) close(descriptor);
    if (memory == MAP_FAILED)
      fail(DiagnosticId::no_workspace, {file}, "the file cannot be made: " + std::string(std::strerror(errno)));
    head = new (memory) replay::Head(shape);
  }

  void end() { close(std::exchange(stop, -1)); }

  void start(Command command, std::string const &file, std::string const &begun_as) {
    std::array<int, 2> to, from, stops;
    if (pipe2(to.data(), O_CLOEXEC) != 0 || pipe2(from.data(), O_CLOEXEC) != 0 || pipe2(stops.data(), O_CLOEXEC) != 0)
      fail(DiagnosticId::no_workspace, {}, "no pipe can be made: " + std::string(std::strerror(errno)));
    commands = to[1];
    answers = from[0];
    stop = stops[1];
    command.stop = stops[0];
    command.request.set(Entry::replay, fmt::format("{},{},{}", file, to[0], from[1]));
    command.request.set(Entry::replay_kernel, begun_as);
    command.inherited = {to[0], from[1]};
    process = std::jthread([this, command, to, from, stops] {
      outcome = program::run(command, [](std::string_view) {});
      close(to[0]);
      close(from[1]);
      close(stops[0]);
    });
  }
};

Replay::Replay(std::string what, std::string const &executable, RunOptions const &options, std::string const &begun_as,
               Graph const &graph, Workspace const &workspace, GeneratedCode const *code, std::string const &profile,
               wire::Request request)
    : what_(std::move(what)),
      server_(std::make_unique<Server>()) {
  std::signal(SIGPIPE, SIG_IGN); // the program may end at any moment
  if (!graph.inputs.empty()) place_ = graph.inputs.front().place;
  static std::atomic<unsigned> started = 0;
  std::string file = workspace.file("samples-" + std::to_string(++started));
  server_->share(file, graph, options.time_limit, code, profile.empty() ? 1 + most_later : 1);
  Command command{.arguments = {executable},
                  .directory = options.directory,
                  .request = std::move(request),
                  .standard_input = options.standard_input,
                  .inherited = {}};
  command.arguments.insert(command.arguments.end(), options.arguments.begin(), options.arguments.end());
  if (code) {
    std::string const recorded = workspace.file("replayed.graph");
    write_binary_graph(recorded, graph);
    command.request.set(Entry::replay_code, code->object());
    command.request.set(Entry::replay_prefix, code->prefix());
    command.request.set(Entry::replay_graph, recorded);
  }
  if (!profile.empty()) command.environment.push_back("LLVM_PROFILE_FILE=" + profile);
  server_->start(command, file, begun_as);
}

Replay::~Replay() = default;

void Replay::send(void const *bytes, std::size_t size) {
  if (write(server_->commands, bytes, size) != static_cast<ssize_t>(size))
    fail(DiagnosticId::replay_failed, place_, what_ + " did not reach its kernel again");
}

void Replay::end_calls() {
  if (!is_calling_) return;
  is_calling_ = false;
  send(&replay::no_function, sizeof replay::no_function);
  wait_for_answer();
}

void Replay::call(std::size_t function, std::span<double const> arguments, std::span<double> results) {
  require_reached();
  replay::Head *head = server_->head;
  if (constexpr auto command = replay::Command::functions; !is_calling_) send(&command, sizeof command);
  is_calling_ = true;
  internal_check(arguments.size() <= head->most_arguments && results.size() <= head->most_results);
  std::ranges::copy(arguments, replay::shared_arguments(head));
  auto const number = static_cast<std::uint32_t>(function);
  send(&number, sizeof number);
  wait_for_answer();
  std::copy_n(replay::shared_results(head), results.size(), results.begin());
}

void Replay::ask(replay::Command command, Sample const &sample, std::span<Sample const> later, unsigned seconds) {
  require_reached();
  end_calls();
  Server &server = *server_;
  replay::Head *head = server.head;
  head->calls_wanted = static_cast<std::uint32_t>(1 + later.size());
  internal_check(head->calls_wanted <= head->most_calls);
  head->seconds = seconds != 0 ? seconds : server.seconds;
  for (std::size_t call = 0; call <= later.size(); ++call) {
    Sample const &one = call == 0 ? sample : later[call - 1];
    auto const own = std::span<double const>(one.inputs).first(head->input_count); // seeds may follow
    std::ranges::copy(own, replay::shared_inputs(head, call));
    std::ranges::copy(one.parameters, replay::shared_parameters(head, call));
  }

  send(&command, sizeof command);
  wait_for_answer();
  head->examines = 0;
  if (head->state == replay::State::inside)
    fail(DiagnosticId::replay_failed, place_, "on a sample " + what_ + " ended within its kernel");
  if (head->state != replay::State::complete)
    fail(DiagnosticId::replay_failed, place_,
         "on a sample " + what_ + " reached other annotations than in the recorded run");
}

std::optional<int> Replay::answer(unsigned seconds) {
  Server &server = *server_;
  server.is_waiting = false;
  pollfd answer = {server.answers, POLLIN, 0};
  int status = 0;
  if (poll(&answer, 1, static_cast<int>(seconds) * 1000) != 1) return std::nullopt;
  server.is_waiting = read(server.answers, &status, sizeof status) == sizeof status;
  return server.is_waiting ? std::optional<int>(status) : std::nullopt;
}

std::optional<Outcome> Replay::miss(unsigned seconds) {
  if (is_reached_ || (is_reached_ = answer(seconds).has_value())) return std::nullopt;
  // The pipe of an ended program is closed at its other end.
  pollfd closed = {server_->answers, POLLIN, 0};
  if (poll(&closed, 1, 0) != 1) return Outcome{Ending::timed_out, 0, static_cast<double>(seconds)};
  if (server_->process.joinable()) server_->process.join();
  return server_->outcome;
}

void Replay::require_reached() {
  if (miss(server_->seconds + seconds_to_answer))
    fail(DiagnosticId::replay_failed, place_, what_ + " did not reach its kernel again");
}

// Waits for the answer. The server limits a sample's time.
void Replay::wait_for_answer() {
  std::optional<int> const answered = answer(server_->head->seconds + seconds_to_answer);
  if (!answered) fail(DiagnosticId::replay_failed, place_, what_ + " did not reach its kernel again");
  int const status = *answered;
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    fail(DiagnosticId::replay_failed, place_, what_ + "'s kernel does not end on a sample within the time limit");
  if (WIFSIGNALED(status))
    fail(DiagnosticId::replay_failed, place_,
         fmt::format("signal {} ({}) ended {}'s kernel on a sample", WTERMSIG(status), strsignal(WTERMSIG(status)),
                     what_));
}

replay::State Replay::state() const { return server_->head->state; }

std::size_t Replay::calls() const { return server_->head->calls_done; }

std::vector<std::uint64_t> Replay::stack() const {
  std::vector<std::uint64_t> stack(std::begin(server_->head->stack), std::end(server_->head->stack));
  std::erase(stack, 0);
  return stack;
}

std::vector<double> Replay::outputs_of(std::size_t call) const {
  replay::Head *head = server_->head;
  double const *outputs = replay::shared_outputs(head, call);
  return {outputs, outputs + head->output_count};
}

std::vector<double> Replay::next_inputs(Sample const &sample, std::span<double const> outputs) const {
  std::vector<double> inputs = sample.inputs;
  double const *links = replay::shared_links(server_->head);
  for (std::size_t k = 0; k < inputs.size(); ++k)
    if (links[k] >= 0) inputs[k] = outputs[static_cast<std::size_t>(links[k])];
  return inputs;
}

std::vector<double> Replay::run(Sample const &sample, std::span<Sample const> later, unsigned seconds) {
  server_->head->watches_world = watched_ < most_watched;
  ++watched_;
  ask(replay::Command::original, sample, later, seconds);
  has_run_ = true;
  return outputs_of(0);
}

std::vector<replay::LeftBehind> Replay::left_behind() const {
  return {server_->head->left, server_->head->left + server_->head->left_count};
}

std::vector<replay::OutsideEffect> Replay::effects() const {
  return {server_->head->effects, server_->head->effects + server_->head->effect_count};
}

std::vector<replay::UnnamedObject> Replay::examine(Sample const &sample) {
  server_->head->watches_world = 0;
  server_->head->examines = 1;
  ask(replay::Command::original, sample, {}, replay::most_seconds_examined);
  return {server_->head->unnamed, server_->head->unnamed + server_->head->unnamed_count};
}

std::string Replay::unexamined() const { return server_->head->unexamined; }

std::uint64_t Replay::returned() const { return server_->head->returned; }

GeneratedCode::Result Replay::run_generated(Sample const &sample, std::span<double const> inputs) {
  replay::Head *head = server_->head;
  internal_check(inputs.size() == head->code_input_count);
  double *const outputs = replay::shared_code_outputs(head);
  std::fill_n(outputs, head->code_output_count, std::bit_cast<double>(GeneratedCode::untouched));
  std::ranges::copy(inputs, replay::shared_code_inputs(head));
  ask(replay::Command::generated, sample);
  return {head->failed, {outputs, outputs + head->code_output_count}};
}

Evaluation Replay::run_graph(Sample const &sample) {
  ask(replay::Command::graph, sample);
  return {outputs_of(0), server_->head->premises, server_->head->failing_guard};
}

} // namespace symreal::program
