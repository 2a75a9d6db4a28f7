// A certificate: what was verified, of which files, and what came out, in a JSON file that others can check against
// their own run.
#pragma once

#include "tool/report/verification_record.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace symreal::tool {

// What a verification is of: the files of the program within its roots, the generated files and those that were
// generated beside them (headers, wrappers, gateways, other languages), and the graphs between, each by the SHA-256 of
// its text.
struct Verified {
  program::Front const *front;
  std::vector<std::string> flags, generated;
};

// `from`: the directory from which it names files.
nlohmann::ordered_json certificate(Verified const &verified, std::vector<VerificationRecord> const &records,
                                   std::string const &from);

// Makes it whole for the file of this name, made here: it says where files are named from, as seen from the file, and
// its last member is the hash of all before it, so that a certificate that was edited is none.
void finish_certificate(nlohmann::ordered_json &certificate, std::string const &path);

// The directory from which the certificate that lies there names files.
std::string made_from(nlohmann::ordered_json const &certificate, std::string const &path);

// Throws verification_file for a file that is no certificate of this version of Symreal, or was edited.
nlohmann::ordered_json read_certificate(std::string const &path);

// The options under which it was made. Throws verification_file.
program::VerificationOptions options_of(nlohmann::ordered_json const &certificate, std::string const &path);

// What the run shows otherwise than the certificate says; empty if nothing. What depends on the clock is not compared.
std::vector<std::string> differences(nlohmann::ordered_json const &certificate, nlohmann::ordered_json const &run);

// A sentence if the mathematical library chose other code, or is another, than `before`; else empty. The figures
// are then those of another reference. `made`: "the certificate was written", before which nothing was known if empty.
std::string other_mathematics(std::string const &made, std::string const &before, std::string const &now);

} // namespace symreal::tool
