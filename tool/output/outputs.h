// Output of a run's files: all of them or none, and none replaces a file that the run has read.
#pragma once

#include "engine/plan/lanes/lanes.h"
#include "engine/plan/reroll/reroll.h"
#include "engine/plan/schedule/schedule.h"
#include "tool/options/language_option.h"
#include "tool/options/options.h"

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

// The schedule as C and C++ print it, if they are among the languages; loops and vectors are searched in it.
Schedule as_emitted(Schedule const &plan, EmitterOptions const &options, FloatingPoint mode,
                    std::vector<Language const *> const &languages);

// Generated code, named after `path`: for each language the source, its header and, on request, the mainline.
std::vector<OutputFile> emitted_files(Schedule const &plan, EmitterOptions const &options, FloatingPoint mode,
                                      std::vector<Language const *> const &languages, std::string const &path,
                                      Rerolled const *loops = nullptr, Laned const *lanes = nullptr);

// Fails if the file cannot be written or was read. Call before the work, lest it be in vain.
void require_writable(std::string const &path);
// Checks several paths, which must differ; skips empty ones.
void require_writable(std::vector<std::string> const &paths);

// Creates a missing directory.
void make_directory(std::string const &path);

// Are these files on disk with the same content? Reports differing ones; prints the differences to standard output.
bool check_files(std::vector<OutputFile const *> const &files);

// Writes all results of a command, which calls it once; checks them against each other and against the files read.
// Returns the files' paths. Leaves up-to-date files alone.
std::vector<std::string> write_outputs(Outputs const &outputs);

} // namespace symreal::tool
