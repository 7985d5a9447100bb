#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Render a PNG picture of a surface from the folder of a run, for example
#
#   contrib/pictures.sh results/closure --field mipe --view top --out closed-valve.png
#
# All options: contrib/pictures.sh --help. Installs VTK for Python and a virtual display with apt
# (through sudo where not root) if they are missing; nothing else of the program needs them.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
# Debian's own Python, whatever else comes first in PATH: it is the one that has the packages.
python=/usr/bin/python3

missing=""
"$python" -c "import vtk" 2>/dev/null || missing="$missing python3-vtk9"
command -v xvfb-run >/dev/null || missing="$missing xvfb xauth libgl1-mesa-dri"
if [ -n "$missing" ]; then
  echo "installing$missing" >&2
  as_root=""
  [ "$(id -u)" -eq 0 ] || as_root=sudo
  $as_root apt-get update -qq
  # shellcheck disable=SC2086 # one word per package
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >&2
fi

exec xvfb-run -a -s "-screen 0 1600x1200x24" "$python" "$here/pictures.py" "$@"
