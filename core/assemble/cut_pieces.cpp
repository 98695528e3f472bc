// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/cut_pieces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/assemble/cut_owner.h"
#include "core/assemble/part_origins.h"
#include "core/base/id.h"
#include "core/base/text.h"
#include "core/cut/auto_cut.h"
#include "core/cut/surface_paths.h"
#include "core/mesh/repair.h"

namespace toile {
namespace {

using PiecePointer = std::shared_ptr<const Piece>;

/// Approximate shares of a piece's time: for the user's cuts, and for proposing and making others;
/// and within making cuts, for tracing them.
constexpr double kByHandShare = 0.2, kByProposalShare = 0.4;
constexpr double kTracingShare = 0.7;
/// Approximate share of the time of proposals for finding them.
constexpr double kProposingShare = 0.7;
/// If the user's cuts divide a piece into more parts than this, no cuts are proposed.
constexpr std::size_t kMaxParts = 50;

/// Maximum cuts per piece to separate crossings; more need the user's attention.
constexpr int kMaxCrossingCuts = 8;

/// A point of the reference panel from its place on the surface.
Eigen::RowVector2d panelPoint(const Points2& panel, const Triangles& F, const SurfacePoint& place) {
    Eigen::RowVector2d point = Eigen::RowVector2d::Zero();
    for (int k = 0; place.face >= 0 && k < 3; ++k) {
        point += place.barycentric[k] * panel.row(F(place.face, k));
    }
    return point;
}

/// Cuts one piece along curves. The result has the old piece's file, sources, panel and name; the
/// caller names several parts.
/// @param ids     of the cuts, one per path
/// @param opened  receives the runs that each curve opened
Result<std::vector<Piece>> cutPiece(const Piece& piece, const std::vector<PathPolyline>& paths,
                                    const std::vector<CutId>& ids, const CutOptions& options,
                                    const Progress& progress, std::vector<OpenedCut>& opened) {
    auto cut = cutAlong(piece.mesh, paths, options, progress);
    if (!cut) {
        Error error = cut.error();
        error.subject = subjectOf(piece);
        return error;
    }
    MeshPart part;
    for (const int v : cut->sourceVertex) {
        part.sourceVertex.push_back(v < 0 ? -1 : piece.sourceVertex[v]);
    }
    for (const int f : cut->sourceFace) {
        part.sourceFace.push_back(piece.sourceFace[f]);
    }
    part.mesh = cut->mesh;
    std::vector<ConnectedPart> parts = connectedParts(std::move(part));
    std::vector<int> partOf(static_cast<std::size_t>(cut->mesh.V.rows()), -1);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        for (const int v : parts[p].vertex) {
            partOf[v] = static_cast<int>(p);
        }
    }
    const std::vector<Lineage> lineages =
        partLineages(piece.lineage, ids, *cut, partOf, static_cast<int>(parts.size()));
    const PartOrigins origins(piece, ids, paths, *cut);
    std::vector<Piece> made;
    for (auto& [connected, vertex] : parts) {
        Piece& next = made.emplace_back(makePiece(piece.name, std::move(connected.mesh)));
        next.lineage = lineages[made.size() - 1];
        next.id = idOf(next.lineage);
        nameDefect(next);
        next.origins = origins.of(next, vertex);
        next.file = piece.file;
        next.sourceVertex = std::move(connected.sourceVertex);
        next.sourceFace = std::move(connected.sourceFace);
        if (piece.reference) {
            next.reference.emplace(next.mesh.V.rows(), 2);
            for (std::size_t v = 0; v < vertex.size(); ++v) {
                next.reference->row(static_cast<Eigen::Index>(v)) =
                    panelPoint(*piece.reference, piece.mesh.F, cut->place[vertex[v]]);
            }
        }
    }
    opened = std::move(cut->cuts);
    return made;
}

bool cutsCanRepair(ErrorCode defect) {
    return defect == ErrorCode::ClosedSurface || defect == ErrorCode::SeveralLoops ||
           defect == ErrorCode::Handle;
}

class Cutter {
public:
    Cutter(const std::vector<PiecePointer>& uncut, bool automatic,
           const std::vector<CutRecord>& before, const CutProposer& proposer)
        : automatic_(automatic), proposer_(proposer), namesPiece_(uncut.size() > 1) {
        for (const PiecePointer& whole : uncut) {
            names_.take(whole->name);
        }
        for (const CutRecord& cut : before) {
            before_.emplace(cut.whole.get(), &cut);
        }
    }

    void cut(const PiecePointer& whole, std::vector<UserCut> requested, const Progress& progress) {
        const int way = automatic_ && proposer_.propose ? proposer_.way : 0;
        if (requested.empty() && !isToOpen(*whole) && !isToAskAbout(*whole) && !mayCross(*whole)) {
            made_.pieces.push_back(whole);
            return;
        }
        const auto known = before_.find(whole.get());
        if (known != before_.end() && known->second->requested == requested &&
            known->second->proposer == way && known->second->namesPiece == namesPiece_ &&
            known->second->automatic == automatic_ && areFree(*known->second)) {
            done_ = *known->second;
            for (const PiecePointer& part : done_.pieces) {
                names_.take(part->name);
            }
        } else {
            done_ = {whole, std::move(requested), automatic_, way, namesPiece_};
            cutAnew(whole, progress);
            partCrossings(Progress(progress, 0));
        }
        const auto append = [](auto& list, const auto& more) {
            list.insert(list.end(), more.begin(), more.end());
        };
        append(made_.pieces, done_.pieces);
        append(made_.cuts, done_.cuts);
        append(made_.problems, done_.problems);
        made_.records.push_back(std::move(done_));
    }

    CutPieces take() { return std::move(made_); }

    void fail(Error error) { made_.problems.push_back(std::move(error)); }

private:
    bool isToOpen(const Piece& piece) const {
        return automatic_ && piece.defect && cutsCanRepair(piece.defect->code);
    }

    /// Whether cuts can be proposed for a piece.
    bool isToAskAbout(const Piece& piece) const {
        return automatic_ && proposer_.propose &&
               (isToOpen(piece) || (proposer_.isForDisks && !piece.defect));
    }

    /// Whether a piece is divided if its flat outline crosses itself.
    bool mayCross(const Piece& piece) const {
        return automatic_ && proposer_.partCrossing && !piece.defect;
    }

    /// Whether its parts can get their earlier names.
    bool areFree(const CutRecord& cut) const {
        return std::ranges::all_of(cut.pieces, [&](const PiecePointer& part) {
            return part->name == cut.whole->name || names_.isFree(part->name);
        });
    }

    void cutAnew(const PiecePointer& whole, const Progress& progress) {
        std::vector<Piece> parts =
            byHand(*whole, done_.requested, Progress(progress, kByHandShare));
        if (parts.empty()) {  // no cut of the user, or none could be made
            if (!isToOpen(*whole) && !isToAskAbout(*whole)) {
                done_.pieces.push_back(whole);
                return;
            }
            parts.push_back(*whole);
        }
        PartNames nameOf;
        const auto isLeft = [this](const Piece& part) { return isToAskAbout(part); };
        if (parts.size() <= kMaxParts && std::ranges::any_of(parts, isLeft)) {
            nameOf = byProposal(whole, parts, Progress(progress, kByProposalShare));
            if (done_.cuts.empty() && !isToOpen(*whole)) {
                done_.pieces.push_back(whole);
                return;
            }
        }
        const bool several = parts.size() > 1;
        for (Piece& part : parts) {
            if (several) {
                part.name = freeName(*whole, nameOf ? nameOf(part) : std::string());
                nameDefect(part);
            }
            if (isToOpen(part)) {
                byItself(part, Progress(progress, (1 - kByHandShare - kByProposalShare) /
                                                      static_cast<double>(parts.size())));
            }
            done_.pieces.push_back(std::make_shared<Piece>(std::move(part)));
        }
    }

    using PartNames = std::function<std::string(const Piece&)>;

    /// The id of the last of some cuts, a proposed one: based on its name, so that it is stable if
    /// another cut is added or removed.
    static CutId idOf(const Piece& piece, const std::vector<UserCut>& cuts) {
        std::uint64_t hash = hashOf({piece.id.value, 'p', contentHash(cuts.back().name)});
        while (std::ranges::any_of(
            cuts, [hash](const UserCut& other) { return other.id.value == hash; })) {
            hash = hashOf({hash});
        }
        return {hash};
    }

    /// The name of a part. @param own  its own name within the piece; empty: a number
    std::string freeName(const Piece& whole, const std::string& own) {
        return own.empty()   ? names_.numbered(whole.name)
               : namesPiece_ ? names_.free(whole.name + ", " + own)
                             : names_.free(own);
    }

    /// Makes the proposed cuts in addition to the user's, if automatic cuts can open the parts that
    /// remain closed.
    /// @param parts  those after the user's cuts alone; replaced if others are made
    /// @return  the names of the parts
    PartNames byProposal(const PiecePointer& piece, std::vector<Piece>& parts,
                         const Progress& progress) {
        ProposedCuts proposed =
            proposer_.propose(piece, done_.requested, Progress(progress, kProposingShare));
        std::vector<UserCut> cuts = done_.requested;
        const std::size_t own = cuts.size();
        for (ProposedCut& one : proposed.cuts) {
            cuts.push_back(std::move(one.cut));
            if (namesPiece_) {
                cuts.back().name = piece->name + ", " + cuts.back().name;
            }
            cuts.back().id = idOf(*piece, cuts);
        }
        const CutRecord before = done_;
        done_.cuts.clear();
        std::vector<Piece> made;
        if (cuts.size() > own) {
            made = byHand(*piece, cuts, Progress(progress, 1 - kProposingShare));
        }
        done_.problems = before.problems;  // ignore problems of proposed cuts
        const bool isHopeless = std::ranges::any_of(made, [](const Piece& part) {
            return part.defect && !cutsCanRepair(part.defect->code);
        });
        if (made.empty() || isHopeless) {
            done_.cuts = before.cuts;
            const bool isEnough = cuts.size() == own && proposed.nameOf;  // it is recognised
            if (own == 0 && isToOpen(*piece) && !isEnough) {
                done_.problems.push_back({ErrorCode::NoBodySeen, subjectOf(*piece)});
            }
            return {};
        }
        for (AppliedCut& cut : done_.cuts) {
            const auto at = std::ranges::find(cuts, cut.id, &UserCut::id) - cuts.begin();
            if (at >= std::ssize(done_.requested)) {
                cut.author = CutAuthor::Automatic;
                cut.evidence = proposed.cuts[static_cast<std::size_t>(at) - own].evidence;
            }
        }
        parts = std::move(made);
        return std::move(proposed.nameOf);
    }

    /// The parts after some cuts; empty if no cut was made.
    std::vector<Piece> byHand(const Piece& piece, const std::vector<UserCut>& cuts,
                              const Progress& progress) {
        if (cuts.empty()) {
            return {};
        }
        const SurfaceLinks links(piece.mesh, piece.table);
        const NearestSurface nearest(piece.mesh);
        std::vector<PathPolyline> paths;
        std::vector<const UserCut*> traced;
        std::vector<CutId> ids;
        for (std::size_t c = 0; c < cuts.size() && !progress.isCancelled(); ++c) {
            auto path = traceUserCut(links, nearest, cuts[c], progress);
            if (path) {
                paths.push_back(std::move(*path));
                traced.push_back(&cuts[c]);
                ids.push_back(cuts[c].id);
            } else {
                failIn(piece, cuts[c], path.error());
            }
            progress.report(kTracingShare * static_cast<double>(c + 1) /
                            static_cast<double>(cuts.size()));
        }
        if (paths.empty()) {
            return {};
        }
        std::vector<OpenedCut> opened;
        auto parts = cutPiece(piece, paths, ids, {.leavesOut = true}, progress, opened);
        bool areAllOut = true;
        for (std::size_t c = 0; c < traced.size(); ++c) {
            const UserCut& cut = *traced[c];
            if (!parts || opened[c].error) {
                failIn(piece, cut, parts ? *opened[c].error : parts.error());
                continue;
            }
            areAllOut = false;
            if (opened[c].length > 0) {
                done_.cuts.push_back({cut.name, CutAuthor::User, cut.kind, piece.name,
                                      opened[c].length, ids[c], cut.evidence,
                                      positionsOf(piece.mesh, paths[c])});
            } else {
                done_.problems.push_back(cutError(
                    subjectOf(cut),
                    toile::worded(
                        "in %1 it runs along the outline or another cut, so it opens nothing",
                        {piece.name})));
            }
        }
        return areAllOut ? std::vector<Piece>{} : std::move(*parts);
    }

    void failIn(const Piece& piece, const UserCut& cut, const Error& error) {
        done_.problems.push_back(cutError(
            subjectOf(cut),
            toile::worded("in %1, %2", {piece.name, error.detail.empty()
                                                        ? toile::worded(describe(error.code).data())
                                                        : error.detail})));
    }

    /// Makes a disk of a piece, or stores the reason in its defect if that fails.
    void byItself(Piece& piece, const Progress& progress) {
        const auto proposal = proposeCuts(piece.mesh, piece.table, {}, progress);
        if (!proposal) {
            piece.defect = proposal.error();
            nameDefect(piece);
            return;
        }
        std::vector<CutId> ids;
        for (std::size_t c = 0; c < proposal->cuts.size(); ++c) {
            ids.push_back({hashOf({piece.id.value, 'a', c})});
        }
        std::vector<OpenedCut> opened;
        auto parts = cutPiece(piece, proposal->cuts, ids, {}, progress, opened);
        if (!parts || parts->size() != 1) {
            piece.defect = parts ? cutError(subjectOf(piece),
                                            toile::worded("the cuts would separate the piece"))
                                 : parts.error();
            return;
        }
        for (std::size_t c = 0; c < opened.size(); ++c) {
            done_.cuts.push_back({piece.name + ", automatic cut " + std::to_string(c + 1),
                                  CutAuthor::Automatic,
                                  UserCut::Kind::Path,
                                  piece.name,
                                  opened[c].length,
                                  ids[c],
                                  {},
                                  positionsOf(piece.mesh, proposal->cuts[c])});
        }
        piece = std::move(parts->front());
    }

    /// Divides pieces whose flat outline would cross itself, and then their parts.
    void partCrossings(const Progress& progress) {
        int count = 0;
        for (std::size_t p = 0; p < done_.pieces.size() && count < kMaxCrossingCuts;) {
            const PiecePointer piece = done_.pieces[p];
            const std::vector<int> way =
                mayCross(*piece) ? proposer_.partCrossing(*piece, progress) : std::vector<int>{};
            if (way.empty() || !divideAlong(piece, way, count, progress)) {
                ++p;
                continue;
            }
            ++count;
        }
    }

    /// Replaces a piece of the record by its parts along a path of edges.
    bool divideAlong(const PiecePointer& piece, const std::vector<int>& way, int number,
                     const Progress& progress) {
        const PathPolyline path = polylineOf(SurfaceLinks(piece->mesh, piece->table), way);
        const CutId id{hashOf({piece->id.value, 'x', static_cast<std::uint64_t>(number)})};
        std::vector<OpenedCut> opened;
        auto parts = cutPiece(*piece, {path}, {id}, {}, progress, opened);
        if (!parts || parts->size() < 2) {
            return false;
        }
        done_.cuts.push_back(
            {piece->name + ", automatic cut " + std::to_string(done_.cuts.size() + 1),
             CutAuthor::Automatic, UserCut::Kind::Path, piece->name, opened.front().length, id,
             toile::worded("its flat outline would cross itself"), positionsOf(piece->mesh, path)});
        const auto at = std::ranges::find(done_.pieces, piece);
        std::vector<PiecePointer> made;
        for (Piece& one : *parts) {
            one.name = names_.numbered(piece->name);
            nameDefect(one);
            made.push_back(std::make_shared<Piece>(std::move(one)));
        }
        done_.pieces.insert(done_.pieces.erase(at), made.begin(), made.end());
        return true;
    }

    const bool automatic_;
    const CutProposer& proposer_;
    const bool namesPiece_;
    std::unordered_map<const Piece*, const CutRecord*> before_;
    UniqueNames names_;
    CutRecord done_;  ///< of the current piece
    CutPieces made_;
};

}  // namespace

CutPieces cutPieces(const std::vector<PiecePointer>& uncut, std::vector<UserCut> cuts,
                    bool automatic, const Progress& progress, const std::vector<CutRecord>& before,
                    const CutProposer& proposer) {
    giveIds(cuts);
    CutOwners owners = findCutOwners(uncut, cuts, progress);
    Cutter cutter(uncut, automatic, before, proposer);
    for (Error& problem : owners.problems) {
        cutter.fail(std::move(problem));
    }
    const auto count = static_cast<double>(uncut.size());
    for (std::size_t p = 0; p < uncut.size() && !progress.isCancelled(); ++p) {
        cutter.cut(uncut[p], std::move(owners.cutsOf[p]), Progress(progress, 1 / count));
        progress.report(static_cast<double>(p + 1) / count);
    }
    return cutter.take();
}

namespace {

/// Lines are equal if their lengths differ by no more than this share.
constexpr double kSameLine = 0.01;

/// Which points of a line a cut keeps. The middle point identifies the piece if two meet at both
/// ends, like a lining and its shell.
enum class Kept { EndsAndMiddle, Bends, All };

UserCut cutAlongLine(const Piece& piece, const SurfaceLinks& links, const PathPolyline& line,
                     Kept kept) {
    UserCut cut;
    const std::size_t last = line.points.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
        const bool isOne = i == 0 || i == last || i == (last + 1) / 2;
        const bool isAtVertex = links.carrierOf(line.points[i]).kind == Carrier::Kind::Vertex;
        if (isOne || kept == Kept::All || (kept == Kept::Bends && isAtVertex)) {
            cut.points.push_back(positionOf(piece.mesh, line.points[i]));
        }
    }
    return cut;
}

/// Whether the cuts leave one disk, and follow their original lines.
bool doOpen(const std::shared_ptr<const Piece>& piece, const std::vector<UserCut>& cuts,
            const AutoCut& proposal, const Progress& progress) {
    const CutPieces made = cutPieces({piece}, cuts, false, progress);
    double wanted = 0, opened = 0;
    for (const PathPolyline& line : proposal.cuts) {
        wanted += line.length;
    }
    for (const AppliedCut& cut : made.cuts) {
        opened += cut.length;
    }
    return made.pieces.size() == 1 && !made.pieces.front()->defect && made.problems.empty() &&
           std::abs(opened - wanted) <= kSameLine * wanted;
}

}  // namespace

bool isOpenable(const Piece& piece) {
    constexpr ErrorCode kRepairable[] = {ErrorCode::ClosedSurface, ErrorCode::SeveralLoops,
                                         ErrorCode::Handle};
    return piece.defect &&
           std::ranges::find(kRepairable, piece.defect->code) != std::end(kRepairable);
}

Result<std::vector<UserCut>> openingCuts(const Piece& piece, bool isWhole,
                                         const Progress& progress) {
    const auto proposal = proposeCuts(piece.mesh, piece.table, {}, progress);
    if (!proposal) {
        return proposal.error();
    }
    const SurfaceLinks links(piece.mesh, piece.table);
    const auto alone = std::make_shared<const Piece>(piece);
    for (const Kept kept : {Kept::EndsAndMiddle, Kept::Bends, Kept::All}) {
        if (!isWhole && kept != Kept::All) {
            continue;
        }
        std::vector<UserCut> cuts;
        for (const PathPolyline& line : proposal->cuts) {
            cuts.push_back(cutAlongLine(piece, links, line, kept));
        }
        if (doOpen(alone, cuts, *proposal, progress)) {
            return cuts;
        }
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
    }
    return cutError(subjectOf(piece), worded("no cuts were found that open it"));
}

}  // namespace toile
