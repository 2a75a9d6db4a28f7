#include "tool/commands/product.h"

#include <fmt/ostream.h>
#include <iostream>
#include <nlohmann/json.hpp>

namespace symreal::tool {

void Product::tell_of(PlannedCode const &code) {
  remarks.insert(remarks.end(), {code.angles, code.loops, code.lanes});
  looped = code.looped;
  warnings.insert(warnings.end(), code.remarks.begin(), code.remarks.end());
}

std::vector<OutputFile const *> all_files(Product const &product) {
  std::vector<OutputFile const *> all;
  for (auto const *list : {&product.bundle.package.files, &product.bundle.units, &product.files})
    for (OutputFile const &file : *list) all.push_back(&file);
  return all;
}

bool check_products(std::vector<Product> const &products) {
  std::vector<OutputFile const *> files;
  for (Product const &product : products)
    for (OutputFile const *file : all_files(product)) files.push_back(file);
  return check_files(files);
}

Outputs outputs_of(std::vector<Product> const &products, std::vector<std::string> const &directories) {
  Outputs outputs;
  for (std::string const &directory : directories)
    if (!directory.empty()) outputs.directories.push_back(directory);
  for (Product const &product : products) {
    product.bundle.add_to(outputs);
    outputs.files.insert(outputs.files.end(), product.files.begin(), product.files.end());
  }
  return outputs;
}

void show_products(std::vector<Product> const &products, program::Front const &front, bool details, bool as_json) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (Product const &product : products) {
    KernelReport report{product.optimised.recorded, &product.optimised.graph, product.optimised.stages, {}, {}};
    for (OutputFile const *file : all_files(product)) report.files.push_back(file->path);
    report.seconds = {{"rewrite", front.rewrite_seconds},
                      {"build", front.build_seconds},
                      {"run", front.run_seconds},
                      {"optimise and emit", product.seconds}};
    report.exploration = product.exploration ? &*product.exploration : nullptr;
    report.looped = product.looped;
    print_table(std::cerr, report, details);
    for (std::string const &remark : product.remarks)
      if (!remark.empty()) fmt::print(std::cerr, "  {}\n", remark);
    if (as_json) json.push_back(to_json(report));
  }
  program::ObjectCache const &cache = *front.build.cache;
  if (details)
    fmt::print(std::cerr,
               "sources: {} read, {} as an earlier run read them\n"
               "objects: {} compiled, {} as an earlier run compiled them\n",
               front.rewritten.sources_read, front.rewritten.sources_kept, cache.compiled(), cache.reused());
  if (as_json)
    std::cout << nlohmann::ordered_json{{"kernels", json},
                                        {"sources",
                                         {{"read", front.rewritten.sources_read},
                                          {"reused", front.rewritten.sources_kept}}},
                                        {"objects", {{"compiled", cache.compiled()}, {"reused", cache.reused()}}}}
                     .dump(2)
              << "\n";
}

} // namespace symreal::tool
