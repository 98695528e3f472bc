// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/check_garment.h"

#include <cmath>
#include <vector>

#include "core/assemble/cut_pieces.h"
#include "core/assemble/divide.h"
#include "core/formats/drawing/drawing.h"
#include "core/formats/formats.h"
#include "core/formats/writers.h"
#include "core/quality/measures.h"
#include "core/seam/find_seams.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/laid_rows.h"

namespace toile::fuzz {
namespace {

constexpr int kMaxGarmentFaces = 400;
constexpr std::size_t kMaxGarmentBytes = 16 * 1024;

double areaOf(const Pieces& pieces) {
    double area = 0;
    for (const auto& piece : pieces) {
        area += triangleAreas3d(piece->mesh).sum();
    }
    return area;
}

/// The garment of one file; one cut runs between the first and the last vertex of the first piece.
Garment cutAndSewn(SourceFile file) {
    Garment garment;
    file.path = "fuzz.off";
    auto uncut = divide(file, 0, "", {}).pieces;
    garment.files.push_back(std::make_shared<SourceFile>(std::move(file)));
    identify(uncut, garment.files, {});
    garment.uncut.assign(uncut.begin(), uncut.end());
    std::vector<UserCut> cuts;
    if (!garment.uncut.empty()) {
        const Points3& V = garment.uncut.front()->mesh.V;
        cuts.push_back({"line",
                        UserCut::Kind::Path,
                        {V.topRows<1>().transpose(), V.bottomRows<1>().transpose()},
                        false});
    }
    CutPieces cut = cutPieces(garment.uncut, cuts, true, Progress());
    garment.pieces = std::move(cut.pieces);
    garment.cuts = std::move(cut.cuts);
    garment.problems = std::move(cut.problems);
    garment.seams = findSeams(garment.pieces);
    return garment;
}

}  // namespace

std::string whatBreaksIn(const Garment& garment) {
    const double before = areaOf(garment.uncut);
    if (std::isfinite(before) && std::abs(areaOf(garment.pieces) - before) > 1e-9 * before) {
        return "cutting has changed the area";
    }
    for (const Seam& seam : garment.seams.seams) {
        const bool finite = std::isfinite(seam.length3d[0]) && std::isfinite(seam.length3d[1]) &&
                            std::isfinite(seam.gap);
        const auto count = static_cast<int>(garment.pieces.size());
        if (!finite || seam.left.piece < 0 || seam.left.piece >= count ||
            seam.right.piece >= count) {
            return "a seam has no finite length or no piece";
        }
    }
    return "";
}

std::string whatBreaksIn(const Garment& garment, const PieceResults& results,
                         const LaidOutPattern& laid) {
    for (const auto& result : results) {
        if (result->flat.has_value() == result->error.has_value()) {
            return "a piece is neither flat nor failed";
        }
        if (result->flat && (!result->flat->Q.allFinite() ||
                             result->flat->Q.rows() != result->piece->mesh.V.rows())) {
            return "flat points are not finite";
        }
    }
    const Drawing drawing = draw(laid.pattern, laid.marker);
    std::vector<std::string> files{writeSvg(drawing), writeObj(garment, results, laid.whole)};
    for (const DxfProfile profile : {DxfProfile::Astm, DxfProfile::Aama, DxfProfile::Plain}) {
        ExportOptions options;
        options.dxf.profile = profile;
        const ExportSource source(garment, results, laid, options);
        const Format& dxf = formatOf(FormatId::Dxf);
        const auto written = dxf.write(source);
        if (!written) {
            return "DXF is not written";
        }
        (void)dxf.readBack(*written, source);
        files.push_back(written->front().bytes);
    }
    for (const std::string& file : files) {
        if (file.find("nan") != std::string::npos || file.find("inf") != std::string::npos) {
            return "a file holds what is no number";
        }
    }
    return writeReport(garment, results, laid.pattern).empty() ? "no report" : "";
}

std::string whatBreaksOnTheWay(std::string bytes) {
    if (bytes.size() > kMaxGarmentBytes) {
        return "";
    }
    Progress progress;
    auto soup = readOff(std::make_shared<const std::string>(std::move(bytes)), "fuzz", progress);
    if (!soup || soup->faceCount() > kMaxGarmentFaces) {
        return "";
    }
    SourceFile file;
    file.soup = std::make_shared<const PolygonSoup>(std::move(*soup));
    const Garment garment = cutAndSewn(std::move(file));
    if (std::string broken = whatBreaksIn(garment); !broken.empty()) {
        return broken;
    }
    for (const MethodTraits& traits : allMethods()) {
        FlattenOptions options;
        options.method = traits.method;
        const PieceResults results = flattenGarment(garment, options, progress);
        if (std::string broken = whatBreaksIn(garment, results, inRows(garment, results));
            !broken.empty()) {
            return broken;
        }
    }
    return "";
}

}  // namespace toile::fuzz
