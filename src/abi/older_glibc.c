/// Lets a library built with a new glibc load with an old one, down to 2.17.
///
/// libstdc++ and libgcc, linked in, call four things that newer versions of glibc brought or moved. They are
/// here, made of what glibc 2.17 has, and seen by this library only. Exceptions need them: creation and the
/// offline solver throw when memory is short. No real-time call comes here. tests/abi/imports.sh lists what
/// the library still asks of its host.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <features.h>
#include <link.h>
#include <pthread.h>
#include <stddef.h>
#include <stdint.h>

#define HIDDEN __attribute__((visibility("hidden")))

#if __GLIBC_PREREQ(2, 32)
/// "Perhaps there are several threads": reference counts are atomic. glibc 2.32 tells whether there is only
/// one.
HIDDEN char __libc_single_threaded = 0;
#endif

#if __GLIBC_PREREQ(2, 34)
// The first symbol version of an architecture's C library.
#if defined(__x86_64__)
#define FIRST_VERSION "GLIBC_2.2.5"
#elif defined(__aarch64__)
#define FIRST_VERSION "GLIBC_2.17"
#else
#error "name this processor's first version of glibc here"
#endif

/// The host's, in its libpthread before 2.34: a process without that library has one thread.
extern int host_pthread_once(pthread_once_t* control, void (*routine)(void)) __attribute__((weak));
__asm__(".symver host_pthread_once, pthread_once@" FIRST_VERSION);

HIDDEN int pthread_once(pthread_once_t* control, void (*routine)(void)) {
  if (host_pthread_once != NULL) return host_pthread_once(control, routine);
  static const pthread_once_t not_yet = PTHREAD_ONCE_INIT;
  if (*control == not_yet) {
    routine();
    *control = 2;  // what glibc leaves there, should its libpthread be loaded later
  }
  return 0;
}

/// Never called: that the name exists tells libgcc that there may be threads, and mutexes are locked.
HIDDEN int __pthread_key_create(pthread_key_t* key, void (*destructor)(void*));
HIDDEN int __pthread_key_create(pthread_key_t* key, void (*destructor)(void*)) {
  (void)key;
  (void)destructor;
  return ENOSYS;
}
#endif

#if __GLIBC_PREREQ(2, 35)
typedef struct {
  uintptr_t address;
  struct dl_find_object* result;
} Search;

/// One loaded object: if the address lies in it, notes where it is and where its unwind table begins, and
/// stops.
static int look_into(struct dl_phdr_info* object, size_t size, void* argument) {
  (void)size;
  Search* search = argument;
  const ElfW(Phdr)* table = NULL;
  uintptr_t start = UINTPTR_MAX, end = 0;
  int inside = 0;
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)* segment = &object->dlpi_phdr[i];
    if (segment->p_type == PT_GNU_EH_FRAME) table = segment;
    if (segment->p_type != PT_LOAD) continue;
    const uintptr_t from = object->dlpi_addr + segment->p_vaddr, to = from + segment->p_memsz;
    if (search->address >= from && search->address < to) inside = 1;
    if (from < start) start = from;
    if (to > end) end = to;
  }
  if (!inside) return 0;
  if (table == NULL) return -1;
  search->result->dlfo_flags = 0;
  search->result->dlfo_map_start = (void*)start;
  search->result->dlfo_map_end = (void*)end;
  search->result->dlfo_link_map = NULL;  // the unwinder does not read it
  search->result->dlfo_eh_frame = (void*)(object->dlpi_addr + table->p_vaddr);
  return 1;
}

/// Where the unwind table of the code at an address is: 0 if found. glibc 2.35 has it without a search.
HIDDEN int _dl_find_object(void* address, struct dl_find_object* result) {
  Search search = {(uintptr_t)address, result};
  return dl_iterate_phdr(look_into, &search) == 1 ? 0 : -1;
}
#endif
