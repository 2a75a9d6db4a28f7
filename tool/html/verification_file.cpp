#include "support/files.h"
#include "tool/html/report_data.h"

namespace symreal::tool {

using Json = nlohmann::ordered_json;

// What the page reads of it.
static bool is_verification(Json const &json) {
  return json.is_object() && json.contains("kernel") && json["kernel"].is_string() && json.contains("samples") &&
         json["samples"].is_number() && json.contains("inside") && json["inside"].is_number() &&
         json.contains("outputs") && json["outputs"].is_array();
}

Json read_verification(std::string const &file, std::string const &kernel) {
  Json const read = Json::parse(read_file(file), nullptr, /*allow_exceptions=*/false);
  Json const all = read.is_object() && read.contains("kernels") ? read["kernels"] : Json::array({read});
  for (Json const &one : all) {
    if (!is_verification(one))
      fail(DiagnosticId::verification_file, {file}, "this file is not what verify --json prints");
    if (one["kernel"] == kernel) return one;
  }
  fail(DiagnosticId::verification_file, {file}, "this file has no verification of kernel '" + kernel + "'");
}

} // namespace symreal::tool
