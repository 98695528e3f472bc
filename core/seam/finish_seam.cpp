// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "core/seam/matched_interval.h"

namespace toile::seam {
namespace {

// An end this close to a vertex, in local edge lengths, is snapped to the vertex.
constexpr double kEndAtVertex = 0.2;
// Vertices of the two sides that face each other within this fraction of the edge length are
// matched exactly, so that equally sampled sides have no rounding slivers between them.
constexpr double kSameVertex = 1e-6;

/// The same interval with its sides swapped, running along the other side's outline.
MatchedInterval turned(const MatchedInterval& interval) {
    MatchedInterval other = interval;
    std::swap(other.outlineA, other.outlineB);
    for (Correspondence& f : other.line) {
        std::swap(f.a, f.b);
    }
    if (!interval.parallel) {
        std::reverse(other.line.begin(), other.line.end());
    }
    return other;
}

/// Decides the kind, and turns an interval of a piece with itself so that a dart ends at its tip.
SeamKind settleKind(const Outlines& outlines, MatchedInterval& interval) {
    if (interval.outlineA != interval.outlineB) {
        // Rims of holes follow all outlines; the piece indices decide which side is the left one.
        if (outlines.list[interval.outlineB].piece < outlines.list[interval.outlineA].piece) {
            interval = turned(interval);
        }
        return SeamKind::Seam;
    }
    const FoldEnds foldEnds = foldEndsOf(interval, outlines);
    const bool point = foldEnds.start != foldEnds.end;
    const Outline& outline = outlines.list[interval.outlineA];
    if (point ? foldEnds.start
              : outline.wrap(interval.arcB().from) < outline.wrap(interval.arcA().from)) {
        interval = turned(interval);
    }
    return !point ? SeamKind::Seam : interval.folded ? SeamKind::Fold : SeamKind::Dart;
}

double onVertex(const Outline& outline, double s) {
    const double vertex = outline.nearestVertex(s);
    return std::abs(vertex - s) < kEndAtVertex * outline.spacingAt(s) ? vertex : s;
}

/// Arc lengths of the vertices strictly between two places.
std::vector<double> verticesBetween(const Outline& outline, double from, double to, double tiny) {
    std::vector<double> found;
    const double turns = from - outline.wrap(from);
    for (int k = outline.edgeAt(from);; ++k) {
        const double s = turns + outline.arcOf(k);
        if (s >= to - tiny) {
            return found;
        }
        if (s > from + tiny) {
            found.push_back(s);
        }
    }
}

/// A match that may be at a vertex of either side.
struct Mark {
    SeamMatch at;
    bool vertexA, vertexB;
};

std::vector<SeamMatch> matchesOf(const Outlines& outlines, const MatchedInterval& interval) {
    const Outline &a = outlines.list[interval.outlineA], &b = outlines.list[interval.outlineB];
    const double tiny = kSameVertex * interval.spacing(outlines);
    const Correspondence first = interval.line.front(), last = interval.line.back();
    std::vector<Mark> marks{{{first.a, first.b}, true, true}};
    for (const double s : verticesBetween(a, first.a, last.a, tiny)) {
        marks.push_back({{s, interval.atA(s).b}, true, false});
    }
    const auto [lowB, highB] = std::minmax(first.b, last.b);
    for (const double s : verticesBetween(b, lowB, highB, tiny)) {
        marks.push_back({{interval.atB(s).a, s}, false, true});
    }
    marks.push_back({{last.a, last.b}, true, true});
    const double sign = interval.parallel ? 1 : -1;
    std::ranges::stable_sort(
        marks, {}, [sign](const Mark& mark) { return mark.at.left + sign * mark.at.right; });
    std::vector<SeamMatch> matches;
    bool openA = false, openB = false;  // the last match is not yet a vertex of this side
    for (const Mark& mark : marks) {
        const bool same = !matches.empty() && std::abs(mark.at.left - matches.back().left) < tiny &&
                          std::abs(mark.at.right - matches.back().right) < tiny;
        if (!same) {
            matches.push_back(mark.at);
            openA = !mark.vertexA;
            openB = !mark.vertexB;
            continue;
        }
        if (openA && mark.vertexA) {
            matches.back().left = mark.at.left;
            openA = false;
        }
        if (openB && mark.vertexB) {
            matches.back().right = mark.at.right;
            openB = false;
        }
    }
    return matches;
}

/// The side from one place to another, counted so that its smaller place is in the first turn.
SeamSide sideOf(const Outline& outline, double start, double end) {
    SeamSide side{.piece = outline.piece, .reversed = end < start, .loop = outline.loop};
    const double low = std::min(start, end);
    const double shift = outline.wrap(low) - low;
    side.start = start + shift;
    side.end = end + shift;
    side.first = outline.edgeAt(low);
    const double tiny = kSameVertex * outline.spacingAt(low);
    const double high = std::max(side.start, side.end);
    side.count = 1;
    while (outline.arcOf(side.first + side.count) < high - tiny) {
        ++side.count;
    }
    return side;
}

}  // namespace

Seam finishSeam(const Outlines& outlines, MatchedInterval interval) {
    Seam seam;
    seam.kind = settleKind(outlines, interval);
    seam.stacked = interval.stacked;
    seam.gap = interval.meanGap();
    const Outline &a = outlines.list[interval.outlineA], &b = outlines.list[interval.outlineB];
    for (Correspondence* f : {&interval.line.front(), &interval.line.back()}) {
        f->a = onVertex(a, f->a);
        f->b = onVertex(b, f->b);
    }
    const double sign = interval.parallel ? 1 : -1;
    const Correspondence first = interval.line.front(), last = interval.line.back();
    // If an end moved inwards, its neighbours move with it.
    for (Correspondence& f : interval.line) {
        f.a = std::clamp(f.a, first.a, last.a);
        f.b = sign * std::clamp(sign * f.b, sign * first.b, sign * last.b);
    }
    seam.left = sideOf(a, first.a, last.a);
    seam.right = sideOf(b, first.b, last.b);
    seam.matches = matchesOf(outlines, interval);
    for (SeamMatch& match : seam.matches) {
        match.left += seam.left.start - first.a;
        match.right += seam.right.start - first.b;
    }
    seam.matches.front() = {seam.left.start, seam.right.start};
    seam.matches.back() = {seam.left.end, seam.right.end};
    seam.length3d[0] = seam.left.length();
    seam.length3d[1] = seam.right.length();
    const auto whole = [](const SeamSide& side, const Outline& outline) {
        return side.length() > (1 - kSameVertex) * outline.length();
    };
    seam.closed =
        whole(seam.left, a) && whole(seam.right, b) && interval.outlineA != interval.outlineB;
    return seam;
}

Seam freeEdge(const Outlines& outlines, int index, Arc arc) {
    const Outline& outline = outlines.list[index];
    Seam seam;
    seam.kind = SeamKind::Free;
    seam.left = sideOf(outline, arc.from, arc.to);
    seam.length3d[0] = seam.left.length();
    seam.closed = seam.left.length() > (1 - kSameVertex) * outline.length();
    return seam;
}

namespace {

// Step for comparing places, as a fraction of the garment's size, so that rounding is harmless.
constexpr double kSameCentre = 1e-6;

using Key = std::tuple<bool, int, int, SeamKind, std::array<double, 3>, double>;

Key keyOf(const Outlines& outlines, const Seam& seam) {
    const Outline& outline = outlines.list[outlines.indexOf(seam.left)];
    const Eigen::Vector3d middle = outline.pointAt(0.5 * (seam.left.start + seam.left.end));
    std::array<double, 3> place{};
    for (int k = 0; k < 3; ++k) {
        place[k] = std::round(middle[k] / (kSameCentre * outlines.size));
    }
    return {seam.kind == SeamKind::Free,
            seam.left.piece,
            seam.right.piece,
            seam.kind,
            place,
            seam.left.start};
}

/// The name without its number, and the noun to put before a number.
std::pair<std::string, std::string> baseName(const Pieces& pieces, const Seam& seam) {
    const std::string& left = pieces[seam.left.piece]->name;
    switch (seam.kind) {
        case SeamKind::Dart:
            return {left + ", dart", ""};
        case SeamKind::Fold:
            return {left + ", pleat", ""};
        case SeamKind::Free:
            return {left + ", free edge", ""};
        case SeamKind::Seam:
            break;
    }
    const bool itself = seam.left.piece == seam.right.piece;
    return {left + " / " + (itself ? "itself" : pieces[seam.right.piece]->name), ", seam"};
}

}  // namespace

void orderAndName(const Pieces& pieces, const Outlines& outlines, std::vector<Seam>& seams) {
    std::vector<std::pair<Key, std::size_t>> order;
    std::map<std::string, int> count, used;
    for (std::size_t k = 0; k < seams.size(); ++k) {
        order.emplace_back(keyOf(outlines, seams[k]), k);
        ++count[baseName(pieces, seams[k]).first];
    }
    std::sort(order.begin(), order.end());
    std::vector<Seam> sorted;
    for (const auto& entry : order) {
        Seam& seam = sorted.emplace_back(std::move(seams[entry.second]));
        const auto [base, noun] = baseName(pieces, seam);
        seam.name = count[base] > 1 ? base + noun + " " + std::to_string(++used[base]) : base;
    }
    seams = std::move(sorted);
}

}  // namespace toile::seam
