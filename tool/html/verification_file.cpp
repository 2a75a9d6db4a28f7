#include "engine/support/files.h"
#include "tool/html/report_data.h"

namespace symreal::tool {

using Json = nlohmann::ordered_json;

static bool has_number(Json const &json, char const *key) { return json.contains(key) && json[key].is_number(); }

// Does the JSON have the members that the page reads?
static bool is_verification(Json const &json) {
  if (!json.is_object() || !json.contains("kernel") || !json["kernel"].is_string() || !has_number(json, "samples") ||
      !has_number(json, "inside") || !json.contains("outputs") || !json["outputs"].is_array())
    return false;
  for (Json const &output : json["outputs"])
    if (!output.is_object() || !output.contains("label") || !has_number(output, "worst_ulp") ||
        !has_number(output, "different"))
      return false;
  for (Json const &guard : json.value("guards", Json::array()))
    if (!guard.is_object() || !has_number(guard, "failed")) return false;
  return true;
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
