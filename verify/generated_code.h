// Loader of generated C and C++ files: compiles a file and calls its functions.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "engine/graph/graph.h"
#include "engine/ops/floating_point.h"
#include "program/build/object_cache.h"
#include "program/build/workspace.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace symreal::program {

// Banner of a generated file: the contents of its first line.
struct Banner {
  std::string kernel, prefix, version;
  FloatingPoint mode = FloatingPoint::finite;
  std::size_t inputs = 0, parameters = 0, constants = 0, outputs = 0, guards = 0;
  std::string decisions = "error";              // policy under which the kernel was recorded
  bool from_instructions = false;               // recorded from the original's instructions, as in Graph
  bool is_single = false;                       // its numbers are of type float
  unsigned threads = 1;                         // number of threads that share an evaluation
  unsigned vector = 1;                          // numbers per vector, 1 without --vector
  std::vector<DerivativeWish> derivatives = {}; // derivatives that were added, as in Graph
  bool has_values = true;                       // false: the file has the derivatives alone
  std::string mathematics = {};                 // the original's mathematical library at generation; empty if unknown
};
// Does the file begin with a banner?
bool is_generated(std::string const &path);
// Is a generated file, by its name, in C++ rather than C?
bool is_generated_cpp(std::string const &path);
// Reads the banner. Throws foreign_file for a file that this version of the tool did not generate.
Banner read_banner(std::string const &path);

// Flags under which the manual tells users to compile generated files.
inline constexpr std::array documented_flags = {"-O2", "-ffp-contract=off", "-fno-tree-slp-vectorize",
                                                "-fno-builtin-pow"};

// Compilers, flags and object file of a compilation.
struct CodeBuild {
  std::string compiler = "cc", cxx_compiler = "c++";
  std::span<char const *const> flags = documented_flags;
  char const *object = "generated.so";
  bool alone = false; // one thread, whatever the banner says
};

class GeneratedCode {
public:
  // Throws compiler_missing and generated_code_broken. `graph`: the graph that the code was generated from. Code that
  // calls external functions cannot run in this process, which lacks them; the replay program runs it (`object`).
  GeneratedCode(std::string const &path, Banner const &banner, Graph const &graph, CodeBuild const &build,
                ObjectCache &cache, Workspace const &workspace);
  ~GeneratedCode();
  GeneratedCode(GeneratedCode const &) = delete;
  GeneratedCode &operator=(GeneratedCode const &) = delete;

  struct Result {
    int failed;                  // 0, or the number of a guard
    std::vector<double> outputs; // `untouched` where the code sets none
  };
  static constexpr std::uint64_t untouched = 0x7ff4'dead'beef'dead; // bits of a NaN that no computation yields
  Banner const &banner() const { return banner_; }
  bool needs_program() const { return needs_program_; }
  std::string const &object() const { return object_; }
  std::string const &prefix() const { return prefix_; } // prefix of the names in the object
  // Calls the code. In single precision, inputs and outputs are rounded to float.
  Result run(std::span<double const> inputs, std::span<double const> parameters);

  // Mean time of a call of `compute` over `calls` calls in a row.
  double nanoseconds(std::span<double const> inputs, std::span<double const> parameters, std::size_t calls);

  // Text of guard `number` in the file.
  std::string guard_text(std::size_t number) const;

private:
  void compile(std::string const &path, Graph const &graph, CodeBuild const &build, ObjectCache &cache,
               Workspace const &workspace);
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
  void *preprocess_ = nullptr, *compute_ = nullptr; // functions on double or float, with or without guards
  GuardText guard_text_ = nullptr;
};

} // namespace symreal::program
