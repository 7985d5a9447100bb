#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: contrib/parameters.sh PROGRAM [--check]
#
# Writes doc/parameters.md from what the program prints about its kinds of scenes; with --check only
# compares.
set -eu
program=$1
reference=$(cd "$(dirname "$0")/.." && pwd)/doc/parameters.md

reference_text() {
  echo "# Parameters"
  echo
  echo "Made by contrib/parameters.sh from the output of \`semilunar --print-parameters\`: change the"
  echo "text in the sources."
  "$program" --list-scenes | sed -n 's/^\([^ ][^:]*\): .*/\1/p' | while read -r kind; do
    echo
    echo "## Scene = $kind"
    echo
    "$program" --print-parameters "$kind" markdown
  done
}

if [[ ${2:-} == --check ]]; then
  diff "$reference" <(reference_text) || {
    echo "doc/parameters.md is out of date: run contrib/parameters.sh $program"
    exit 1
  }
else
  reference_text >"$reference"
fi
