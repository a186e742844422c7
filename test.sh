#!/usr/bin/env bash
# From a fresh machine to passed tests: installs what is missing, builds weft, runs all tests.
# Further arguments go to ctest: ./test.sh -R stability
set -euo pipefail
cd "$(dirname "$0")"

tools/install_packages.sh tools/packages.txt tools/test-packages.txt
cmake --preset test >/dev/null
cmake --build --preset test
ctest --preset test "$@"
