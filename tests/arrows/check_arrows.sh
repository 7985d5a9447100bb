#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: check_arrows.sh SOURCE_TREE
#
# Checks which rooms include which: prints file and line of every forbidden #include and fails.
set -u
cd "$1" || exit 1

declare -A may_include=(
  [core]="core"
  [spline]="core spline"
  [valve]="core spline valve"
  [shell]="core spline shell"
  [mesh]="core mesh"
  [flow]="core mesh flow"
  [coupling]="core spline shell mesh flow coupling"
  [output]="core spline shell mesh flow coupling output"
  [scene]="core spline valve shell mesh flow coupling output scene"
  [main]="core scene"
)
n_files=0
n_violations=0

complain() {
  echo "$1: $2"
  n_violations=$((n_violations + 1))
}

room_of() {
  local path=${1#include/semilunar/}
  path=${path#source/}
  if [[ $path == main.cc ]]; then echo main; else echo "${path%%/*}"; fi
}

check_includes() {
  local file=$1 room=$2 line included
  while IFS=: read -r line included; do
    [[ " ${may_include[$room]} " == *" $included "* ]] ||
      complain "$file:$line" "room $room must not include room $included"
  done < <(grep -nE '^[[:space:]]*#[[:space:]]*include' "$file" |
             sed -nE 's|^([0-9]+):.*[<"]semilunar/([a-z_]+)/.*|\1:\2|p')
}

# Every line that matches a pattern is a violation.
forbid() {
  local file=$1 pattern=$2 why=$3 line
  while IFS=: read -r line _; do
    complain "$file:$line" "$why"
  done < <(grep -nE "$pattern" "$file")
}

while read -r file; do
  n_files=$((n_files + 1))
  room=$(room_of "$file")
  if [[ -z ${may_include[$room]:-} ]]; then
    complain "$file" "there is no room $room"
    continue
  fi
  check_includes "$file" "$room"
  forbid "$file" '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' \
    'include headers as <semilunar/ROOM/x.h>: other forms are not checked'
  if [[ $room == shell ]]; then
    forbid "$file" 'deal\.II/(dofs|grid|fe|distributed)/' \
      'the shell must not know DoFHandler, Triangulation or finite elements'
  fi
  if [[ $file != include/semilunar/core/compat.h ]]; then
    forbid "$file" 'DEAL_II_VERSION' 'branches on the deal.II version belong in core/compat.h'
  fi
done < <(find include/semilunar source -name '*.h' -o -name '*.cc' | sort)

if [[ $n_files -eq 0 ]]; then
  echo "there are no source files in $PWD"
  exit 1
fi
echo "$n_files files, $n_violations violations"
[[ $n_violations -eq 0 ]]
