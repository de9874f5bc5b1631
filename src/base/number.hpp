/// The functions formulas use beside + - * / where they are written for plain numbers and others; packs of
/// them (base/pack.hpp) and numbers with derivatives (base/dual.hpp) have their own.
#pragma once

#include "base/in_loop.hpp"

namespace wrc {

// root() is the processor's instruction, which gives the same bits with every instruction set
WRC_IN_LOOP double root(double a) { return __builtin_sqrt(a); }
WRC_IN_LOOP double magnitude(double a) { return a < 0.0 ? -a : a; }
WRC_IN_LOOP double larger(double a, double b) { return a > b ? a : b; }
WRC_IN_LOOP double smaller(double a, double b) { return a < b ? a : b; }
WRC_IN_LOOP double select(bool which, double yes, double no) { return which ? yes : no; }
WRC_IN_LOOP bool any(bool which) { return which; }

/// From 0 to 1 over t from 0 to 1, with zero slope at both ends; t beyond them counts as the end.
WRC_IN_LOOP double smooth_step(double t) {
  const double within = smaller(larger(t, 0.0), 1.0);
  return within * within * (3.0 - 2.0 * within);
}

}  // namespace wrc
