// Certificate of a verification: a JSON file with inputs and results, which others can check against their own run.
#pragma once

#include "tool/report/verification_record.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace symreal::tool {

// Inputs of a verification: the program's files within its roots, the generated files with their companions (headers,
// wrappers, gateways, other languages), and the graphs between, each by the SHA-256 of its text.
struct Verified {
  program::Front const *front;
  std::vector<std::string> flags, generated;
};

// Makes a certificate. `from`: directory that file names are relative to.
nlohmann::ordered_json certificate(Verified const &verified, std::vector<VerificationRecord> const &records,
                                   std::string const &from);

// Completes a certificate that was made here, for the file at `path`: adds the directory that names are relative to, as
// seen from the file, and last a hash of everything before, which detects edits.
void finish_certificate(nlohmann::ordered_json &certificate, std::string const &path);

// Directory that names in the certificate at `path` are relative to.
std::string made_from(nlohmann::ordered_json const &certificate, std::string const &path);

// Reads a certificate. Throws verification_file for a file of another version or kind, or one that was edited.
nlohmann::ordered_json read_certificate(std::string const &path);

// Options of the certified run. Throws verification_file.
program::VerificationOptions options_of(nlohmann::ordered_json const &certificate, std::string const &path);

// Differences between the run and the certificate, except times; empty if they agree.
std::vector<std::string> differences(nlohmann::ordered_json const &certificate, nlohmann::ordered_json const &run);

// A sentence if the mathematical library is another than `before` or chose other code, since figures then have another
// reference; else empty. `made`: "the certificate was written"; if empty, no library was known before.
std::string other_mathematics(std::string const &made, std::string const &before, std::string const &now);

} // namespace symreal::tool
