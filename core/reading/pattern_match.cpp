// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/pattern_match.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/base/words.h"
#include "core/geometry/polygon.h"

namespace toile {
namespace {

constexpr Word<MatchedBy> kMatchedByWords[] = {
    {MatchedBy::Id, "id"}, {MatchedBy::Name, "name"}, {MatchedBy::Shape, "shape"}};

/// Shapes do not match if their lengths, or the roots of their areas, differ by more than this
/// factor.
constexpr double kMaxRatio = 1.5;
/// Largest rough distance of matching shapes, as a fraction of the root of the area.
constexpr double kMaxMatchApart = 0.25;
/// A rival's distance is at most this factor times the match's distance plus this many mm.
constexpr double kRivalShare = 1.25, kRivalLength = 1;
/// A mirrored pair must be closer than an unmirrored one by this distance, mm.
constexpr double kForMirrored = 0.5;
/// Larger files are not matched by shape: patterns have up to a few hundred pieces.
constexpr std::size_t kMaxMatchCandidates = 1000;

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
        const double lengths = geometry::perimeterOf(a) / geometry::perimeterOf(b);
        const double areas =
            std::sqrt(std::abs(geometry::signedAreaOf(a) / geometry::signedAreaOf(b)));
        return lengths < kMaxRatio && lengths > 1 / kMaxRatio && areas < kMaxRatio &&
               areas > 1 / kMaxRatio;
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
