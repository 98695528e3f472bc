// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/json_fields.h"

namespace toile::app {

struct BatchEntry;

/// What a garment's own process does: flattens it and writes its files, `pattern.svg` and so on, to
/// a folder. @return its figures (batch_record.h). Never throws.
OrderedJson flattenForBatch(const BatchEntry& entry, const std::vector<std::string>& formats,
                            const std::filesystem::path& folder);

}  // namespace toile::app
