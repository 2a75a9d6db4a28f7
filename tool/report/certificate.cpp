#include "tool/report/certificate.h"

#include "engine/emit/language/banner.h"
#include "engine/graph/graph_text.h"
#include "engine/support/files.h"
#include "engine/support/installation.h"
#include "engine/support/math_library.h"
#include "program/build/durable_files.h"

#include <filesystem>
#include <fmt/format.h>
#include <set>
#include <sstream>

namespace symreal::tool {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int form = 1; // version of the certificate format

fs::path directory_of(std::string const &path) { return fs::weakly_canonical(fs::absolute(path)).parent_path(); }

// Path relative to the directory; absolute if they share only the root.
std::string seen_from(fs::path const &directory, fs::path const &file) {
  auto const first = [](fs::path const &path) {
    return path.relative_path().empty() ? path : *path.relative_path().begin();
  };
  return (first(directory) == first(file) ? file.lexically_relative(directory) : file).string();
}

// File names relative to the directory where the certificate was made, which it stores relative to itself: so it is
// valid from any directory and moves with its project.
class Names {
public:
  Names(fs::path const &directory, Verified const &verified)
      : directory_(fs::weakly_canonical(fs::absolute(directory))),
        shown_(verified.generated.begin(), verified.generated.end()) {
    for (rewrite::File const &file : verified.front->rewritten.files) shown_.insert(file.display_path);
  }

  std::string of(std::string const &file) const {
    return seen_from(directory_, fs::weakly_canonical(fs::absolute(file)));
  }
  void move(Place &place) const {
    if (!place.file.empty() && fs::exists(place.file)) place.file = of(place.file);
  }
  // Converts every string that is a file name or a place in a file.
  void move(Json &json) const {
    if (json.is_structured())
      for (auto &one : json) move(one);
    if (!json.is_string()) return;
    std::string const text = json.get<std::string>(), name = text.substr(0, text.find(':'));
    if (shown_.contains(name)) json = of(name) + text.substr(name.size());
  }

private:
  fs::path directory_;
  std::set<std::string> shown_; // file names in messages
};

// Flags with directories and headers named like all files.
Json named_flags(std::vector<std::string> flags, Names const &names) {
  std::string_view before;
  for (std::string &flag : flags) {
    std::string_view option = before;
    for (std::string_view one : {"-I", "-isystem", "-iquote", "-idirafter", "-include", "-imacros"})
      if (before.empty() && flag.starts_with(one)) option = one;
    bool const is_in_word = before.empty() && !option.empty();
    std::string const value = is_in_word ? flag.substr(option.size()) : flag;
    before = is_in_word && value.empty() ? option : std::string_view();
    if (!option.empty() && !value.empty() && fs::exists(value))
      flag = (is_in_word ? std::string(option) : "") + names.of(value);
  }
  return flags;
}

// Hash of a generated file without the mathematical library that it names, which is compared separately.
std::string generated_hash(std::string const &path) {
  return program::content_hash(without_reference(read_file(path)));
}

std::string text_hash(Graph graph, Names const &names) {
  for (auto *objects : {&graph.inputs, &graph.parameters, &graph.outputs})
    for (Object &one : *objects) names.move(one.place);
  for (Location &one : graph.locations)
    for (Place &place : one.places) names.move(place);
  for (Frozen &one : graph.frozen) names.move(one.place);
  for (DerivativeWish &one : graph.wishes) names.move(one.place);
  std::ostringstream text;
  write_graph(text, graph);
  return program::content_hash(text.str());
}

std::string digest_of(Json json) {
  json.erase("digest");
  return program::content_hash(json.dump());
}

// The reproducible part of a run: without times.
Json repeatable(Json json) {
  for (Json &record : json["verified"])
    if (record.contains("parallel")) record["parallel"].erase("nanoseconds");
  return json;
}

void compare_hashes(Json const &one, Json const &other, std::string_view what, std::vector<std::string> &found) {
  for (auto const &[name, hash] : one.items())
    if (!other.contains(name))
      found.push_back(fmt::format("{} '{}' is not there now", what, name));
    else if (other[name] != hash)
      found.push_back(fmt::format("{} '{}' is another one now", what, name));
  for (auto const &[name, hash] : other.items())
    if (!one.contains(name)) found.push_back(fmt::format("{} '{}' is new", what, name));
}

// Companions of a generated file: files with the same banner, or wrappers by their name.
std::vector<std::string> written_beside(std::string const &generated) {
  std::vector<std::string> files;
  std::string const stem = fs::path(generated).stem().string();
  fs::path const directory = fs::path(generated).parent_path();
  Json const own = Json::parse(banner_of(read_file(generated)), nullptr, /*allow_exceptions=*/false);
  std::error_code error;
  for (fs::directory_iterator one(directory.empty() ? "." : directory, error), end; !error && one != end;
       one.increment(error)) {
    std::string const name = one->path().filename().string();
    std::string const path = (directory / name).string();
    if (!name.starts_with(stem) || name.size() <= stem.size() || !one->is_regular_file(error)) continue;
    std::string const rest = name.substr(stem.size());
    if ((rest[0] != '.' && rest[0] != '_') || fs::path(path) == fs::path(generated)) continue;
    std::string const text = text_of_file(path).value_or("");
    Json const other = Json::parse(banner_of(text), nullptr, /*allow_exceptions=*/false);
    bool const is_wrapper = rest == "_wrapper.c" || rest == "_wrapper.cpp";
    bool const is_same = other.is_object() && own.is_object() && other.value("kernel", "") == own.value("kernel", "") &&
                         other.value("prefix", "") == own.value("prefix", "");
    if (is_wrapper || is_same) files.push_back(path);
  }
  return files;
}

// Path of the first member that differs.
std::string first_difference(Json const &one, Json const &other, std::string const &path) {
  if (one == other) return {};
  if (one.is_object() && other.is_object())
    for (auto const &[name, value] : one.items())
      if (std::string found = first_difference(value, other.value(name, Json()), path + "/" + name); !found.empty())
        return found;
  if (one.is_array() && other.is_array() && one.size() == other.size())
    for (std::size_t k = 0; k < one.size(); ++k)
      if (std::string found = first_difference(one[k], other[k], path + "/" + std::to_string(k)); !found.empty())
        return found;
  return fmt::format("{}: {} in the certificate, {} now", path, one.dump(), other.dump());
}

} // namespace

Json certificate(Verified const &verified, std::vector<VerificationRecord> const &records, std::string const &from) {
  Names const names(from, verified);
  Json json = {{"symreal_certificate", form},
               {"version", version},
               {"flags", named_flags(verified.flags, names)},
               {"mathematics", math_library()}};
  for (char const *hashed : {"sources", "generated", "beside", "graphs"}) json[hashed] = Json::object();
  for (rewrite::File const &file : verified.front->rewritten.files)
    json["sources"][names.of(file.path)] = program::content_hash(file.original);
  std::set<std::string> beside;
  for (std::string const &file : verified.generated) {
    json["generated"][names.of(file)] = generated_hash(file);
    for (std::string const &other : written_beside(file)) beside.insert(other);
  }
  for (std::string const &file : beside)
    if (!json["generated"].contains(names.of(file))) json["beside"][names.of(file)] = generated_hash(file);
  for (program::Recorded const &recorded : verified.front->kernels)
    json["graphs"][recorded.graph.kernel] = text_hash(recorded.graph, names);
  json["verified"] = Json::array();
  for (VerificationRecord const &record : records) {
    json["verified"].push_back(to_json(record));
    json["verified"].back().erase("mathematics"); // stored above
  }
  names.move(json["verified"]);
  return json;
}

Json read_certificate(std::string const &path) {
  Json json = Json::parse(read_file(path), nullptr, /*allow_exceptions=*/false);
  if (!json.is_object() || json.value("symreal_certificate", 0) != form || !json.contains("digest"))
    fail(DiagnosticId::verification_file, {path}, "this file is not a certificate that verify --certificate wrote");
  if (json["digest"] != digest_of(json))
    fail(DiagnosticId::certificate_refused, {path}, "the certificate was changed after it was written");
  if (json.value("version", "") != version)
    fail(DiagnosticId::certificate_refused, {path},
         fmt::format("the certificate was written by version {}, and this is version {}", json.value("version", ""),
                     version));
  return json;
}

void finish_certificate(Json &json, std::string const &path) {
  json["from"] = seen_from(directory_of(path), fs::canonical(fs::current_path()));
  json["digest"] = digest_of(json);
}

std::string made_from(Json const &certificate, std::string const &path) {
  if (!certificate.contains("from")) return fs::current_path().string();
  return (directory_of(path) / certificate["from"].get<std::string>()).string();
}

program::VerificationOptions options_of(Json const &certificate, std::string const &path) {
  try {
    Json const &record = certificate.at("verified").at(0);
    program::VerificationOptions options;
    options.samples = record.at("drawn");
    options.min_samples = record.at("min_samples");
    options.seed = record.at("seed");
    options.tolerance = record.at("tolerance");
    options.branches = record.contains("branches");
    if (record.contains("errors")) options.exact_bits = record["errors"].at("bits");
    return options;
  } catch (Json::exception const &) {
    fail(DiagnosticId::verification_file, {path}, "this file is not a certificate that verify --certificate wrote");
  }
}

std::vector<std::string> differences(Json const &certificate, Json const &run) {
  std::vector<std::string> found;
  compare_hashes(certificate["sources"], run["sources"], "source", found);
  compare_hashes(certificate["generated"], run["generated"], "generated file", found);
  // Ignores companions that were generated later.
  Json beside = Json::object();
  Json const certified = certificate.value("beside", Json::object()); // absent in older certificates
  for (auto const &[name, hash] : certified.items())
    if (run["beside"].contains(name)) beside[name] = run["beside"][name];
  compare_hashes(certified, beside, "generated file", found);
  compare_hashes(certificate["graphs"], run["graphs"], "the recorded graph of kernel", found);
  if (certificate["flags"] != run["flags"]) found.push_back("the sources have other compiler flags");
  Json const one = repeatable(certificate)["verified"], other = repeatable(run)["verified"];
  if (std::string const figure = first_difference(one, other, "figure "); !figure.empty()) found.push_back(figure);
  return found;
}

std::string other_mathematics(std::string const &made, std::string const &before, std::string const &now) {
  if (before.empty() || before == now) return {};
  return fmt::format("{} with {}; these functions are those of {}", made, before, now);
}

} // namespace symreal::tool
