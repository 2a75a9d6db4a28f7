// Everything that a symbolic program sees.
#pragma once

#include <symreal/atomic.h>
#include <symreal/branch.h>
#include <symreal/eigen_traits.h>
#include <symreal/environment.h>
#include <symreal/external.h>
#include <symreal/lookup.h>
#include <symreal/order.h>
#include <symreal/standard_library.h>
#include <symreal/state.h>
#include <symreal/symbolic_expr.h>
#include <symreal/text.h>
#include <symreal/type_traits.h>
