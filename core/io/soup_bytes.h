// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/io/soup.h"

namespace toile::io {

/// A soup without text, hash and up axis, or an error, as bytes for another process of the same
/// program; of the unit without its reason, of problems only code and text.
std::string packedSoup(Result<PolygonSoup> soup);

/// The soup or the error of such bytes. What does not keep the promises of a soup is MalformedFile.
/// @param name  the file, for messages
Result<PolygonSoup> unpackedSoup(std::string_view bytes, const std::string& name);

}  // namespace toile::io
