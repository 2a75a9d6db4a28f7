#include "tool/html/data.h"

namespace symreal::tool {

Json source_data(Sources const &sources) {
  Json files = Json::array();
  for (SourceFile const &file : sources.files()) {
    Json functions = Json::array();
    for (FunctionLines const &function : file.functions)
      functions.push_back({function.name, function.first, function.last});
    files.push_back({{"name", file.name}, {"text", nullptr}, {"functions", std::move(functions)}});
    if (file.text) files.back()["text"] = *file.text;
  }
  return files;
}

} // namespace symreal::tool
