// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/find_seams.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
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

namespace toile::seam {
namespace {

// Cuts closer to each other than this fraction of the local edge length are merged. Parts that
// overlap by less do not compete.
constexpr double kMargin = 0.25;
// Below this fraction of the edge length two sides coincide: smaller gaps count as equal.
constexpr double kNoGap = 1e-3;
// A fold of a pleat is accepted only if no other seam competes for the place, or if that seam is
// this many times farther away: in a stack of layers everything is near.
constexpr double kFoldFactor = 10;

/// A part of a candidate: the unit of choice.
struct Part {
    int parent = 0;  ///< the candidate
    MatchedInterval interval;
    double cost = 0;         ///< gap relative to the local edge length; 0 if the sides coincide
    bool contested = false;  ///< another part overlaps this one
};

/// Those of the sorted places (in [0, length)) that lie inside `arc`, counted on like the arc.
std::vector<double> inside(const std::vector<double>& places, double length, Arc arc) {
    std::vector<double> found;
    double turn = std::floor(arc.from / length) * length;
    while (turn < arc.to) {
        auto at = std::lower_bound(places.begin(), places.end(), arc.from - turn);
        for (; at != places.end() && turn + *at < arc.to; ++at) {
            found.push_back(turn + *at);
        }
        turn += length;
    }
    return found;
}

std::vector<std::vector<double>> intervalEnds(const Outlines& outlines,
                                              const std::vector<MatchedInterval>& intervals) {
    std::vector<std::vector<double>> ends(outlines.list.size());
    for (const MatchedInterval& interval : intervals) {
        for (const Correspondence& f : {interval.line.front(), interval.line.back()}) {
            ends[interval.outlineA].push_back(outlines.list[interval.outlineA].wrap(f.a));
            ends[interval.outlineB].push_back(outlines.list[interval.outlineB].wrap(f.b));
        }
    }
    for (auto& places : ends) {
        std::sort(places.begin(), places.end());
    }
    return ends;
}

double costOf(const MatchedInterval& interval, const Outlines& outlines) {
    double cost = interval.meanGap() / interval.spacing(outlines);
    cost = cost < kNoGap ? 0 : cost;
    return interval.folded ? kFoldFactor * std::max(cost, kNoGap) : cost;
}

struct Claim {
    double from, to;
    int part;
};

/// Marks the parts that overlap another part on one outline.
void markContested(std::vector<Claim>& claims, double margin, std::vector<Part>& parts) {
    std::ranges::sort(claims, {}, [](const Claim& c) { return std::pair(c.from, c.part); });
    std::vector<Claim> open;
    for (const Claim& claim : claims) {
        std::erase_if(open, [&](const Claim& c) { return c.to <= claim.from + margin; });
        for (const Claim& other : open) {
            if (claim.to > claim.from + margin && other.part != claim.part) {
                parts[other.part].contested = parts[claim.part].contested = true;
            }
        }
        open.push_back(claim);
    }
}

void findContests(const Outlines& outlines, std::vector<Part>& parts) {
    std::vector<std::vector<Claim>> claims(outlines.list.size());
    const auto claim = [&](int piece, Arc arc, int part) {
        const Outline& outline = outlines.list[piece];
        const double from = outline.wrap(arc.from), to = from + arc.to - arc.from;
        claims[piece].push_back({from, std::min(to, outline.length()), part});
        if (to > outline.length()) {
            claims[piece].push_back({0, to - outline.length(), part});
        }
    };
    for (std::size_t k = 0; k < parts.size(); ++k) {
        claim(parts[k].interval.outlineA, parts[k].interval.arcA(), static_cast<int>(k));
        claim(parts[k].interval.outlineB, parts[k].interval.arcB(), static_cast<int>(k));
    }
    for (std::size_t p = 0; p < claims.size(); ++p) {
        const Outline& outline = outlines.list[p];
        if (outline.size() > 0) {
            markContested(claims[p], kMargin * outline.length() / outline.size(), parts);
        }
    }
}

/// Splits every interval where others begin or end on either of its outlines, and finds the parts
/// that compete.
std::vector<Part> cutIntoParts(const Outlines& outlines,
                               const std::vector<MatchedInterval>& intervals) {
    const auto ends = intervalEnds(outlines, intervals);
    std::vector<Part> parts;
    for (std::size_t k = 0; k < intervals.size(); ++k) {
        const MatchedInterval& interval = intervals[k];
        std::vector<double> cuts = inside(
            ends[interval.outlineA], outlines.list[interval.outlineA].length(), interval.arcA());
        for (const double b : inside(ends[interval.outlineB],
                                     outlines.list[interval.outlineB].length(), interval.arcB())) {
            cuts.push_back(interval.atB(b).a);
        }
        std::sort(cuts.begin(), cuts.end());
        const double margin = kMargin * interval.spacing(outlines);
        double from = interval.line.front().a;
        const double to = interval.line.back().a;
        const auto add = [&](double until) {
            Part part{.parent = static_cast<int>(k), .interval = interval.part({from, until})};
            part.cost = costOf(part.interval, outlines);
            parts.push_back(std::move(part));
            from = until;
        };
        for (const double cut : cuts) {
            if (cut > from + margin && cut < to - margin) {
                add(cut);
            }
        }
        add(to);
    }
    findContests(outlines, parts);
    return parts;
}

// Remainders beside chosen intervals that are shorter than this many local edges are end effects.
constexpr double kMinRest = 0.25;
// The same for edges that certainly match: only rounding is shorter.
constexpr double kMinCertain = 1e-9;
// If a garment's seams are closed more tightly than the tolerance, an interval is accepted only if
// its gap is below this many times the median, or below this fraction of the edge length.
constexpr double kGapTimesMedian = 10;
constexpr double kGapAlways = 0.05;
// Intervals found by proximity that are shorter than this many local edges are rejected.
constexpr double kShortest = 0.9;
// Sides closer than this many local edges coincide.
constexpr double kCoincident = 1e-4;
// A third layer must lie this close, relative to the local edge length.
constexpr double kStackedGap = 0.05;

class Chooser {
public:
    Chooser(const Outlines& outlines, const std::vector<MatchedInterval>& candidates)
        : outlines_(outlines), candidates_(candidates), parts_(cutIntoParts(outlines, candidates)) {
        revisit({});
    }

    std::vector<MatchedInterval> choose() {
        const std::vector<int> order = orderOfChoice();
        std::vector<MatchedInterval> chosen;
        for (const int k : order) {
            takeFree(parts_[k], chosen);
        }
        chosen = joinIntervals(outlines_, std::move(chosen), taken_);
        accept(chosen);
        revisit(chosen);
        std::vector<MatchedInterval> layers;
        for (const int k : order) {
            takeStacked(parts_[k], layers);
        }
        layers = joinIntervals(outlines_, std::move(layers), taken_);
        accept(layers);
        chosen.insert(chosen.end(), layers.begin(), layers.end());
        return chosen;
    }

private:
    std::vector<int> orderOfChoice() const {
        std::vector<double> undisputed(candidates_.size(), 0);
        for (const Part& part : parts_) {
            undisputed[part.parent] += part.contested ? 0 : part.interval.length();
        }
        std::vector<int> order(parts_.size());
        std::iota(order.begin(), order.end(), 0);
        std::ranges::stable_sort(order, {}, [&](int k) {
            const Part& part = parts_[k];
            return std::tuple(part.cost, -undisputed[part.parent], -part.interval.length());
        });
        return order;
    }

    void take(const MatchedInterval& interval) {
        taken_[interval.outlineA].add(interval.arcA());
        taken_[interval.outlineB].add(interval.arcB());
    }

    /// Chooses the stretches of the part that are free on both sides.
    void takeFree(const Part& part, std::vector<MatchedInterval>& chosen) {
        const double least =
            (part.interval.certain ? kMinCertain : kMinRest) * part.interval.spacing(outlines_);
        for (const Arc& a : taken_[part.interval.outlineA].outside(part.interval.arcA())) {
            const MatchedInterval half = part.interval.part(a);
            if (half.line.size() < 2 || half.length() < least) {
                continue;
            }
            for (const Arc& b : taken_[half.outlineB].outside(half.arcB())) {
                const MatchedInterval rest = half.partOnB(b);
                if (rest.line.size() > 1 && std::min(rest.length(), rest.lengthB()) >= least) {
                    chosen.push_back(rest);
                    take(rest);
                }
            }
        }
    }

    /// Chooses the stretches of the part that are free on one side only.
    void takeStacked(const Part& part, std::vector<MatchedInterval>& chosen) {
        if (part.cost > kStackedGap || part.interval.folded) {
            return;
        }
        const MatchedInterval& interval = part.interval;
        for (const Arc& a : taken_[interval.outlineA].outside(interval.arcA())) {
            takeLayer(interval.part(a), chosen);
        }
        for (const Arc& b : taken_[interval.outlineB].outside(interval.arcB())) {
            takeLayer(interval.partOnB(b), chosen);
        }
    }

    void takeLayer(const MatchedInterval& interval, std::vector<MatchedInterval>& chosen) {
        if (interval.line.size() > 1 &&
            interval.length() >= kMinRest * interval.spacing(outlines_)) {
            chosen.push_back(interval);
            chosen.back().stacked = true;
            take(interval);
        }
    }

    /// Removes intervals that are too short, or gape far more than this garment's seams.
    void accept(std::vector<MatchedInterval>& intervals) {
        const auto gapOf = [&](const MatchedInterval& interval) {
            return interval.meanGap() / interval.spacing(outlines_);
        };
        if (widest_ < 0) {
            std::vector<std::pair<double, double>> gaps;  // gap, length
            double total = 0;
            for (const MatchedInterval& interval : intervals) {
                gaps.emplace_back(gapOf(interval), interval.length());
                total += interval.length();
            }
            std::sort(gaps.begin(), gaps.end());
            double median = 0, below = 0;
            for (std::size_t k = 0; k < gaps.size() && below < 0.5 * total; ++k) {
                median = gaps[k].first;
                below += gaps[k].second;
            }
            widest_ = std::max(kGapAlways, kGapTimesMedian * median);
        }
        std::erase_if(intervals, [&](const MatchedInterval& interval) {
            // A whole edge that coincides with another is no accident; proximity needs more length.
            const double gap = gapOf(interval);
            const double least = gap < kCoincident ? kMinRest : kShortest;
            const double length = std::min(interval.length(), interval.lengthB());
            return !interval.certain &&
                   (length < least * interval.spacing(outlines_) || gap > widest_);
        });
    }

    void revisit(const std::vector<MatchedInterval>& intervals) {
        taken_.clear();
        for (const Outline& outline : outlines_.list) {
            taken_.emplace_back(outline.length());
        }
        for (const MatchedInterval& interval : intervals) {
            take(interval);
        }
    }

    const Outlines& outlines_;
    const std::vector<MatchedInterval>& candidates_;
    std::vector<Part> parts_;
    std::vector<ArcSet> taken_;
    double widest_ = -1;  ///< largest accepted gap in local edge lengths; negative: not yet known
};

}  // namespace

std::vector<MatchedInterval> chooseIntervals(const Outlines& outlines,
                                             const std::vector<MatchedInterval>& candidates) {
    return Chooser(outlines, candidates).choose();
}

}  // namespace toile::seam
