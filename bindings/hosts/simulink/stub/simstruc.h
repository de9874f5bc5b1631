/* Stands for Simulink's simstruc.h where there is none: the names of the published interface that wrc_wheel.c
 * uses, over a struct of its own. For compiling and for running the block's arithmetic in Octave
 * (stub/simulink.c), not for Simulink. */
#ifndef WRC_STUB_SIMSTRUC_H
#define WRC_STUB_SIMSTRUC_H

#include "mex.h"

typedef int int_T;
typedef struct SimStruct {
  int wanted_parameters, parameters, input_width, output_width;
  const mxArray* const* parameter;
  void* work[1];
  const double* input;
  double* output;
  const char* error;
} SimStruct;

#define CONTINUOUS_SAMPLE_TIME 0.0
#define SS_OPTION_EXCEPTION_FREE_CODE 1
#define ssSetNumSFcnParams(S, n) ((S)->wanted_parameters = (n))
#define ssGetNumSFcnParams(S) ((S)->wanted_parameters)
#define ssGetSFcnParamsCount(S) ((S)->parameters)
#define ssGetSFcnParam(S, i) ((S)->parameter[i])
#define ssSetNumContStates(S, n) ((void)(S))
#define ssSetNumDiscStates(S, n) ((void)(S))
#define ssSetNumInputPorts(S, n) ((void)(S), 1)
#define ssSetNumOutputPorts(S, n) ((void)(S), 1)
#define ssSetInputPortWidth(S, port, n) ((S)->input_width = (n))
#define ssSetInputPortDirectFeedThrough(S, port, yes) ((void)(S))
#define ssSetInputPortRequiredContiguous(S, port, yes) ((void)(S))
#define ssSetOutputPortWidth(S, port, n) ((S)->output_width = (n))
#define ssSetNumSampleTimes(S, n) ((void)(S))
#define ssSetNumPWork(S, n) ((void)(S))
#define ssSetOptions(S, options) ((void)(S))
#define ssSetSampleTime(S, i, time) ((void)(S))
#define ssSetOffsetTime(S, i, time) ((void)(S))
#define ssGetPWork(S) ((S)->work)
#define ssGetInputPortRealSignal(S, port) ((S)->input)
#define ssGetOutputPortRealSignal(S, port) ((S)->output)
#define ssSetErrorStatus(S, text) ((S)->error = (text))

#endif
