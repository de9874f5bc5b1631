/// The processor time of the calling thread: waiting for the processor does not count.
#pragma once

#include <ctime>

/// Since the thread began [us].
inline double processor_time() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}
