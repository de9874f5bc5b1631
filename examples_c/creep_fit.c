/* creep_fit.c - friction and a layer from a measured creep curve, with their spread.
 *
 *   cc creep_fit.c -lwrc -lm -o creep_fit && ./creep_fit [FILE]
 *
 * FILE has a point a line: slip and adhesion as numbers (1.6 % is 0.016), speed [m/s], load [N]. Without one
 * the curve is that of friction by name, "locomotive", to which 5 % of scatter is added.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "wrc/wrc_offline.h"

enum { MOST = 1000 };

static double slip[MOST], adhesion[MOST], speed[MOST], load[MOST], fitted[MOST];

/* Points of a file. */
static uint32_t read_points(const char* name) {
  FILE* const file = fopen(name, "r");
  char line[200];
  uint32_t n = 0;
  if (file == NULL) return 0;
  while (n < MOST && fgets(line, sizeof line, file) != NULL)
    n += sscanf(line, "%lf %lf %lf %lf", &slip[n], &adhesion[n], &speed[n], &load[n]) == 4;
  fclose(file);
  return n;
}

/* 36 points of a law, scattered by 5 % from a sequence of random numbers that is always the same. */
static uint32_t make_points(wrc_contact* contact, const wrc_friction* law, const wrc_ellipse* ellipse) {
  const uint32_t n = 36;
  uint64_t state = 7;
  for (uint32_t i = 0; i < n; ++i) {
    slip[i] = 5e-4 * pow(600.0, i / (n - 1.0));
    speed[i] = i % 2 == 0 ? 5.0 : 20.0;
    load[i] = ellipse->normal_force;
    wrc_creepage creepage = wrc_creepage_default();
    creepage.longitudinal = slip[i];
    creepage.speed = speed[i];
    wrc_planar_forces forces = {.fx = 0.0};
    wrc_planar_tangential(contact, ellipse, &creepage, law, &forces);
    double bell = -6.0;
    for (int k = 0; k < 12; ++k) {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      bell += (double)(state >> 11) / 9007199254740992.0;
    }
    adhesion[i] = -forces.fx / forces.fn * (1.0 + 0.05 * bell);
  }
  return n;
}

/* One line of a parameter that was looked for. */
static void show(const char* name, const wrc_creep_fit* fit, int parameter, double scale, const char* unit) {
  if (fit->undetermined >> parameter & 1) {
    printf("%-22s %9.3f %-4s not determined by the curve\n", name, scale * fit->value[parameter], unit);
    return;
  }
  printf("%-22s %9.3f %-4s +- %.3f, with 95 %% in %.3f .. %.3f\n", name, scale * fit->value[parameter], unit,
         scale * fit->deviation[parameter], scale * fit->low[parameter], scale * fit->high[parameter]);
}

int main(int argc, char** argv) {
  wrc_config config = wrc_config_default(); /* strip FASTSIM, which carries layers */
  wrc_model* model = NULL;
  wrc_contact* contact = NULL;
  char text[400];
  if (wrc_model_create(&config, NULL, &model, text, sizeof text) < 0 ||
      wrc_contact_create(model, WRC_SIDE_RIGHT, NULL, &contact, text, sizeof text) < 0) {
    fprintf(stderr, "%s\n", text);
    return EXIT_FAILURE;
  }

  /* The patch under one load; its axes grow with the cube root of others. */
  wrc_creep_curve curve = wrc_creep_curve_default();
  curve.ellipse.a = 6.3e-3;
  curve.ellipse.b = 12.6e-3;
  curve.ellipse.normal_force = 106.7e3;
  wrc_friction_use(&curve.friction, "locomotive", NULL, 0);
  curve.count = argc > 1 ? read_points(argv[1]) : make_points(contact, &curve.friction, &curve.ellipse);
  curve.slip = slip;
  curve.adhesion = adhesion;
  curve.speed = speed;
  curve.load = load;

  /* The fit begins elsewhere. */
  curve.friction.coefficient = 0.5;
  curve.friction.kinetic_ratio = 0.8;
  curve.friction.fall_rate = 1.0;
  curve.friction.layer_thickness = 0.3e-3;
  curve.parameters = 1U << WRC_CREEP_COEFFICIENT | 1U << WRC_CREEP_KINETIC_RATIO | 1U << WRC_CREEP_FALL_RATE |
                     1U << WRC_CREEP_LAYER_THICKNESS;
  wrc_creep_fit fit = {.struct_size = sizeof fit};
  const int32_t status = wrc_fit_creep_curve(contact, &curve, &fit, fitted);
  if (status < 0) {
    wrc_contact_last_error(contact, text, sizeof text);
    fprintf(stderr, "%s: %s\n", wrc_status_name(status), text);
  } else {
    printf("%u points scatter by %.1f %% about the law; %d iterations\n", curve.count, 100.0 * fit.scatter,
           fit.iterations);
    show("friction at rest", &fit, WRC_CREEP_COEFFICIENT, 1.0, "");
    show("kinetic over it", &fit, WRC_CREEP_KINETIC_RATIO, 1.0, "");
    show("fall rate", &fit, WRC_CREEP_FALL_RATE, 1.0, "s/m");
    show("thickness of the layer", &fit, WRC_CREEP_LAYER_THICKNESS, 1e3, "mm");
    printf("\n  slip    speed   measured  fitted\n");
    for (uint32_t i = 0; i < curve.count; i += 5)
      printf("%6.2f %% %4.0f m/s %9.3f %8.3f\n", 100.0 * slip[i], speed[i], adhesion[i], fitted[i]);
  }
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
  return status < 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
