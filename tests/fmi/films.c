/* The FMU wrc_wheelset with films: two wheelsets brake on wet leaves, the second on the rail that the first
 * left. An example of the exchange, and a test of it.
 *
 *   fmi_films wrc_fmu.so     exit status 1 if the second does not find more adhesion, or a run differs from
 *                            another
 */
#include <math.h>

#include "model.h"
#include "wheelset_fmu.h"

enum { sets = 2, steps = 300, delay = 100, substances = 5 }; /* 2.5 m behind the first at 25 m/s: 100 steps */

static const double step = 1e-3, speed = 25.0, radius = 0.46;

static fmi3Instance start(const functions* fmu) {
  fmi3Instance set = new_wheelset(fmu);
  const uint32_t numbers[] = {SET_speed, SET_friction}, films = FIRST_INTEGER + SET_films;
  const double values[] = {speed, 0.4};
  const int32_t with_films = 1;
  if (!set || fmu->set(set, numbers, 2, values, 2) != fmi3OK ||
      fmu->set_integer(set, &films, 1, &with_films, 1) != fmi3OK ||
      fmu->enter(set, false, 0.0, 0.0, false, 0.0) != fmi3OK || fmu->leave(set) != fmi3OK)
    stop("the FMU does not start");
  return set;
}

/* Both over all steps: film that each left on the rail, and the mean of its braking force. */
static void run(const functions* fmu, double film[sets], double force[sets]) {
  static double left[steps][substances]; /* behind the first, step by step */
  const double leaves[substances] = {0.02, 0.0, 0.009, 0.0, 0.0};
  for (int i = 0; i < sets; ++i) {
    fmi3Instance set = start(fmu);
    force[i] = 0.0;
    for (int n = 0; n < steps; ++n) {
      uint32_t ahead[substances + 1], behind[substances];
      double given[substances + 1];
      for (uint32_t q = 0; q < substances; ++q) {
        ahead[q] = SET_water_ahead + q;
        behind[q] = SET_water_behind + q;
        given[q] = i == 0 || n < delay ? leaves[q] : left[n - delay][q];
      }
      /* slide protection: the brake of 12 kN m acts while the wheels slide by less than 8 % */
      const uint32_t turning = SET_pitch_rate, pulls = SET_fx;
      double rate, fx, out[substances];
      bool event, end, early;
      double last;
      fmu->get(set, &turning, 1, &rate, 1);
      ahead[substances] = SET_moment_y;
      given[substances] = -rate * radius > 0.92 * speed ? 12e3 : 0.0;
      if (fmu->set(set, ahead, substances + 1, given, substances + 1) != fmi3OK ||
          fmu->step(set, n * step, step, true, &event, &end, &early, &last) != fmi3OK ||
          fmu->get(set, behind, substances, out, substances) != fmi3OK ||
          fmu->get(set, &pulls, 1, &fx, 1) != fmi3OK)
        stop("a step failed");
      if (i == 0) memcpy(left[n], out, sizeof out);
      if (n >= 2 * delay) force[i] += -fx / (steps - 2 * delay);
      film[i] = out[2];
    }
    fmu->release(set);
  }
}

int main(int count, char** words) {
  if (count < 2) return 2;
  const functions fmu = functions_of(load(words[1]));
  double film[sets], force[sets], again_film[sets], again_force[sets];
  run(&fmu, film, force);
  run(&fmu, again_film, again_force);
  for (int i = 0; i < sets; ++i)
    printf("wheelset %d: braking force %.2f kN, film left %.2f g/m^2\n", i + 1, 1e-3 * force[i],
           1e3 * film[i]);
  const int same =
      memcmp(film, again_film, sizeof film) == 0 && memcmp(force, again_force, sizeof force) == 0;
  const int good = film[0] < 0.009 && film[1] < film[0] && force[1] > 1.02 * force[0] && force[0] > 0.0;
  printf("%s, %s\n", good ? "the second finds more" : "WRONG", same ? "the same bits again" : "OTHER BITS");
  return !(good && same);
}
