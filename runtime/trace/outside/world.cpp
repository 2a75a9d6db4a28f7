#include "runtime/trace/outside/world.h"

#include "runtime/memory/heap_blocks.h"
#include "runtime/trace/outside/system_calls.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ios>
#include <iostream>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

extern char **environ;

namespace symreal::trace {

namespace {

std::map<std::string, std::string> environment() {
  std::map<std::string, std::string> variables;
  for (char **each = environ; each && *each; ++each) {
    std::string_view const text = *each;
    std::size_t const equal = text.find('=');
    variables.try_emplace(std::string(text.substr(0, equal)), equal == text.npos ? "" : text.substr(equal));
  }
  return variables;
}

std::map<std::string, std::string> &environment_before() {
  static auto *variables = memory::make_own<std::map<std::string, std::string>>();
  return *variables;
}

void compare_environment(std::vector<Effect> &effects) {
  std::map<std::string, std::string> const now = environment(), &before = environment_before();
  auto const differs = [](auto const &one, auto const &all) {
    auto const found = all.find(one.first);
    return found == all.end() || found->second != one.second;
  };
  auto const add = [&](std::string const &name) {
    Effect effect{Effect::Kind::changes, "changes the environment variable '" + name + "'"};
    if (std::ranges::find(effects, effect) == effects.end()) effects.push_back(std::move(effect));
  };
  for (auto const &one : now)
    if (differs(one, before)) add(one.first);
  for (auto const &one : before)
    if (differs(one, now)) add(one.first);
}

// The formats of the standard streams of C++: state that the whole program has.
struct StreamFormat {
  std::ios_base::fmtflags flags = {};
  std::streamsize precision = 0, width = 0;
  char fill = 0;
  bool operator==(StreamFormat const &) const = default;
};
using StreamFormats = std::array<StreamFormat, 4>;

constexpr std::array<char const *, 4> names = {"std::cin", "std::cout", "std::cerr", "std::clog"};
std::array<std::ios *, 4> streams() {
  static std::ios_base::Init const initialised; // a kernel may run before other constructors
  return {&std::cin, &std::cout, &std::cerr, &std::clog};
}

StreamFormats read_formats() {
  StreamFormats formats;
  for (std::size_t k = 0; std::ios const *stream : streams())
    formats[k++] = {stream->flags(), stream->precision(), stream->width(), stream->fill()};
  return formats;
}

// The streams whose formats are others by now.
std::vector<std::string> changed_formats(StreamFormats const &before) {
  std::vector<std::string> changed;
  StreamFormats const now = read_formats();
  for (std::size_t k = 0; k < now.size(); ++k)
    if (now[k] != before[k]) changed.emplace_back(names[k]);
  return changed;
}

StreamFormats formats_before;

bool is_open = false; // between the two moments
std::vector<std::pair<Effect::Kind, char const *>> &library_effects() {
  static auto *effects = memory::make_own<std::vector<std::pair<Effect::Kind, char const *>>>();
  return *effects;
}

void note(Effect::Kind kind, char const *what) {
  if (!is_open || memory::OwnWork::is_going_on()) return;
  memory::OwnWork const own;
  if (std::pair const one(kind, what); std::ranges::find(library_effects(), one) == library_effects().end())
    library_effects().push_back(one);
}

} // namespace

void watch_world() {
  memory::OwnWork const own;
  std::fflush(nullptr);
  environment_before() = environment();
  formats_before = read_formats();
  library_effects().clear();
  is_open = true;
  watch_calls();
}

void note_effect(char const *what) { note(Effect::Kind::changes, what); }
void note_result(char const *function) { note(Effect::Kind::reads, function); }

std::vector<Effect> effects_on_world(bool discard) {
  discard_output(discard);
  std::fflush(nullptr);
  memory::OwnWork const own;
  std::vector<Effect> effects;
  end_calls(effects);
  is_open = false;
  for (auto const &[kind, what] : library_effects())
    if (Effect effect{kind, what}; std::ranges::find(effects, effect) == effects.end())
      effects.push_back(std::move(effect));
  compare_environment(effects);
  for (std::string const &stream : changed_formats(formats_before))
    effects.push_back({Effect::Kind::changes, "changes the format of '" + stream + "'"});
  return effects;
}

void change_formats() {
  for (std::ios *stream : streams()) {
    stream->setf(std::ios_base::showpos);
    stream->precision(stream->precision() + 3);
    stream->width(stream->width() + 7);
    stream->fill('#');
  }
}

} // namespace symreal::trace
