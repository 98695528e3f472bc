// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/known_file.h"

#include "core/base/content_hash.h"
#include "core/base/file.h"

namespace toile {

bool wasChangedByOthers(const KnownFile& known) {
    if (!known.hash) {
        return false;
    }
    const auto bytes = readFile(known.path);
    return bytes && contentHash(*bytes) != *known.hash;
}

}  // namespace toile
