// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/problems.h"

#include <set>
#include <string_view>
#include <tuple>

#include "core/garment/garment.h"

namespace toile {
Problems problemsOf(const SourceFile& file) {
    Problems all;
    std::set<std::tuple<ErrorCode, Subject::Kind, std::string_view, std::string_view>> seen;
    for (const Error& error : file.problems) {
        const auto& [kind, id, name] = error.subject;
        if (seen.emplace(error.code, kind, name, error.detail).second) {
            all.push_back(error);
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

}  // namespace toile
