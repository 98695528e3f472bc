// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay.h"
#include "patch.h"

namespace toile::samples {

namespace {

constexpr int kRounds = 12;               // of turning edges and moving vertices
constexpr double kRoundCorner = 1.15;     // radians (66 degrees): wider corners get two triangles
constexpr double kShortBridge = 0.7;      // of an edge: shorter links near a tip stay
constexpr double kOpposite = kPi + 1e-6;  // two opposite angles of a Delaunay edge sum to less

double angleAt(Vec3 a, Vec3 b, Vec3 c) {
    return std::atan2(length(cross(b - a, c - a)), dot(b - a, c - a));
}

/// True where turning the edge opposite slot `k` leaves two anti-clockwise triangles.
bool canFlip(const Patch& patch, int t, int k) {
    const Vec2 a = patch.flatAt(patch.net.corner(t, k));
    const Vec2 b = patch.flatAt(patch.net.corner(t, k + 1));
    const Vec2 c = patch.flatAt(patch.net.corner(t, k + 2));
    const Vec2 d = patch.flatAt(patch.net.cornerBeyond(t, k));
    const double least = 0.05 * (doubleArea(a, b, c) + doubleArea(d, c, b));
    return doubleArea(a, b, d) > least && doubleArea(a, d, c) > least;
}

/// Turns every inner edge whose opposite angles in space sum to more than two right angles.
void turnEdges(Patch& patch) {
    TriangleNet& net = patch.net;
    constexpr int kMaxPasses = 50;
    bool turned = true;
    for (int pass = 0; pass < kMaxPasses && turned; ++pass) {
        turned = false;
        for (int t = 0; t < net.size(); ++t) {
            for (int k = 0; k < 3; ++k) {
                if (net.beside(t, k) < t) {
                    continue;  // border, or the other side's turn
                }
                const int a = net.corner(t, k);
                const int b = net.corner(t, k + 1);
                const int c = net.corner(t, k + 2);
                const int d = net.cornerBeyond(t, k);
                if (patch.onOutline(a) && patch.onOutline(d)) {
                    continue;  // would bridge the outline
                }
                const double sum = angleAt(patch.spaceAt(a), patch.spaceAt(b), patch.spaceAt(c)) +
                                   angleAt(patch.spaceAt(d), patch.spaceAt(b), patch.spaceAt(c));
                if (sum > kOpposite && canFlip(patch, t, k)) {
                    net.flipEdge(t, k);
                    turned = true;
                }
            }
        }
    }
}

/// The triangles around each vertex.
std::vector<std::vector<int>> trianglesAround(const Patch& patch) {
    std::vector<std::vector<int>> around(patch.flat.size());
    for (int t = 0; t < patch.net.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
            around[static_cast<std::size_t>(patch.net.corner(t, k))].push_back(t);
        }
    }
    return around;
}

double flatArea(const Patch& patch, int t) {
    return doubleArea(patch.flatAt(patch.net.corner(t, 0)), patch.flatAt(patch.net.corner(t, 1)),
                      patch.flatAt(patch.net.corner(t, 2)));
}

double spaceArea(const Patch& patch, int t) {
    const Vec3 a = patch.spaceAt(patch.net.corner(t, 0));
    return length(cross(patch.spaceAt(patch.net.corner(t, 1)) - a,
                        patch.spaceAt(patch.net.corner(t, 2)) - a));
}

/// Moves each inner vertex to the middle of its triangles, weighted by their area in space.
void moveVertices(Patch& patch, const Surface& surface) {
    const auto around = trianglesAround(patch);
    for (std::size_t v = static_cast<std::size_t>(patch.outlineCount()); v < around.size(); ++v) {
        Vec2 sum;
        double weight = 0.0;
        for (const int t : around[v]) {
            const double area = spaceArea(patch, t);
            for (int k = 0; k < 3; ++k) {
                sum = sum + (area / 3.0) * patch.flatAt(patch.net.corner(t, k));
            }
            weight += area;
        }
        const Vec2 before = patch.flat[v];
        Vec2 step = (1.0 / weight) * sum - before;
        constexpr int kMaxHalvings = 4;
        for (int trial = 0; trial < kMaxHalvings; ++trial, step = 0.5 * step) {
            patch.flat[v] = before + step;
            bool upright = true;
            for (const int t : around[v]) {
                upright = upright && flatArea(patch, t) > 0.0;
            }
            if (upright) {
                break;
            }
            patch.flat[v] = before;
        }
        patch.space[v] = surface(patch.flat[v]);
    }
}

/// True where slot `k` of `t` is the corner of an "ear": two of its sides lie on the outline.
bool isEar(const TriangleNet& net, int t, int k) {
    return net.beside(t, k + 1) == Triangle::kNone && net.beside(t, k + 2) == Triangle::kNone;
}

/// Finds inner edges that join two outline vertices; turns them at wide corners, else splits them.
void removeBridges(Patch& patch, const Surface& surface, double edge) {
    TriangleNet& net = patch.net;
    for (int t = 0; t < net.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const int b = net.corner(t, k + 1);
            const int c = net.corner(t, k + 2);
            if (net.beside(t, k) == Triangle::kNone || !patch.onOutline(b) || !patch.onOutline(c)) {
                continue;
            }
            const int a = net.corner(t, k);
            const int d = net.cornerBeyond(t, k);
            const bool ear = isEar(net, t, k);
            const int other = net.beside(t, k);
            if (!ear && isEar(net, other, net.slotOfNeighbour(other, t))) {
                continue;  // dealt with from the ear's side
            }
            const Vec3 spaceB = patch.spaceAt(b);
            const Vec3 spaceC = patch.spaceAt(c);
            if (ear && angleAt(patch.spaceAt(a), spaceB, spaceC) < kRoundCorner) {
                continue;
            }
            if (ear && !patch.onOutline(d) && canFlip(patch, t, k)) {
                net.flipEdge(t, k);
            } else if (length(spaceB - spaceC) > kShortBridge * edge) {
                patch.flat.push_back(0.5 * (patch.flatAt(b) + patch.flatAt(c)));
                patch.space.push_back(surface(patch.flat.back()));
                net.splitEdge(t, k, static_cast<int>(patch.flat.size()) - 1);
            }
        }
    }
}

}  // namespace

void relaxPatch(Patch& patch, const Surface& surface, double edge) {
    turnEdges(patch);
    removeBridges(patch, surface, edge);
    for (int round = 0; round < kRounds; ++round) {
        moveVertices(patch, surface);
        turnEdges(patch);
    }
}

}  // namespace toile::samples
