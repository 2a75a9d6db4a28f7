// A verification as a record that outlives its run: JSON that `verify --json` prints, that another run reads back, and
// that records of other shards are joined with.
#pragma once

#include "verify/verification.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace symreal::tool {

struct VerificationRecord {
  Graph graph; // the kernel's name and its outputs; no nodes
  std::string file;
  program::Verification verification;
  program::VerificationOptions options; // those that decide what was tried and when it fails
  std::vector<std::size_t> shards;      // indices of those that are in it
};

VerificationRecord record_of(Graph const &graph, std::string const &file, program::Verification verification,
                             program::VerificationOptions const &options);

nlohmann::ordered_json to_json(VerificationRecord const &record);

// All records in a file that `verify --json` printed. Throws verification_file.
std::vector<VerificationRecord> read_records(std::string const &path);

// The samples that a record names, or one alone that someone wrote: {"inputs": [...], "parameters": [...]}. Throws
// verification_file for a file that has none, or none of this shape.
std::vector<Sample> read_samples(std::string const &path, Graph const &graph);

// Joins records of different shards of one verification. Throws verification_file, naming `path`, where they are not
// that.
void join(VerificationRecord &record, VerificationRecord const &other, std::string const &path);

} // namespace symreal::tool
