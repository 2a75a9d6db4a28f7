// Products of `generate`, one for each kernel, and their output.
#pragma once

#include "program/record/front.h"
#include "tool/commands/bundle.h"
#include "tool/commands/optimise.h"

#include <optional>
#include <string>
#include <vector>

namespace symreal::tool {

struct Product {
  Optimised optimised = {};
  std::vector<OutputFile> files = {};
  Bundle bundle = {};
  std::vector<Diagnostic> warnings = {};
  std::string sharing = {};                   // gain of threads that share an evaluation, in words
  std::string loops = {};                     // share of the code in loops, in words
  std::optional<OperationCounts> looped = {}; // operations of compute inside and outside loops
  std::string lanes = {};                     // share of the code in vectors, in words
  std::string angles = {};                    // angles whose sines and cosines are computed first, in words
  std::optional<program::Exploration> exploration = {};
  double seconds = 0;
};

// Are these files on disk with the same content? Writes nothing.
bool check_products(std::vector<Product> const &products);

// All files of the products, with the directories to create.
Outputs outputs_of(std::vector<Product> const &products, std::vector<std::string> const &directories);
// Path of the file that names the product in a make rule.
std::string first_path(Product const &product);

// Prints the table, or JSON on standard output.
void show_products(std::vector<Product> const &products, program::Front const &front, bool details, bool as_json);

} // namespace symreal::tool
