#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: scene_files.sh PROGRAM
#
# Every scene file of the project builds its scene; those that need a surface from a file say so.
set -eu
program=$1
prm=$(cd "$(dirname "$0")/../../prm" && pwd)

failures=0
fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

n_scenes=0
while read -r scene; do
  n_scenes=$((n_scenes + 1))
  code=0
  message=$("$program" "$scene" --dry-run --quiet 2>&1) || code=$?
  if [[ $scene == *-imported.prm ]]; then
    [[ $code -eq 1 && $message == *Surface/File* ]] || fail "$scene: code $code, $message"
  else
    [[ $code -eq 0 ]] || fail "$scene: code $code, $message"
  fi
done < <(find "$prm" -name '*.prm' | sort)

[[ $n_scenes -gt 10 ]] || fail "only $n_scenes scene files were found in $prm"
exit $((failures > 0))
