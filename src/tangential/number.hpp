/// The functions the formulas of this room use beside + - * /, for plain numbers; packs of them
/// (simd/pack.hpp) and numbers with derivatives (dual.hpp) have their own.
#pragma once

namespace wrc {

inline double root(double a) { return __builtin_sqrt(a); }  // the instruction: with every set the same bits
inline double larger(double a, double b) { return a > b ? a : b; }
inline double smaller(double a, double b) { return a < b ? a : b; }
inline double select(bool which, double yes, double no) { return which ? yes : no; }

}  // namespace wrc
