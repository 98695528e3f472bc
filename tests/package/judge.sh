#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The Debian packages of a folder, judged by lintian: no errors, no warnings.
set -euo pipefail
lintian --allow-root --fail-on error,warning --info "$1"/*.deb
