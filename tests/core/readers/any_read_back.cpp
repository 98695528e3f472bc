// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/readers/any_read_back.h"

#include "tests/core/readers/mesh_compare.h"
#include "tests/core/readers/pdf_read_back.h"
#include "tests/core/readers/plt_read_back.h"

namespace toile::test {
namespace {

Result<ReadBack> comparedMeshes(const Result<MeshFile>& file, const ExportSource& source) {
    return file ? comparedWithMeshes(*file, pieceMeshes(source))
                : notReadBack({}, sentence(file.error()));
}

}  // namespace

bool isReadBack(const Format& format) {
    return format.readBack || format.id == FormatId::Pdf || format.id == FormatId::Plt ||
           format.id == FormatId::Usd || format.id == FormatId::Glb;
}

Result<ReadBack> readBack(const Format& format, const ExportedFiles& files,
                          const ExportSource& source) {
    const std::string& bytes = files.front().bytes;
    switch (format.id) {
        case FormatId::Pdf:
            return readBackPdf(bytes, source.drawing(), source.options().pdf);
        case FormatId::Plt:
            return readBackPlt(bytes, source.drawing(), source.options().plt);
        case FormatId::Usd:
            return comparedMeshes(readUsda(bytes), source);
        case FormatId::Glb:
            return comparedMeshes(readGlb(bytes), source);
        default:
            return format.readBack(files, source);
    }
}

}  // namespace toile::test
