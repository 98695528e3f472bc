// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/seam_samples.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/geometry/line.h"
#include "core/seam/seam_measure.h"

namespace toile::sew {
namespace {

/// A place closer to a vertex than this fraction of the shorter of two edges is the vertex.
constexpr double kAcross = 0.05;

/// A piece whose rim edges are to be split at given places.
class DividedPiece {
public:
    explicit DividedPiece(const Piece& piece, const Points2& flat)
        : V(piece.mesh.V), Q(flat), F(piece.mesh.F) {
        for (int side = 0; side < static_cast<int>(F.size()); ++side) {
            if (piece.table.isBorder(piece.table.faceEdges.data()[side])) {
                faceAt_[{tailOf(F, side), headOf(F, side)}] = side / 3;
            }
        }
    }

    /// The vertex at a place of an original rim edge, existing or new.
    int vertexAt(int tail, int head, double share) {
        std::vector<std::pair<double, int>>& stops = stops_[{tail, head}];
        if (stops.empty()) {
            stops = {{0, tail}, {1, head}};
        }
        const auto after =
            std::ranges::lower_bound(stops, share, {}, &std::pair<double, int>::first);
        const auto before = after == stops.begin() ? after : after - 1;
        const auto near = share - before->first < after->first - share ? before : after;
        if (std::abs(near->first - share) < kAcross * kAcross) {
            return near->second;
        }
        const int made = divide(before->second, after->second,
                                (share - before->first) / (after->first - before->first));
        if (made >= 0) {
            stops.insert(after, {share, made});
        }
        return made >= 0 ? made : near->second;
    }

    Points3 V;
    Points2 Q;
    Triangles F;

private:
    int divide(int tail, int head, double share) {
        const auto found = faceAt_.find({tail, head});
        if (found == faceAt_.end()) {
            return -1;
        }
        const int f = found->second, made = static_cast<int>(V.rows());
        faceAt_.erase(found);
        V.conservativeResize(made + 1, 3);
        Q.conservativeResize(made + 1, 2);
        V.row(made) = (1 - share) * V.row(tail) + share * V.row(head);
        Q.row(made) = (1 - share) * Q.row(tail) + share * Q.row(head);
        const auto g = static_cast<int>(F.rows());
        F.conservativeResize(g + 1, 3);
        F.row(g) = F.row(f);
        for (int k = 0; k < 3; ++k) {
            if (F(f, k) == head) {
                F(f, k) = made;  // tail, made, apex
            }
            if (F(g, k) == tail) {
                F(g, k) = made;  // made, head, apex
            }
        }
        for (int k = 0; k < 3; ++k) {
            const auto other = faceAt_.find({F(g, k), F(g, (k + 1) % 3)});
            if (other != faceAt_.end()) {
                other->second = g;
            }
        }
        faceAt_[{tail, made}] = f;
        faceAt_[{made, head}] = g;
        return made;
    }

    std::map<std::pair<int, int>, int> faceAt_;  ///< by tail and head of a rim edge
    /// Per original rim edge: its vertices and their places, in order.
    std::map<std::pair<int, int>, std::vector<std::pair<double, int>>> stops_;
};

class SeamSewer {
public:
    SeamSewer(const Garment& garment, const std::vector<Points2>& flat)
        : garment_(garment), flat_(flat) {
        for (std::size_t p = 0; p < flat.size(); ++p) {
            divided_.emplace_back(*garment.pieces[p], flat[p]);
        }
    }

    void sew(const Seam& seam) {
        if (!isHere(seam.left) || !isHere(seam.right)) {
            return;
        }
        const geometry::Arc left = arcOf(seam.left), right = arcOf(seam.right);
        if (!(left.length() > 0) || !(right.length() > 0)) {
            return;
        }
        for (const SeamMatch& match : seam.matches) {
            geometry::EdgePlace a = left.edgePlace(match.left), b = right.edgePlace(match.right);
            const double lengthA = left[a.edge + 1] - left[a.edge];
            const double lengthB = right[b.edge + 1] - right[b.edge];
            const double across = kAcross * std::min(lengthA, lengthB);
            const bool atA = snap(a, lengthA, across), atB = snap(b, lengthB, across);
            if (atA || atB) {
                sewn_.push_back({{seam.left.piece, vertexAt(seam.left, a)},
                                 {seam.right.piece, vertexAt(seam.right, b)}});
            }
        }
    }

    CutCloth cut() const {
        CutCloth cut;
        std::vector<int> first;
        Eigen::Index points = 0, faces = 0;
        for (std::size_t p = 0; p < flat_.size(); ++p) {
            first.push_back(static_cast<int>(points));
            points += isHere(p) ? divided_[p].V.rows() : 0;
            faces += isHere(p) ? divided_[p].F.rows() : 0;
        }
        cut.Q.resize(points, 2);
        cut.V.resize(points, 3);
        cut.F.resize(faces, 3);
        Eigen::Index f = 0;
        for (std::size_t p = 0; p < flat_.size(); ++p) {
            if (!isHere(p)) {
                continue;
            }
            const DividedPiece& piece = divided_[p];
            cut.Q.middleRows(first[p], piece.Q.rows()) = piece.Q;
            cut.V.middleRows(first[p], piece.V.rows()) = piece.V;
            cut.F.middleRows(f, piece.F.rows()) = piece.F.array() + first[p];
            f += piece.F.rows();
            cut.pieceOf.insert(cut.pieceOf.end(), static_cast<std::size_t>(piece.F.rows()),
                               static_cast<int>(p));
        }
        for (const auto& [a, b] : sewn_) {
            cut.sewn.emplace_back(first[a.first] + a.second, first[b.first] + b.second);
        }
        return cut;
    }

private:
    bool isHere(std::size_t piece) const { return flat_[piece].rows() > 0; }
    bool isHere(const SeamSide& side) const {
        return side.piece >= 0 && isHere(static_cast<std::size_t>(side.piece));
    }
    const std::vector<int>& loop(const SeamSide& side) const {
        return loopOf(side, *garment_.pieces[side.piece]);
    }
    geometry::Arc arcOf(const SeamSide& side) const {
        const Points3& V = garment_.pieces[side.piece]->mesh.V;
        return geometry::SpaceLine::closed(V(loop(side), Eigen::all)).arc();
    }

    static bool snap(geometry::EdgePlace& place, double length, double across) {
        const double along = place.share * length;
        if (along <= across) {
            place.share = 0;
        } else if (length - along <= across) {
            place.share = 1;
        }
        return place.share == 0 || place.share == 1;
    }

    int vertexAt(const SeamSide& side, const geometry::EdgePlace& place) {
        const std::vector<int>& vertices = loop(side);
        const int tail = vertices[place.edge];
        const int head = vertices[(place.edge + 1) % static_cast<int>(vertices.size())];
        if (place.share == 0 || place.share == 1) {
            return place.share == 0 ? tail : head;
        }
        return divided_[side.piece].vertexAt(tail, head, place.share);
    }

    const Garment& garment_;
    const std::vector<Points2>& flat_;
    std::vector<DividedPiece> divided_;
    using Vertex = std::pair<int, int>;  ///< piece, vertex of it
    std::vector<std::pair<Vertex, Vertex>> sewn_;
};

}  // namespace

Result<CutCloth> cutAlongSeams(const Garment& garment, const std::vector<Points2>& flat) {
    SeamSewer sewer(garment, flat);
    for (const Seam& seam : garment.seams.seams) {
        sewer.sew(seam);
    }
    CutCloth cut = sewer.cut();
    if (cut.F.rows() == 0) {
        return Error{ErrorCode::NoGeometry, {}, "no piece is flattened"};
    }
    return cut;
}

}  // namespace toile::sew
