#!/usr/bin/env bash
# Runs a program of googletest with the suites that these files define.
#   suites.sh PROGRAM SKIPPED FILE...     but for SKIPPED, tests by gtest's pattern; fails if no test ran
#   suites.sh PROGRAM --left FILE...      fails if the program has tests that none of the files defines
set -euo pipefail
program=$1 skipped=$2
suites=$(sed -nE 's/^(TYPED_)?TEST(_[FP])?\((\w+),.*/\3/p' "${@:3}" | sort -u)
[ -n "$suites" ] || { echo "WRONG: no tests in ${*:3}"; exit 1; }
filter=$(printf '%s.*:*/%s.*:' $(sed 's/.*/& &/' <<<"$suites"))
if [ "$skipped" = --left ]; then
  ! "$program" --gtest_list_tests --gtest_filter="-$filter" | grep '^  '
else
  said=$(mktemp)
  trap 'rm -f "$said"' EXIT
  "$program" --gtest_brief=1 --gtest_filter="$filter-$skipped" | tee "$said"
  ! grep -q '\] 0 tests' "$said" || { echo "WRONG: no test ran"; exit 1; }
fi
