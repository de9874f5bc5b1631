#!/usr/bin/env bash
# Pieces of C in the manuals and in the headers compile as they stand, and those of C++ in the bindings' manual; README's whole
# program has a test of its own. What a piece takes for given is declared before it here.
#   snippets.sh source_directory
set -euo pipefail
source=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
count=0
for page in "$source"/docs/*.md; do
  awk -v to="$folder/$(basename "$page" .md)" '/^```c$/ {file = to "_" ++n ".piece"; printf "" > file; next}
                                               /^```/ {file = ""} file {print > file}' "$page"
done
for piece in "$folder"/*.piece; do
  {
    echo '#include "wrc/wrc_api.h"'
    echo '#include "wrc/wrc_profiles.h"'
    echo 'void use(double value); void complain(const char* text);'
    echo 'void piece(wrc_config config, wrc_contact* contact, wrc_wrench wrench, void* memory, double y, double z, double roll, double yaw, double speed, double radius, double roll_rate, double yaw_rate);'
    echo 'void piece(wrc_config config, wrc_contact* contact, wrc_wrench wrench, void* memory, double y, double z, double roll, double yaw, double speed, double radius, double roll_rate, double yaw_rate) {'
    echo '  (void)config, (void)contact, (void)wrench, (void)memory, (void)y, (void)z, (void)roll, (void)yaw, (void)speed, (void)radius, (void)roll_rate, (void)yaw_rate;'
    echo '  {'
    cat "$piece"
    echo '  }'
    echo '}'
  } >"$folder/piece.c"
  cc -std=c99 -Wall -Wextra -Wno-unused-variable -Wno-unused-but-set-variable -Werror -fsyntax-only -I"$source/include_c" "$folder/piece.c" ||
    { echo "in $(basename "$piece")"; exit 1; }
  count=$((count + 1))
done
# those of a C header together, in their order; "..." stands for what a host does with a failure
for header in wrc wrc_damage wrc_surface; do
  {
    echo '#include "wrc/wrc_damage.h"'
    echo '#include "wrc/wrc_surface.h"'
    echo 'void piece(wrc_contact* contact, wrc_wheel_input input, wrc_wrench wrench, wrc_friction dry, double* values, double x, double v, double dt, double arc, double radius);'
    echo 'void piece(wrc_contact* contact, wrc_wheel_input input, wrc_wrench wrench, wrc_friction dry, double* values, double x, double v, double dt, double arc, double radius) {'
    echo '  double y = 0, z = 0, roll = 0, yaw = 0, dy_dt = 0, dz_dt = 0, droll_dt = 0, dyaw_dt = 0, r0 = 0.46, force[3] = {0}, moment[3] = {0}; int side, i; char why[300];'
    echo '  (void)contact, (void)input, (void)wrench, (void)dry, (void)values, (void)x, (void)v, (void)dt, (void)arc, (void)radius, (void)y, (void)z, (void)roll, (void)yaw, (void)dy_dt, (void)dz_dt, (void)droll_dt, (void)dyaw_dt, (void)r0, (void)force, (void)moment, (void)side, (void)i, (void)why;'
    echo '  {'
    sed -n '/^ \* @code$/,/^ \* @endcode$/{/code$/d;s/^ \* \{0,3\}//;s/ \.\.\.$/ return;/;p}' "$source/include_c/wrc/$header.h"
    echo '  }'
    echo '}'
  } >"$folder/piece.c"
  [ "$(wc -l <"$folder/piece.c")" -gt 15 ] || { echo "no example in $header.h"; exit 1; }
  cc -std=c99 -Wall -Wextra -Wno-unused-variable -Wno-unused-but-set-variable -Werror -Wno-missing-field-initializers -fsyntax-only \
    -I"$source/include_c" "$folder/piece.c" || { echo "in $header.h"; exit 1; }
  count=$((count + 1))
done
# the example at the top of the C++ header
sed -n '/^ \* @code$/,/^ \* @endcode$/{/code$/d;s/^ \* \{0,3\}//p}' "$source/bindings/cpp/wrc/wrc.hpp" >"$folder/top"
{ echo '#include "wrc/wrc.hpp"'; echo 'void use(double area, double pressure); int main() {'; cat "$folder/top"; echo 'return wrench.flag.value();'; echo '}'; } >"$folder/top.cpp"
c++ -std=c++17 -Wall -Wextra -Werror -fsyntax-only -I"$source/include_c" -I"$source/bindings/cpp" "$folder/top.cpp"
[ "$count" -ge 6 ] || { echo "$count pieces found: the search does not see what it should"; exit 1; }
echo "$count pieces of C and one of C++ compile"
