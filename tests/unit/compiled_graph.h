// Emitted C, compiled with every warning an error and loaded.
#pragma once

#include "emit/emit.h"
#include "program/workspace.h"

#include <dlfcn.h>
#include <fstream>
#include <gtest/gtest.h>

namespace symreal {

class Compiled {
public:
  Compiled(Graph const &graph, std::string const &compiler) : guarded_(!graph.guards.empty()) {
    for (EmittedFile const &file : emit_c(graph, {.base_name = "k", .mainline = true}))
      std::ofstream(workspace_.file(file.name)) << file.text;
    std::string flags = " -std=c99 -O1 -ffp-contract=off -fno-builtin -Wall -Wextra -Wconversion -pedantic -Werror ";
    // clang computes what it takes to be harmless before it is known to be needed, unless told that flags matter.
    if (compiler.starts_with("clang")) flags += "-ffp-exception-behavior=maytrap ";
    std::string const path = workspace_.path();
    EXPECT_EQ(std::system((compiler + flags + "-fPIC -shared " + path + "/k.c -o " + path + "/k.so -lm").c_str()), 0);
    EXPECT_EQ(std::system((compiler + flags + "-fsyntax-only " + path + "/k_main.c").c_str()), 0);
    library_ = dlopen((path + "/k.so").c_str(), RTLD_NOW | RTLD_LOCAL);
    EXPECT_NE(library_, nullptr) << dlerror();
  }
  ~Compiled() {
    if (library_) dlclose(library_);
  }
  std::vector<double> run(std::vector<double> const &input, std::size_t outputs) const {
    std::vector<double> output(outputs);
    run(input, output);
    return output;
  }
  // The guard that does not hold, or 0.
  int run(std::vector<double> const &input, std::vector<double> &output) const {
    if (guarded_) {
      auto compute = reinterpret_cast<int (*)(double const *, double const *, double *)>(dlsym(library_, "compute"));
      return compute(input.data(), nullptr, output.data());
    }
    auto compute = reinterpret_cast<void (*)(double const *, double const *, double *)>(dlsym(library_, "compute"));
    compute(input.data(), nullptr, output.data());
    return 0;
  }

private:
  program::Workspace workspace_{false};
  void *library_ = nullptr;
  bool guarded_;
};

} // namespace symreal
