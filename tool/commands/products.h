// What `generate` gives of each kernel, as it is written and as it is told.
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
  std::string sharing = {};                   // what threads that share an evaluation give, in words
  std::string loops = {};                     // how much of it loops hold, in words
  std::optional<OperationCounts> looped = {}; // what compute does in loops and between them
  std::string lanes = {};                     // how much of it vectors hold, in words
  std::string angles = {};                    // whose sines and cosines it begins with, in words
  std::optional<program::Exploration> exploration = {};
  double seconds = 0;
};

// Does the disk hold these files? Writes nothing.
bool check_products(std::vector<Product> const &products);

// All files, below directories that are made where there are none.
Outputs outputs_of(std::vector<Product> const &products, std::vector<std::string> const &directories);
// Of the file that a rule of make names the product by.
std::string first_path(Product const &product);

// The table, and as JSON on standard output.
void show_products(std::vector<Product> const &products, program::Front const &front, bool details, bool as_json);

} // namespace symreal::tool
