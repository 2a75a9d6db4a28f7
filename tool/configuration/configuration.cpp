#include "tool/configuration/configuration.h"

#include "tool/configuration/configured_pragmas.h"
#include "tool/configuration/unknown_words.h"

#include <filesystem>

namespace symreal::tool {
namespace {

namespace fs = std::filesystem;

// File name for messages: relative if the file is below the current directory.
std::string shown(fs::path const &file) {
  fs::path const near = file.lexically_proximate(fs::current_path());
  return near.begin() != near.end() && *near.begin() == ".." ? file.string() : near.string();
}

Configuration::Option read_option(Yaml::Entry const &entry) {
  Configuration::Option option{entry.key.text, {}, entry.key.place};
  for (Yaml const &value : entry.value.list()) option.values.push_back(value.text().text);
  return option;
}

// Is the option excluded from `options`, since it locates the configuration or has a key of its own?
bool has_own_key(std::string const &name) {
  return name == "config" || name == "root" || name == "type-name" || name == "help" || name == "numeric";
}

CLI::Option *find_option(CLI::App &command, std::string const &name) {
  if (name.empty() || name.front() == '-') return nullptr;
  return command.get_option_no_throw((name.size() == 1 ? "-" : "--") + name);
}

void refuse_unknown(Configuration::Option const &option, CLI::App &command) {
  if (has_own_key(option.name))
    fail(DiagnosticId::configuration, option.place, "'" + option.name + "' cannot be set under 'options'");
  for (CLI::App *one : command.get_parent()->get_subcommands([](CLI::App *) { return true; }))
    if (find_option(*one, option.name)) return;
  fail(DiagnosticId::configuration, option.place, "no subcommand has an option '" + option.name + "'");
}

void set(CLI::Option &known, Configuration::Option const &option, std::string const &directory) {
  bool const is_path = known.get_type_name() == "FILE" || known.get_type_name() == "DIR";
  for (std::string const &value : option.values)
    known.add_result(is_path ? (fs::path(directory) / value).string() : value);
  try {
    known.run_callback();
  } catch (CLI::Error const &problem) {
    fail(DiagnosticId::configuration, option.place, problem.what());
  }
}

} // namespace

std::string find_configuration(std::string const &directory) {
  std::error_code error;
  fs::path at = fs::weakly_canonical(directory.empty() ? "." : directory, error);
  while (!error) {
    fs::path const file = at / ".symreal.yaml";
    if (fs::is_regular_file(file, error)) return shown(file);
    error.clear();
    if (!at.has_relative_path()) break;
    at = at.parent_path();
  }
  return {};
}

Configuration read_configuration(std::string const &file) {
  Configuration result;
  std::error_code is_no_file; // a pipe has no canonical name
  fs::path const canonical = fs::weakly_canonical(file, is_no_file);
  result.directory = (is_no_file ? fs::absolute(file) : canonical).parent_path().string();
  auto const below = [&](std::string const &name) { return (fs::path(result.directory) / name).string(); };
  result.exclude.directory = result.directory;
  for (auto const &[key, value] : read_yaml(file).entries()) {
    if (key.text == "roots")
      for (Yaml const &one : value.list()) {
        result.roots.push_back(below(one.text().text));
        if (!fs::is_directory(result.roots.back())) one.fail("'" + one.text().text + "' is not a directory");
      }
    else if (key.text == "exclude")
      for (Yaml const &one : value.list()) result.exclude.patterns.push_back(one.text().text);
    else if (key.text == "type")
      result.type_name = value.text().text;
    else if (key.text == "options")
      for (Yaml::Entry const &one : value.entries()) result.options.push_back(read_option(one));
    else if (key.text == "kernels")
      for (Yaml const &one : value.list())
        if (one.is_map())
          result.kernels.push_back(read_kernel(one, result.directory));
        else
          result.calls.push_back(one.text());
    else if (key.text == "externals")
      for (Yaml const &one : value.list()) result.externals.push_back(read_external(one));
    else
      fail(DiagnosticId::configuration, key.place,
           "unknown key '" + key.text + "'; there are: roots, exclude, type, options, kernels, externals" +
               did_you_mean(key.text, "roots, exclude, type, options, kernels, externals"));
  }
  return result;
}

void set_options(Configuration const &configuration, CLI::App &command, ConfiguredOptions &given) {
  for (Configuration::Option const &option : configuration.options) {
    refuse_unknown(option, command);
    CLI::Option *known = find_option(command, option.name);
    if (!known || known->count() != 0) continue;
    set(*known, option, configuration.directory);
    given[known->get_name()] = option.place;
  }
}

Diagnostic located(Diagnostic diagnostic, ConfiguredOptions const &given) {
  if (!diagnostic.place.file.empty()) return diagnostic;
  std::string const name = diagnostic.message.substr(0, diagnostic.message.find_first_of(" :"));
  if (auto const found = given.find(name); found != given.end()) diagnostic.place = found->second;
  return diagnostic;
}

} // namespace symreal::tool
