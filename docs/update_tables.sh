#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Rewrites the tables of the documentation that tests of the command line print. Tables of garments in
# ../shared/data are rewritten only where that folder is.
#
#   docs/update_tables.sh
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release -DBUILD_TESTING=ON -DTOILE_PYTHON=ON >/dev/null
cmake --build build/release --parallel "$(./run.sh --jobs)" --target toile_cli_test
status=0
TOILE_UPDATE_DOCS=1 build/release/tests/cli/toile_cli_test --gtest_brief=1 || status=$?
git diff --stat -- docs
exit $status
