// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/find_seams.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "core/seam/contacts.h"
#include "core/seam/matched_interval.h"
#include "core/seam/seam_measure.h"
#include "core/seam/seam_settings.h"

namespace toile {
namespace {

// Outline between two seams that is shorter than this many local edges is not a free edge.
constexpr double kShortestFree = 0.5;

void addFreeEdges(const seam::Outlines& outlines, std::vector<Seam>& seams) {
    std::vector<seam::ArcSet> sewn;
    std::vector<double> begin(outlines.list.size(), 0);  // a start that does not split a free edge
    std::vector<char> isSewn(outlines.list.size(), 0);
    for (const seam::Outline& outline : outlines.list) {
        sewn.emplace_back(outline.length());
    }
    for (const Seam& seam : seams) {
        for (const SeamSide& side : {seam.left, seam.right}) {
            const auto [low, high] = std::minmax(side.start, side.end);
            const int index = outlines.indexOf(side);
            sewn[index].add({low, high});
            begin[index] = low;
            isSewn[index] = 1;
        }
    }
    for (std::size_t p = 0; p < outlines.list.size(); ++p) {
        const seam::Outline& outline = outlines.list[p];
        // A buttonhole is not an edge that somebody might have forgotten to sew.
        if (outline.size() == 0 || (outline.loop > 0 && !isSewn[p])) {
            continue;
        }
        for (const seam::Arc& arc : sewn[p].outside({begin[p], begin[p] + outline.length()})) {
            if (arc.to - arc.from > kShortestFree * outline.spacingAt(arc.from)) {
                seams.push_back(seam::freeEdge(outlines, static_cast<int>(p), arc));
            }
        }
    }
}

void indexEdges(const seam::Outlines& outlines, SeamGraph& graph) {
    const std::size_t pieces = outlines.firstHole.size();
    for (std::size_t p = 0; p < pieces; ++p) {
        graph.seamsOfEdge.emplace_back(outlines.list[p].size());
    }
    graph.seamsOfHoles.resize(pieces);
    const auto add = [](std::vector<int>& list, std::size_t seam) {
        if (list.empty() || list.back() != static_cast<int>(seam)) {
            list.push_back(static_cast<int>(seam));
        }
    };
    for (std::size_t k = 0; k < graph.seams.size(); ++k) {
        for (const SeamSide& side : {graph.seams[k].left, graph.seams[k].right}) {
            if (side.piece >= 0 && side.loop > 0) {
                add(graph.seamsOfHoles[side.piece], k);
                continue;
            }
            for (int e = 0; e < side.count; ++e) {
                add(graph.seamsOfEdge[side.piece]
                                     [outlines.list[side.piece].wrapIndex(side.first + e)],
                    k);
            }
        }
    }
}

/// Seams found by proximity: their edges are near each other but do not coincide.
struct GuessedSeams {
    long long count = 0;
    double widest = 0;  ///< gap, mm

    void add(const seam::Outlines& outlines, const seam::MatchedInterval& interval) {
        const auto most = std::ranges::max_element(interval.line, {}, &seam::Correspondence::gap);
        if (!interval.certain && most->gap > seam::kCoincidentShare * outlines.size) {
            ++count;
            widest = std::max(widest, most->gap);
        }
    }
    Problems notes() const {
        return count == 0 ? Problems{}
                          : Problems{{ErrorCode::SeamsByNearness,
                                      {},
                                      counted(count, "seam") + ", at most " + fixed(widest, 2) +
                                          " mm apart"}};
    }
};

/// One note for all crowded places, because they usually occur in numbers.
Problems notesOf(const std::vector<seam::CrowdedPlace>& crowded) {
    const auto worst = std::ranges::max_element(crowded, {}, &seam::CrowdedPlace::edges);
    if (worst == crowded.end()) {
        return {};
    }
    const Eigen::Vector3d& at = worst->middle;
    return {{ErrorCode::EdgesCrowd,
             {},
             counted(static_cast<long long>(crowded.size()), "place") + ", with up to " +
                 std::to_string(worst->edges) + " edges, as at " + fixed(at.x(), 1) + ", " +
                 fixed(at.y(), 1) + ", " + fixed(at.z(), 1) + " mm"}};
}

}  // namespace

SeamGraph findSeams(const Pieces& pieces, const SeamOptions& options, const Progress& progress) {
    const auto goesOnAt = [&progress](double share) {
        progress.report(share);
        return !progress.isCancelled();
    };
    const seam::Outlines outlines = seam::buildOutlines(pieces);
    if (!goesOnAt(0.3)) {
        return {};
    }
    std::vector<char> settled(outlines.edgeCount(), 0);
    std::vector<seam::Contact> contacts = seam::sharedContacts(pieces, outlines, settled);
    std::vector<seam::CrowdedPlace> crowded;
    std::vector<seam::Contact> near = seam::nearContacts(outlines, options.gap, settled, crowded);
    seam::dropContradicted(pieces, outlines, contacts, near);
    if (!goesOnAt(0.6)) {
        return {};
    }
    contacts.insert(contacts.end(), near.begin(), near.end());
    seam::keepConsistentWinding(outlines, contacts);

    SeamGraph graph;
    graph.notes = notesOf(crowded);
    const std::vector<seam::MatchedInterval> intervals = seam::chainContacts(outlines, contacts);
    if (!goesOnAt(0.8)) {
        return {};
    }
    GuessedSeams guessed;
    for (seam::MatchedInterval& interval : seam::chooseIntervals(outlines, intervals)) {
        guessed.add(outlines, interval);
        graph.seams.push_back(seam::finishSeam(outlines, std::move(interval)));
    }
    const Problems guesses = guessed.notes();
    graph.notes.insert(graph.notes.end(), guesses.begin(), guesses.end());
    addFreeEdges(outlines, graph.seams);
    seam::orderAndName(pieces, outlines, graph.seams);
    traceOrigins(pieces, outlines, graph.seams);
    indexEdges(outlines, graph);
    progress.report(1);
    return graph;
}

namespace {

constexpr const char* kMirrorSeam = "mirror seam";
/// Largest distance of its points from the plane, mm: rounding.
constexpr double kOffPlane = 1e-3;

bool liesInMirror(const SeamSide& side, const Garment& garment) {
    const Piece& piece = *garment.pieces[side.piece];
    const SourceFile& file = *garment.files[piece.file];
    if (!file.reading.half || !file.reading.half->isCompleted) {
        return false;
    }
    const Points3 line = spaceLine(side, piece);
    return std::ranges::all_of(line.rowwise(), [&](const auto& point) {
        const Eigen::Vector3d inFile = asInFile(file.up, point).transpose();
        return std::abs(file.reading.half->plane.signedDistance(inFile)) < kOffPlane;
    });
}

}  // namespace

void nameMirrorSeams(SeamGraph& seams, const Garment& garment) {
    std::set<std::string> taken;
    std::vector<Seam*> mirrored;
    for (Seam& seam : seams.seams) {
        const bool isMirrored = seam.kind == SeamKind::Seam && seam.cuts.empty() &&
                                liesInMirror(seam.left, garment) &&
                                liesInMirror(seam.right, garment);
        if (isMirrored) {
            mirrored.push_back(&seam);
        } else {
            taken.insert(seam.name);
        }
    }
    int number = mirrored.size() > 1 ? 1 : 0;
    for (Seam* seam : mirrored) {
        do {
            seam->name = kMirrorSeam + (number > 0 ? " " + std::to_string(number) : "");
            ++number;
        } while (!taken.insert(seam->name).second);
    }
}

}  // namespace toile
