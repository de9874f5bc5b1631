/// The program's own malloc, which the shared library finds first: counts calls and living blocks, and fails
/// on demand.
#pragma once

/// Calls of malloc, calloc, realloc, free and the aligned ones so far.
long heap_calls();
/// Blocks allocated and not yet freed.
long living_blocks();
/// Lets the n-th allocation from now on return no memory; 0: none. The others succeed.
void fail_allocation(long n);
/// Has the allocation asked for failed yet?
bool allocation_failed();
