// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file.h"
#include "core/base/version.h"
#include "core/export/json.h"
#include "core/export/problems.h"
#include "core/export/writers.h"

namespace toile {
namespace {

constexpr int kInfoVersion = 1;  // of the fields: grows when one changes its meaning or goes

Json pieceJson(const Garment& garment, const Piece& piece) {
    const Eigen::RowVector3d size =
        piece.mesh.V.colwise().maxCoeff() - piece.mesh.V.colwise().minCoeff();
    Json loops = Json::array();
    for (const double length : loopLengths(piece)) {
        loops.push_back(number(length));
    }
    return {{"name", piece.name},
            {"file", pathText(garment.files[piece.file]->path)},
            {"kind", piece.defect ? text(name(piece.defect->code)) : Json("disk")},
            {"vertices", piece.mesh.V.rows()},
            {"triangles", piece.mesh.F.rows()},
            {"size", {number(size.x()), number(size.y()), number(size.z())}},
            {"loops", std::move(loops)},
            {"holes", piece.holes.size()},
            {"has_reference", piece.reference.has_value()}};
}

}  // namespace

std::string writeInfo(const Garment& garment) {
    Json info{{"version", kInfoVersion}, {"toile", text(version())}};
    info["files"] = filesJson(garment, {});
    info["pieces"] = Json::array();
    for (const auto& piece : garment.pieces) {
        info["pieces"].push_back(pieceJson(garment, *piece));
    }
    info["cuts"] = cutsJson(garment);
    info["seams"] = seamsJson(garment, {});
    info["problems"] = problemsJson(garment);
    return jsonText(info);
}

}  // namespace toile
