// What reads the command line includes this besides.
#pragma once

#include "precompiled/json.h"

#include <CLI/CLI.hpp>
