// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/export/drawing.h"
#include "core/export/export_options.h"
#include "core/export/read_back.h"

namespace toile {

/// Reads of a PNG picture what says its size: dots, and dots per metre; that every chunk is whole
/// and the last is there. What it shows is not looked at. Errors: NotReadBack. Cost: linear in the
/// bytes. Pure.
Result<ReadBack> readBackPng(std::string_view bytes, const Drawing& drawing,
                             const PngOptions& options);

}  // namespace toile
