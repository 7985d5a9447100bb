#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: run_folder.sh PROGRAM
#
# What a static run leaves in its folder: at its end, when run again from its parameters, and when
# it is stopped half-way.
source "$(dirname "$0")/expect.sh"

cat >strip.prm <<'END_PRM'
set Scene = shell statics
subsection Surface
  set Source   = quadrilateral
  set Degree   = 3
  set Elements = 6, 4
end
subsection Shell
  set Material  = Fung
  set Thickness = 0.1
end
subsection Supports
  set Supports = clamp x=0
end
subsection Loads
  set Edge loads = x=1: (0, 0, 1000)
end
subsection Solver
  set Method     = Newton
  set Load steps = 50
end
subsection Output
  set Probes = tip: (1, 0.5, 0)
end
END_PRM

n_rows() { tail -n +2 "$1/timeseries.csv" | wc -l; }
n_states() { find "$1" -name 'shell-*.vtu' | wc -l; }

# One row and one file for each accepted step, and a file before the first.
expect_steps() {
  local steps=$2 file
  [[ $(n_rows "$1") -eq $steps ]] || failed "$1: $(n_rows "$1") rows of $steps steps"
  [[ $(n_states "$1") -eq $((steps + 1)) ]] || failed "$1: $(n_states "$1") states of $steps steps"
  [[ $(grep -c '<DataSet' "$1/shell.pvd") -eq $((steps + 1)) ]] || failed "$1: collection"
  for file in "$1"/*.vtu "$1"/*.pvd; do
    [[ $(tail -n 1 "$file") == '</VTKFile>' ]] || failed "$file is torn"
  done
  [[ -z $(find "$1" -name '*.part') ]] || failed "$1 holds unfinished files"
  awk -F, 'NR == 1 { n = NF } NF != n { exit 1 }' "$1/timeseries.csv" || failed "$1: torn row"
}

# A whole run, and the same from its parameters.
expect 0 'done in' strip.prm --output strip
steps=$(grep -c '^step ' out)
[[ $steps -gt 3 ]] || failed "only $steps steps"
expect_steps strip "$steps"
[[ $(sed -n 's/.*"steps": \([0-9]*\).*/\1/p' strip/summary.json) -eq $steps ]] ||
  failed "another number of steps in the summary"
[[ $(tail -n 1 strip/timeseries.csv) == 1,* ]] || failed "the last row is not that of the full load"
expect 0 'done in' strip/parameters.prm --output again
cmp -s <(quantities strip) <(quantities again) || failed "another summary from parameters.prm"
cmp -s strip/timeseries.csv again/timeseries.csv || failed "another time series"
for file in strip/*.vtu; do
  cmp -s "$file" "again/${file#*/}" || failed "another $file from parameters.prm"
done

# A run that is stopped after some steps; a test of nothing if it ends by itself.
"$program" strip.prm --output stopped --set "Surface/Elements=30, 30" >out 2>err &
run=$!
while kill -0 $run 2>/dev/null; do
  [[ -e stopped/timeseries.csv && $(n_rows stopped) -ge 2 ]] && break
  sleep 0.05
done
kill -TERM $run
code=0
wait $run || code=$?
[[ $code -eq 2 ]] || failed "a stopped run ends with $code, not 2"
[[ $(wc -l <err) -eq 1 ]] && grep -q 'interrupted' err || failed "the run does not say it was stopped"
expect_steps stopped "$(grep -c '^step ' out)"
[[ $(n_rows stopped) -ge 2 ]] || failed "no steps before the signal"
[[ -e stopped/summary.json ]] && failed "a stopped run wrote a summary"
cat err

finish
