#!/usr/bin/env bash
# Misspelt words of texts and comments, by codespell (PyPI or Debian); the field's words are in WORDS. Status 77 without codespell.
set -euo pipefail
cd "$(dirname "$0")/../.."
WORDS=tread,cant,inout,nknown,methd,presure,hertzs,numer,statics,trough
codespell=build/venv/bin/codespell
[ -x "$codespell" ] || codespell=$(command -v codespell) || { echo "skipped: no codespell"; exit 77; }
git ls-files '*.md' '*.h' '*.hpp' '*.cpp' '*.c' '*.py' '*.pyi' '*.sh' '*.toml' '*.yaml' '*.json' '*.txt' '*.cmake' '*.f90' '*.f' '*.css' |
  xargs "$codespell" --ignore-words-list "$WORDS"
