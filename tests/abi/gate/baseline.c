/* Today's headers and library against the interface of baseline.h: what was there must be there, of the same
 * type, at the same place, with the same value; what is new may be anywhere but in its way. Compiling is most
 * of the test; linking asks for the functions; running asks whether structs of the baseline's size, of the
 * first and of a larger one to come are taken. */
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "wrc/wrc_api.h"
#include "wrc/wrc_experimental_api.h"

#define NUMBER(name, value) _Static_assert(name == value, #name " has another value");
#define COUNT(name, value) _Static_assert(name >= value, #name " has become less");
#define SAME(type, other) __builtin_types_compatible_p(type, other)
#define CALLBACK(name, type) _Static_assert(SAME(name, type), #name " is another function");
#define FIXED(type, size) _Static_assert(sizeof(type) == size, #type " has another size");
#define GROWING(type, size) _Static_assert(sizeof(type) >= size, #type " has shrunk");
#define INITIALISED(type, first, size)
#define MEMBER(type, member, place, of)                                            \
  _Static_assert(offsetof(type, member) == place, #type "." #member " has moved"); \
  _Static_assert(SAME(__typeof__(((type*)0)->member), of), #type "." #member " is of another type");
#define FUNCTION(returned, name, arguments) \
  _Static_assert(SAME(__typeof__(&name), returned(*) arguments), #name " is another function");
#define IN_TABLE(table, name, place)                                                                     \
  _Static_assert(sizeof(void*) != 8 || offsetof(table, name) == place, #table "'s " #name " has moved"); \
  _Static_assert(SAME(__typeof__(((table*)0)->name), __typeof__(&wrc_##name)), #table "'s " #name);
#include "baseline.h"

#ifndef WRC_LAYOUT_ONLY
#undef NUMBER
#undef COUNT
#undef CALLBACK
#undef FIXED
#undef GROWING
#undef INITIALISED
#undef MEMBER
#undef FUNCTION
#undef IN_TABLE
#define NUMBER(name, value)
#define COUNT(name, value)
#define CALLBACK(name, type)
#define FIXED(type, size)
#define MEMBER(type, member, place, of)
#define GROWING(type, size)
#define INITIALISED(type, first, size)                                 \
  wrong += refused(#type, first, (int32_t(*)(void*))type##_init) +     \
           refused(#type, size, (int32_t(*)(void*))type##_init) +      \
           refused(#type, size + 64, (int32_t(*)(void*))type##_init) + \
           taken(#type, first - 8, (int32_t(*)(void*))type##_init);
#define FUNCTION(returned, name, arguments) functions += (void (*)(void))name != NULL;
#define IN_TABLE(table, name, place)

static unsigned char memory[4096];

static int32_t initialised(uint32_t size, int32_t (*init)(void*)) {
  memset(memory, 0xa5, sizeof memory);
  memcpy(memory, &size, sizeof size);
  return init(memory);
}

/* Is a struct of that size refused, or written less or more of? */
static int refused(const char* name, uint32_t size, int32_t (*init)(void*)) {
  const int32_t status = initialised(size, init);
  size_t i = size;
  while (i < sizeof memory && memory[i] == 0xa5) ++i;
  if (status == WRC_OK && i == sizeof memory && memory[size - 1] != 0xa5) return 0;
  printf("%s of %u bytes: %s, written up to byte %u\n", name, (unsigned)size, wrc_status_name(status),
         (unsigned)(i == sizeof memory ? size : i));
  return 1;
}

/* Is a struct smaller than the first taken? */
static int taken(const char* name, uint32_t size, int32_t (*init)(void*)) {
  const int32_t status = initialised(size, init);
  if (status == WRC_ERROR_STRUCT_SIZE && memory[sizeof size] == 0xa5) return 0;
  printf("%s of %u bytes: %s\n", name, (unsigned)size, wrc_status_name(status));
  return 1;
}

int main(void) {
  int wrong = 0, functions = 0;
#include "baseline.h"
  printf("%d functions of the baseline, %d sizes of structs wrong\n", functions, wrong);
  return wrong != 0;
}
#endif
