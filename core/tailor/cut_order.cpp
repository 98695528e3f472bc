// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/cut_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/cut/fill_holes.h"
#include "core/cut/surface_paths.h"
#include "core/geometry/disjoint_sets.h"
#include "core/tailor/form_lines.h"

namespace toile::tailor {
namespace {

/// Smallest gain of a worthwhile cut, about the share of the strain that it removes.
constexpr double kWorthwhile = 0.03;
/// Relative surplus of cloth below this does not justify a dart.
constexpr double kWorthADart = 0.04;
/// Shortest dart, as a fraction of the root of the area.
constexpr double kShortestDart = 0.05;
/// Nearly flat: below this strain nothing more is worthwhile.
constexpr double kFlat = 0.002;
/// Number of places tried for the next dart.
constexpr int kPlaces = 3;

}  // namespace

std::vector<int> PartedLines::verticesAlong(const std::vector<Eigen::Vector3d>& points) const {
    std::vector<int> vertices;
    for (const Eigen::Vector3d& point : points) {
        const SurfacePoint at = nearest_.find(point);
        int corner = 0;
        at.barycentric.maxCoeff(&corner);
        const int vertex = links_.mesh().F(at.face, corner);
        if (vertices.empty() || vertices.back() != vertex) {
            vertices.push_back(vertex);
        }
    }
    return vertices;
}

void PartedLines::add(const std::vector<Eigen::Vector3d>& points, bool isDart) {
    for (const Eigen::Vector3d& point : points) {
        const int vertex = verticesAlong({point}).front();
        isParted_[static_cast<std::size_t>(vertex)] = 1;
        if (!isDart) {
            isSewn_[static_cast<std::size_t>(vertex)] = 1;
            place_.emplace(vertex, point);
        }
    }
}

std::vector<char> PartedLines::with(const std::vector<Eigen::Vector3d>& points) const {
    std::vector<char> parted = isParted_;
    for (const int vertex : verticesAlong(points)) {
        parted[static_cast<std::size_t>(vertex)] = 1;
    }
    return parted;
}

bool PartedLines::meetsDart(const std::vector<Eigen::Vector3d>& points) const {
    return std::ranges::any_of(verticesAlong(points), [this](int v) {
        const auto at = static_cast<std::size_t>(v);
        return isParted_[at] != 0 && isSewn_[at] == 0;
    });
}

geometry::ShortestForest PartedLines::forest(const std::vector<double>& edgeLengths, int stopAt,
                                             const Progress& progress) const {
    std::vector<std::vector<int>> sources(1);
    for (int v = 0; v < links_.vertexCount(); ++v) {
        if (isSewn_[static_cast<std::size_t>(v)] != 0 && !links_.cornersAt(v).empty()) {
            sources[0].push_back(v);
        }
    }
    return geometry::shortestForest(links_.table().edges, links_.vertexCount(), edgeLengths,
                                    sources, stopAt, progress);
}

std::vector<double> PartedLines::distances(const std::vector<double>& edgeLengths,
                                           const Progress& progress) const {
    return forest(edgeLengths, -1, progress).distance;
}

std::vector<Eigen::Vector3d> PartedLines::wayTo(int vertex, const std::vector<double>& edgeLengths,
                                                const Progress& progress) const {
    const auto ways = forest(edgeLengths, vertex, progress);
    if (ways.source[static_cast<std::size_t>(vertex)] < 0 || progress.isCancelled()) {
        return {};
    }
    const int from = ways.pathTo(vertex, links_.table().edges).front();
    const auto known = place_.find(from);
    const SurfacePoint begin =
        known != place_.end() ? nearest_.find(known->second) : links_.atVertex(from);
    const auto path = geodesicPath(links_, begin, links_.atVertex(vertex), progress);
    return path ? positionsOf(links_.mesh(), *path) : std::vector<Eigen::Vector3d>();
}

CutOrder::CutOrder(const SurfaceLinks& links, const std::vector<PathPolyline>& opening,
                   const Progress& progress)
    : links_(links),
      progress_(progress),
      nearest_(links.mesh()),
      model_(links),
      lengths_(edgeLengths(links.mesh(), links.table().edges)),
      lines_(links, nearest_, model_.rims()),
      hasHandles_(links.vertexCount() - links.edgeCount() + links.faceCount() +
                      static_cast<int>(rimsOf(links.mesh(), links.table()).size()) <
                  2),
      size_(std::sqrt(std::accumulate(model_.areas().begin(), model_.areas().end(), 0.0))) {
    for (const PathPolyline& path : opening) {
        const std::vector<int> vertices = lines_.verticesAlong(positionsOf(links.mesh(), path));
        opening_.insert(opening_.end(), vertices.begin(), vertices.end());
    }
}

void CutOrder::add(const UserCut& cut) {
    if (const auto path = traceUserCut(links_, nearest_, cut, progress_)) {
        lines_.add(positionsOf(links_.mesh(), *path), false);
    }
}

const std::optional<FlatScale>& CutOrder::look() {
    scale_ = scaleWith(lines_.isParted());
    return scale_;
}

/// If the given lines do not open the piece, adds the shortest cuts that do.
std::optional<FlatScale> CutOrder::scaleWith(std::vector<char> parted) {
    if (!isOpened(parted)) {
        for (const int vertex : opening_) {
            parted[static_cast<std::size_t>(vertex)] = 1;
        }
    }
    return model_.solve(std::move(parted));
}

/// A surface without handles falls into disks if all lines and rims are connected.
bool CutOrder::isOpened(const std::vector<char>& parted) const {
    geometry::DisjointSets sets(links_.vertexCount());
    const Edges& edges = links_.table().edges;
    for (Eigen::Index e = 0; e < edges.rows(); ++e) {
        if (parted[static_cast<std::size_t>(edges(e, 0))] != 0 &&
            parted[static_cast<std::size_t>(edges(e, 1))] != 0) {
            sets.join(edges(e, 0), edges(e, 1));
        }
    }
    int first = -1;
    for (int v = 0; v < links_.vertexCount(); ++v) {
        if (parted[static_cast<std::size_t>(v)] == 0 || links_.cornersAt(v).empty()) {
            continue;
        }
        first = first < 0 ? v : first;
        if (sets.root(v) != sets.root(first)) {
            return false;
        }
    }
    return first >= 0 && !hasHandles_;
}

double CutOrder::mean() const {
    return scale_ ? scale_->strain.mean : 1;
}

/// Reduction of the mean strain as a logarithm, so that halving counts equally at all levels.
double CutOrder::gainOf(const std::optional<FlatScale>& scale) const {
    return scale ? std::log(std::max(mean(), kFlat) / std::max(scale->strain.mean, kFlat)) : 0;
}

void CutOrder::propose(AdvisedCut cut) {
    const auto path = traceUserCut(links_, nearest_, cut.what.cut, progress_);
    if (!path) {
        return;
    }
    cut.length = path->length;
    const auto partner = std::ranges::find_if(groups_, [&cut](const Group& group) {
        const TailorCut& other = group.cuts.front().cut.what;
        return cut.what.side != 0 && group.cuts.size() == 1 && other.line == cut.what.line &&
               other.side == -cut.what.side;
    });
    Group& group = partner != groups_.end() ? *partner : groups_.emplace_back();
    group.length += cut.length;
    group.cuts.push_back({std::move(cut), positionsOf(links_.mesh(), *path)});
}

void CutOrder::take(Proposal proposal) {
    lines_.add(proposal.line, proposal.cut.what.line == TailorLine::Dart);
    if (look()) {
        proposal.cut.predicted = scale_->strain;
    }
    taken_.push_back(std::move(proposal.cut));
    progress_.step();
}

void CutOrder::takeGroup(std::size_t index) {
    for (Proposal& proposal : groups_[index].cuts) {
        take(std::move(proposal));
    }
    groups_.erase(groups_.begin() + static_cast<std::ptrdiff_t>(index));
}

void CutOrder::takeAll() {
    look();
    while (!groups_.empty() && !progress_.isCancelled()) {
        takeGroup(bestGroup());
    }
}

void CutOrder::takeWorthwhile(std::size_t mostDarts) {
    look();
    std::size_t darts = 0;
    while (!progress_.isCancelled() && mean() > kFlat) {
        const std::size_t best = groups_.empty() ? 0 : bestGroup();
        const double gain = groups_.empty() ? 0 : groups_[best].gain;
        const bool isBestWorthwhile = !groups_.empty() && gain * groups_[best].length > kWorthwhile;
        std::optional<DartFound> dart = darts < mostDarts ? nextDart() : std::nullopt;
        if (dart && dart->gain * dart->proposal.cut.length < kWorthwhile) {
            dart.reset();
        }
        if (dart && (!isBestWorthwhile || dart->gain > gain)) {
            take(std::move(dart->proposal));
            ++darts;
            std::erase_if(groups_, [this](const Group& group) {  // they would cut it off
                return std::ranges::any_of(group.cuts, [this](const Proposal& proposal) {
                    return lines_.meetsDart(proposal.line);
                });
            });
        } else if (isBestWorthwhile) {
            takeGroup(best);
        } else {
            return;
        }
    }
}

double CutOrder::gainOf(const Group& group) {
    std::vector<char> parted = lines_.isParted();
    for (const Proposal& proposal : group.cuts) {
        for (const int vertex : lines_.verticesAlong(proposal.line)) {
            parted[static_cast<std::size_t>(vertex)] = 1;
        }
    }
    return gainOf(scaleWith(std::move(parted))) / group.length;
}

/// The gain of a cut usually decreases when others are made, so old gains are upper bounds:
/// recomputes only those that could still be the best.
std::size_t CutOrder::bestGroup() {
    std::vector<char> isKnown(groups_.size(), 0);
    for (;;) {
        const auto best = static_cast<std::size_t>(
            std::ranges::max_element(groups_, {}, &Group::gain) - groups_.begin());
        if (isKnown[best] != 0 || progress_.isCancelled()) {
            return best;
        }
        groups_[best].gain = gainOf(groups_[best]);
        isKnown[best] = 1;
    }
}

/// The best dart to one of the places with surplus cloth, far from any cut.
std::optional<CutOrder::DartFound> CutOrder::nextDart() {
    std::optional<DartFound> best;
    if (!scale_) {
        return best;
    }
    const std::vector<double> far = lines_.distances(lengths_, progress_);
    std::vector<char> isTried(far.size(), 0);
    for (int place = 0; place < kPlaces && !progress_.isCancelled(); ++place) {
        int tip = -1;
        double most = 0;
        for (int v = 0; v < links_.vertexCount(); ++v) {
            const auto at = static_cast<std::size_t>(v);
            const double tooLong = std::expm1(-scale_->log[v]);
            if (isTried[at] == 0 && tooLong > kWorthADart && far[at] > kShortestDart * size_ &&
                std::isfinite(far[at]) && tooLong * far[at] > most) {
                most = tooLong * far[at];
                tip = v;
            }
        }
        if (tip < 0) {
            break;
        }
        std::optional<DartFound> dart = dartTo(tip);
        if (dart && (!best || dart->gain > best->gain)) {
            best = std::move(dart);
        }
        const double around = far[static_cast<std::size_t>(tip)] / 2;
        for (int v = 0; v < links_.vertexCount(); ++v) {
            if ((links_.mesh().V.row(v) - links_.mesh().V.row(tip)).norm() < around) {
                isTried[static_cast<std::size_t>(v)] = 1;
            }
        }
    }
    return best;
}

std::optional<CutOrder::DartFound> CutOrder::dartTo(int tip) {
    std::vector<Eigen::Vector3d> line = lines_.wayTo(tip, lengths_, progress_);
    if (line.size() < 2) {
        return std::nullopt;
    }
    const auto scale = scaleWith(lines_.with(line));
    if (!scale) {
        return std::nullopt;
    }
    AdvisedCut cut;
    cut.what.line = TailorLine::Dart;
    cut.what.cut.points = line;
    cut.length = lengthOf(line, false);
    cut.intake = intakeOf(line, *scale);
    cut.evidence = toile::worded("the cloth at its tip is %1 % too long",
                                 {figure(100 * std::expm1(-scale_->log[tip]), 0)});
    const double gain = gainOf(scale) / cut.length;
    if (cut.intake->width <= 0 || cut.intake->angle <= 0 || gain <= 0) {
        return std::nullopt;
    }
    return DartFound{{std::move(cut), std::move(line)}, gain};
}

/// The opening of a cut: the sum of the angles that it takes in, each about its own place.
DartIntake CutOrder::intakeOf(const std::vector<Eigen::Vector3d>& points,
                              const FlatScale& scale) const {
    DartIntake intake;
    double along = 0;
    int last = lines_.verticesAlong({points.front()}).front();
    for (std::size_t k = 1; k < points.size(); ++k) {
        along += (points[k] - points[k - 1]).norm();
        const int vertex = lines_.verticesAlong({points[k]}).front();
        if (vertex != last) {
            intake.angle += scale.absorbed[vertex];
            intake.width += scale.absorbed[vertex] * along;
        }
        last = vertex;
    }
    return intake;
}

}  // namespace toile::tailor
