// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "tests/core/readers/pdf_reader.h"

namespace toile {

/// What a content stream shows, in the unit in which its own matrix leaves it.
struct PdfShown {
    std::vector<ReadLine> lines{};                             ///< that have an id
    std::set<std::string> pieces{};                            ///< that they are of
    std::vector<std::pair<std::string, ReadPdfView>> forms{};  ///< by their keys in the resources
};

/// Follows the operators of a content stream of ours.
/// @param layers  names by keys of the resources
/// Takes any bytes. Errors: MalformedFile. Cost: linear.
Result<PdfShown> readPdfContent(std::string_view content,
                                const std::map<std::string, std::string>& layers);

}  // namespace toile
