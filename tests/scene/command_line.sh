#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: command_line.sh PROGRAM
#
# What the program says and returns to its caller: exit codes, one line on standard error, formats.
source "$(dirname "$0")/expect.sh"

cat >plate.prm <<'END'
set Scene = geometry
subsection Surface
  set Elements = 2, 3
end
END

# Good input.
expect 0 'usage: semilunar' --help
expect 0 'deal.II' --version
expect 0 'geometry:' --list-scenes
expect 0 'surface: 6 elements' plate.prm
for file in parameters.prm summary.json timeseries.csv surface.iga surface.vtu surface.pvd; do
  [[ -s results/plate/$file ]] || failed "the run wrote no $file"
done
expect 0 'surface: 6 elements' results/plate/parameters.prm --output again
cmp -s results/plate/surface.iga again/surface.iga || failed "parameters.prm gives another surface"
cmp -s results/plate/parameters.prm again/parameters.prm || failed "parameters.prm is not stable"
expect 0 'surface: 9 elements' plate.prm --set "Surface/Elements=3, 3"
expect 0 'nothing was written' plate.prm --dry-run --output dry
[[ -e dry ]] && failed "a dry run wrote files"
expect 0 '' plate.prm --quiet
[[ -s out ]] && failed "--quiet prints on standard output"

# Formats of the parameters: the first is a valid scene file, the second JSON.
expect 0 'set Scene' --print-parameters geometry
cp out printed.prm
expect 0 'surface: 64 elements' printed.prm
expect 0 '"Scale factor"' --print-parameters geometry json
cat >check.cmake <<'END'
string(JSON default GET "${JSON}" Surface "Scale factor" default_value)
if(NOT default STREQUAL "1")
  message(FATAL_ERROR "the default is ${default}")
endif()
END
cmake -DJSON="$(cat out)" -P check.cmake 2>err || failed "no valid JSON"
cat >check.cmake <<'END'
string(JSON value GET "${JSON}" quantities elements value)
string(JSON memory GET "${JSON}" cost peak_memory_mib)
if(NOT value EQUAL 6 OR NOT memory GREATER 0)
  message(FATAL_ERROR "elements: ${value}, memory: ${memory}")
endif()
END
cmake -DJSON="$(cat again/summary.json)" -P check.cmake 2>err || failed "no valid summary"
expect 0 '| Scale factor | `1` |' --print-parameters geometry markdown

# Arguments.
expect 1 'there is no scene file'
expect 1 "did you mean '--dry-run'?" --dry-rnu plate.prm
expect 1 'one scene file' plate.prm plate.prm
expect 1 'is missing' plate.prm --set
expect 1 "did you mean 'geometry'?" --print-parameters geometri
expect 1 "'markdown'" --print-parameters geometry xml
expect 1 'give a folder' plate.prm --output plate.prm
expect 1 'not from a run' plate.prm --output .

# Scene files and entries.
expect 1 "did you mean 'plate.prm'?" plat.prm
expect 1 'is a directory' .
expect 1 "did you mean 'Elements'?" plate.prm --set "Surface/Element=3, 3"
expect 1 "did you mean 'Surface'?" plate.prm --set "Surfaces/Elements=3, 3"
expect 1 "did you mean 'geometry'?" plate.prm --set Scene=geometrie
expect 1 'a number greater than 0' plate.prm --set "Surface/Scale factor=0"
expect 1 'a number greater than 0' plate.prm --set "Surface/Scale factor=1cm"
expect 1 'a number greater than 0' plate.prm --set "Surface/Scale factor=nan"
expect 1 '--set, Surface/Degree = "2": is too small' plate.prm \
  --set Surface/Source=cylinder --set Surface/Degree=2 --set "Surface/Cylinder/Angles=0, 170"
expect 1 'give the smaller number first' plate.prm \
  --set Surface/Source=sphere --set "Surface/Sphere/Latitudes=9, 9"
expect 1 'the weight of control point 3 is not positive' plate.prm --set Surface/Source=nurbs \
  --set "Surface/NURBS/Control net=0,0,0,1; 1,0,0,1; 0,1,0,1; 1,1,0,-1"
echo 'set Degree = 3' >bad.prm
expect 1 'bad.prm: the kind of scene is not set' bad.prm
printf 'set Scene = geometry\nsubsection Surface\n  set Sorce = sphere\nend\n' >bad.prm
expect 1 "bad.prm:3, Surface/Sorce = \"sphere\": there is no such entry; did you mean 'Source'?" bad.prm

# Surface files.
iga=again/surface.iga
expect 0 'surface: 6 elements' plate.prm --set Surface/Source=iga --set Surface/File=$iga --output iga
cmp -s $iga iga/surface.iga || failed "an .iga file changes when it is read and written"
expect 1 'Surface/File: is not set' plate.prm --set Surface/Source=iga
expect 1 'no.iga' plate.prm --set Surface/Source=iga --set Surface/File=no.iga
head -c $(($(wc -c <$iga) / 2)) $iga >truncated.iga
expect 1 'truncated.iga:' plate.prm --set Surface/Source=iga --set Surface/File=truncated.iga
sed '0,/^node /s/^node [^ ]*/node nan/' $iga >nan.iga
expect 1 'not finite' plate.prm --set Surface/Source=iga --set Surface/File=nan.iga

finish
