// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/base/text.h"
#include "core/formats/read_backs.h"
#include "core/io/soup.h"

namespace toile {
namespace {

struct VertexOfPiece {
    int piece, vertex;
};

/// The vertices of pieces for each position of the file: positions of the input files in sequence,
/// each followed by its added vertices.
class Positions {
public:
    explicit Positions(const Garment& garment) {
        for (std::size_t f = 0; f < garment.files.size(); ++f) {
            const std::size_t own = of_.size();
            of_.resize(of_.size() + garment.files[f]->soup->positions.size());
            for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
                if (garment.pieces[p]->file == static_cast<int>(f)) {
                    addPiece(*garment.pieces[p], static_cast<int>(p), own);
                }
            }
        }
    }

    const std::vector<VertexOfPiece>& at(int position) const {
        static const std::vector<VertexOfPiece> none;
        const auto index = static_cast<std::size_t>(position);
        return index < of_.size() ? of_[index] : none;
    }

private:
    void addPiece(const Piece& piece, int index, std::size_t own) {
        for (std::size_t v = 0; v < piece.sourceVertex.size(); ++v) {
            const int source = piece.sourceVertex[v];
            if (source < 0) {
                of_.emplace_back();
            }
            (source < 0 ? of_.back() : of_[own + static_cast<std::size_t>(source)])
                .push_back({index, static_cast<int>(v)});
        }
    }

    std::vector<std::vector<VertexOfPiece>> of_;
};

/// The piece vertex of a corner: among those that share its position, the one with the nearest flat
/// point, in the piece of the face's other corners if it is known.
struct NearestVertex {
    double distance = std::numeric_limits<double>::infinity();
    VertexOfPiece at{-1, -1};
};

NearestVertex nearestVertex(const std::vector<VertexOfPiece>& candidates, int piece,
                            const PieceMeshes& meshes, const Eigen::Vector2d& uv) {
    NearestVertex best;
    for (const VertexOfPiece& candidate : candidates) {
        const Points2& flat = meshes.meshes[static_cast<std::size_t>(candidate.piece)].uv;
        if (flat.rows() == 0 || (piece >= 0 && candidate.piece != piece)) {
            continue;
        }
        const double distance = (flat.row(candidate.vertex).transpose() - uv).norm();
        if (distance < best.distance) {
            best = {distance, candidate};
        }
    }
    return best;
}

double lengthAlong(const Points2& uv, const std::vector<int>& vertices) {
    double length = 0;
    for (std::size_t k = 1; k < vertices.size(); ++k) {
        length += (uv.row(vertices[k]) - uv.row(vertices[k - 1])).norm();
    }
    return length;
}

/// Compares both sides of a seam in the pattern of the file. @param uv  by mesh
Result<double> compareSeam(const MeshSeam& seam, const PieceMeshes& meshes,
                           const std::vector<Points2>& uv, double rounding) {
    double largest = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        const auto mesh = static_cast<std::size_t>(seam.mesh[k]);
        const Points2& should = meshes.meshes[mesh].uv;
        if (should.rows() == 0) {
            continue;  // not flat
        }
        const double difference =
            lengthAlong(uv[mesh], seam.vertices[k]) - lengthAlong(should, seam.vertices[k]);
        const double allowed =
            kReadBackLengths + static_cast<double>(seam.vertices[k].size()) * rounding;
        if (!(std::abs(difference) <= allowed)) {
            return notReadBack(seam.name, "longer by " + fixed(difference, 3) + " mm");
        }
        largest = std::max(largest, std::abs(difference));
    }
    return largest;
}

}  // namespace

Result<ReadBack> withSeamsCompared(ReadBack found, const PieceMeshes& meshes,
                                   const std::vector<Points2>& uv, double rounding) {
    for (const MeshSeam& seam : meshes.seams) {
        const Result<double> difference = compareSeam(seam, meshes, uv, rounding);
        if (!difference) {
            return difference.error();
        }
        found.largest = std::max(found.largest, *difference);
        ++found.seams;
    }
    return found;
}

Result<ReadBack> comparedWithObj(const std::string& obj, const ExportSource& source) {
    Progress progress;
    const auto soup = readObj(std::make_shared<const std::string>(obj), "", progress);
    if (!soup) {
        return notReadBack({}, sentence(soup.error()));
    }
    const PieceMeshes meshes = pieceMeshes(source);
    const Positions positions(source.garment());
    std::vector<Points2> uv;
    for (const PieceMesh& mesh : meshes.meshes) {
        uv.push_back(Points2::Constant(mesh.uv.rows(), 2, std::nan("")));
    }
    ReadBack found;
    std::vector<int> pieceOf(soup->groups.size(), -1);  // by group
    for (int face = 0; face < soup->faceCount() && !soup->cornerUvs.empty(); ++face) {
        const auto f = static_cast<std::size_t>(face);
        const int group = soup->faceGroup.empty() ? -1 : soup->faceGroup[f];
        for (int c = soup->faceStart[f]; c < soup->faceStart[f + 1]; ++c) {
            const auto corner = static_cast<std::size_t>(c);
            if (soup->cornerUvs[corner] < 0 || group < 0) {
                continue;
            }
            const Eigen::Vector2d at = soup->uvs[static_cast<std::size_t>(soup->cornerUvs[corner])];
            int& piece = pieceOf[static_cast<std::size_t>(group)];
            const NearestVertex nearest =
                nearestVertex(positions.at(soup->corners[corner]), piece, meshes, at);
            if (!(nearest.distance <= kReadBackCoordinates)) {
                return notReadBack(soup->groups[static_cast<std::size_t>(group)],
                                   "a point of the pattern is in another place");
            }
            piece = nearest.at.piece;
            found.largest = std::max(found.largest, nearest.distance);
            uv[static_cast<std::size_t>(piece)].row(nearest.at.vertex) = at.transpose();
        }
    }
    for (std::size_t p = 0; p < uv.size(); ++p) {
        if (!uv[p].allFinite()) {
            return notReadBack(meshes.meshes[p].name, "a point of its pattern is missing");
        }
        found.pieces += uv[p].rows() > 0 ? 1 : 0;
    }
    return withSeamsCompared(found, meshes, uv);
}

}  // namespace toile
