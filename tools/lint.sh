#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
#
# Checks the format of all C++ files and the style of those in src/, or in one of its rooms: tools/lint.sh [src/ROOM]
set -euo pipefail
cd "$(dirname "$0")/.."
part=${1:-src}
log=build/lint/tidy.log
formatted=yes
mkdir -p build

echo "lint: format of all C++ files"
if ! git ls-files -co --exclude-standard '*.cpp' '*.hpp' | xargs clang-format-14 --dry-run -Werror 2> build/format.log; then
  sed -n 's/^\([^ ]*\):[0-9]*:[0-9]*: error: .*/\1: is not formatted/p' build/format.log | sort -u
  echo "lint: make format mends this" >&2
  formatted=no
fi

echo "lint: style of $part"
cmake --preset lint > /dev/null
# clang-tidy needs the messages' headers, but not their code built.
mapfile -t message_headers < <(ninja -C build/lint -t targets all | sed -n 's/\(.*\.pb\.h\): .*/\1/p')
if [ ${#message_headers[@]} -gt 0 ]; then
  cmake --build build/lint --target "${message_headers[@]}" > /dev/null
fi

# Many sources at once first, as what they all include takes most of the time. What has something to say, or does not
# compile together, is looked at again one by one, and that is what counts.
tidy() {  # DATABASE ARGUMENT FILE...: prints the names of files that do not pass; what was said of FILE goes to FILE.tidy in build/lint
  local database=$1 argument=$2
  shift 2
  printf '%s\n' "$@" | xargs -P "$(nproc)" -I{} bash -c '
    log=build/lint/said/$(echo "$2" | tr / _).tidy
    clang-tidy-16 -p "$1" --quiet $3 "$2" > "$log" 2>&1 || echo "$2"' _ "$database" {} "$argument"
}
rm -rf build/lint/said
mkdir -p build/lint/said
mapfile -t sources < <(git ls-files -co --exclude-standard "${part%/}/*.cpp")
tools/tidy-batches build/lint "${sources[@]}"
mapfile -t doubtful < <(tidy build/lint/batches --extra-arg=-Wno-shadow build/lint/batches/*.cpp)
if [ ${#doubtful[@]} -gt 0 ]; then
  mapfile -t again < <(sed -n 's/^#include "\(.*\)"$/\1/p' "${doubtful[@]}")
  rm -f build/lint/said/*
  mapfile -t failed < <(tidy build/lint --extra-arg=-Wno-error "${again[@]}")
  if [ ${#failed[@]} -gt 0 ]; then
    cat build/lint/said/*.tidy > "$log"
    # One header is seen by many files: say each thing once.
    sed "s|$PWD/||; s|build/lint/include/[a-z]*/|src/|" "$log" | grep -E '^[^ ]+:[0-9]+:[0-9]+: |^error: ' | sort -u || tail -n 20 "$log"
    echo "lint: see $log for all of it" >&2
    exit 1
  fi
fi
[ "$formatted" = yes ] || exit 1
echo "lint: nothing to say"
