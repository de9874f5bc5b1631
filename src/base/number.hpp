/// The functions formulas use beside + - * / where they are written for plain numbers and others; packs of
/// them (base/pack.hpp) and numbers with derivatives (base/dual.hpp) have their own.
#pragma once

namespace wrc {

inline double root(double a) { return __builtin_sqrt(a); }  // the instruction: with every set the same bits
inline double magnitude(double a) { return a < 0.0 ? -a : a; }
inline double larger(double a, double b) { return a > b ? a : b; }
inline double smaller(double a, double b) { return a < b ? a : b; }
inline double select(bool which, double yes, double no) { return which ? yes : no; }

}  // namespace wrc
