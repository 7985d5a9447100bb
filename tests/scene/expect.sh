# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Sourced by the scripts of this folder, whose first argument is the program and whose last line
# calls `finish`. They run in an empty folder.
set -u
program=$(realpath "$1")
whole_program=$program
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
n_failures=0

# mpiexec refuses root, as in containers, unless told twice, and more ranks than cores.
if [[ $EUID -eq 0 ]]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi
export OMPI_MCA_rmaps_base_oversubscribe=1
command -v ssh >/dev/null || export OMPI_MCA_plm_rsh_agent=

failed() {
  echo "FAILED: $1"
  [[ -e err ]] && sed 's/^/    /' err
  n_failures=$((n_failures + 1))
}

# expect CODE TEXT ARGUMENT...: the program ends with this code; its only line on standard error
# (none if CODE is 0) holds the text, otherwise standard output does.
expect() {
  local code=$1 text=$2 stream=err lines=1 actual=0
  shift 2
  [[ $code -eq 0 ]] && stream=out && lines=0
  "$program" "$@" >out 2>err </dev/null || actual=$?
  [[ $actual -eq $code ]] || failed "$* ends with $actual, not $code"
  [[ $(wc -l <err) -eq $lines ]] || failed "$* prints $(wc -l <err) lines on standard error"
  [[ -z $text ]] || grep -qF -- "$text" $stream || failed "$* does not say '$text'"
}

# on_ranks N: from here on the program runs on that many ranks, by $mpiexec.
on_ranks() {
  program=$whole_program
  [[ $1 -eq 1 ]] && return
  program=$folder/on_$1_ranks
  printf '#!/bin/bash\nexec "%s" -n %d "%s" "$@"\n' "$mpiexec" "$1" "$whole_program" >"$program"
  chmod +x "$program"
}

# quantities RUN: the quantities in the summary of a run, one per line as it wrote them.
quantities() { sed -n '/"quantities"/,/^  }/p' "$1/summary.json"; }

# quantity RUN NAME: the value.
quantity() { quantities "$1" | sed -n "s/.*\"$2\": {\"value\": \([^,]*\),.*/\1/p"; }

# expect_between RUN NAME LOW HIGH: the quantity lies there; print it.
expect_between() {
  local value
  value=$(quantity "$1" "$2")
  printf '%-20s %-34s %.6g\n' "$1" "$2" "${value:-nan}"
  awk -v v="$value" -v l="$3" -v h="$4" 'BEGIN { exit !(v != "" && v + 0 >= l && v + 0 <= h) }' ||
    failed "$1: $2 = '$value' does not lie between $3 and $4"
}

finish() {
  echo "$n_failures failures"
  [[ $n_failures -eq 0 ]]
}
