#!/usr/bin/env bash
# The public headers, each alone, and the examples under every language standard a host may use, with the strictest warnings of
# gcc, clang, mingw, and of clang in the place of Microsoft's compiler, whose standard headers are declared here.
#   header_matrix.sh include_directory [examples_directory]
set -euo pipefail
include=$1
examples=${2:-}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
strict=(-Wall -Wextra -Wpedantic -Wconversion -Werror)

# What Microsoft's standard headers declare, as far as the headers and examples use it. The examples may need no more.
standard_headers() {
  local to=$1
  mkdir "$to"
  cat >"$to/stddef.h" <<'END'
#pragma once
typedef unsigned long long size_t;
#ifdef __cplusplus
#define NULL 0
#else
#define NULL ((void*)0)
#endif
#define offsetof(type, member) __builtin_offsetof(type, member)
END
  cat >"$to/stdint.h" <<'END'
#pragma once
typedef int int32_t;
typedef unsigned int uint32_t;
typedef long long int64_t;
typedef unsigned long long uint64_t, uintptr_t;
END
  cat >"$to/string.h" <<'END'
#pragma once
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif
void* memset(void*, int, size_t);
void* memcpy(void*, const void*, size_t);
void* memmove(void*, const void*, size_t);
size_t strlen(const char*);
size_t strspn(const char*, const char*);
size_t strcspn(const char*, const char*);
char* strpbrk(const char*, const char*);
int strcmp(const char*, const char*);
int strncmp(const char*, const char*, size_t);
char* strchr(const char*, int);
char* strerror(int);
#ifdef __cplusplus
}
#endif
END
  cat >"$to/stdio.h" <<'END'
#pragma once
#include <stddef.h>
typedef struct FILE FILE;
FILE* __stream(unsigned);
#define stdout __stream(1)
#define stderr __stream(2)
int printf(const char*, ...);
int fprintf(FILE*, const char*, ...);
int remove(const char*);
int snprintf(char*, size_t, const char*, ...);
int sscanf(const char*, const char*, ...);
#define EOF (-1)
int puts(const char*);
int fputs(const char*, FILE*);
int fgetc(FILE*);
char* fgets(char*, int, FILE*);
FILE* fopen(const char*, const char*);
int fclose(FILE*);
int fflush(FILE*);
END
  cat >"$to/stdlib.h" <<'END'
#pragma once
#include <stddef.h>
__declspec(noreturn) void exit(int);
#define EXIT_SUCCESS 0
#define EXIT_FAILURE 1
void* malloc(size_t);
void* calloc(size_t, size_t);
void free(void*);
double atof(const char*);
int atoi(const char*);
double strtod(const char*, char**);
void qsort(void*, size_t, size_t, int (*)(const void*, const void*));
END
  cat >"$to/math.h" <<'END'
#pragma once
#define NAN __builtin_nanf("")
double fabs(double), fmax(double, double), fmin(double, double), sin(double), cos(double), tan(double), atan(double), sqrt(double),
    log(double), hypot(double, double), copysign(double, double), pow(double, double), fmod(double, double), floor(double), ceil(double),
    exp(double), atan2(double, double);
END
  printf '#pragma once\n#include <stdlib.h>\nint isspace(int);\nint isdigit(int);\n' >"$to/ctype.h"
  printf '#pragma once\nint* _errno(void);\n#define errno (*_errno())\n' >"$to/errno.h"
  printf '#pragma once\ntypedef long clock_t;\ntypedef long long time_t;\nclock_t clock(void);\n#define CLOCKS_PER_SEC 1000\n' >"$to/time.h"
  cat >"$to/windows.h" <<'END'
#pragma once
typedef struct HINSTANCE__* HMODULE;
typedef long long (*FARPROC)(void);
HMODULE LoadLibraryA(const char*);
FARPROC GetProcAddress(HMODULE, const char*);
unsigned long GetLastError(void);
int FreeLibrary(HMODULE);
END
}

# Clang with the options and the extensions of Microsoft's compiler.
microsoft() { # STANDARD FILE
  clang --driver-mode=cl --target=x86_64-pc-windows-msvc /nologo /Zs /W4 /WX -Wvla -Wgnu /D__attribute__=no_word_of_theirs "-imsvc$scratch/standard" "/std:$1" "-I$include" -- "$2"
}

# every FILE.c FILE.cpp NAME: both under all standards of all compilers.
every() {
  local cc cxx pair standard
  for pair in gcc:g++ clang:clang++ x86_64-w64-mingw32-gcc:x86_64-w64-mingw32-g++; do
    cc=${pair%%:*} cxx=${pair##*:}
    command -v "$cc" >/dev/null || continue
    for standard in c99 c11 c17 c2x; do
      "$cc" -std=$standard "${strict[@]}" -I"$include" -fsyntax-only "$1"
    done
    for standard in c++98 c++11 c++14 c++17 c++20 c++2b; do
      "$cxx" -std=$standard "${strict[@]}" -I"$include" -fsyntax-only "$2"
    done
    echo "$3 $cc, C99 to C2x and C++98 to C++2b"
  done
  command -v clang >/dev/null || return 0
  for standard in c11 c17; do microsoft $standard "$1"; done
  for standard in c++14 c++17 c++20 c++latest; do microsoft $standard "$2"; done
  echo "$3 as Microsoft's compiler reads it, C11 to C17 and C++14 to the latest"
}

for cc in gcc clang x86_64-w64-mingw32-gcc; do
  command -v "$cc" >/dev/null || echo "left out: $cc is not installed"
done
standard_headers "$scratch/standard"
for header in "$include"/wrc/*.h; do
  name="wrc/$(basename "$header")"
  printf '#include "%s"\n#include "%s"\nint main(void) { return 0; }\n' "$name" "$name" >"$scratch/main.c"
  cp "$scratch/main.c" "$scratch/main.cpp"
  every "$scratch/main.c" "$scratch/main.cpp" "$name"
done

# The examples are C99 and need the standard library alone; gcc and clang compile them in their builds.
[ -n "$examples" ] || exit 0
for example in "$examples"/*.c; do
  name=$(basename "$example") needs=
  while read -r header; do
    [ "$header" = dlfcn.h ] || [ -e "$scratch/standard/$header" ] || needs="$needs $header"
  done < <(sed -nE 's/^#include <(.*)>.*/\1/p' "$example")
  if [ -n "$needs" ]; then
    echo "$name left out on Windows: it needs$needs"
    continue
  fi
  ! command -v x86_64-w64-mingw32-gcc >/dev/null || x86_64-w64-mingw32-gcc -std=c99 -Wall -Wextra -Werror -I"$include" -fsyntax-only "$example"
  ! command -v clang >/dev/null || microsoft c11 "$example"
  echo "$name on Windows"
done
