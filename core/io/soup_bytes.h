// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/io/soup.h"

namespace toile::io {

/// A soup without text, hash and up axis, or an error, as bytes for another process of the same
/// program; the unit without its reason, problems with code and text only.
std::string packedSoup(Result<PolygonSoup> soup);

/// Unpacks the soup or the error. Bytes that violate the invariants of a soup are MalformedFile.
/// @param name  the file, for messages
Result<PolygonSoup> unpackedSoup(std::string_view bytes, const std::string& name);

}  // namespace toile::io
