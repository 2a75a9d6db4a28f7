// A generated file in C or C++, compiled and loaded, so that it can be called.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "engine/graph/graph.h"
#include "engine/ops/floating_point.h"
#include "program/build/workspace.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace symreal::program {

// What the first line of a generated file says of it.
struct Banner {
  std::string kernel, prefix, version;
  FloatingPoint mode = FloatingPoint::finite;
  std::size_t inputs = 0, parameters = 0, constants = 0, outputs = 0, guards = 0;
  std::string decisions = "error";              // the policy under which the kernel was recorded
  bool from_instructions = false;               // of the original, as in Graph
  bool is_single = false;                       // its numbers are float
  unsigned threads = 1;                         // that share an evaluation
  unsigned vector = 1;                          // numbers that are computed side by side, where the processor can
  std::vector<DerivativeWish> derivatives = {}; // that were added, as in Graph
  bool has_values = true;                       // and not the derivatives alone
  std::string mathematics = {};                 // the original's library when it was generated; may be unknown
};
// Does the file begin as a generated one?
bool is_generated(std::string const &path);
// Is a generated file, by its name, C++ and not C?
bool is_generated_cpp(std::string const &path);
// Throws foreign_file for a file that this version of the tool did not generate.
Banner read_banner(std::string const &path);

// How the manual says that a generated file is compiled.
inline constexpr std::array documented_flags = {"-O2", "-ffp-contract=off", "-fno-tree-slp-vectorize",
                                                "-fno-builtin-pow"};

// By what it is compiled, and to which file of the workspace.
struct CodeBuild {
  std::string compiler = "cc", cxx_compiler = "c++";
  std::span<char const *const> flags = documented_flags;
  char const *object = "generated.so";
  bool alone = false; // one thread, whatever the banner says
};

class GeneratedCode {
public:
  // Throws compiler_missing and generated_code_broken.
  // `graph`: what the code was generated from. Code with external functions cannot be run here, where these are not;
  // the replay program runs it (object).
  GeneratedCode(std::string const &path, Banner const &banner, Graph const &graph, CodeBuild const &build,
                Workspace const &workspace);
  ~GeneratedCode();
  GeneratedCode(GeneratedCode const &) = delete;
  GeneratedCode &operator=(GeneratedCode const &) = delete;

  struct Result {
    int failed;                  // 0, or the number of a guard
    std::vector<double> outputs; // what the code does not set is `untouched`
  };
  static constexpr std::uint64_t untouched = 0x7ff4'dead'beef'dead; // the bits of a NaN that no computation yields
  Banner const &banner() const { return banner_; }
  bool needs_program() const { return needs_program_; }
  std::string const &object() const { return object_; }
  std::string const &prefix() const { return prefix_; } // of the names in the object
  // Code in single precision is given, and gives, the numbers rounded to it.
  Result run(std::span<double const> inputs, std::span<double const> parameters);

  // How long a call of `compute` takes, on average of so many in a row.
  double nanoseconds(std::span<double const> inputs, std::span<double const> parameters, std::size_t calls);

  // What the file says of guard `number`.
  std::string guard_text(std::size_t number) const;

private:
  void compile(std::string const &path, Graph const &graph, CodeBuild const &build, Workspace const &workspace);
  void load(std::string const &path);

  template <class Real> struct Numbers;
  template <class Real> int compute(Numbers<Real> &numbers) const;
  template <class Real> Result run_in(std::span<double const> inputs, std::span<double const> parameters);
  template <class Real>
  double time_of(std::span<double const> inputs, std::span<double const> parameters, std::size_t calls);

  using GuardText = char const *(*)(int);

  Banner banner_;
  std::string object_, prefix_;
  bool needs_program_;
  void *library_ = nullptr;
  void *preprocess_ = nullptr, *compute_ = nullptr; // of double or float, with guards and without
  GuardText guard_text_ = nullptr;
};

} // namespace symreal::program
