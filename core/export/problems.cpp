// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/problems.h"

#include <algorithm>

#include "core/garment/garment.h"

namespace toile {
namespace {

bool same(const Error& a, const Error& b) {
    return a.code == b.code && a.where == b.where && a.detail == b.detail;
}

}  // namespace

Problems problemsOf(const SourceFile& file) {
    Problems all;
    for (const Problems* list : {&file.soup.problems, &file.problems}) {
        for (const Error& error : *list) {
            const auto equal = [&error](const Error& other) { return same(error, other); };
            if (std::none_of(all.begin(), all.end(), equal)) {
                all.push_back(error);
            }
        }
    }
    return all;
}

bool changesOutput(ErrorCode code) {
    switch (code) {
        case ErrorCode::OutputDiffers:
        case ErrorCode::IndexOutOfRange:       // the faces are gone
        case ErrorCode::NonFinitePosition:     // its faces are in no piece
        case ErrorCode::DegenerateFaceRecord:  // gone, or in no piece
        case ErrorCode::MalformedFile:         // what could not be read is gone
        case ErrorCode::VerticesWelded:        // faces name other vertices
            return true;
        default:
            return false;
    }
}

std::string pathText(const std::filesystem::path& path) {
    const std::u8string text = path.generic_u8string();
    return {text.begin(), text.end()};
}

}  // namespace toile
