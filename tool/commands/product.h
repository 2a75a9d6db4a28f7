// Product of `generate`: the files of a kernel, and the report on it.
#pragma once

#include "program/record/front.h"
#include "tool/bundle/bundle.h"
#include "tool/commands/optimise.h"
#include "tool/commands/planned_code.h"

#include <optional>
#include <string>
#include <vector>

namespace symreal::tool {

// Files and report of one kernel.
struct Product {
  Optimised optimised = {};
  std::vector<OutputFile> files = {};
  Bundle bundle = {};
  std::vector<Diagnostic> warnings = {};
  std::vector<std::string> remarks = {};      // in words: threads that share it, sines at the start, loops, vectors
  std::optional<OperationCounts> looped = {}; // operations of compute inside and outside loops
  std::optional<program::Exploration> exploration = {};
  double seconds = 0;

  void tell_of(PlannedCode const &code);
};

// All files of a product, bundles first.
std::vector<OutputFile const *> all_files(Product const &product);

// Are these files on disk with the same content? Writes nothing.
bool check_products(std::vector<Product> const &products);

// All files of the products, with the directories to create.
Outputs outputs_of(std::vector<Product> const &products, std::vector<std::string> const &directories);

// Prints the table, or JSON on standard output.
void show_products(std::vector<Product> const &products, program::Front const &front, bool details, bool as_json);

} // namespace symreal::tool
