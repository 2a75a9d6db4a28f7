// Above the runtime: JSON as well.
#pragma once

#include "precompiled/standard.h"

#include <nlohmann/json.hpp>
