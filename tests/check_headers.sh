#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Fails if a tracked source, script, shader or build file has no licence identifier in its first three
# lines, and prints the names of such files. Takes less than a second.
set -euo pipefail
cd "$(dirname "$0")/.."
git rev-parse --git-dir >/dev/null 2>&1 || { echo "skipped: this is no git checkout" && exit; }

git ls-files -z -- '*.cpp' '*.h' '*.inl' '*.py' '*.pyi' '*.sh' '*.cjs' '*.cmake' '*CMakeLists.txt' \
    '*.glsl' '*.vert' '*.frag' '*.geom' '*.qrc' '*.toml' '*.yaml' '*.yml' '*Snakefile' \
    .ci .clang-format .clang-tidy .editorconfig |
    xargs -0 awk '
        FNR == 1 { files[FILENAME] = 0 }
        FNR <= 3 && /SPDX-License-Identifier: GPL-3\.0-or-later( -->| \*\/)?$/ { files[FILENAME] = 1 }
        FNR > 3 { nextfile }
        END {
            for (name in files)
                if (!files[name]) { print name ": no SPDX line in the first three lines"; bad = 1 }
            exit bad
        }'
