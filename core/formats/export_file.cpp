// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/export_file.h"

#include <algorithm>

#include "core/base/file.h"
#include "core/formats/dxf/apparel_dxf.h"
#include "core/formats/formats.h"

namespace toile {
namespace {

/// Approximate shares of the export time: creating, then also reading back; the rest is writing.
constexpr double kMakingShare = 0.5, kReadShare = 0.8;
/// Readers refuse coordinates beyond this, mm: no garment has them, and their digits are lost.
constexpr double kMaxDrawing = 1e7;

}  // namespace

std::filesystem::path exportedPath(const std::filesystem::path& path, const std::string& beside) {
    if (beside.empty()) {
        return path;
    }
    std::string name = path.filename().string();
    name.resize(name.size() - endingOf(path).size());
    return path.parent_path() / (name + beside);
}

Result<Exported> exportFile(const std::filesystem::path& path, const ExportSource& source,
                            const Progress& progress) {
    const auto about = [&path](Error error) -> Error {
        if (error.subject.kind == Subject::Kind::None) {
            error.subject = Subject::file(path.string());
        }
        return error;
    };
    const Format* format = formatOf(path);
    if (!format) {
        return about(
            {ErrorCode::UnknownFormat, {}, "ending \"" + path.extension().string() + "\""});
    }
    if (!format->write) {
        return about({ErrorCode::FormatNotBuilt, {}, format->name});
    }
    const double size = std::max(source.laid().marker.width, source.laid().marker.height);
    if (format->trueScale && size > kMaxDrawing) {
        return about({ErrorCode::PageTooSmall,
                      {},
                      worded("%1 mm, while a file holds at most %2 mm; check the garment's unit",
                             {figure(size), figure(kMaxDrawing)})});
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    const Result<ExportedFiles> made = format->write(source);
    if (!made) {
        return about(made.error());
    }
    progress.report(kMakingShare);
    Exported done;
    if (format->id == FormatId::Dxf) {
        done.notes = renamedNotes(source);
    }
    if (format->readBack && !progress.isCancelled()) {
        const Result<ReadBack> read = format->readBack(*made, source);
        if (!read) {
            return about(read.error());
        }
        done.readBack = *read;
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    progress.report(kReadShare);
    for (const ExportedFile& file : *made) {
        const std::filesystem::path& target =
            done.files.emplace_back(exportedPath(path, file.beside));
        if (const Result<void> written = writeFile(target, file.bytes); !written) {
            return written.error();
        }
    }
    return done;
}

}  // namespace toile
