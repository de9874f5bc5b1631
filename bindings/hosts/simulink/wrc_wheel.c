/* S-function, C, level 2: one wheel on its rail (../wrc_block.h has inputs and outputs).
 * Parameters: side (0 right, 1 left), wheel profile (2: S1002), rail profile (3: 60E1, 4: UIC60 of the
 * Manchester benchmark), tangent of the rails' cant, coefficient of friction.
 *   mex wrc_wheel.c -I../ -lwrc */
#define S_FUNCTION_NAME wrc_wheel
#define S_FUNCTION_LEVEL 2
#include "simstruc.h"
#include "wrc_block.h"

enum { SIDE, WHEEL, RAIL, INCLINATION, FRICTION, PARAMETERS };

static double parameter(SimStruct* S, int i) { return mxGetScalar(ssGetSFcnParam(S, i)); }

static void mdlInitializeSizes(SimStruct* S) {
  ssSetNumSFcnParams(S, PARAMETERS);
  if (ssGetNumSFcnParams(S) != ssGetSFcnParamsCount(S)) return; /* Simulink says so */
  ssSetNumContStates(S, 0);
  ssSetNumDiscStates(S, 0);
  if (!ssSetNumInputPorts(S, 1) || !ssSetNumOutputPorts(S, 1)) return;
  ssSetInputPortWidth(S, 0, WRC_BLOCK_INPUTS);
  ssSetInputPortDirectFeedThrough(S, 0, 1);
  ssSetInputPortRequiredContiguous(S, 0, 1);
  ssSetOutputPortWidth(S, 0, WRC_BLOCK_OUTPUTS);
  ssSetNumSampleTimes(S, 1);
  ssSetNumPWork(S, 1);
  ssSetOptions(S, SS_OPTION_EXCEPTION_FREE_CODE);
}

static void mdlInitializeSampleTimes(SimStruct* S) {
  ssSetSampleTime(S, 0, CONTINUOUS_SAMPLE_TIME);
  ssSetOffsetTime(S, 0, 0.0);
}

#define MDL_START
static void mdlStart(SimStruct* S) {
  wrc_block* block =
      wrc_block_open((int)parameter(S, SIDE), (int)parameter(S, WHEEL), (int)parameter(S, RAIL),
                     parameter(S, INCLINATION), parameter(S, FRICTION));
  ssGetPWork(S)[0] = block;
  if (!block)
    ssSetErrorStatus(S, "wrc: no memory");
  else if (!block->contact)
    ssSetErrorStatus(S, block->sentence);
}

static void mdlOutputs(SimStruct* S, int_T tid) {
  wrc_block* block = (wrc_block*)ssGetPWork(S)[0];
  (void)tid;
  if (wrc_block_wrench(block, ssGetInputPortRealSignal(S, 0), ssGetOutputPortRealSignal(S, 0), NULL) < 0)
    ssSetErrorStatus(S, block->sentence);
}

static void mdlTerminate(SimStruct* S) {
  wrc_block_close((wrc_block*)ssGetPWork(S)[0]);
  ssGetPWork(S)[0] = NULL;
}

#ifdef MATLAB_MEX_FILE
#include "simulink.c"
#else
#include "cg_sfun.h"
#endif
