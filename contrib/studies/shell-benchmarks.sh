#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: contrib/studies/shell-benchmarks.sh [--iga FOLDER]
#
# Builds the program and prints the tables of doc/results/shell-benchmarks.md,
# large-displacements.md and hard-shells.md and draws their plots; with --iga also those
# on the surfaces from .iga files in the folder.
set -eu
source "$(dirname "$0")/../prepare.sh"

packages+=(python3)
prepare semilunar
export PYTHONDONTWRITEBYTECODE=1
"$build/semilunar" --version
for study in linear_shells hyperelastic large_displacements hard_shells; do
  echo
  /usr/bin/python3 "$root/contrib/studies/$study.py" "$build/semilunar" "$@"
done
