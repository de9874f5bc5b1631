/* FMI 2.0 over model.h. What wrc_wheel and wrc_wheelset do not have (strings, events, states) answers as the
 * standard says. */
#include <stdlib.h>
#include <string.h>

#include "fmi2Functions.h"
#include "model.h"

#define STATUS(how) ((fmi2Status)(how))

static void say(instance* of, int severity, const char* sentence) {
  fmi2CallbackLogger logger;
  memcpy(&logger, &of->logger, sizeof logger);
  if (logger && (of->logging || severity == WRONG))
    logger(of->environment, of->name, STATUS(severity),
           severity == WRONG ? "logStatusError" : "logStatusDiscard", "%s", sentence);
}

const char* fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char* fmi2GetVersion(void) { return fmi2Version; }

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions* functions, fmi2Boolean visible,
                              fmi2Boolean logging) {
  (void)visible;
  instance* of = model_new(guid, resources);
  if (!of || (of->kind == WHEEL) != (type == fmi2ModelExchange)) {
    model_free(of);
    return NULL;
  }
  const size_t length = strlen(name ? name : "") + 1;
  char* kept = malloc(length);
  if (!kept) {
    model_free(of);
    return NULL;
  }
  of->name = memcpy(kept, name ? name : "", length);
  of->say = say;
  of->logging = logging;
  if (functions) {
    memcpy(&of->logger, &functions->logger, sizeof of->logger);
    of->environment = functions->componentEnvironment;
  }
  return of;
}

void fmi2FreeInstance(fmi2Component c) {
  instance* of = c;
  if (of) free((char*)of->name);
  model_free(of);
}

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t count, const fmi2String names[]) {
  (void)count, (void)names;
  ((instance*)c)->logging = on;
  return fmi2OK;
}

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real start,
                               fmi2Boolean has_stop, fmi2Real stop) {
  (void)has_tolerance, (void)tolerance, (void)has_stop, (void)stop;
  ((instance*)c)->now.time = start;
  return fmi2OK;
}
fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
  ((instance*)c)->initialising = 1;
  return fmi2OK;
}
fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
  instance* of = c;
  const outcome how = of->model ? FINE : model_start(of);
  of->initialising = 0;
  return STATUS(how);
}
fmi2Status fmi2Terminate(fmi2Component c) {
  (void)c;
  return fmi2OK;
}
fmi2Status fmi2Reset(fmi2Component c) {
  model_reset(c);
  return fmi2OK;
}

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t count, fmi2Real value[]) {
  return STATUS(model_get_real(c, vr, count, value));
}
fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t count, const fmi2Real value[]) {
  return STATUS(model_set_real(c, vr, count, value));
}
fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t count, fmi2Integer value[]) {
  return STATUS(model_get_integer(c, vr, count, value));
}
fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t count,
                          const fmi2Integer value[]) {
  return STATUS(model_set_integer(c, vr, count, value));
}
/* There are no variables of these types. */
fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t count, fmi2Boolean value[]) {
  return (void)c, (void)vr, (void)value, count ? fmi2Error : fmi2OK;
}
fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t count,
                          const fmi2Boolean value[]) {
  return (void)c, (void)vr, (void)value, count ? fmi2Error : fmi2OK;
}
fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference vr[], size_t count, fmi2String value[]) {
  return (void)c, (void)vr, (void)value, count ? fmi2Error : fmi2OK;
}
fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference vr[], size_t count,
                         const fmi2String value[]) {
  return (void)c, (void)vr, (void)value, count ? fmi2Error : fmi2OK;
}

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate* state) {
  if (!*state) *state = malloc(sizeof(saved));
  if (!*state) return fmi2Error;
  model_save(c, *state);
  return fmi2OK;
}
fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
  return state ? STATUS(model_restore(c, state)) : fmi2Error;
}
fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate* state) {
  (void)c;
  if (state) {
    free(*state);
    *state = NULL;
  }
  return fmi2OK;
}
fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t* size) {
  (void)c, (void)state;
  *size = sizeof(saved);
  return fmi2OK;
}
fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
  (void)c;
  if (!state || size < sizeof(saved)) return fmi2Error;
  memcpy(bytes, state, sizeof(saved));
  return fmi2OK;
}
fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size,
                                   fmi2FMUstate* state) {
  saved read;
  if (size != sizeof read) return fmi2Error;
  memcpy(&read, bytes, sizeof read);
  if (model_valid(c, &read) != FINE || fmi2GetFMUstate(c, state) != fmi2OK) return fmi2Error;
  memcpy(*state, &read, sizeof read);
  return fmi2OK;
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference unknowns[],
                                        size_t unknown_count, const fmi2ValueReference knowns[],
                                        size_t known_count, const fmi2Real seed[], fmi2Real sensitivity[]) {
  return STATUS(model_derivatives(c, 0, unknowns, unknown_count, knowns, known_count, seed, sensitivity));
}

/* Model exchange, of a model without states and events. */
fmi2Status fmi2EnterEventMode(fmi2Component c) { return (void)c, fmi2OK; }
fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo* info) {
  (void)c;
  memset(info, 0, sizeof *info);
  return fmi2OK;
}
fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c) { return (void)c, fmi2OK; }
fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean no_return, fmi2Boolean* event,
                                       fmi2Boolean* end) {
  (void)c, (void)no_return;
  *event = *end = fmi2False;
  return fmi2OK;
}
fmi2Status fmi2SetTime(fmi2Component c, fmi2Real time) {
  ((instance*)c)->now.time = time;
  return fmi2OK;
}
fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real x[], size_t count) {
  return (void)c, (void)x, count ? fmi2Error : fmi2OK;
}
fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real derivatives[], size_t count) {
  return (void)c, (void)derivatives, count ? fmi2Error : fmi2OK;
}
fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real indicators[], size_t count) {
  return (void)c, (void)indicators, count ? fmi2Error : fmi2OK;
}
fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real x[], size_t count) {
  return (void)c, (void)x, count ? fmi2Error : fmi2OK;
}
fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real x[], size_t count) {
  return (void)c, (void)x, count ? fmi2Error : fmi2OK;
}

/* Co-simulation: a step is done when it returns. */
fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real length, fmi2Boolean no_return) {
  (void)no_return;
  return STATUS(model_step(c, time, length));
}
fmi2Status fmi2CancelStep(fmi2Component c) { return (void)c, fmi2Error; }
fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t count,
                                       const fmi2Integer order[], const fmi2Real value[]) {
  return (void)c, (void)vr, (void)order, (void)value, count ? fmi2Error : fmi2OK;
}
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t count,
                                        const fmi2Integer order[], fmi2Real value[]) {
  return (void)c, (void)vr, (void)order, (void)value, count ? fmi2Error : fmi2OK;
}
fmi2Status fmi2GetStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Status* value) {
  return (void)c, (void)kind, *value = fmi2OK, fmi2OK;
}
fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Real* value) {
  *value = ((const instance*)c)->now.time;
  return kind == fmi2LastSuccessfulTime ? fmi2OK : fmi2Discard;
}
fmi2Status fmi2GetIntegerStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Integer* value) {
  return (void)c, (void)kind, *value = 0, fmi2Discard;
}
fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Boolean* value) {
  return (void)c, *value = fmi2False, kind == fmi2Terminated ? fmi2OK : fmi2Discard;
}
fmi2Status fmi2GetStringStatus(fmi2Component c, const fmi2StatusKind kind, fmi2String* value) {
  return (void)c, (void)kind, *value = "", fmi2Discard;
}
