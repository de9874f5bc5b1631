/* What both versions of FMI share: one instance of wrc_wheel or wrc_wheelset, its variables by number, its
 * steps. */
#ifndef WRC_FMU_MODEL_H
#define WRC_FMU_MODEL_H

#include <stddef.h>
#include <stdint.h>

#include "wrc/wrc_surface.h"

enum { TIME = 999, FIRST_INTEGER = 1000, MOST_REALS = 96, MOST_INTEGERS = 8 };

/* Numbers of the variables: WHEEL_y and so on. */
#define TOKEN(text)
#define REAL(name, unit, causality, variability, start, range, description) WHEEL_##name,
#define INTEGER(name, causality, variability, start, range, description)
enum {
#include "wheel.def"
  WHEEL_REALS
};
#undef REAL
#define REAL(name, unit, causality, variability, start, range, description) SET_##name,
enum {
#include "wheelset.def"
  SET_REALS
};
#undef REAL
#undef INTEGER
#define REAL(name, unit, causality, variability, start, range, description)
#define INTEGER(name, causality, variability, start, range, description) WHEEL_##name,
enum {
#include "wheel.def"
  WHEEL_INTEGERS
};
#undef INTEGER
#define INTEGER(name, causality, variability, start, range, description) SET_##name,
enum {
#include "wheelset.def"
  SET_INTEGERS
};
#undef TOKEN
#undef REAL
#undef INTEGER

enum kind { WHEEL, WHEELSET };

/* All that an instance remembers. The contacts remember nothing that counts: every call starts anew
 * (WRC_START_COLD), so these numbers are the whole state, in this process and in any other. */
typedef struct contents {
  double real[MOST_REALS];
  int32_t integer[MOST_INTEGERS];
  double time;
  int32_t solved; /* are the outputs those of the inputs? */
  int32_t reserved;
} contents;

/* A state with what says whose it is, byte for byte what is serialised. */
typedef struct saved {
  char mark[16];
  contents now;
} saved;

typedef struct instance instance;
struct instance {
  enum kind kind;
  contents now;
  char* resources; /* folder, without / at its end */
  wrc_model* model;
  wrc_contact* contact[2];
  int initialising;
  wrc_wheel_input input;
  int32_t slopes_known;
  wrc_wrench_derivatives slopes;
  /* how a sentence reaches the host, severity 1: warning, 2: discarded, 3: error, as both versions of FMI
   * number it */
  void (*say)(instance* of, int severity, const char* sentence);
  void* environment;
  const char* name;
  void* logger;
  int logging;
};

/* As fmi2Status and fmi3Status number it. */
typedef enum { FINE = 0, DISCARDED = 2, WRONG = 3 } outcome;

/* Tells the host a sentence; returns its severity as outcome. */
outcome model_say(instance* of, outcome severity, const char* sentence);

/* The instance a token asks for; NULL: of another FMU, or no memory. Resources: a path or a file URI. */
instance* model_new(const char* token, const char* resources);
void model_free(instance* of);
/* Everything as at the beginning. */
void model_reset(instance* of);
/* At the end of initialisation: makes model and contacts of the parameters, and finds where the wheelset
 * stands. */
outcome model_start(instance* of);

outcome model_get_real(instance* of, const uint32_t* numbers, size_t count, double* values);
outcome model_set_real(instance* of, const uint32_t* numbers, size_t count, const double* values);
outcome model_get_integer(instance* of, const uint32_t* numbers, size_t count, int32_t* values);
outcome model_set_integer(instance* of, const uint32_t* numbers, size_t count, const int32_t* values);

/* Jacobian times seed, or its transpose times seed; of a wheel's wrench by its inputs. */
outcome model_derivatives(instance* of, int transposed, const uint32_t* unknowns, size_t unknown_count,
                          const uint32_t* knowns, size_t known_count, const double* seed, double* result);

/* wheelset.c: its forces as it stands, brought into the outputs; status of the library, which says more to
 * wrc_contact_last_error() of *failed. */
int32_t wheelset_solve(instance* of, const wrc_contact** failed);
/* One communication step of a wheelset. One that cannot be done leaves everything as it was before. */
outcome model_step(instance* of, double from, double length);

/* Bytes of a state, for this process and others on such processors. A state of other parameters brings them
 * along. Valid: of this FMU in this version, numbers finite and in their ranges. */
void model_save(const instance* of, saved* into);
outcome model_valid(instance* of, const saved* from);
outcome model_restore(instance* of, const saved* from);

#endif
