#!/usr/bin/env bash
# What the shared library asks of its host, by name and version: no more than the list beside this file, and nothing
# that glibc 2.17 does not have.
#   imports.sh libwrc.so
# A new line is a new demand on every host: look for what brought it in (link with -Wl,-y,NAME) before it is added.
set -euo pipefail
export LC_ALL=C
library=$1 list=$(dirname "$0")/imports.txt
imports=$(objdump -T "$library" | awk '$0 ~ /\*UND\*/ {version = $(NF - 1); gsub(/[()]/, "", version)
                                                      print $NF, (version ~ /^GLIBC_/ ? version : "-")}' | sort -u)
allowed=$(grep -v '^#' "$list" | sort -u)
new=$(comm -23 <(echo "$imports") <(echo "$allowed"))
if [ -n "$new" ]; then
  echo "$library asks for what $list does not name:"
  echo "$new"
  exit 1
fi
newest=$(echo "$imports" | grep -o 'GLIBC_.*' | sort -Vu | tail -1)
if [ -z "$newest" ] || [ "$(printf '%s\n' GLIBC_2.17 "$newest" | sort -V | tail -1)" != GLIBC_2.17 ]; then
  echo "$library needs ${newest:-no version of glibc}: GLIBC_2.17 is the highest allowed"
  exit 1
fi
echo "$(echo "$imports" | wc -l) imports, none newer than $newest"
