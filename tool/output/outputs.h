// The files that a run leaves: all of them or none, and none in the place of a file that it has read.
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

// A directory that is handed on as a whole; the paths of its files begin with its own.
struct OutputFolder {
  std::string path;
  std::vector<OutputFile> files;
};

// All that a command writes.
struct Outputs {
  std::vector<OutputFile> files;
  std::vector<OutputFolder> folders = {};
  std::vector<std::string> directories = {}; // made where there are none
};

// The schedule as C and C++ print it, where that is among the languages: what loops and vectors are looked for in.
Schedule as_emitted(Schedule const &plan, EmitterOptions const &options, FloatingPoint mode,
                    std::vector<Language const *> const &languages);

// Generated code beside `path`, which gives it its name: of each language the source, its header and on request the
// mainline.
std::vector<OutputFile> emitted_files(Schedule const &plan, EmitterOptions const &options, FloatingPoint mode,
                                      std::vector<Language const *> const &languages, std::string const &path,
                                      Rerolled const *loops = nullptr, Laned const *lanes = nullptr);

// Fails when a file of this name cannot be written, or was read; before the work is done, so that it is not done in
// vain.
void require_writable(std::string const &path);
// The same for several, which must not fall together; empty ones are left out.
void require_writable(std::vector<std::string> const &paths);

// Makes a directory where there is none.
void make_directory(std::string const &path);

// Does the disk hold these files? What differs is reported, and its difference printed to standard output.
bool check_files(std::vector<OutputFile const *> const &files);

// Each command writes its results by one call of this, which is where they are held against each other and against
// what was read. Returns the paths of the files. Files that are up to date are left alone.
std::vector<std::string> write_outputs(Outputs const &outputs);

} // namespace symreal::tool
