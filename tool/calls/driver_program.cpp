#include "tool/calls/driver_program.h"

#include "engine/support/files.h"
#include "engine/support/text.h"
#include "tool/calls/call_binding.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <utility>

namespace symreal::tool {
namespace {

namespace fs = std::filesystem;
using rewrite::Callable;

constexpr char const *other_main = "symreal_main_of_the_program";

// A function and its call.
struct Call {
  Callable function;
  CallBinding binding;
};

std::string last_name(std::string const &qualified) {
  std::size_t const colon = qualified.rfind(':');
  return colon == qualified.npos ? qualified : qualified.substr(colon + 1);
}

// Does the call name this function? For a method a.b::c, the function's scopes end in `b`.
bool names(CallSpec const &spec, Callable const &function) {
  std::string wanted = spec.function.text;
  if (wanted.starts_with("::")) wanted = wanted.substr(2);
  if (!spec.object) return function.qualified == wanted || function.with_inline == wanted;
  return function.has_this && (function.qualified == wanted || function.qualified.ends_with("::" + wanted) ||
                               function.with_inline.ends_with("::" + wanted));
}

// Does the object expression construct the function's class by name?
bool is_of_class(std::string const &object, Callable const &function) {
  std::string const named = object.substr(0, object.find_first_of("({<"));
  return function.object == named || function.object.ends_with("::" + named) ||
         function.object.starts_with(named + "<");
}

std::string squeezed(std::string text) {
  std::erase(text, ' ');
  return text;
}

std::vector<Note> list(std::vector<Callable> const &functions) {
  std::vector<Note> notes;
  for (Callable const &one : functions) notes.push_back({one.place, one.key});
  return notes;
}

// The template instance that the call denotes.
std::vector<Callable> instances(CallSpec const &spec, rewrite::Request const &request) {
  std::string const &name = spec.function.text;
  std::string const whole = name + spec.template_arguments;
  bool const is_instance = whole.find('<') != whole.npos && name.find("operator") == name.npos;
  bool const is_of_instance = spec.object && spec.object->find('<') != std::string::npos;
  if (!is_instance && !is_of_instance) return {};
  std::string const scope = spec.object ? "symreal_plain<decltype(" + *spec.object + ")>::type::" : "::";
  return rewrite::find_instance(request, last_name(name),
                                "&" + scope + (name.starts_with("::") ? whole.substr(2) : whole));
}

Call choose(CallSpec const &spec, rewrite::Request const &request) {
  std::string const &name = spec.function.text;
  std::vector<Callable> const found = rewrite::find_callables(request, last_name(name));
  std::vector<Callable> candidates;
  if (spec.template_arguments.empty())
    std::copy_if(found.begin(), found.end(), std::back_inserter(candidates),
                 [&](Callable const &one) { return names(spec, one); });
  if (candidates.empty()) candidates = instances(spec, request);
  if (candidates.empty() && !spec.called_object.empty() && !spec.object) {
    CallSpec called = spec;
    called.object = spec.called_object;
    called.types = called.called_object = called.template_arguments = "";
    called.function.text = "operator()";
    std::vector<Callable> const operators = rewrite::find_callables(request, called.function.text);
    bool const is_class = std::any_of(operators.begin(), operators.end(),
                                      [&](Callable const &one) { return is_of_class(*called.object, one); }) ||
                          !instances(called, request).empty();
    if (is_class) return choose(called, request);
  }
  if (spec.object && std::any_of(candidates.begin(), candidates.end(),
                                 [&](Callable const &one) { return is_of_class(*spec.object, one); }))
    std::erase_if(candidates, [&](Callable const &one) { return !is_of_class(*spec.object, one); });
  if (candidates.empty())
    fail(DiagnosticId::configured_function, spec.function.place,
         "no source defines a function '" + name + spec.template_arguments + "'" +
             (spec.template_arguments.empty() ? "" : ", with all arguments of one template") +
             (found.empty() ? "" : "; there are:"),
         list(found));
  if (!spec.types.empty()) {
    std::vector<Callable> const all = candidates;
    std::erase_if(candidates, [&](Callable const &one) {
      return squeezed(one.key) != squeezed(one.qualified + spec.types) &&
             squeezed(one.declared_types) != squeezed(spec.types);
    });
    if (candidates.empty())
      fail(DiagnosticId::configured_function, spec.function.place,
           "no function '" + name + "' has parameters of the types " + spec.types + "; there are:", list(all));
  }
  std::vector<Call> fitting;
  std::vector<Diagnostic> problems;
  for (Callable const &one : candidates) {
    CallBinding binding = bind_call(spec, one);
    if (binding.problems.empty())
      fitting.push_back({one, std::move(binding)});
    else
      problems = std::move(binding.problems);
  }
  // Prefers the functions that leave the fewest names unknown: an argument of one may be a variable to another.
  std::size_t fewest = ~std::size_t{0};
  for (Call const &one : fitting) fewest = std::min(fewest, one.binding.unknown.size());
  std::erase_if(fitting, [&](Call const &one) { return one.binding.unknown.size() > fewest; });
  if (fitting.size() == 1) return std::move(fitting.front());
  if (fitting.empty() && candidates.size() == 1) throw DiagnosticError(problems.front());
  std::vector<Callable> shown;
  for (Call const &one : fitting) shown.push_back(one.function);
  fail(DiagnosticId::call_specification, spec.function.place,
       fmt::format("{} functions '{}' {}: write the types of its parameters, {}",
                   fitting.empty() ? candidates.size() : fitting.size(), name,
                   fitting.empty() ? "do not take these arguments" : "take these arguments",
                   "as in f(double const *, int)(ARGUMENTS)"),
       list(fitting.empty() ? candidates : shown));
}

// Driver of one source, whose place in the program it takes.
class Driver {
public:
  Driver(rewrite::Compilation const &source, bool is_c) : is_c_(is_c) {
    fs::path const path(source.source);
    path_ = (path.parent_path() / (path.stem().string() + ".symreal-driver" + path.extension().string())).string();
    line(fmt::format("#define main {}", other_main));
    line(fmt::format("#include \"{}\"", path.filename().string()));
    line("#undef main");
    text_ += binding_helpers(is_c);
  }

  void add(Call const &call, std::size_t number) {
    std::string const name = fmt::format("symreal_call_{}", number);
    line(is_c_ ? "void " + name + "(void);" : "extern \"C\" void " + name + "();");
    if (!call.binding.before.empty()) line(call.binding.before);
    line("void " + name + (is_c_ ? "(void) {" : "() {"));
    for (CallBinding::Statement const &one : call.binding.statements) {
      line("  " + one.text);
      places_[count()] = one.place;
    }
    line("}");
  }

  void add_main(std::size_t calls) {
    std::string text = is_c_ ? "int main(void) {" : "int main() {";
    for (std::size_t k = 0; k < calls; ++k) {
      line(fmt::format("{}void symreal_call_{}({});", is_c_ ? "" : "extern \"C\" ", k, is_c_ ? "void" : ""));
      text += fmt::format(" symreal_call_{}();", k);
    }
    line(text + " return 0; }");
  }

  std::string const &path() const { return path_; }
  std::string const &text() const { return text_; }
  // Place of the words that a line derives from.
  Place place_of(unsigned line) const {
    auto const at = places_.find(line);
    return at == places_.end() ? Place() : at->second;
  }

private:
  void line(std::string const &text) { text_ += text + "\n"; }
  unsigned count() const { return static_cast<unsigned>(std::count(text_.begin(), text_.end(), '\n')); }

  bool is_c_;
  std::string path_, text_;
  std::map<unsigned, Place> places_;
};

// Renames main in other sources.
void rename_main(rewrite::Compilation &source) {
  std::string const path = rewrite::real_source(source);
  if (fs::exists(path) && read_file(path).find("main") != std::string::npos)
    source.flags.push_back(std::string("-Dmain=") + other_main);
}

class Program {
public:
  Program(program::FrontRequest &request, std::vector<rewrite::ConfiguredText> const &calls, Console &console) {
    rewrite::Request &source = request.source;
    std::vector<rewrite::Compilation> compilations = rewrite::compilations_of(source);
    std::map<std::size_t, std::vector<Call>> by_source;
    for (rewrite::ConfiguredText const &text : calls) {
      CallSpec const spec = parse_call_spec(text);
      Call call = choose(spec, source);
      report_unvalued(call, spec, console);
      request.called.push_back(call.function.name);
      source.kernels.push_back(call.binding.kernel);
      by_source[call.function.source].push_back(std::move(call));
    }
    std::size_t number = 0;
    for (std::size_t i = 0; i < compilations.size(); ++i)
      if (auto const found = by_source.find(i); found != by_source.end()) {
        Driver driver(compilations[i], found->second.front().function.is_c);
        for (Call const &call : found->second) driver.add(call, number++);
        if (number == calls.size()) driver.add_main(number);
        compilations[i].source = driver.path();
        fs::path const at =
            compilations[i].directory.empty() ? fs::current_path() : fs::path(compilations[i].directory);
        source.texts.push_back({(at / driver.path()).lexically_normal().string(), driver.text()});
        drivers_.push_back(std::move(driver));
      } else
        rename_main(compilations[i]);
    source.compilations = std::move(compilations);
    source.sources.clear();
    for (rewrite::Compilation const &one : source.compilations) source.sources.push_back(one.source);
  }

  // Moves a diagnostic on a driver line to the words that the line derives from.
  Diagnostic located(Diagnostic diagnostic) const {
    if (Driver const *driver = driver_of(diagnostic.place))
      if (Place const place = driver->place_of(diagnostic.place.line); !place.file.empty()) {
        diagnostic.place = place;
        if (diagnostic.id == DiagnosticId::source_error) diagnostic.id = DiagnosticId::call_specification;
      }
    std::vector<Note> notes;
    for (Note note : diagnostic.notes) {
      if (Driver const *driver = driver_of(note.place)) {
        note.place = driver->place_of(note.place.line);
        if (note.place.file.empty()) continue; // a line of the driver itself
        if (note.message.starts_with("called from ")) note.message = "called from the driver program";
      }
      notes.push_back(std::move(note));
    }
    bool const is_here = driver_of(diagnostic.place) && !notes.empty();
    if (is_here) { // the error is in a declaration that the words use
      diagnostic.place = notes.front().place;
      diagnostic.id = DiagnosticId::call_specification;
      notes.erase(notes.begin());
    }
    diagnostic.notes = std::move(notes);
    return diagnostic;
  }

private:
  static void report_unvalued(Call const &call, CallSpec const &spec, Console &console) {
    if (call.binding.unvalued.empty()) return;
    console.report({DiagnosticId::chosen_value, spec.function.place,
                    fmt::format("no values are given for {}: '{}' is recorded at numbers between 0 and 1",
                                fmt::join(call.binding.unvalued, ", "), call.function.name)});
  }

  Driver const *driver_of(Place const &place) const {
    for (Driver const &driver : drivers_)
      if (!place.file.empty() && fs::path(place.file).filename() == fs::path(driver.path()).filename()) return &driver;
    return nullptr;
  }

  std::vector<Driver> drivers_;
};

// The calls of the kernels with these names; all calls if there are none.
std::vector<rewrite::ConfiguredText> calls_of(std::vector<rewrite::ConfiguredText> const &calls,
                                              std::string const &kernels) {
  std::vector<std::string> const chosen = items_of(kernels);
  std::vector<rewrite::ConfiguredText> wanted;
  for (rewrite::ConfiguredText const &one : calls)
    if (kernels.empty() || std::ranges::find(chosen, last_name(parse_call_spec(one).function.text)) != chosen.end())
      wanted.push_back(one);
  return wanted;
}

} // namespace

void with_driver(program::FrontRequest request, std::vector<rewrite::ConfiguredText> const &calls, program::Talk talk,
                 Console &console, Stages const &stages) {
  std::vector<rewrite::ConfiguredText> wanted = calls_of(calls, is_call_spec(request.kernel) ? "" : request.kernel);
  if (is_call_spec(request.kernel)) wanted = {{std::exchange(request.kernel, ""), {"--kernel", 1, 1}}};
  if (wanted.empty()) return stages(request, talk);
  console.stage("reading");
  Program const driver(request, wanted, console);
  talk.report = [&, report = talk.report](Diagnostic const &one) { report(driver.located(one)); };
  try {
    stages(request, talk);
  } catch (DiagnosticError const &problem) {
    throw DiagnosticError(driver.located(problem.diagnostic()));
  }
}

} // namespace symreal::tool
