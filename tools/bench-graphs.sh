#!/bin/sh
# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
#
# Times the graph solver beside Ceres, as `make bench` does: on the lane graphs of the real data, if they are there, and on
# the windows of a simulated drive.
#
#     tools/bench-graphs.sh [PROGRAM]
set -eu
program=$(realpath "${1:-build/release/lanefuse}")
graphs=${LANEFUSE_DATA:-../shared/data}/lane_graphs
if [ -d "$graphs" ]; then
  "$program" bench lane-graphs "$graphs"
else
  echo "no lane graphs at $graphs: set LANEFUSE_DATA"
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$program" simulate --seed 1 --km 1 -o "$folder/drive.mcap" >/dev/null
"$program" run "$folder/drive.mcap" -o "$folder/lanes.mcap" --dump-graphs "$folder/windows" >/dev/null
"$program" bench windows "$folder/windows"
