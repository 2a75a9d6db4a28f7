#include "tool/report/console.h"

#include "engine/support/number.h"
#include "engine/support/progress.h"
#include "program/build/interruption.h"

#include <cstdlib>
#include <fmt/format.h>
#include <iostream>
#include <unistd.h>

namespace symreal::tool {

namespace {

// Interval between progress lines: $SYMREAL_PROGRESS, in seconds.
std::chrono::duration<double> interval(bool is_terminal) {
  constexpr double on_terminal = 1, elsewhere = 10;
  char const *const asked = std::getenv("SYMREAL_PROGRESS");
  std::optional<double> const given = asked ? parse_number(asked) : std::nullopt;
  double const seconds = given.value_or(is_terminal ? on_terminal : elsewhere);
  return std::chrono::duration<double>(seconds > 0 && seconds < 1e6 ? seconds : 0);
}

} // namespace

Console::Console() : is_terminal_(isatty(STDERR_FILENO) == 1), interval_(interval(is_terminal_)) {
  if (interval_.count() == 0) return;
  program::Uninterrupted const signals_go_to_others;
  watcher_ = std::thread([this] { watch(); });
}

Console::~Console() {
  clear();
  if (!watcher_.joinable()) return;
  {
    std::scoped_lock const lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_one();
  watcher_.join();
}

void Console::watch() {
  std::unique_lock lock(mutex_);
  while (!is_over_) {
    if (stage_.empty())
      changed_.wait(lock);
    else if (changed_.wait_until(lock, next_) == std::cv_status::timeout && !stage_.empty() && Clock::now() >= next_)
      show();
  }
}

void Console::show() {
  auto const seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
  std::string const counted = Progress::now();
  std::string const line =
      fmt::format("symreal: {}{}{}, {:.0f} s", stage_, counted.empty() ? "" : ": ", counted, seconds);
  wipe();
  std::cerr << line << (is_terminal_ ? " ..." : "\n") << std::flush;
  line_shown_ = is_terminal_;
  next_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(interval_);
}

program::Talk Console::talk() {
  return {[this](std::string_view name) { stage(name); }, [this](Diagnostic const &diagnostic) { report(diagnostic); },
          [this](std::string_view line) { print_line(fmt::format("program| {}", line)); },
          [this](std::string const &text) { note(text); }};
}

void Console::stage(std::string_view name) {
  {
    std::scoped_lock const lock(mutex_);
    stage_ = name;
    begun_ = Clock::now();
    next_ = begun_ + std::chrono::duration_cast<Clock::duration>(interval_);
    if (is_terminal_) {
      wipe();
      std::cerr << "symreal: " << name << " ..." << std::flush;
      line_shown_ = true;
    }
  }
  changed_.notify_one();
}

void Console::report(Diagnostic const &diagnostic) {
  std::scoped_lock const lock(mutex_);
  wipe();
  print(std::cerr, diagnostic);
}

void Console::note(std::string const &text) { print_line("symreal: " + text); }

void Console::print_line(std::string const &line) {
  std::scoped_lock const lock(mutex_);
  wipe();
  std::cerr << line << "\n";
}

void Console::clear() {
  std::scoped_lock const lock(mutex_);
  wipe();
  stage_.clear();
}

void Console::wipe() {
  if (line_shown_) std::cerr << "\r\033[K" << std::flush;
  line_shown_ = false;
}

} // namespace symreal::tool
