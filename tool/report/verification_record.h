// Verification records, which outlive their run: JSON that `verify --json` prints, that another run reads, and that
// joins the records of other shards.
#pragma once

#include "verify/verification.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace symreal::tool {

struct VerificationRecord {
  Graph graph; // the kernel's name and outputs, without nodes
  std::string file;
  program::Verification verification;
  program::VerificationOptions options; // options that determine the samples and the criteria of failure
  std::vector<std::size_t> shards;      // indices of the shards included
};

VerificationRecord record_of(Graph const &graph, std::string const &file, program::Verification verification,
                             program::VerificationOptions const &options);

nlohmann::ordered_json to_json(VerificationRecord const &record);
// Throws what nlohmann::json throws for a member that is missing or of another type, std::invalid_argument for others.
VerificationRecord record_of(nlohmann::ordered_json const &json);

// Reads all records of a file that `verify --json` printed. Throws verification_file.
std::vector<VerificationRecord> read_records(std::string const &path);

// Reads the samples that a record names, or a single hand-written one: {"inputs": [...], "parameters": [...]}. Throws
// verification_file if the file has no samples of this shape.
std::vector<Sample> read_samples(std::string const &path, Graph const &graph);

// Joins records of different shards of one verification. Throws verification_file, naming `path`, for other records.
void join(VerificationRecord &record, VerificationRecord const &other, std::string const &path);

} // namespace symreal::tool
