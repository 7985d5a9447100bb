#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: contrib/run.sh [SCENE.prm] [options]
#
# Installs what is missing, builds the program and runs a scene. Without a scene, a heart valve opens
# in flowing blood (a few minutes on two cores), and a picture of it is made.
# Options are those of the program; contrib/run.sh --help prints them.
set -eu
source "$(dirname "$0")/prepare.sh"

prepare semilunar
for argument in "$@"; do
  if [[ $argument == *.prm && $argument != *=* || $argument == --help || $argument == --version ||
        $argument == --list-scenes || $argument == --print-parameters ]]; then
    say "semilunar $*"
    exec "$build/semilunar" "$@"
  fi
done

results=$root/results/quickstart
ranks=$(($(nproc) < 4 ? $(nproc) : 4))
say "mpiexec -n $ranks semilunar prm/valve/quickstart.prm $*"
DEAL_II_NUM_THREADS=1 mpiexec -n "$ranks" "$build/semilunar" "$root/prm/valve/quickstart.prm" \
  --output "$results" "$@"
if [[ -e $results/summary.json ]]; then
  "$root/contrib/pictures.sh" "$results" --field mipe --view oblique --out "$results/valve.png"
  say "the valve: $results/valve.png"
fi
