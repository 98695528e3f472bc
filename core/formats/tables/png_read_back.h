// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/formats/drawing/drawing.h"
#include "core/formats/export_options.h"
#include "core/formats/read_back.h"

namespace toile {

/// Reads the size of a PNG picture, in dots and dots per metre, and checks that every chunk is
/// whole and the last is there. The image itself is not checked. Errors: NotReadBack. Cost: linear
/// in the bytes. Pure.
Result<ReadBack> readBackPng(std::string_view bytes, const Drawing& drawing,
                             const PngOptions& options);

}  // namespace toile
