#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
#
# Drives a benchmark as an array of processes, one drive each, and merges what they leave into FOLDER/results.jsonl.
#
#     tools/benchmark-slurm.sh [--local] FOLDER OPTIONS...     e.g.  runs/ablations --suite ablations --seeds 1-6
#
# OPTIONS are those of `lanefuse benchmark`. With Slurm (sbatch) this is a job array over all machines of the cluster,
# which must share FOLDER and the program; sbatch takes further options from SBATCH_PARTITION, SBATCH_ACCOUNT and their
# like. Without Slurm, or with --local, the same array runs on this machine, one process a core. What is there already is
# not driven again: start it anew after a breakdown. The program is $LANEFUSE_BIN, else `lanefuse` on the path, else the
# one that was built in this tree.
set -euo pipefail

usage() {
  sed -n '5,13s/^# \{0,1\}//p' "$here/benchmark-slurm.sh" >&2
  exit 2
}

find_program() {
  if [[ -n ${LANEFUSE_BIN:-} ]]; then
    realpath "$LANEFUSE_BIN"
  elif ! command -v lanefuse; then
    realpath "$here/../build/release/lanefuse"
  fi
}

# One element of the array.
drive_one() {
  local number=$1
  exec "$program" benchmark "${options[@]}" --jobs 1 --job "$number/$count" -o "$folder/drive-$number.jsonl"
}

merge_all() {
  local -a files=()
  for ((number = 1; number <= count; ++number)); do files+=("$folder/drive-$number.jsonl"); done
  "$program" benchmark merge "${files[@]}" -o "$folder/results.jsonl" --force
}

# The script calls itself for each part, under Slurm on another machine: everything comes by its arguments.
call_of() { printf '%q ' "$here/benchmark-slurm.sh" "$@" "$count" "$program" "$folder" "${options[@]}"; }

run_with_slurm() {
  local array merge
  array=$(sbatch --parsable --job-name=lanefuse-benchmark --array="1-$count" --ntasks=1 --cpus-per-task=1 \
    --output="$folder/drive-%a.log" --wrap="$(call_of --drive)")
  merge=$(sbatch --parsable --job-name=lanefuse-merge --dependency="afterok:$array" --kill-on-invalid-dep=yes \
    --ntasks=1 --output="$folder/merge.log" --wrap="$(call_of --merge)")
  echo "$count drives: job array $array; then job $merge merges them -> $folder/results.jsonl"
}

run_here() {
  local call
  call=$(call_of --drive)
  seq "$count" | xargs -P "$(nproc)" -I{} env SLURM_ARRAY_TASK_ID={} bash -c "$call" >"$folder/drives.log"
  merge_all
}

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
case ${1:-} in
  --drive | --merge)
    part=$1 count=$2 program=$3 folder=$4
    options=("${@:5}")
    if [[ $part == --drive ]]; then drive_one "$SLURM_ARRAY_TASK_ID"; else merge_all; fi
    exit
    ;;
esac

local_only=false
if [[ ${1:-} == --local ]]; then
  local_only=true
  shift
fi
[[ $# -ge 1 && $1 != -* ]] || usage
program=$(find_program)
mkdir -p "$1"
folder=$(realpath "$1")
options=("${@:2}")
drives=$("$program" benchmark "${options[@]}" --list)
count=$(wc -l <<<"$drives")
if ! $local_only && command -v sbatch >/dev/null; then run_with_slurm; else run_here; fi
