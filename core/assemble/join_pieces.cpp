// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/join_pieces.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "core/assemble/cut_owner.h"
#include "core/assemble/weld_soup.h"
#include "core/base/text.h"
#include "core/geometry/segment.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {
namespace {

bool isUsable(const std::shared_ptr<const Piece>& piece) {
    return piece && piece->mesh.F.rows() > 0 && piece->mesh.V.allFinite();
}

double toleranceOf(const Pieces& pieces) {
    Eigen::AlignedBox3d box;
    for (const auto& piece : pieces) {
        if (isUsable(piece)) {
            box.extend(Eigen::Vector3d(piece->mesh.V.colwise().minCoeff().transpose()));
            box.extend(Eigen::Vector3d(piece->mesh.V.colwise().maxCoeff().transpose()));
        }
    }
    return box.isEmpty() ? 0 : kRimTolerance * box.diagonal().norm();
}

}  // namespace

RimPairs::RimPairs(const Pieces& pieces)
    : rims_(pieces.size()), index_(places_, toleranceOf(pieces)) {
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        if (isUsable(pieces[p])) {
            add(*pieces[p], static_cast<int>(p), {});
        }
    }
    for (const auto& [ends, edges] : between_) {
        findMates(ends);
    }
}

void RimPairs::replace(int left, int right, const Piece& made) {
    std::vector<int> old = std::exchange(rims_[left], {});
    old.insert(old.end(), rims_[right].begin(), rims_[right].end());
    rims_[right].clear();
    std::set<Ends> changed;
    for (const int e : old) {
        std::erase(between_[ends_[e]], e);
        changed.insert(ends_[e]);
    }
    add(made, left, std::move(old));
    for (const int e : rims_[left]) {
        changed.insert(ends_[e]);
    }
    for (const Ends& ends : changed) {
        findMates(ends);
    }
}

void RimPairs::add(const Piece& piece, int index, std::vector<int> numbers) {
    const EdgeTable& table = piece.table;
    std::vector<int>& rim = rims_[index];
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        if (!table.isBorder(e)) {
            continue;
        }
        if (numbers.empty()) {
            numbers.push_back(static_cast<int>(edges_.size()));
            edges_.emplace_back();
            ends_.emplace_back();
        }
        const int number = numbers.back();
        numbers.pop_back();
        const int side = table.usesOf(e)[0];
        const int tail = tailOf(piece.mesh.F, side), head = headOf(piece.mesh.F, side);
        edges_[number] = {index, tail, head};
        const int from = index_.insert(piece.mesh.V.row(tail)).first;
        ends_[number] = {from, index_.insert(piece.mesh.V.row(head)).first};
        between_[ends_[number]].push_back(number);
        rim.push_back(number);
    }
    link(rim, piece.mesh.V.rows());
}

/// Links each edge to the next; none at a vertex where several edges begin or end.
void RimPairs::link(const std::vector<int>& rim, Eigen::Index vertexCount) {
    std::vector<int> leaving(vertexCount, kNone), arriving(vertexCount, kNone);
    const auto note = [](int& slot, int e) { slot = slot == kNone ? e : kSeveral; };
    for (const int e : rim) {
        note(leaving[edges_[e].tail], e);
        note(arriving[edges_[e].head], e);
    }
    for (const int e : rim) {
        const int next = leaving[edges_[e].head];
        if (next >= 0 && arriving[edges_[e].head] == e) {
            edges_[e].next = next;
            edges_[next].prev = e;
        }
    }
}

/// Among all edges between two places.
void RimPairs::findMates(const Ends& ends) {
    const std::vector<int> none;
    const auto edgesBetween = [&](const Ends& key) -> const std::vector<int>& {
        const auto found = between_.find(key);
        return found == between_.end() ? none : found->second;
    };
    const std::vector<int>& along = edgesBetween(ends);
    const std::vector<int>& against = edgesBetween({ends.second, ends.first});
    const bool areSingle = along.size() == 1 && against.size() == 1;
    const bool areApart = along.empty() || against.empty() || ends.first == ends.second;
    for (const auto& [edges, others] : {std::pair(&along, &against), std::pair(&against, &along)}) {
        for (const int e : *edges) {
            edges_[e].mate = areApart ? kNone : areSingle ? others->front() : kSeveral;
        }
    }
}

PairedChain chainAround(const RimPairs& rims, int seed) {
    PairedChain chain{{seed}};
    std::set<int> used{seed, rims.edge(seed).mate};
    const auto mateOf = [&rims](int e) { return rims.edge(e).mate; };
    // At the tip of a dart the edge continues with its own mate: the seam ends there.
    const auto isFree = [&](int e) { return e >= 0 && mateOf(e) >= 0 && !used.contains(e); };
    const auto areInRow = [&](int e, int next) {
        return rims.edge(mateOf(next)).next == mateOf(e);
    };
    const auto take = [&](int e, std::vector<int>& edges) {
        used.insert({e, mateOf(e)});
        edges.push_back(e);
    };
    int last = seed, next = rims.edge(seed).next;
    for (; isFree(next) && areInRow(last, next); next = rims.edge(last).next) {
        take(next, chain.edges);
        last = next;
    }
    if (next == seed && areInRow(last, seed)) {
        chain.closed = chain.edges.size() > 2;
        return chain;
    }
    std::vector<int> ahead;
    int first = seed;
    for (int e = rims.edge(seed).prev; isFree(e) && areInRow(e, first); e = rims.edge(first).prev) {
        take(e, ahead);
        first = e;
    }
    chain.edges.insert(chain.edges.begin(), ahead.rbegin(), ahead.rend());
    return chain;
}

namespace {

using PiecePointer = std::shared_ptr<const Piece>;

/// A rim edge with a partner is preferred although one without is closer, by up to this part of its
/// length: the mesh may have changed slightly since the points were set.
constexpr double kNearlyThere = 0.5;

Error joinError(const UserJoin& join, Wording detail) {
    return {ErrorCode::JoinImpossible, Subject::join(join.name), std::move(detail)};
}

/// A point on a rim edge: its position along it, and its distance from the query.
struct OnEdge {
    double along = 0;  ///< mm from its tail
    double distance = std::numeric_limits<double>::infinity();
};

/// Vertices to merge: of the left piece, and of the right one in the same order.
struct SewnChain {
    int left = 0, right = 0;
    std::vector<std::pair<int, int>> vertices;
    double length = 0;
};

class Joiner {
public:
    explicit Joiner(const std::vector<PiecePointer>& uncut) : pieces_(uncut) {
        for (const PiecePointer& whole : uncut) {
            names_.take(whole->name);
        }
    }

    Result<void> join(const UserJoin& join) {
        if (join.points.size() < 2) {
            return joinError(join, toile::worded("it needs %1 points or more", {figure(2)}));
        }
        if (std::ranges::any_of(join.points,
                                [](const Eigen::Vector3d& p) { return !p.allFinite(); })) {
            return joinError(join, toile::worded("a point is not finite"));
        }
        if (!rims_) {
            rims_.emplace(pieces_);
        }
        const Result<int> seed = findSeed(join);
        if (!seed) {
            return seed.error();
        }
        const SewnChain weld = weldAlong(chainAround(*rims_, *seed), join);
        if (pieces_[weld.left]->file != pieces_[weld.right]->file) {
            return joinError(join,
                             toile::worded("%1 and %2 come from different files",
                                           {pieces_[weld.left]->name, pieces_[weld.right]->name}));
        }
        return apply(join, weld);
    }

    void fail(const Error& error) { made_.problems.push_back(error); }

    JoinedPieces take() {
        std::erase(pieces_, nullptr);
        made_.pieces = std::move(pieces_);
        return std::move(made_);
    }

private:
    Eigen::Vector3d at(int piece, int vertex) const { return pieces_[piece]->mesh.V.row(vertex); }
    const RimPairs::Edge& edge(int e) const { return rims_->edge(e); }
    Eigen::Vector3d tailOf(int e) const { return at(edge(e).piece, edge(e).tail); }
    Eigen::Vector3d headOf(int e) const { return at(edge(e).piece, edge(e).head); }
    double lengthOf(int e) const { return (headOf(e) - tailOf(e)).norm(); }

    OnEdge nearestOn(int e, const Eigen::Vector3d& point) const {
        const Eigen::Vector3d a = tailOf(e), b = headOf(e);
        const double t = geometry::nearestShare(point, a, b);
        return {t * (b - a).norm(), (a + t * (b - a) - point).norm()};
    }

    double limit() const {
        Eigen::AlignedBox3d box;
        for (const auto& rim : rims_->rims()) {
            for (const int e : rim) {
                box.extend(tailOf(e));
            }
        }
        return box.isEmpty() ? 0 : kFarFromSurface * box.diagonal().norm();
    }

    /// The rim edge with a partner that contains the middle of the join.
    Result<int> findSeed(const UserJoin& join) const {
        const Eigen::Vector3d& middle = join.points[join.points.size() / 2];
        int nearest = -1, paired = -1;
        double toNearest = std::numeric_limits<double>::infinity(), toPaired = toNearest;
        for (const auto& rim : rims_->rims()) {
            for (const int e : rim) {
                const double distance = nearestOn(e, middle).distance;
                if (nearest < 0 || distance < toNearest) {
                    nearest = e;
                    toNearest = distance;
                }
                if (edge(e).mate >= 0 && distance < toPaired) {
                    paired = e;
                    toPaired = distance;
                }
            }
        }
        if (nearest < 0) {
            return joinError(join, toile::worded("no piece has an edge"));
        }
        if (toNearest > limit()) {
            return joinError(join, toile::worded("it is %1 mm from the nearest edge of a piece",
                                                 {figure(toNearest)}));
        }
        const double allowed =
            toNearest +
            (paired < 0 ? 0 : kNearlyThere * std::min(lengthOf(nearest), lengthOf(paired)));
        if (paired >= 0 && toPaired <= allowed) {
            return paired;
        }
        const std::string& name = pieces_[edge(nearest).piece]->name;
        return joinError(
            join,
            edge(nearest).mate == RimPairs::kSeveral
                ? toile::worded("more than two edges coincide there, one of them of %1", {name})
                : toile::worded("the vertices of the two edges there, one of them of %1, do not "
                                "match one to one",
                                {name}));
    }

    /// Lengths along a chain up to each of its vertices.
    std::vector<double> arcsOf(const PairedChain& chain) const {
        std::vector<double> arc{0};
        for (const int e : chain.edges) {
            arc.push_back(arc.back() + lengthOf(e));
        }
        return arc;
    }

    double arcAt(const PairedChain& chain, const std::vector<double>& arc,
                 const Eigen::Vector3d& point) const {
        OnEdge best;
        double at = 0;
        for (std::size_t i = 0; i < chain.edges.size(); ++i) {
            const OnEdge here = nearestOn(chain.edges[i], point);
            if (here.distance < best.distance) {
                best = here;
                at = arc[i] + here.along;
            }
        }
        return at;
    }

    /// The part of the chain that the join's points span, in whole edges, at least one.
    SewnChain weldAlong(const PairedChain& chain, const UserJoin& join) const {
        const std::vector<double> arc = arcsOf(chain);
        double at = arcAt(chain, arc, join.points.front()), low = at, high = at;
        for (std::size_t i = 1; i < join.points.size(); ++i) {
            double step = arcAt(chain, arc, join.points[i]) - at;
            if (chain.closed) {  // the shorter way around
                step -= arc.back() * std::round(step / arc.back());
            }
            at += step;
            low = std::min(low, at);
            high = std::max(high, at);
        }
        // A closed seam without a closed chain, because it passes an ambiguous vertex.
        if (!chain.closed && (join.points.front() - join.points.back()).norm() <
                                 kNearlyThere * lengthOf(chain.edges.front())) {
            low = 0;
            high = arc.back();
        }
        const int count = static_cast<int>(chain.edges.size());
        const auto vertexNear = [&](double s) {
            const double turns = chain.closed ? std::floor(s / arc.back()) : 0;
            const double rest = s - turns * arc.back();
            const auto after = std::ranges::lower_bound(arc, rest);
            int k = static_cast<int>(std::min(after - arc.begin(), std::ptrdiff_t{count}));
            k -= k > 0 && rest - arc[k - 1] < arc[k] - rest ? 1 : 0;
            return k + static_cast<int>(turns) * count;
        };
        int first = vertexNear(low), last = vertexNear(high);
        if (first == last) {
            first -= chain.closed || first > 0 ? 1 : 0;
            last = first + 1;
        }
        if (chain.closed) {
            last = std::min(last, first + count);
        }
        const RimPairs::Edge& seed = edge(chain.edges[0]);
        SewnChain weld{seed.piece, edge(seed.mate).piece, {}};
        for (int i = first; i < last; ++i) {
            const int e = chain.edges[(i % count + count) % count];
            const RimPairs::Edge& side = edge(e);
            const RimPairs::Edge& mate = edge(side.mate);
            weld.vertices.emplace_back(side.tail, mate.head);
            weld.vertices.emplace_back(side.head, mate.tail);
            weld.length += lengthOf(e);
        }
        if (weld.right < weld.left) {
            std::swap(weld.left, weld.right);
            for (auto& [left, right] : weld.vertices) {
                std::swap(left, right);
            }
        }
        return weld;
    }

    Result<void> apply(const UserJoin& join, const SewnChain& weld) {
        const bool itself = weld.left == weld.right;
        const Piece& left = *pieces_[weld.left];
        const Piece& right = *pieces_[weld.right];
        Piece made = welded(left, right, weld);
        if (made.defect && isNoSurface(made.defect->code)) {
            return joinError(
                join,
                toile::worded("%1, the result: %2",
                              {made.name, toile::worded(describe(made.defect->code).data())}));
        }
        if (!itself) {
            made.name = names_.free(left.name + " + " + right.name);
        }
        nameDefect(made);
        made_.joins.push_back({join.name, made.name, weld.length});
        rims_->replace(weld.left, weld.right, made);
        pieces_[weld.left] = std::make_shared<const Piece>(std::move(made));
        if (!itself) {
            pieces_[weld.right] = nullptr;
        }
        return {};
    }

    static Piece welded(const Piece& left, const Piece& right, const SewnChain& weld) {
        const bool itself = weld.left == weld.right;
        const auto offset = static_cast<int>(itself ? 0 : left.mesh.V.rows());
        const auto total = static_cast<int>(offset + right.mesh.V.rows());
        geometry::DisjointSets same(total);
        for (const auto& [l, r] : weld.vertices) {
            same.join(l, offset + r);
        }
        MeshArrays mesh;
        mesh.V.resize(total, 3);
        std::vector<int> sourceVertex(static_cast<std::size_t>(total), -1);
        for (const auto& [piece, from] : {std::pair(&left, 0), std::pair(&right, offset)}) {
            mesh.V.middleRows(from, piece->mesh.V.rows()) = piece->mesh.V;
            std::ranges::copy(piece->sourceVertex, sourceVertex.begin() + from);
        }
        MergedVertices merged = mergedVertices(mesh.V, sourceVertex, same);
        mesh.V = std::move(merged.V);
        const auto leftFaces = itself ? Eigen::Index{0} : left.mesh.F.rows();
        mesh.F.resize(leftFaces + right.mesh.F.rows(), 3);
        std::vector<int> sourceFace = itself ? std::vector<int>{} : left.sourceFace;
        sourceFace.insert(sourceFace.end(), right.sourceFace.begin(), right.sourceFace.end());
        for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
            for (int k = 0; k < 3; ++k) {
                mesh.F(f, k) =
                    merged.number[f < leftFaces ? left.mesh.F(f, k)
                                                : offset + right.mesh.F(f - leftFaces, k)];
            }
        }
        Piece made = makePiece(left.name, std::move(mesh));
        made.file = left.file;
        made.sourceVertex = std::move(merged.sourceVertex);
        made.sourceFace = std::move(sourceFace);
        made.lineage = lineageOf(left, right);
        made.id = idOf(made.lineage);
        made.origins = originsOf(left, itself ? nullptr : &right, merged.number, offset);
        return made;
    }

    static Lineage lineageOf(const Piece& left, const Piece& right) {
        Lineage both;
        std::set_union(left.lineage.uncut.begin(), left.lineage.uncut.end(),
                       right.lineage.uncut.begin(), right.lineage.uncut.end(),
                       std::back_inserter(both.uncut));
        return both;
    }

    /// Of the remaining rims. @param number  per vertex of both: its new index
    static std::vector<EdgeOrigin> originsOf(const Piece& left, const Piece* right,
                                             const std::vector<int>& number, int offset) {
        std::vector<EdgeOrigin> all;
        std::set<std::pair<int, int>> edges;
        const auto take = [&](const Piece& piece, int first) {
            for (EdgeOrigin origin : piece.origins) {
                origin.tail = number[origin.tail + first];
                origin.head = number[origin.head + first];
                edges.emplace(origin.tail, origin.head);
                all.push_back(origin);
            }
        };
        take(left, 0);
        if (right) {
            take(*right, offset);
        }
        std::erase_if(all, [&](const EdgeOrigin& origin) {
            return edges.contains({origin.head, origin.tail});
        });
        std::ranges::sort(all, {}, &EdgeOrigin::tail);
        return all;
    }

    static bool isNoSurface(ErrorCode defect) {
        return defect == ErrorCode::NonManifoldEdge || defect == ErrorCode::NonManifoldVertex ||
               defect == ErrorCode::OpposedWinding || defect == ErrorCode::NotOrientable ||
               defect == ErrorCode::DuplicateFace || defect == ErrorCode::DegenerateFace;
    }

    std::vector<PiecePointer> pieces_;  ///< null if a piece was merged into another
    std::optional<RimPairs> rims_;      ///< computed for the first join
    UniqueNames names_;
    JoinedPieces made_;
};

}  // namespace

JoinedPieces joinPieces(const std::vector<PiecePointer>& uncut, const std::vector<UserJoin>& joins,
                        const Progress& progress) {
    Joiner joiner(uncut);
    for (std::size_t j = 0; j < joins.size() && !progress.isCancelled(); ++j) {
        if (const auto done = joiner.join(joins[j]); !done) {
            joiner.fail(done.error());
        }
        progress.report(static_cast<double>(j + 1) / static_cast<double>(joins.size()));
    }
    return joiner.take();
}

}  // namespace toile
