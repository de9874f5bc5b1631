#pragma once

/// For functions of a march's inner loop, which must not be calls, and for those of headers that kernels
/// read: as calls, units of several instruction sets would share them. In sanitized builds they may be calls:
/// there the compiler takes minutes for one unit otherwise.
#ifdef WRC_SANITIZED
#define WRC_IN_LOOP inline
#else
#define WRC_IN_LOOP [[gnu::always_inline]] inline
#endif
