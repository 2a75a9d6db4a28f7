// A generated C file, compiled as its header comment asks and loaded, so that it can be called.
#pragma once

#include "diagnostics/diagnostic.h"
#include "passes/floating_point.h"
#include "program/workspace.h"

#include <span>
#include <string>
#include <vector>

namespace symreal::program {

// What the first line of a generated file says of it.
struct Banner {
  std::string kernel, prefix, version;
  FloatingPoint mode = FloatingPoint::finite;
  std::size_t inputs = 0, parameters = 0, constants = 0, outputs = 0;
};
// Throws foreign_file for a file that this version of the tool did not generate.
Banner read_banner(std::string const &path);

class GeneratedCode {
public:
  // Throws compiler_missing and generated_code_broken.
  GeneratedCode(std::string const &path, Banner const &banner, Workspace const &workspace);
  ~GeneratedCode();
  GeneratedCode(GeneratedCode const &) = delete;
  GeneratedCode &operator=(GeneratedCode const &) = delete;

  std::vector<double> run(std::span<double const> inputs, std::span<double const> parameters);

private:
  using Preprocess = void (*)(double const *, double *);
  using Compute = void (*)(double const *, double const *, double *);

  Banner banner_;
  void *library_ = nullptr;
  Preprocess preprocess_ = nullptr;
  Compute compute_ = nullptr;
};

} // namespace symreal::program
