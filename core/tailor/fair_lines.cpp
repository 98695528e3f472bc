// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/fair_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>

#include "core/cut/surface_paths.h"
#include "core/geometry/segment.h"
#include "core/tailor/fair_path.h"

namespace toile::tailor {
namespace {

/// Edges that look like a seam stay where they follow each other for so long, mm; none turns more
/// than by this from the one before, as a cosine.
constexpr double kLongEnough = 50, kNoCorner = 0.8;
/// An armhole, which is hollow, and other lines.
constexpr Fairness kFairHollow{5, 20, 3}, kFairStraight{18, 40, 6};
/// A line that comes this near to another meets it, mm; where the other has a point near, there.
constexpr double kMeets = 1, kMeetsAtPoint = 3;
/// A line that begins at the one that it ends on has left it when it is so far off, mm.
constexpr double kLeft = 10;
constexpr int kPartsLookedAt = 8;

/// A line on the surface: its points, and those between that its geodesics pass.
struct FairLine {
    struct Point {
        Eigen::Vector3d at;
        bool isOwn;  ///< of the line; false: passed
    };
    std::vector<Point> points;

    /// The place of the line nearest to another, and between which points it lies.
    struct Nearest {
        Eigen::Vector3d at;
        std::size_t after = 0;
        double distance = 0;
    };
    Nearest nearest(const Eigen::Vector3d& p) const {
        Nearest found{points.front().at, 0, (points.front().at - p).norm()};
        for (std::size_t k = 1; k < points.size(); ++k) {
            const Eigen::Vector3d &a = points[k - 1].at, &b = points[k].at;
            const Eigen::Vector3d at = a + geometry::nearestShare(p, a, b) * (b - a);
            if ((at - p).norm() < found.distance) {
                found = {at, k, (at - p).norm()};
            }
        }
        return found;
    }

    /// Has another line meet it there: at a point that it has near, or at a new one.
    Eigen::Vector3d meet(const Nearest& place) {
        for (Point& point : points) {
            if (point.isOwn && (point.at - place.at).norm() < kMeetsAtPoint) {
                return point.at;
            }
        }
        points.insert(
            points.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(place.after, 1)),
            {place.at, true});
        return place.at;
    }

    /// Ends on another line: where it first comes to it, or is nearest to it.
    void endOn(FairLine& other) {
        bool hasLeft = other.nearest(points.front().at).distance > kMeets;
        for (std::size_t k = 1; k < points.size(); ++k) {
            for (int part = 1; part <= kPartsLookedAt; ++part) {
                const double share = static_cast<double>(part) / kPartsLookedAt;
                const auto place =
                    other.nearest((1 - share) * points[k - 1].at + share * points[k].at);
                hasLeft = hasLeft || place.distance > kLeft;
                if (hasLeft && place.distance < kMeets) {
                    points.resize(k);
                    points.push_back({other.meet(place), true});
                    return;
                }
            }
        }
        const auto place = other.nearest(points.back().at);
        while (points.size() > 2 &&
               (points[points.size() - 2].at - place.at).norm() < 2 * place.distance) {
            points.pop_back();
        }
        points.back() = {other.meet(place), true};
    }
};

class FairLines {
public:
    FairLines(const BodyWays& ways, const MeshLines& lines, const std::vector<TailorSeam>& seams,
              const std::vector<std::vector<int>>& cuts)
        : ways_(ways), lines_(lines), seams_(seams) {
        for (const std::vector<int>& cut : cuts) {
            held_.insert(cut.begin(), cut.end());
        }
        for (std::size_t s = 0; s < seams.size(); ++s) {
            if (!isOfMesh(seams[s])) {
                held_.insert(seams[s].way.front());
                held_.insert(seams[s].way.back());
            }
            for (const int v : seams[s].way) {
                seamAt_.emplace(v, s);
            }
        }
    }

    std::vector<std::vector<Eigen::Vector3d>> run() {
        for (const TailorSeam& seam : seams_) {
            made_.push_back(fair(seam));
        }
        for (std::size_t s = 0; s < seams_.size(); ++s) {
            if (isOfMesh(seams_[s]) && !isRound(seams_[s])) {
                endOnOther(s, seams_[s].way.back());
                std::ranges::reverse(made_[s].points);
                endOnOther(s, seams_[s].way.front());
                std::ranges::reverse(made_[s].points);
            }
        }
        std::vector<std::vector<Eigen::Vector3d>> lines;
        for (std::size_t s = 0; s < seams_.size(); ++s) {
            std::vector<Eigen::Vector3d>& line = lines.emplace_back();
            for (const FairLine::Point& point : made_[s].points) {
                if (point.isOwn) {
                    line.push_back(point.at);
                }
            }
            if (isRound(seams_[s])) {
                line.pop_back();
            }
        }
        return lines;
    }

private:
    /// Led by the mesh alone: it ends on lines that the form has.
    static bool isOfMesh(const TailorSeam& seam) {
        return seam.line == TailorLine::Style || seam.line == TailorLine::Band;
    }

    static bool isRound(const TailorSeam& seam) { return seam.way.front() == seam.way.back(); }

    /// The end of a style line, where it lies on another line's way.
    void endOnOther(std::size_t s, int end) {
        const auto other = seamAt_.find(end);
        if (other != seamAt_.end() && other->second != s && !held_.contains(end)) {
            made_[s].endOn(made_[other->second]);
        }
    }

    std::vector<char> fixedVertices(const std::vector<int>& way) const {
        std::vector<char> isFixed;
        isFixed.reserve(way.size());
        for (const int v : way) {
            isFixed.push_back(held_.contains(v) ? 1 : 0);
        }
        isFixed.front() = isFixed.back() = 1;
        std::size_t first = 0;  // of the seam's edges that follow each other
        double length = 0;
        for (std::size_t k = 1; k <= way.size(); ++k) {
            if (k < way.size() && isSeam(way[k - 1], way[k]) &&
                (length == 0 || isStraightOn(way[k - 2], way[k - 1], way[k]))) {
                length += (ways_.at(way[k]) - ways_.at(way[k - 1])).norm();
                continue;
            }
            if (length >= kLongEnough) {
                std::fill(isFixed.begin() + static_cast<std::ptrdiff_t>(first),
                          isFixed.begin() + static_cast<std::ptrdiff_t>(k), char{1});
            }
            const bool isCorner = k < way.size() && isSeam(way[k - 1], way[k]);
            first = isCorner ? k - 1 : k;
            length = isCorner ? (ways_.at(way[k]) - ways_.at(way[k - 1])).norm() : 0;
        }
        return isFixed;
    }

    bool isSeam(int from, int to) const {
        return lines_.at(findEdge(ways_.links().table().edges, from, to)) >= MeshLines::kLikely;
    }

    bool isStraightOn(int a, int b, int c) const {
        const Eigen::Vector3d before = ways_.at(b) - ways_.at(a), after = ways_.at(c) - ways_.at(b);
        return before.dot(after) > kNoCorner * before.norm() * after.norm();
    }

    void addFair(std::span<const int> way, TailorLine line, FairLine& made) const {
        const SurfaceLinks& links = ways_.links();
        for (const PathPolyline& part :
             fairPath(links, way, line == TailorLine::Armhole ? kFairHollow : kFairStraight)) {
            for (std::size_t k = 1; k + 1 < part.points.size(); ++k) {
                made.points.push_back({positionOf(links.mesh(), part.points[k]), false});
            }
            made.points.push_back({positionOf(links.mesh(), part.points.back()), true});
        }
        made.points.back().at = ways_.at(way.back());
    }

    FairLine fair(const TailorSeam& seam) const {
        const std::vector<int>& way = seam.way;
        const std::vector<char> isFixed = fixedVertices(way);
        FairLine made{{{ways_.at(way.front()), true}}};
        for (std::size_t first = 0; first + 1 < way.size() && !ways_.isCancelled();) {
            std::size_t last = first + 1;
            while (isFixed[last] == 0) {
                ++last;
            }
            if (last == first + 1) {
                made.points.push_back({ways_.at(way[last]), true});
            } else {
                if (way[first] == way[last]) {
                    last = (first + last) / 2;  // it goes round, and is held nowhere else
                }
                addFair(std::span(way).subspan(first, last - first + 1), seam.line, made);
            }
            first = last;
        }
        return made;
    }

    const BodyWays& ways_;
    const MeshLines& lines_;
    const std::vector<TailorSeam>& seams_;
    std::set<int> held_;
    std::map<int, std::size_t> seamAt_;  ///< by vertex: the first
    std::vector<FairLine> made_;
};

}  // namespace

std::vector<std::vector<Eigen::Vector3d>> fairLines(const BodyWays& ways, const MeshLines& lines,
                                                    const std::vector<TailorSeam>& seams,
                                                    const std::vector<std::vector<int>>& cuts) {
    return FairLines(ways, lines, seams, cuts).run();
}

}  // namespace toile::tailor
