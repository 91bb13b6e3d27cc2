#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
#
# Installs from Debian 12 what is missing: tools/setup.sh [--build] [--test] [--lint]   (default: --build)
# Needs root or sudo only if something is missing. What is needed, and why, is in tools/packages.txt.
set -euo pipefail
cd "$(dirname "$0")/.."

sets=()
for argument in "$@"; do
  case "$argument" in
    --build | --test | --lint) sets+=("${argument#--}") ;;
    *)
      echo "usage: tools/setup.sh [--build] [--test] [--lint]" >&2
      exit 2
      ;;
  esac
done
[ ${#sets[@]} -gt 0 ] || sets=(build)

# The packages of the wanted sets that are neither installed nor made unnecessary.
missing_packages() {
  local set package program reason wanted
  declare -A installed=()
  while read -r package reason; do
    [ "$reason" = "install ok installed" ] && installed["${package%%:*}"]=1
  done < <(dpkg-query -W -f='${Package} ${Status}\n')
  while read -r set package program reason; do
    for wanted in "${sets[@]}"; do
      [ "$set" = "$wanted" ] || continue
      [ -n "${installed[$package]:-}" ] && continue
      [ "$program" != "-" ] && command -v "$program" > /dev/null && continue
      echo "$package"
    done
  done < tools/packages.txt | sort -u
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  else
    sudo "$@"
  fi
}

install_packages() {
  if ! command -v apt-get > /dev/null; then
    echo "setup: this is no Debian; please install what corresponds to: $*" >&2
    exit 1
  fi
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo > /dev/null; then
    echo "setup: neither root nor sudo; please have these packages installed: $*" >&2
    exit 1
  fi
  echo "setup: installing $*"
  as_root apt-get update -q
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "$@"
}

# The tests' npm packages, at the versions of the lock file.
install_npm_packages() {
  [ -f tests/npm/package.json ] || return 0
  [ tests/npm/node_modules/.package-lock.json -nt tests/npm/package-lock.json ] && return 0
  echo "setup: npm ci in tests/npm"
  (cd tests/npm && npm ci --no-audit --no-fund)
}

if ! command -v dpkg-query > /dev/null; then
  echo "setup: this is no Debian; what is needed is in tools/packages.txt. Going on with what is there." >&2
else
  mapfile -t missing < <(missing_packages)
  [ ${#missing[@]} -eq 0 ] || install_packages "${missing[@]}"
fi
for set in "${sets[@]}"; do
  if [ "$set" = "test" ]; then install_npm_packages; fi
done
