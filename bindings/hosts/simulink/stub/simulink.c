#include <stdio.h>

/* In place of Simulink's: the block as an Octave function, wrench = wrc_wheel(inputs, side, wheel, rail,
 * cant, friction), inputs 18 x n, wrench 6 x n. Calls what Simulink calls, in its order. */
void mexFunction(int results, mxArray* result[], int arguments, const mxArray* argument[]) {
  SimStruct S;
  (void)results;
  memset(&S, 0, sizeof S);
  S.parameters = arguments - 1;
  S.parameter = argument + 1;
  mdlInitializeSizes(&S);
  if (S.parameters != S.wanted_parameters)
    mexErrMsgTxt("wrc_wheel(inputs, side, wheel, rail, cant, friction)");
  if (mxGetM(argument[0]) != (size_t)S.input_width) mexErrMsgTxt("inputs: 18 rows");
  mdlInitializeSampleTimes(&S);
  mdlStart(&S);
  size_t count = mxGetN(argument[0]);
  result[0] = mxCreateDoubleMatrix((size_t)S.output_width, count, mxREAL);
  for (size_t i = 0; i < count && !S.error; ++i) {
    S.input = mxGetPr(argument[0]) + i * (size_t)S.input_width;
    S.output = mxGetPr(result[0]) + i * (size_t)S.output_width;
    mdlOutputs(&S, 0);
  }
  char sentence[400] = "";
  if (S.error) snprintf(sentence, sizeof sentence, "%s", S.error); /* it goes with the block */
  mdlTerminate(&S);
  if (sentence[0]) mexErrMsgTxt(sentence);
}
