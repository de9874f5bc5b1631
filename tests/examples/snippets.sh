#!/usr/bin/env bash
# Pieces of C in the manuals compile as they stand, and those of C++ in the bindings' manual; README's whole program has a test of
# its own. What a piece takes for given is declared before it here.
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
# the example at the top of the C++ header
sed -n '/^ \* @code$/,/^ \* @endcode$/{/code$/d;s/^ \* \{0,3\}//p}' "$source/bindings/cpp/wrc/wrc.hpp" >"$folder/top"
{ echo '#include "wrc/wrc.hpp"'; echo 'void use(double area, double pressure); int main() {'; cat "$folder/top"; echo 'return wrench.flag.value();'; echo '}'; } >"$folder/top.cpp"
c++ -std=c++17 -Wall -Wextra -Werror -fsyntax-only -I"$source/include_c" -I"$source/bindings/cpp" "$folder/top.cpp"
[ "$count" -ge 6 ] || { echo "$count pieces found: the search does not see what it should"; exit 1; }
echo "$count pieces of C and one of C++ compile"
