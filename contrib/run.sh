#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: contrib/run.sh [SCENE.prm] [options]
#
# Installs what is missing, builds the program and runs a scene: the closing valve if none is named.
# Options are those of the program; contrib/run.sh --help prints them.
set -eu
source "$(dirname "$0")/prepare.sh"

scene=("$root/prm/valve/closure.prm")
for argument in "$@"; do
  [[ $argument == *.prm && $argument != *=* ]] && scene=()
done

prepare semilunar
say "semilunar ${scene[*]} $*"
exec "$build/semilunar" "${scene[@]}" "$@"
