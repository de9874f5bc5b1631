/* What Wrc.mo calls, over ../wrc_block.h. A failure ends the simulation's step with the library's sentence.
 */
#ifndef WRC_MODELICA_H
#define WRC_MODELICA_H

#include "ModelicaUtilities.h" /* of the Modelica tool */
#include "wrc_block.h"

static void* wrc_modelica_open(int side, int wheel, int rail, double inclination, double friction) {
  wrc_block* block = wrc_block_open(side, wheel, rail, inclination, friction);
  if (!block) ModelicaError("wrc: no memory");
  if (!block->contact) ModelicaFormatError("wrc: %s", block->sentence);
  return block;
}

static void wrc_modelica_close(void* block) { wrc_block_close((wrc_block*)block); }

static void wrc_modelica_wrench(void* block, const double* u, double* w) {
  if (wrc_block_wrench((wrc_block*)block, u, w, NULL) < 0)
    ModelicaFormatError("wrc: %s", ((wrc_block*)block)->sentence);
}

static void wrc_modelica_wrench_der(void* block, const double* u, const double* du, double* dw) {
  double w[WRC_BLOCK_OUTPUTS], slopes[WRC_BLOCK_OUTPUTS * WRC_BLOCK_INPUTS];
  int i, j;
  if (wrc_block_wrench((wrc_block*)block, u, w, slopes) < 0)
    ModelicaFormatError("wrc: %s", ((wrc_block*)block)->sentence);
  for (i = 0; i < WRC_BLOCK_OUTPUTS; ++i) {
    dw[i] = 0.0;
    for (j = 0; j < WRC_BLOCK_INPUTS; ++j) dw[i] += slopes[i * WRC_BLOCK_INPUTS + j] * du[j];
  }
}

#endif
