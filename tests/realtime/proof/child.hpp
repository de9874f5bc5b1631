/// Runs something in a child process that the kernel kills at its first system call.
#pragma once

#include <cstdint>

/// What a child leaves behind for its parent, in memory both see.
struct Record {
  long steps = 0, failed_calls = 0, heap_calls = 0, minor_faults = 0, major_faults = 0;
};

enum class End { good, system_call, trap, cannot_filter, failed };

/// From here on the kernel allows this process write, exit and getrusage of the calling thread, and kills it
/// at anything else. False where it does not let a process filter itself.
bool forbid_system_calls();

/// Page faults of this thread so far, into the record with a minus sign or a plus.
void count_faults(Record& record, int sign);

/// Forks, runs work(context, record) in the child, waits. The child calls forbid_system_calls() itself, when
/// ready.
End in_child(void (*work)(void* context, Record& record), void* context, Record& record);
