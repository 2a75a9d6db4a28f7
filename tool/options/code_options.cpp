#include "tool/options/code_options.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/graph/names.h"
#include "engine/optimise/passes/pass.h"
#include "tool/options/option_table.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace symreal::tool {

void EmitterOptions::add_to(CLI::App &app) {
  app.add_option("--prefix", prefix, "Prefix of every external name of the generated code: P gives P_compute")
      ->each([](std::string const &given) {
        if (!given.empty() && identifier(given) != given)
          fail(DiagnosticId::bad_option, {}, "--prefix takes a name of C and C++, not '" + given + "'");
      });
  app.add_option("--real", real, "Number type of the generated code: double, or float for single precision")
      ->capture_default_str();
  app.add_option("--sines", sines,
                 "Compute sines and cosines of inputs 'side-by-side' in a loop (default) or each by the 'library' (C "
                 "and C++, mode fast)")
      ->type_name("WORD");
  auto const add_extra = [&](std::string const &name, std::string const &doc) {
    app.add_flag_callback("--" + name, [this, name] { extras.insert(name); }, doc);
  };
  add_extra("mainline", "Also emit a program that runs the generated code");
  add_extra("mex", "Also emit a MEX gateway to the C code, for MATLAB and Octave");
  add_extra("simulink", "Also emit an S-function that calls the C code, for Simulink");
  app.add_option("--map", map_file, "Also write a map from generated lines to source lines, as JSON")
      ->type_name("FILE");
  app.add_option(
         "--debug", debug,
         "Emit aids: comments with the source lines of each statement; values: report the first NaN or infinity "
         "of a call with its source line")
      ->type_name("AIDS")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"comments", "values"}));
}

bool EmitterOptions::is_single() const {
  require_one_of("--real", real, "double|float");
  return real == "float";
}

bool EmitterOptions::has_angles(FloatingPoint mode) const {
  if (!sines.empty()) require_one_of("--sines", sines, "side-by-side|library");
  bool const can = mode == FloatingPoint::fast && !is_single();
  if (sines == "side-by-side" && !can)
    fail(DiagnosticId::bad_option, {},
         is_single() ? "--sines=side-by-side computes with doubles: leave --real=float or this out"
                     : "--sines=side-by-side does not give the bits of the library, which only --fp=fast permits");
  return can && sines != "library";
}

void LanguageOption::add_to(CLI::App &app, std::string const &usual, std::string others) {
  text = usual;
  others_ = std::move(others);
  std::string names;
  for (LanguageRow const &language : symreal::languages())
    names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", language.name, language.doc);
  app.add_option("--lang", text,
                 "Output languages, separated by commas: " + names + (others_.empty() ? "" : "; or " + others_))
      ->capture_default_str();
}

bool LanguageOption::is_other() const { return ("|" + others_ + "|").find("|" + text + "|") != std::string::npos; }

std::vector<Language const *> LanguageOption::languages() const {
  std::vector<Language const *> found;
  std::string words = others_;
  for (LanguageRow const &language : symreal::languages()) words.append(words.empty() ? "" : "|").append(language.name);
  if (is_other()) return found;
  for (std::string_view rest = text;;) {
    std::size_t const end = std::min(rest.find(','), rest.size());
    std::string const name(rest.substr(0, end));
    require_one_of("--lang", name, words);
    found.push_back(find_language(name));
    if (end == rest.size()) return found;
    rest.remove_prefix(end + 1);
  }
}

std::vector<Language const *> all_languages() {
  std::vector<Language const *> all;
  for (LanguageRow const &language : symreal::languages()) all.push_back(find_language(language.name));
  return all;
}

void require_one_language(std::vector<Language const *> const &languages, EmitterOptions const &options) {
  if (languages.size() > 1 && !options.map_file.empty())
    fail(DiagnosticId::bad_option, {}, "--map is the map of one file: ask for one language with --lang");
}

void require_source_name(std::string const &path, std::vector<Language const *> const &languages) {
  std::string const extension = std::filesystem::path(path).extension();
  std::vector<std::string_view> known;
  for (Language const *language : languages) known.push_back(language->files.extension);
  if (std::ranges::find(known, extension) == known.end())
    fail(DiagnosticId::bad_option, {},
         fmt::format("the result is a file whose name ends in {}, not '{}'", fmt::join(known, " or "), path));
  if (std::filesystem::path(path).filename().string().find_first_of("\"\n\\") != std::string::npos)
    fail(DiagnosticId::bad_option, {}, "an #include cannot name the header beside '" + path + "'");
}

void RerollOption::add_to(CLI::App &app) {
  app.add_flag("--reroll", is_given, "Emit repeated operations as loops over tables (C or C++)");
}

std::optional<Rerolled> RerollOption::loops(Plan const &plan, std::optional<Rerolled> const &found,
                                            PassOptions const &passes, std::vector<Diagnostic> &remarks,
                                            std::string &text) const {
  if (!is_given) return {};
  auto const improve = [&](Graph graph, bool in_loop) {
    PassSettings settings = passes.settings();
    std::vector<std::string> names = passes.names();
    if (in_loop)
      std::erase(names, "latency"); // iterations run side by side: recurrences.h
    else
      settings.effort = std::min(settings.effort, 1); // code that runs once
    return run_passes(std::move(graph), names, settings);
  };
  Rerolled loops = found ? improved(*found, plan.angles, improve) : rerolled(plan, passes.settings().mode);
  if (!loops.has_loops()) {
    remarks.push_back(
        {DiagnosticId::not_rerolled, {}, "kernel '" + plan.graph->kernel + "' is not re-rolled: " + loops.why_not});
    return {};
  }
  text = describe(loops);
  return loops;
}

void VectorOption::add_to(CLI::App &app) {
  app.add_option("--vector", width, "Emit C or C++ with vector operations of 2, 4 or 8 lanes")
      ->type_name("N")
      ->check(CLI::IsMember({2U, 4U, 8U}));
}

std::optional<Laned> VectorOption::lanes(Plan const &plan, std::vector<Diagnostic> &remarks, std::string &text) const {
  if (!is_given()) return {};
  Laned lanes = laned(plan, width);
  if (!lanes.compute) {
    remarks.push_back(
        {DiagnosticId::no_vectors, {}, "kernel '" + plan.graph->kernel + "' has no vectors: " + lanes.why_not});
    return {};
  }
  text = describe(*lanes.compute);
  return lanes;
}

} // namespace symreal::tool
