// Emitted C, C++ or Rust, compiled with every warning an error and loaded.
#pragma once

#include "engine/emit/emit.h"

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace symreal {

class Compiled {
public:
  // `graph`: of a kernel "k". `compiler`: of C; in C++ the one of its family. In Rust it is rustc.
  Compiled(Graph const &graph, std::string compiler, std::string const &language = "c")
      : guarded_(!graph.guards.empty()),
        is_cpp_(language == "cpp") {
    std::string path = (std::filesystem::temp_directory_path() / "symreal-XXXXXX").string();
    EXPECT_NE(mkdtemp(path.data()), nullptr);
    directory_ = path;
    for (EmittedFile const &file :
         emit(schedule(graph), *find_language(language), {.base_name = "k", .extras = {"mainline"}}))
      std::ofstream(directory_ / file.name) << file.text;
    if (language == "rust")
      build_rust(graph, path);
    else
      build(path, compiler);
    library_ = dlopen((path + "/k.so").c_str(), RTLD_NOW | RTLD_LOCAL);
    EXPECT_NE(library_, nullptr) << dlerror();
  }
  ~Compiled() {
    if (library_) dlclose(library_);
    std::error_code ignored;
    std::filesystem::remove_all(directory_, ignored);
  }
  static bool has_rust() { return std::system("rustc --version > /dev/null 2>&1") == 0; }

  std::vector<double> run(std::vector<double> const &input, std::size_t outputs) const {
    std::vector<double> output(outputs);
    run(input, output);
    return output;
  }
  // The guard that does not hold, or 0.
  int run(std::vector<double> const &input, std::vector<double> &output) const {
    return run(input.data(), output.data());
  }
  int run(double const *input, double *output) const {
    char const *const name = is_cpp_ ? "_ZN1k7computeEPKdS1_Pd" : "compute"; // k::compute
    if (guarded_) {
      auto compute = reinterpret_cast<int (*)(double const *, double const *, double *)>(dlsym(library_, name));
      return compute(input, nullptr, output);
    }
    auto compute = reinterpret_cast<void (*)(double const *, double const *, double *)>(dlsym(library_, name));
    compute(input, nullptr, output);
    return 0;
  }

private:
  void build(std::string const &path, std::string compiler) {
    std::string flags = is_cpp_ ? " -std=c++17" : " -std=c99 -pedantic";
    flags += " -O1 -ffp-contract=off -fno-builtin -Wall -Wextra -Wconversion -Werror ";
    // clang computes what it takes to be harmless before it is known to be needed, unless told that flags matter.
    if (compiler.starts_with("clang")) flags += "-ffp-exception-behavior=maytrap ";
    if (is_cpp_) compiler = compiler == "gcc" ? "g++" : "clang++-19";
    std::string const end = is_cpp_ ? ".cpp" : ".c";
    std::string const build = compiler + flags + "-fPIC -shared " + path + "/k" + end + " -o " + path + "/k.so -lm";
    EXPECT_EQ(std::system(build.c_str()), 0);
    EXPECT_EQ(std::system((compiler + flags + "-fsyntax-only " + path + "/k_main" + end).c_str()), 0);
  }
  // With a function that has C's interface around it.
  void build_rust(Graph const &graph, std::string const &path) {
    std::ofstream(directory_ / "k_shared.rs")
        << "#[path = \"k.rs\"]\nmod k;\n#[no_mangle]\n"
           "pub unsafe extern \"C\" fn compute(input: *const f64, _: *const f64, output: *mut f64)"
        << (guarded_ ? " -> i32" : "") << " {\n    k::compute(std::slice::from_raw_parts(input, " << graph.input_count()
        << "), &[], std::slice::from_raw_parts_mut(output, " << graph.output_count() << "))\n}\n";
    std::string const rustc = "rustc --edition 2021 -D warnings -C opt-level=1 ";
    EXPECT_EQ(std::system((rustc + "--crate-type cdylib " + path + "/k_shared.rs -o " + path + "/k.so").c_str()), 0);
    EXPECT_EQ(std::system((rustc + "--emit metadata " + path + "/k_main.rs -o " + path + "/k_main.rmeta").c_str()), 0);
  }

  std::filesystem::path directory_;
  void *library_ = nullptr;
  bool guarded_, is_cpp_;
};

} // namespace symreal
