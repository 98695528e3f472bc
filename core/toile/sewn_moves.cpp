// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/toile/sewn_moves.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/seam/outline.h"

namespace toile {
namespace {

/// Ratios that differ by less are equal.
constexpr double kSameRatio = 1e-12;

bool hasBothSides(const Seam& seam) {
    return seam.left.piece >= 0 && seam.right.piece >= 0;
}

void moveSeam(Seam& seam, const seam::Outlines& before, const seam::Outlines& after) {
    const auto moved = [&](const SeamSide& side, double s) {
        const int outline = before.indexOf(side);
        return before.list[outline].length() > 0
                   ? before.list[outline].line.placeOn(after.list[outline].line, s)
                   : s;
    };
    for (SeamMatch& match : seam.matches) {
        match = {moved(seam.left, match.left), moved(seam.right, match.right)};
    }
    const double ratio =
        hasBothSides(seam) ? seam.left.length() / seam.right.length() : 1;  // as designed
    for (SeamSide* side : {&seam.left, &seam.right}) {
        if (side->piece >= 0) {
            std::tie(side->start, side->end) =
                std::pair(moved(*side, side->start), moved(*side, side->end));
            seam.length3d[side == &seam.left ? 0 : 1] = side->length();
        }
    }
    const bool isAnothersPlace = !hasBothSides(seam) || seam.stacked || seam.kind == SeamKind::Free;
    if (isAnothersPlace || (seam.ease && seam.drawn) || !std::isfinite(ratio)) {
        return;
    }
    const double right = ratio * seam.right.length();
    if (std::abs(seam.left.length() - right) > kSameRatio * right) {
        seam.ease = ratio - 1;
        seam.drawn = SeamPart{};
    }
}

}  // namespace

Garment movedGarment(const Garment& garment, const std::vector<Points3>& positions) {
    Garment moved = garment;
    for (std::size_t p = 0; p < positions.size(); ++p) {
        if (positions[p].rows() > 0) {
            auto piece = std::make_shared<Piece>(*garment.pieces[p]);
            piece->mesh.V = positions[p];
            moved.pieces[p] = std::move(piece);
        }
    }
    const seam::Outlines before = seam::buildOutlines(garment.pieces);
    const seam::Outlines after = seam::buildOutlines(moved.pieces);
    for (Seam& seam : moved.seams.seams) {
        moveSeam(seam, before, after);
    }
    return moved;
}

namespace {

/// A place nearer to a vertex than this part of the edge counts as the vertex.
constexpr double kIsVertex = 1e-6;
/// A pass of smoothing averages each move with the mean of its neighbours: the squared deviation
/// grows by about this part of the squared edge length.
constexpr double kPerPass = 0.25;
constexpr double kMaxMovePasses = 400;

int vertexCount(const std::vector<Points3>& moves) {
    Eigen::Index count = 0;
    for (const Points3& of : moves) {
        count += of.rows();
    }
    return static_cast<int>(count);
}

/// The average of each move and the mean of its neighbours, within a piece.
Points3 blurred(const Points3& moves, const Triangles& F) {
    Points3 sums = Points3::Zero(moves.rows(), 3);
    Eigen::VectorXd counts = Eigen::VectorXd::Zero(moves.rows());
    for (Eigen::Index f = 0; f < F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            sums.row(F(f, k)) += moves.row(F(f, (k + 1) % 3)) + moves.row(F(f, (k + 2) % 3));
            counts[F(f, k)] += 2;
        }
    }
    for (Eigen::Index v = 0; v < moves.rows(); ++v) {
        sums.row(v) = counts[v] > 0 ? ((moves.row(v) + sums.row(v) / counts[v]) / 2).eval()
                                    : moves.row(v).eval();
    }
    return sums;
}

}  // namespace

SewnMoves::SewnMoves(const Garment& garment, std::vector<Points3> moves)
    : garment_(garment), moves_(std::move(moves)), groups_(vertexCount(moves_)) {
    int count = 0;
    for (const Points3& of : moves_) {
        first_.push_back(count);
        count += static_cast<int>(of.rows());
    }
    match();
    sizes_.assign(static_cast<std::size_t>(count), 0);
    for (int v = 0; v < count; ++v) {
        ++sizes_[groups_.root(v)];
    }
    even();
}

void SewnMoves::match() {
    const seam::Outlines outlines = seam::buildOutlines(garment_.pieces);
    const auto placeAt = [](const seam::Outline& outline, double s) -> Place {
        const auto [k, share] = outline.line.arc().edgePlace(s);
        const int tail = outline.vertices[k], head = outline.vertices[(k + 1) % outline.size()];
        if (share < kIsVertex || share > 1 - kIsVertex) {
            const int vertex = share < kIsVertex ? tail : head;
            return {outline.piece, vertex, vertex, 0};
        }
        return {outline.piece, tail, head, share};
    };
    const auto isMoved = [this](const SeamSide& side) {
        return side.piece >= 0 && moves_[side.piece].rows() > 0;
    };
    for (const Seam& seam : garment_.seams.seams) {
        if (!isMoved(seam.left) || !isMoved(seam.right)) {
            continue;
        }
        const seam::Outline& left = outlines.list[outlines.indexOf(seam.left)];
        const seam::Outline& right = outlines.list[outlines.indexOf(seam.right)];
        for (const SeamMatch& match : seam.matches) {
            const Place a = placeAt(left, match.left), b = placeAt(right, match.right);
            if (a.share == 0 && b.share == 0) {
                groups_.join(numberOf(a.piece, a.tail), numberOf(b.piece, b.tail));
            } else if (a.share == 0) {
                between_.emplace_back(a, b);
            } else if (b.share == 0) {
                between_.emplace_back(b, a);
            }
        }
    }
}

void SewnMoves::even() {
    Points3 sums = Points3::Zero(static_cast<Eigen::Index>(sizes_.size()), 3);
    const auto ofEach = [this](const auto& act) {
        for (int p = 0; p < static_cast<int>(moves_.size()); ++p) {
            for (int v = 0; v < static_cast<int>(moves_[p].rows()); ++v) {
                const int root = groups_.root(numberOf(p, v));
                if (sizes_[root] > 1) {
                    act(moves_[p].row(v), root);
                }
            }
        }
    };
    ofEach([&](const auto& move, int root) { sums.row(root) += move; });
    ofEach([&](auto&& move, int root) { move = sums.row(root) / sizes_[root]; });
    std::vector<Eigen::RowVector3d> evened;
    for (const auto& [vertex, across] : between_) {
        const Points3& there = moves_[across.piece];
        evened.emplace_back((moves_[vertex.piece].row(vertex.tail) +
                             (1 - across.share) * there.row(across.tail) +
                             across.share * there.row(across.head)) /
                            2);
    }
    for (std::size_t k = 0; k < between_.size(); ++k) {
        const Place& vertex = between_[k].first;
        if (sizes_[groups_.root(numberOf(vertex.piece, vertex.tail))] == 1) {
            moves_[vertex.piece].row(vertex.tail) = evened[k];
        }
    }
}

double SewnMoves::meanEdge() const {
    double sum = 0, count = 0;
    for (std::size_t p = 0; p < moves_.size(); ++p) {
        const MeshArrays& mesh = garment_.pieces[p]->mesh;
        for (Eigen::Index f = 0; moves_[p].rows() > 0 && f < mesh.F.rows(); ++f) {
            for (int k = 0; k < 3; ++k) {
                sum += (mesh.V.row(mesh.F(f, k)) - mesh.V.row(mesh.F(f, (k + 1) % 3))).norm();
                ++count;
            }
        }
    }
    return count > 0 ? sum / count : 0;
}

void SewnMoves::smooth(double length) {
    const double edge = meanEdge();
    const double passes =
        edge > 0 ? std::min(std::ceil(length * length / (kPerPass * edge * edge)), kMaxMovePasses)
                 : 0;
    for (int pass = 0; pass < passes; ++pass) {
        for (std::size_t p = 0; p < moves_.size(); ++p) {
            moves_[p] =
                moves_[p].rows() > 0 ? blurred(moves_[p], garment_.pieces[p]->mesh.F) : moves_[p];
        }
        even();
    }
}

}  // namespace toile
