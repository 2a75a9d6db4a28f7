#include "tool/package/package.h"

#include "engine/emit/emit.h"
#include "engine/emit/print/module.h"
#include "engine/emit/print/source.h"
#include "engine/graph/names.h"
#include "tool/package/externals.h"
#include "tool/package/module_text.h"
#include "tool/package/project_patterns.h"

#include <filesystem>

namespace symreal::tool {

namespace {

namespace fs = std::filesystem;

std::string batch_text(Schedule const &plan, EmitOptions const &options) {
  Emission const emission{plan, *find_language("c"), options};
  Filling fill = module_facts(emission);
  fill.set("call", fill(plan.graph->guards.empty() ? batch_call : batch_checked_call));
  return banner(emission) + fill(batch_pattern);
}

std::string filled(Emission const &emission, std::string_view pattern) {
  return banner(emission) + module_facts(emission)(pattern);
}

} // namespace

std::vector<OutputFile> package_files(Schedule const &plan, EmitterOptions const &emitter, FloatingPoint mode,
                                      std::string const &folder) {
  Graph const &graph = *plan.graph;
  require_no_externals(graph);
  Language const python = package_language();
  std::string const name = identifier(emitter.prefix.empty() ? graph.kernel : emitter.prefix, python.names);
  EmitOptions const options{.base_name = name,
                            .prefix = emitter.prefix,
                            .mode = mode,
                            .trace_comments = emitter.trace_comments,
                            .check_values = emitter.check_values,
                            .reference = emitter.reference};
  Emission const emission{plan, python, options};
  std::vector<OutputFile> files;
  auto const add = [&](fs::path const &path, std::string text) {
    files.push_back({(fs::path(folder) / path).string(), std::move(text)});
  };
  add("pyproject.toml", filled(emission, pyproject_pattern));
  add("setup.py", filled(emission, setup_pattern));
  add("MANIFEST.in", std::string(manifest_pattern));
  add("README.md", module_facts(emission)(readme_pattern));
  for (EmittedFile const &file : symreal::emit(plan, *find_language("c"), options)) add("c/" + file.name, file.text);
  add("c/" + name + "_batch.c", batch_text(plan, options));
  fs::path const module = fs::path("src") / name;
  add(module / "__init__.py", module_text(plan, options));
  add(module / "__init__.pyi", stub_text(plan, options));
  add(module / "py.typed", "");
  add("tests/test_" + name + ".py", test_text(plan, options));
  return files;
}

} // namespace symreal::tool
