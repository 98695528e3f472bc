// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/fair_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "core/cut/straighten.h"
#include "core/cut/surface_paths.h"
#include "core/geometry/segment.h"

namespace toile::tailor {
namespace {

/// Edges that look like a seam stay where they follow each other for so long, mm; none turns more
/// than by this from the one before, as a cosine.
constexpr double kLongEnough = 50, kNoCorner = 0.8;
/// How far a line may leave its way, mm: an armhole, which is hollow, and others.
constexpr double kNearHollow = 5, kNearStraight = 18;
/// Between points of a line, mm; and how often the line is shortened around each.
constexpr double kHollowStep = 20, kStraightStep = 40;
constexpr int kHollowRoundings = 3, kStraightRoundings = 6;
/// A line that comes this near to another meets it, mm; where the other has a point near, there.
constexpr double kMeets = 1, kMeetsAtPoint = 3;
/// A line that begins at the one that it ends on has left it when it is so far off, mm.
constexpr double kLeft = 10;
constexpr int kPartsLookedAt = 8;

/// The point between two neighbours on a path. @param share  0 at the first
SurfacePoint between(const SurfaceLinks& links, const SurfacePoint& a, const SurfacePoint& b,
                     double share) {
    const int face = links.commonFace(a, b);
    const auto first = links.seenFrom(face, a), second = links.seenFrom(face, b);
    return {face, (1 - share) * first->barycentric + share * second->barycentric};
}

/// Both parts of a path. @param at  mm from its start
std::array<PathPolyline, 2> divided(const SurfaceLinks& links, const PathPolyline& path,
                                    double at) {
    std::array<PathPolyline, 2> parts;
    double before = 0;
    std::size_t k = 1;
    parts[0].points.push_back(path.points.front());
    for (; k < path.points.size(); ++k) {
        const double step = (positionOf(links.mesh(), path.points[k]) -
                             positionOf(links.mesh(), path.points[k - 1]))
                                .norm();
        if (before + step >= at || k + 1 == path.points.size()) {
            const double share = step > 0 ? std::clamp((at - before) / step, 0.0, 1.0) : 0;
            const SurfacePoint middle = between(links, path.points[k - 1], path.points[k], share);
            parts[0].points.push_back(middle);
            parts[1].points.push_back(middle);
            break;
        }
        before += step;
        parts[0].points.push_back(path.points[k]);
    }
    parts[1].points.insert(parts[1].points.end(),
                           path.points.begin() + static_cast<std::ptrdiff_t>(k), path.points.end());
    for (PathPolyline& part : parts) {
        part.length = measuredLength(links.mesh(), part);
    }
    return parts;
}

PathPolyline joined(PathPolyline first, const PathPolyline& second) {
    first.points.insert(first.points.end(), second.points.begin() + 1, second.points.end());
    first.length += second.length;
    return first;
}

double distanceTo(const std::vector<Eigen::Vector3d>& line, const Eigen::Vector3d& p) {
    double least = (line.front() - p).norm();
    for (std::size_t k = 1; k < line.size(); ++k) {
        least = std::min(least, geometry::distanceToSegment(p, line[k - 1], line[k]));
    }
    return least;
}

/// The fewest geodesics, one after the other, that stay near a way. Each is the shortest of all:
/// the way pulled tight may pass the bumps of uneven cloth on other sides, and turn far more.
std::vector<PathPolyline> geodesicsNear(const SurfaceLinks& links, std::span<const int> way,
                                        double near) {
    auto shortest = geodesicPath(links, links.atVertex(way.front()), links.atVertex(way.back()));
    PathPolyline path =
        shortest ? std::move(*shortest) : polylineOf(links, {way.begin(), way.end()});
    const std::vector<Eigen::Vector3d> line = positionsOf(links.mesh(), path);
    double most = near;
    std::size_t farthest = 0;
    for (std::size_t k = 1; k + 1 < way.size(); ++k) {
        const double distance = distanceTo(line, links.mesh().V.row(way[k]).transpose());
        if (distance > most) {
            most = distance;
            farthest = k;
        }
    }
    if (farthest == 0) {
        return {std::move(path)};
    }
    std::vector<PathPolyline> parts = geodesicsNear(links, way.first(farthest + 1), near);
    std::vector<PathPolyline> rest = geodesicsNear(links, way.subspan(farthest), near);
    std::ranges::move(rest, std::back_inserter(parts));
    return parts;
}

/// A path in parts of even length, none longer than a step.
std::vector<PathPolyline> inSteps(const SurfaceLinks& links, PathPolyline path, double step) {
    const int count = std::max(1, static_cast<int>(std::ceil(path.length / step)));
    const double each = path.length / count;
    std::vector<PathPolyline> parts;
    for (int k = 1; k < count; ++k) {
        auto [part, rest] = divided(links, path, each);
        parts.push_back(std::move(part));
        path = std::move(rest);
    }
    parts.push_back(std::move(path));
    return parts;
}

/// Shortens a line around every second of its inner points, and around the others, by turns.
void roundKinks(const SurfaceLinks& links, std::vector<PathPolyline>& parts, int roundings) {
    for (int round = 0; round < 2 * roundings; ++round) {
        for (auto k = static_cast<std::size_t>(1 + round % 2); k < parts.size(); k += 2) {
            const PathPolyline whole = straightened(links, joined(parts[k - 1], parts[k]));
            auto [before, after] = divided(links, whole, whole.length / 2);
            parts[k - 1] = std::move(before);
            parts[k] = std::move(after);
        }
    }
}

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
        const bool isHollow = line == TailorLine::Armhole;
        PathPolyline path;
        bool hasKinks = false;
        for (PathPolyline& part :
             geodesicsNear(links, way, isHollow ? kNearHollow : kNearStraight)) {
            hasKinks = !path.points.empty();
            path = hasKinks ? joined(std::move(path), part) : std::move(part);
        }
        std::vector<PathPolyline> parts =
            inSteps(links, std::move(path), isHollow ? kHollowStep : kStraightStep);
        if (hasKinks) {
            roundKinks(links, parts, isHollow ? kHollowRoundings : kStraightRoundings);
        }
        for (const PathPolyline& part : parts) {
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
