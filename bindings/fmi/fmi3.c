/* FMI 3.0 over model.h, as fmi2.c. */
#include <stdlib.h>
#include <string.h>

#include "fmi3Functions.h"
#include "model.h"

#define STATUS(how) ((fmi3Status)(how))
#define NONE(count) ((count) ? fmi3Error : fmi3OK) /* there are no such variables */

static void say(instance* of, int severity, const char* sentence) {
  fmi3LogMessageCallback logger;
  memcpy(&logger, &of->logger, sizeof logger);
  if (logger && (of->logging || severity == WRONG))
    logger(of->environment, STATUS(severity), severity == WRONG ? "logStatusError" : "logStatusDiscard",
           sentence);
}

const char* fmi3GetVersion(void) { return fmi3Version; }

static fmi3Instance new_instance(enum kind kind, fmi3String token, fmi3String resources, fmi3Boolean logging,
                                 fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger) {
  instance* of = model_new(token, resources);
  if (!of || of->kind != kind) {
    model_free(of);
    return NULL;
  }
  of->say = say;
  of->logging = logging;
  of->environment = environment;
  memcpy(&of->logger, &logger, sizeof of->logger);
  return of;
}
fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources,
                                          fmi3Boolean visible, fmi3Boolean logging,
                                          fmi3InstanceEnvironment environment,
                                          fmi3LogMessageCallback logger) {
  (void)name, (void)visible;
  return new_instance(WHEEL, token, resources, logging, environment, logger);
}
fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources,
                                         fmi3Boolean visible, fmi3Boolean logging, fmi3Boolean events,
                                         fmi3Boolean early, const fmi3ValueReference needed[],
                                         size_t needed_count, fmi3InstanceEnvironment environment,
                                         fmi3LogMessageCallback logger,
                                         fmi3IntermediateUpdateCallback update) {
  (void)name, (void)visible, (void)events, (void)early, (void)needed, (void)needed_count, (void)update;
  return new_instance(WHEELSET, token, resources, logging, environment, logger);
}
fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                               fmi3Boolean visible, fmi3Boolean logging,
                                               fmi3InstanceEnvironment environment,
                                               fmi3LogMessageCallback logger, fmi3ClockUpdateCallback update,
                                               fmi3LockPreemptionCallback lock,
                                               fmi3UnlockPreemptionCallback unlock) {
  (void)name, (void)token, (void)resources, (void)visible, (void)logging, (void)environment, (void)logger;
  (void)update, (void)lock, (void)unlock;
  return NULL;
}
void fmi3FreeInstance(fmi3Instance c) { model_free(c); }

fmi3Status fmi3SetDebugLogging(fmi3Instance c, fmi3Boolean on, size_t count, const fmi3String names[]) {
  (void)count, (void)names;
  ((instance*)c)->logging = on;
  return fmi3OK;
}
fmi3Status fmi3EnterInitializationMode(fmi3Instance c, fmi3Boolean has_tolerance, fmi3Float64 tolerance,
                                       fmi3Float64 start, fmi3Boolean has_stop, fmi3Float64 stop) {
  (void)has_tolerance, (void)tolerance, (void)has_stop, (void)stop;
  ((instance*)c)->now.time = start;
  ((instance*)c)->initialising = 1;
  return fmi3OK;
}
fmi3Status fmi3ExitInitializationMode(fmi3Instance c) {
  instance* of = c;
  const outcome how = of->model ? FINE : model_start(of);
  of->initialising = 0;
  return STATUS(how);
}
fmi3Status fmi3EnterEventMode(fmi3Instance c) { return (void)c, fmi3OK; }
fmi3Status fmi3Terminate(fmi3Instance c) { return (void)c, fmi3OK; }
fmi3Status fmi3Reset(fmi3Instance c) { return model_reset(c), fmi3OK; }

fmi3Status fmi3GetFloat64(fmi3Instance c, const fmi3ValueReference vr[], size_t count, fmi3Float64 values[],
                          size_t n) {
  return n != count ? fmi3Error : STATUS(model_get_real(c, vr, count, values));
}
fmi3Status fmi3SetFloat64(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                          const fmi3Float64 values[], size_t n) {
  return n != count ? fmi3Error : STATUS(model_set_real(c, vr, count, values));
}
fmi3Status fmi3GetInt32(fmi3Instance c, const fmi3ValueReference vr[], size_t count, fmi3Int32 values[],
                        size_t n) {
  return n != count ? fmi3Error : STATUS(model_get_integer(c, vr, count, values));
}
fmi3Status fmi3SetInt32(fmi3Instance c, const fmi3ValueReference vr[], size_t count, const fmi3Int32 values[],
                        size_t n) {
  return n != count ? fmi3Error : STATUS(model_set_integer(c, vr, count, values));
}
#define NO_VARIABLES(type)                                                                                   \
  fmi3Status fmi3Get##type(fmi3Instance c, const fmi3ValueReference vr[], size_t count, fmi3##type values[], \
                           size_t n) {                                                                       \
    return (void)c, (void)vr, (void)values, (void)n, NONE(count);                                            \
  }                                                                                                          \
  fmi3Status fmi3Set##type(fmi3Instance c, const fmi3ValueReference vr[], size_t count,                      \
                           const fmi3##type values[], size_t n) {                                            \
    return (void)c, (void)vr, (void)values, (void)n, NONE(count);                                            \
  }
NO_VARIABLES(Float32)
NO_VARIABLES(Int8)
NO_VARIABLES(UInt8)
NO_VARIABLES(Int16)
NO_VARIABLES(UInt16)
NO_VARIABLES(UInt32)
NO_VARIABLES(Int64)
NO_VARIABLES(UInt64)
NO_VARIABLES(Boolean)
NO_VARIABLES(String)
fmi3Status fmi3GetBinary(fmi3Instance c, const fmi3ValueReference vr[], size_t count, size_t sizes[],
                         fmi3Binary values[], size_t n) {
  return (void)c, (void)vr, (void)sizes, (void)values, (void)n, NONE(count);
}
fmi3Status fmi3SetBinary(fmi3Instance c, const fmi3ValueReference vr[], size_t count, const size_t sizes[],
                         const fmi3Binary values[], size_t n) {
  return (void)c, (void)vr, (void)sizes, (void)values, (void)n, NONE(count);
}
fmi3Status fmi3GetClock(fmi3Instance c, const fmi3ValueReference vr[], size_t count, fmi3Clock values[]) {
  return (void)c, (void)vr, (void)values, NONE(count);
}
fmi3Status fmi3SetClock(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                        const fmi3Clock values[]) {
  return (void)c, (void)vr, (void)values, NONE(count);
}
fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance c, fmi3ValueReference vr, size_t* count) {
  return (void)c, (void)vr, *count = 0, fmi3Error; /* they are in the model description */
}
fmi3Status fmi3GetVariableDependencies(fmi3Instance c, fmi3ValueReference of, size_t elements[],
                                       fmi3ValueReference independents[], size_t their_elements[],
                                       fmi3DependencyKind kinds[], size_t count) {
  return (void)c, (void)of, (void)elements, (void)independents, (void)their_elements, (void)kinds,
         (void)count, fmi3Error;
}

fmi3Status fmi3GetFMUState(fmi3Instance c, fmi3FMUState* state) {
  if (!*state) *state = malloc(sizeof(saved));
  if (!*state) return fmi3Error;
  model_save(c, *state);
  return fmi3OK;
}
fmi3Status fmi3SetFMUState(fmi3Instance c, fmi3FMUState state) {
  return state ? STATUS(model_restore(c, state)) : fmi3Error;
}
fmi3Status fmi3FreeFMUState(fmi3Instance c, fmi3FMUState* state) {
  (void)c;
  if (state) {
    free(*state);
    *state = NULL;
  }
  return fmi3OK;
}
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance c, fmi3FMUState state, size_t* size) {
  return (void)c, (void)state, *size = sizeof(saved), fmi3OK;
}
fmi3Status fmi3SerializeFMUState(fmi3Instance c, fmi3FMUState state, fmi3Byte bytes[], size_t size) {
  (void)c;
  if (!state || size < sizeof(saved)) return fmi3Error;
  memcpy(bytes, state, sizeof(saved));
  return fmi3OK;
}
fmi3Status fmi3DeserializeFMUState(fmi3Instance c, const fmi3Byte bytes[], size_t size, fmi3FMUState* state) {
  saved read;
  if (size != sizeof read) return fmi3Error;
  memcpy(&read, bytes, sizeof read);
  if (model_valid(c, &read) != FINE || fmi3GetFMUState(c, state) != fmi3OK) return fmi3Error;
  memcpy(*state, &read, sizeof read);
  return fmi3OK;
}

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance c, const fmi3ValueReference unknowns[],
                                        size_t unknown_count, const fmi3ValueReference knowns[],
                                        size_t known_count, const fmi3Float64 seed[], size_t seeds,
                                        fmi3Float64 sensitivity[], size_t sensitivities) {
  if (seeds != known_count || sensitivities != unknown_count) return fmi3Error;
  return STATUS(model_derivatives(c, 0, unknowns, unknown_count, knowns, known_count, seed, sensitivity));
}
fmi3Status fmi3GetAdjointDerivative(fmi3Instance c, const fmi3ValueReference unknowns[], size_t unknown_count,
                                    const fmi3ValueReference knowns[], size_t known_count,
                                    const fmi3Float64 seed[], size_t seeds, fmi3Float64 sensitivity[],
                                    size_t sensitivities) {
  if (seeds != unknown_count || sensitivities != known_count) return fmi3Error;
  return STATUS(model_derivatives(c, 1, unknowns, unknown_count, knowns, known_count, seed, sensitivity));
}

fmi3Status fmi3EnterConfigurationMode(fmi3Instance c) { return (void)c, fmi3OK; }
fmi3Status fmi3ExitConfigurationMode(fmi3Instance c) { return (void)c, fmi3OK; }
fmi3Status fmi3GetIntervalDecimal(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                                  fmi3Float64 intervals[], fmi3IntervalQualifier qualifiers[]) {
  return (void)c, (void)vr, (void)intervals, (void)qualifiers, NONE(count);
}
fmi3Status fmi3GetIntervalFraction(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                                   fmi3UInt64 counters[], fmi3UInt64 resolutions[],
                                   fmi3IntervalQualifier qualifiers[]) {
  return (void)c, (void)vr, (void)counters, (void)resolutions, (void)qualifiers, NONE(count);
}
fmi3Status fmi3GetShiftDecimal(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                               fmi3Float64 shifts[]) {
  return (void)c, (void)vr, (void)shifts, NONE(count);
}
fmi3Status fmi3GetShiftFraction(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                                fmi3UInt64 counters[], fmi3UInt64 resolutions[]) {
  return (void)c, (void)vr, (void)counters, (void)resolutions, NONE(count);
}
fmi3Status fmi3SetIntervalDecimal(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                                  const fmi3Float64 intervals[]) {
  return (void)c, (void)vr, (void)intervals, NONE(count);
}
fmi3Status fmi3SetIntervalFraction(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                                   const fmi3UInt64 counters[], const fmi3UInt64 resolutions[]) {
  return (void)c, (void)vr, (void)counters, (void)resolutions, NONE(count);
}
fmi3Status fmi3SetShiftDecimal(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                               const fmi3Float64 shifts[]) {
  return (void)c, (void)vr, (void)shifts, NONE(count);
}
fmi3Status fmi3SetShiftFraction(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                                const fmi3UInt64 counters[], const fmi3UInt64 resolutions[]) {
  return (void)c, (void)vr, (void)counters, (void)resolutions, NONE(count);
}
fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance c) { return (void)c, fmi3OK; }
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance c, fmi3Boolean* again, fmi3Boolean* end,
                                    fmi3Boolean* nominals, fmi3Boolean* states, fmi3Boolean* has_next,
                                    fmi3Float64* next) {
  (void)c;
  *again = *end = *nominals = *states = *has_next = fmi3False;
  *next = 0.0;
  return fmi3OK;
}

/* Model exchange, of a model without states. */
fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance c) { return (void)c, fmi3OK; }
fmi3Status fmi3CompletedIntegratorStep(fmi3Instance c, fmi3Boolean no_return, fmi3Boolean* event,
                                       fmi3Boolean* end) {
  return (void)c, (void)no_return, *event = *end = fmi3False, fmi3OK;
}
fmi3Status fmi3SetTime(fmi3Instance c, fmi3Float64 time) {
  ((instance*)c)->now.time = time;
  return fmi3OK;
}
fmi3Status fmi3SetContinuousStates(fmi3Instance c, const fmi3Float64 x[], size_t count) {
  return (void)c, (void)x, NONE(count);
}
fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance c, fmi3Float64 derivatives[], size_t count) {
  return (void)c, (void)derivatives, NONE(count);
}
fmi3Status fmi3GetEventIndicators(fmi3Instance c, fmi3Float64 indicators[], size_t count) {
  return (void)c, (void)indicators, NONE(count);
}
fmi3Status fmi3GetContinuousStates(fmi3Instance c, fmi3Float64 x[], size_t count) {
  return (void)c, (void)x, NONE(count);
}
fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance c, fmi3Float64 x[], size_t count) {
  return (void)c, (void)x, NONE(count);
}
fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance c, size_t* count) {
  return (void)c, *count = 0, fmi3OK;
}
fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance c, size_t* count) {
  return (void)c, *count = 0, fmi3OK;
}

/* Co-simulation. */
fmi3Status fmi3EnterStepMode(fmi3Instance c) { return (void)c, fmi3OK; }
fmi3Status fmi3GetOutputDerivatives(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                                    const fmi3Int32 orders[], fmi3Float64 values[], size_t n) {
  return (void)c, (void)vr, (void)orders, (void)values, (void)n, NONE(count);
}
fmi3Status fmi3DoStep(fmi3Instance c, fmi3Float64 time, fmi3Float64 length, fmi3Boolean no_return,
                      fmi3Boolean* event, fmi3Boolean* end, fmi3Boolean* early, fmi3Float64* last) {
  (void)no_return;
  *event = *end = *early = fmi3False;
  const outcome how = model_step(c, time, length);
  *last = ((const instance*)c)->now.time;
  return STATUS(how);
}
fmi3Status fmi3ActivateModelPartition(fmi3Instance c, fmi3ValueReference clock, fmi3Float64 time) {
  return (void)c, (void)clock, (void)time, fmi3Error;
}
