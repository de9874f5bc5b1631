/* The FMU wrc_wheelset, version 3.0, at run time: the functions that its hosts call, and an instance. */
#ifndef WRC_TEST_WHEELSET_FMU_H
#define WRC_TEST_WHEELSET_FMU_H

#include "fmi3FunctionTypes.h"
#include "load.h"

typedef struct functions {
  fmi3InstantiateCoSimulationTYPE* instantiate;
  fmi3EnterInitializationModeTYPE* enter;
  fmi3ExitInitializationModeTYPE* leave;
  fmi3SetFloat64TYPE* set;
  fmi3GetFloat64TYPE* get;
  fmi3SetInt32TYPE* set_integer;
  fmi3DoStepTYPE* step;
  fmi3FreeInstanceTYPE* release;
} functions;

static functions functions_of(void* library) {
  functions fmu;
  find(library, "fmi3InstantiateCoSimulation", &fmu.instantiate);
  find(library, "fmi3EnterInitializationMode", &fmu.enter);
  find(library, "fmi3ExitInitializationMode", &fmu.leave);
  find(library, "fmi3SetFloat64", &fmu.set);
  find(library, "fmi3GetFloat64", &fmu.get);
  find(library, "fmi3SetInt32", &fmu.set_integer);
  find(library, "fmi3DoStep", &fmu.step);
  find(library, "fmi3FreeInstance", &fmu.release);
  return fmu;
}

static void stop(const char* why) {
  fprintf(stderr, "%s\n", why);
  exit(3);
}

static void told(fmi3InstanceEnvironment of, fmi3Status status, fmi3String category, fmi3String sentence) {
  (void)of, (void)status, (void)category;
  fprintf(stderr, "%s\n", sentence);
}

static fmi3Instance new_wheelset(const functions* fmu) {
  return fmu->instantiate("set", "wrc_wheelset 6", "/nowhere", false, true, false, false, NULL, 0, NULL, told,
                          NULL);
}

#endif
