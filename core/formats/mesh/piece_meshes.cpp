// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/mesh/piece_meshes.h"

#include "core/base/text.h"
#include "core/seam/seam_measure.h"

namespace toile {
namespace {

std::vector<int> verticesOf(const SeamSide& side, const Piece& piece) {
    const std::vector<int>& loop = loopOf(side, piece);
    std::vector<int> vertices;
    for (int k = 0; k <= side.count; ++k) {
        vertices.push_back(loop[static_cast<std::size_t>(side.first + k) % loop.size()]);
    }
    if (side.reversed) {
        std::ranges::reverse(vertices);
    }
    return vertices;
}

}  // namespace

PieceMeshes pieceMeshes(const ExportSource& source) {
    const Garment& garment = source.garment();
    const PieceResults results =
        source.options().mesh.isExact ? exactResults(source.results()) : source.results();
    std::vector<Placement> placements(garment.pieces.size());
    for (const PlacedCopy& copy : source.laid().whole.copies) {
        placements[static_cast<std::size_t>(copy.piece)] = copy.placement;
    }
    PieceMeshes made;
    UniqueNames slugs;
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
        const Piece& piece = *garment.pieces[p];
        PieceMesh& mesh = made.meshes.emplace_back();
        mesh.name = piece.name;
        mesh.slug = slugs.free(slug(piece.name), "-");
        mesh.V = piece.mesh.V;
        mesh.F = piece.mesh.F;
        if (results[p] && results[p]->flat) {
            mesh.uv = (results[p]->flat->Q * placements[p].linear().transpose()).rowwise() +
                      placements[p].offset.transpose();
        }
    }
    for (const Seam& seam : garment.seams.seams) {
        if (seam.kind == SeamKind::Free) {
            continue;
        }
        MeshSeam& added = made.seams.emplace_back();
        added.name = seam.name;
        added.kind = name(seam.kind);
        const SeamSide* const sides[] = {&seam.left, &seam.right};
        for (std::size_t k = 0; k < 2; ++k) {
            const auto piece = static_cast<std::size_t>(sides[k]->piece);
            added.mesh[k] = sides[k]->piece;
            added.vertices[k] = verticesOf(*sides[k], *garment.pieces[piece]);
        }
    }
    return made;
}

std::string writePieceObj(const PieceMesh& mesh, const SourceFile& file) {
    std::string out = "# " + slug(mesh.name) +
                      ": a piece with its pattern as UV map, vt in mm\no " + mesh.slug + "\n";
    const double unit = millimetresPer(file.unit);
    const auto append = [&out](const char* word, std::initializer_list<double> values) {
        out += word;
        for (const double value : values) {
            out += ' ';
            appendShortest(out, value);
        }
        out += '\n';
    };
    for (const auto& row : mesh.V.rowwise()) {
        const Eigen::RowVector3d at = asInFile(file.up, row);
        append("v", {at.x() / unit, at.y() / unit, at.z() / unit});
    }
    for (const auto& row : mesh.uv.rowwise()) {
        append("vt", {row.x(), row.y()});
    }
    for (const auto& face : mesh.F.rowwise()) {
        out += 'f';
        for (const int vertex : face) {
            const std::string number = std::to_string(vertex + 1);
            out += ' ' + number;
            out += mesh.uv.rows() > 0 ? '/' + number : "";
        }
        out += '\n';
    }
    return out;
}

}  // namespace toile
