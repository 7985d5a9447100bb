#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# usage: contrib/doc_pictures.sh
#
# Makes the pictures of doc/ anew: runs the valve closed and open and renders both results.
set -eu
cd "$(dirname "$0")/.."
for state in closed:closure open:opening; do
  contrib/run.sh "prm/valve/${state#*:}.prm" --output "results/${state#*:}"
  contrib/pictures.sh "results/${state#*:}" --field mipe --view oblique --size 900 700 \
    --title MIPE --out "doc/${state%:*}-valve.png"
done
