#pragma once

/// For functions of a march's inner loop, which must not be calls. In sanitized builds they may be: there the
/// compiler takes minutes for one unit otherwise.
#ifdef WRC_SANITIZED
#define WRC_IN_LOOP inline
#else
#define WRC_IN_LOOP [[gnu::always_inline]] inline
#endif
