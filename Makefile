# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
#
# For those who work on Lanefuse; tools/setup.sh --build --test --lint installs what these need.
.PHONY: build test bench lint format clean

build/release/build.ninja:
	cmake --preset release

build: build/release/build.ninja
	cmake --build --preset release

test:
	./test

bench: build
	@set -e; for program in build/release/bench_*; do "$$program"; done
	tools/bench-graphs.sh

lint:
	tools/lint.sh
	tools/structure-rules

format:
	git ls-files '*.cpp' '*.hpp' | xargs clang-format-14 -i

clean:
	rm -rf build demo-output
