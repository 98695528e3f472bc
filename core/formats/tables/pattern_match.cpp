// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/tables/pattern_match.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/base/wording.h"
#include "core/formats/pattern_file.h"
#include "core/geometry/placement.h"
#include "core/geometry/polygon.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

using geometry::CentredPlaces, geometry::NearestOnLine;

constexpr int kRoughPoints = 128;
constexpr int kFinePoints = 400;
constexpr int kMaxFitPoints = 20000;
constexpr int kMaxFitRounds = 40;
constexpr double kSettled = 1e-7;       // mm, change of the mean per round
constexpr double kMirrorShare = 0.8;    // a mirrored fit must be better by this factor
constexpr double kMirrorLength = 0.05;  // and by this distance, mm

/// Points of a closed line at equal distances along it, starting at its first point.
Points2 evenPoints(const Points2& closed, int count) {
    const double length = geometry::perimeterOf(closed);
    Points2 points(count, 2);
    Eigen::Index k = 0;
    double begin = 0;
    double step = (closed.row(1 % closed.rows()) - closed.row(0)).norm();
    for (int n = 0; n < count; ++n) {
        const double at = length * n / count;
        while (k + 1 < closed.rows() && begin + step < at) {
            begin += step;
            ++k;
            step = (closed.row((k + 1) % closed.rows()) - closed.row(k)).norm();
        }
        const double share = step > 0 ? std::clamp((at - begin) / step, 0.0, 1.0) : 0;
        points.row(n) =
            closed.row(k) + share * (closed.row((k + 1) % closed.rows()) - closed.row(k));
    }
    return points;
}

Points2 mirroredLine(const Points2& closed) {
    Points2 image = closed.colwise().reverse();  // so that it runs anti-clockwise again
    image.col(0) *= -1;
    return image;
}

CentredPlaces centred(const Points2& points, Eigen::RowVector2d& middle) {
    middle = points.colwise().mean();
    CentredPlaces numbers;
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        numbers.emplace_back(points(k, 0) - middle.x(), points(k, 1) - middle.y());
    }
    return numbers;
}

bool isLine(const Points2& closed) {
    return closed.rows() > 2 && closed.allFinite() && geometry::perimeterOf(closed) > 0;
}

Points2 turned(const Points2& points, double angle, const Eigen::RowVector2d& from,
               const Eigen::RowVector2d& to) {
    const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(angle).toRotationMatrix();
    return ((points.rowwise() - from) * rotation.transpose()).rowwise() + to;
}

/// Pairs of each point of either line with the nearest point on the other line.
struct NearPairs {
    Points2 first, second;

    NearPairs(const NearestOnLine& line, const Points2& points, const NearestOnLine& other,
              const Points2& otherPoints)
        : first(points.rows() + otherPoints.rows(), 2), second(first.rows(), 2) {
        for (Eigen::Index k = 0; k < points.rows(); ++k) {
            first.row(k) = points.row(k);
            second.row(k) = other(points.row(k));
        }
        for (Eigen::Index k = 0; k < otherPoints.rows(); ++k) {
            first.row(points.rows() + k) = line(otherPoints.row(k));
            second.row(points.rows() + k) = otherPoints.row(k);
        }
    }

    Eigen::VectorXd distances() const { return (first - second).rowwise().norm(); }
};

/// Even points and the line's own points, as even points miss corners.
Points2 pointsToTry(const Points2& closed) {
    Points2 even = evenPoints(closed, kFinePoints);
    if (closed.rows() > kFinePoints) {
        return even;
    }
    Points2 all(even.rows() + closed.rows(), 2);
    all << even, closed;
    return all;
}

LineFit settledFit(const Points2& line, Points2 other, bool mirrored) {
    other = mirrored ? mirroredLine(other) : other;
    Eigen::RowVector2d middle, otherMiddle;
    const auto even = centred(evenPoints(line, kRoughPoints), middle);
    const auto otherEven = centred(evenPoints(other, kRoughPoints), otherMiddle);
    const auto best = geometry::bestLikeness(even, otherEven).likeness;
    other = turned(other, std::arg(best), otherMiddle, middle);
    const Points2 points = pointsToTry(line);
    const NearestOnLine onLine(line);
    LineFit fit{other, mirrored, std::numeric_limits<double>::infinity(), 0};
    for (int round = 0; round < kMaxFitRounds; ++round) {
        const NearPairs pairs(onLine, points, NearestOnLine(other), pointsToTry(other));
        const Eigen::VectorXd distances = pairs.distances();
        const double mean = distances.mean();
        if (!(mean < fit.mean)) {
            break;
        }
        const bool isSettled = fit.mean - mean < kSettled;
        fit = {other, mirrored, mean, distances.maxCoeff(),
               std::sqrt(distances.squaredNorm() / static_cast<double>(distances.size()))};
        if (isSettled) {
            break;
        }
        other = geometry::fitMotion(pairs.second, pairs.first).appliedToRows(other);
    }
    return fit;
}

/// Resamples lines with an implausible number of points.
Points2 fewerPoints(const Points2& closed) {
    return closed.rows() > kMaxFitPoints ? evenPoints(closed, kMaxFitPoints) : closed;
}

}  // namespace

double roughDistance(const Points2& line, const Points2& other, bool mirrored) {
    if (!isLine(line) || !isLine(other)) {
        return std::numeric_limits<double>::infinity();
    }
    Eigen::RowVector2d middle;
    const auto even = centred(evenPoints(line, kRoughPoints), middle);
    const auto otherEven =
        centred(evenPoints(mirrored ? mirroredLine(other) : other, kRoughPoints), middle);
    const double best = std::abs(geometry::bestLikeness(even, otherEven).likeness);
    const double square = geometry::squaresOf(even) + geometry::squaresOf(otherEven) - 2 * best;
    return std::sqrt(std::max(0.0, square) / kRoughPoints);
}

LineFit fitLine(const Points2& line, const Points2& other, bool canMirror) {
    if (!isLine(line) || !isLine(other)) {
        return {};
    }
    const Points2 first = geometry::antiClockwise(fewerPoints(line)),
                  second = geometry::antiClockwise(fewerPoints(other));
    LineFit plain = settledFit(first, second, false);
    if (!canMirror) {
        return plain;
    }
    LineFit image = settledFit(first, second, true);
    const bool isBetter = image.mean < kMirrorShare * plain.mean - kMirrorLength;
    return isBetter ? image : plain;
}

namespace {

constexpr Word<MatchedBy> kMatchedByWords[] = {
    {MatchedBy::Id, "id"}, {MatchedBy::Name, "name"}, {MatchedBy::Shape, "shape"}};

/// Largest differences of the lengths and areas of pieces matched by shape.
constexpr double kMaxMatchLength = 0.15, kMaxMatchArea = 0.25;
/// Differences beyond which a match is doubtful: of length, area, and the mean distance as a
/// fraction of the root of the area.
constexpr double kDoubtLength = 0.05, kDoubtArea = 0.08, kDoubtDistance = 0.03;
/// Largest rough distance of matching shapes, as a fraction of the root of the area.
constexpr double kMaxMatchApart = 0.25;
/// A rival's distance is at most this factor times the match's distance plus this many mm.
constexpr double kRivalShare = 1.25, kRivalLength = 1;
/// A mirrored pair must be closer than an unmirrored one by this distance, mm.
constexpr double kForMirrored = 0.5;
/// Larger files are not matched by shape: patterns have up to a few hundred pieces.
constexpr std::size_t kMaxMatchCandidates = 1000;

/// Whether the larger size exceeds the other by at most this share.
bool isNear(double size, double other, double share) {
    return std::max(size, other) <= (1 + share) * std::min(size, other);
}

class PatternMatcher {
public:
    PatternMatcher(const Pattern& pattern, const PatternFile& file)
        : pattern_(pattern), file_(file) {
        for (int k = 0; k < static_cast<int>(pattern.pieces.size()); ++k) {
            if (ours(k).outline.rows() > 2) {
                free_.push_back(k);
            }
        }
        freeInFile_ = sampleOf(file);
        std::erase_if(freeInFile_, [this](int k) { return outlineOf(theirs(k)).rows() < 3; });
    }

    PatternMatch matched() {
        pairByText(MatchedBy::Id);
        pairByText(MatchedBy::Name);
        pairByShape();
        std::ranges::sort(match_.pairs, {}, &PieceMatch::piece);
        for (PieceMatch& pair : match_.pairs) {
            compareLines(pair);
        }
        match_.alone = free_;
        match_.aloneInFile = freeInFile_;
        return std::move(match_);
    }

private:
    const PatternPiece& ours(int k) const { return pattern_.pieces[static_cast<std::size_t>(k)]; }
    const FilePiece& theirs(int k) const { return file_.pieces[static_cast<std::size_t>(k)]; }

    void pair(int piece, int filePiece, MatchedBy by, std::vector<int> rivals = {}) {
        match_.pairs.push_back({piece, filePiece, by, {}, std::move(rivals)});
        std::erase(free_, piece);
        std::erase(freeInFile_, filePiece);
    }

    /// Texts by which a file may name one of our pieces.
    std::vector<std::string> textsOf(const PatternPiece& piece, MatchedBy by) const {
        if (by == MatchedBy::Name) {
            return {plainName(piece.name)};
        }
        return {plainName(piece.slug), plainName("piece-" + piece.slug), idText(piece.id)};
    }

    /// Matches pieces by texts that occur once on either side.
    void pairByText(MatchedBy by) {
        std::map<std::string, std::vector<int>> called;
        for (const int k : freeInFile_) {
            const FilePiece& piece = theirs(k);
            called[plainName(by == MatchedBy::Id ? piece.id : piece.name)].push_back(k);
        }
        std::map<int, std::vector<int>> found;  // by piece of the file: our candidates
        for (const int k : free_) {
            for (const std::string& text : textsOf(ours(k), by)) {
                const auto there = called.find(text);
                if (!text.empty() && there != called.end() && there->second.size() == 1) {
                    auto& pieces = found[there->second.front()];
                    if (std::ranges::find(pieces, k) == pieces.end()) {
                        pieces.push_back(k);
                    }
                }
            }
        }
        for (const auto& [filePiece, pieces] : found) {
            if (pieces.size() == 1 && std::ranges::find(free_, pieces.front()) != free_.end()) {
                pair(pieces.front(), filePiece, by);
            }
        }
    }

    struct Candidate {
        double distance = 0;
        bool mirrored = false;
        int piece = 0, filePiece = 0;

        double cost() const { return distance + (mirrored ? kForMirrored : 0); }
    };

    static bool isAlike(const Points2& a, const Points2& b) {
        return isNear(geometry::perimeterOf(a), geometry::perimeterOf(b), kMaxMatchLength) &&
               isNear(std::abs(geometry::signedAreaOf(a)), std::abs(geometry::signedAreaOf(b)),
                      kMaxMatchArea);
    }

    /// The line whose shape is compared.
    const Points2& shapeOf(const PatternPiece& piece, const FilePiece& other) const {
        return other.sew.rows() > 0 ? piece.outline : edgeOf(piece);
    }

    void pairByShape() {
        if (freeInFile_.size() > kMaxMatchCandidates) {
            return;
        }
        std::vector<Candidate> candidates;
        for (const int k : free_) {
            for (const int f : freeInFile_) {
                const FilePiece& other = theirs(f);
                const Points2& line = shapeOf(ours(k), other);
                const Points2& otherLine = other.sew.rows() > 0 ? other.sew : other.cut;
                if (!isAlike(line, otherLine)) {
                    continue;
                }
                const double plain = roughDistance(line, geometry::antiClockwise(otherLine), false),
                             image = roughDistance(line, geometry::antiClockwise(otherLine), true);
                const bool mirrored = image + kForMirrored < plain;
                const double distance = mirrored ? image : plain;
                if (distance < kMaxMatchApart * std::sqrt(std::abs(geometry::signedAreaOf(line)))) {
                    candidates.push_back({distance, mirrored, k, f});
                }
            }
        }
        std::ranges::stable_sort(candidates, {}, &Candidate::cost);
        const std::vector<int> pieces = free_, filePieces = freeInFile_;
        for (const Candidate& best : candidates) {
            const bool isFree = std::ranges::find(free_, best.piece) != free_.end() &&
                                std::ranges::find(freeInFile_, best.filePiece) != freeInFile_.end();
            if (!isFree) {
                continue;
            }
            std::vector<int> rivals;
            for (const Candidate& other : candidates) {
                if (other.piece == best.piece && other.filePiece != best.filePiece &&
                    (best.mirrored || !other.mirrored) &&
                    other.distance < kRivalShare * best.distance + kRivalLength) {
                    rivals.push_back(other.filePiece);
                }
            }
            pair(best.piece, best.filePiece, MatchedBy::Shape, std::move(rivals));
        }
    }

    void compareLines(PieceMatch& pair) const {
        const PatternPiece& piece = ours(pair.piece);
        const FilePiece& other = theirs(pair.filePiece);
        const auto add = [&pair](MatchedLine which, const Points2& line, MatchedLine whichOther,
                                 const Points2& otherLine) {
            LineMatch& match = pair.lines.emplace_back();
            match.ours = which;
            match.theirs = whichOther;
            match.fit = fitLine(line, otherLine);
            match.lengthOurs = geometry::perimeterOf(line);
            match.lengthTheirs = geometry::perimeterOf(otherLine);
            match.areaOurs = std::abs(geometry::signedAreaOf(line));
            match.areaTheirs = std::abs(geometry::signedAreaOf(otherLine));
        };
        const bool hasCut = piece.cuttingLine.rows() > 0;
        if (other.sew.rows() > 0) {
            add(MatchedLine::Seam, piece.outline, MatchedLine::Seam, other.sew);
        }
        if (other.cut.rows() > 0 && hasCut) {
            add(MatchedLine::Cut, piece.cuttingLine, MatchedLine::Cut, other.cut);
        } else if (other.cut.rows() > 0 && other.sew.rows() == 0) {
            add(MatchedLine::Seam, piece.outline, MatchedLine::Cut, other.cut);
        }
    }

    const Pattern& pattern_;
    const PatternFile& file_;
    PatternMatch match_;
    std::vector<int> free_, freeInFile_;
};

}  // namespace

bool PieceMatch::isDoubtful() const {
    return !rivals.empty() || std::ranges::any_of(lines, [](const LineMatch& line) {
        return !isNear(line.lengthOurs, line.lengthTheirs, kDoubtLength) ||
               !isNear(line.areaOurs, line.areaTheirs, kDoubtArea) ||
               line.fit.mean > kDoubtDistance * std::sqrt(line.areaOurs);
    });
}

std::string_view name(MatchedBy by) {
    return wordOf(kMatchedByWords, by);
}

std::string plainName(std::string_view name) {
    std::string plain;
    for (const char c : asciiText(name)) {
        const char low = lowered(c);
        if ((low >= 'a' && low <= 'z') || (low >= '0' && low <= '9')) {
            plain += low;
        }
    }
    return plain;
}

PatternMatch matchPatterns(const Pattern& pattern, const PatternFile& file) {
    return PatternMatcher(pattern, file).matched();
}

}  // namespace toile
