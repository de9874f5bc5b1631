/* An FMU's library at run time, on Linux and Windows. */
#ifndef WRC_TEST_LOAD_H
#define WRC_TEST_LOAD_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

static void* load(const char* path) {
#ifdef _WIN32
  void* library = (void*)LoadLibraryA(path);
#else
  void* library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
#endif
  if (!library) {
    fprintf(stderr, "%s cannot be loaded\n", path);
    exit(2);
  }
  return library;
}

/* Writes the address of a function to a pointer to such functions. */
static void find(void* library, const char* name, void* function) {
#ifdef _WIN32
  FARPROC found = GetProcAddress((HMODULE)library, name);
#else
  void* found = dlsym(library, name);
#endif
  if (!found) {
    fprintf(stderr, "%s is not there\n", name);
    exit(2);
  }
  memcpy(function, &found, sizeof found);
}

#endif
