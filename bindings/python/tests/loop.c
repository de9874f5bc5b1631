/* What calls of the library cost from C, for overhead.py: seconds of `repeats` loops over contacts. */
#define _POSIX_C_SOURCE 199309L
#include <stdint.h>
#include <time.h>

typedef int32_t (*call)(void*, const void*, void*);
typedef int32_t (*batch)(void* const*, uint32_t, const void*, uint64_t, void*, uint64_t, int32_t*);

/* Of this thread: what others take from the processor does not count. */
static double now(void) {
  struct timespec at;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &at);
  return (double)at.tv_sec + 1e-9 * (double)at.tv_nsec;
}

double loop_seconds(void* function, void** contacts, int32_t count, const void* input, void* output,
                    int32_t repeats) {
  const call one = (call)(uintptr_t)function;
  const double start = now();
  for (int32_t k = 0; k < repeats; ++k)
    for (int32_t i = 0; i < count; ++i) one(contacts[i], input, output);
  return now() - start;
}

double batch_seconds(void* function, void** contacts, int32_t count, const void* inputs,
                     uint64_t input_stride, void* outputs, uint64_t output_stride, int32_t* statuses,
                     int32_t repeats) {
  const batch all = (batch)(uintptr_t)function;
  const double start = now();
  for (int32_t k = 0; k < repeats; ++k)
    all(contacts, (uint32_t)count, inputs, input_stride, outputs, output_stride, statuses);
  return now() - start;
}
