/* conicity.c - what railway engineers ask of a pair of profiles first: rolling radius difference, contact
 * angles and equivalent conicity of S1002 wheels on 60E1 rails inclined 1:40 (EN 15302), for bodies that
 * touch rigidly and under a load.
 *
 *   conicity [file.csv]     writes the contact functions; draw_conicity.py draws them
 */
#include <stdio.h>
#include <stdlib.h>

#include "wrc/wrc_profiles.h"

enum { COUNT = 281, AMPLITUDES = 14 }; /* -7 mm .. 7 mm; 0.5 mm .. 7 mm */

static double y[COUNT], dr[2][COUNT], right[2][COUNT], left[2][COUNT], y_wheel[2][COUNT], y_rail[2][COUNT];
static double amplitude[AMPLITUDES], conicity[2][2][AMPLITUDES];

static void check(int32_t status, const char* text) {
  if (status >= 0) return;
  fprintf(stderr, "%s: %s\n", wrc_status_name(status), text);
  exit(EXIT_FAILURE);
}

int main(int argc, char** argv) {
  char text[300] = "";
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 1.0 / 40.0;
  wrc_model* model = NULL;
  check(wrc_model_create(&config, NULL, &model, text, sizeof text), text);

  const double load[2] = {0.0, 80e3}; /* N, of each wheel */
  for (int i = 0; i < COUNT; ++i) y[i] = 0.05e-3 * (i - COUNT / 2);
  for (int i = 0; i < AMPLITUDES; ++i) amplitude[i] = 0.5e-3 * (i + 1);
  for (int k = 0; k < 2; ++k) {
    wrc_wheelset_geometry_problem where = {.struct_size = sizeof where};
    where.count = COUNT;
    where.lateral = y;
    where.wheel_load = load[k];
    wrc_wheelset_geometry functions = {.struct_size = sizeof functions};
    functions.radius_difference = dr[k];
    functions.angle_right = right[k];
    functions.angle_left = left[k];
    functions.y_wheel_right = y_wheel[k];
    functions.y_rail_right = y_rail[k];
    check(wrc_profile_wheelset_geometry(model, &where, &functions, text, sizeof text), text);

    wrc_conicity_problem problem = wrc_conicity_problem_default();
    problem.count = COUNT;
    problem.lateral = y;
    problem.radius_difference = dr[k];
    problem.amplitude_count = AMPLITUDES;
    problem.amplitudes = amplitude;
    for (int32_t method = 0; method < 2; ++method) {
      problem.method = method; /* enum wrc_conicity_method */
      wrc_conicity result = {.struct_size = sizeof result};
      result.conicity = conicity[k][method];
      check(wrc_equivalent_conicity(&problem, &result, text, sizeof text), text);
    }
  }
  wrc_model_destroy(model);

  printf("equivalent conicity    rigid                      under 80 kN\n");
  printf("amplitude [mm]   wavelength  regression      wavelength  regression\n");
  for (int i = 0; i < AMPLITUDES; ++i)
    printf("%9.1f        %8.4f    %8.4f        %8.4f    %8.4f\n", 1e3 * amplitude[i], conicity[0][0][i],
           conicity[0][1][i], conicity[1][0][i], conicity[1][1][i]);
  if (argc < 2) return EXIT_SUCCESS;

  FILE* csv = fopen(argv[1], "w");
  if (csv == NULL) {
    fprintf(stderr, "cannot write '%s'\n", argv[1]);
    return EXIT_FAILURE;
  }
  fprintf(
      csv,
      "load_N,y_mm,radius_difference_mm,angle_right_mrad,angle_left_mrad,y_wheel_right_mm,y_rail_right_mm\n");
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < COUNT; ++i)
      fprintf(csv, "%g,%.3f,%.6f,%.4f,%.4f,%.4f,%.4f\n", load[k], 1e3 * y[i], 1e3 * dr[k][i],
              1e3 * right[k][i], 1e3 * left[k][i], 1e3 * y_wheel[k][i], 1e3 * y_rail[k][i]);
  fprintf(csv, "load_N,amplitude_mm,by_wavelength,by_regression\n");
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < AMPLITUDES; ++i)
      fprintf(csv, "%g,%.3f,%.6f,%.6f\n", load[k], 1e3 * amplitude[i], conicity[k][0][i], conicity[k][1][i]);
  return fclose(csv) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
