// Output of a run's files: all of them or none, and none replaces a file that the run has read.
#pragma once

#include "engine/plan/plan.h"
#include "tool/options/code_options.h"

#include <string>
#include <vector>

namespace symreal::tool {

struct OutputFile {
  std::string path, text;
};

// A directory written as a whole; the paths of its files include its own.
struct OutputFolder {
  std::string path;
  std::vector<OutputFile> files;
};

// All outputs of a command.
struct Outputs {
  std::vector<OutputFile> files;
  std::vector<OutputFolder> folders = {};
  std::vector<std::string> directories = {}; // created if missing
};

// A plan in the form of a language.
struct LanguagePlan {
  Language const *language;
  Plan const *plan;
};

// Generated code, named after `path`: for each language the source, its header and, on request, the mainline.
std::vector<OutputFile> emitted_files(std::vector<LanguagePlan> const &plans, EmitterOptions const &options,
                                      FloatingPoint mode, std::string const &path);

// Fails if the file cannot be written or was read. Call before the work, lest it be in vain.
void require_writable(std::string const &path);
// Checks several paths, which must differ; skips empty ones.
void require_writable(std::vector<std::string> const &paths);

// Does the path name a directory, by its last character or since there is one?
bool names_directory(std::string const &path);
// Path of an output. `name`: its name if the option is missing or names a directory, as it does for several kernels.
std::string place_output(std::string const &option, std::string const &name, bool several);
// Path of a folder without a trailing slash.
std::string folder_path(std::string const &given);

// Creates a missing directory.
void make_directory(std::string const &path);

// Are these files on disk with the same content? Reports differing ones; prints the differences to standard output.
bool check_files(std::vector<OutputFile const *> const &files);

// Writes all results of a command, which calls it once; checks them against each other and against the files read.
// Returns the files' paths. Leaves up-to-date files alone.
std::vector<std::string> write_outputs(Outputs const &outputs);

} // namespace symreal::tool
