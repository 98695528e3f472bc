// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geometry/polygon.h"

namespace toile {

/// Lays shapes on a strip of given width as densely as it can ([GVW25]): the strip runs along x
/// from 0, its width along y from 0. All lengths in mm, angles in radians.

/// Where a copy lies: a point p of its shape is mirrored (x changes its sign), then turned
/// anti-clockwise, then moved.
struct NestPlacement {
    int item = 0;
    double angle = 0;
    bool mirrored = false;
    double x = 0, y = 0;

    bool operator==(const NestPlacement&) const = default;
};

/// Where a point of a shape may lie, as on cloth with stripes: per axis at `phase` and whole
/// multiples of `step` from there (to a millionth of a mm). A step of 0: anywhere along that axis;
/// an infinite one: only there.
struct NestLattice {
    Eigen::Vector2d anchor, phase, step;  ///< the anchor in the shape's own coordinates
};

/// A shape and how its copies may lie.
struct NestItem {
    std::string name;
    /// The outline, then its holes; closed, first point not repeated, either winding. No ring
    /// crosses itself or another; the holes lie inside.
    std::vector<geometry::Polygon> rings;
    int demand = 1;                 ///< copies
    std::vector<double> angles{0};  ///< by which it may be turned; at least one
    double tolerance = 0;           ///< and so much more, to both sides; from pi on: freely
    bool mayMirror = false;
    /// Where its one copy lies, whatever angles and lattice say. `item` is not looked at.
    std::optional<NestPlacement> fixed{};
    std::optional<NestLattice> lattice{};
    /// Its lowest point lies on the strip's edge at y = 0, a fold, where no border is kept; across
    /// the strip the lattice says nothing, and it turns by no tolerance. A fixed one may lie above.
    bool touchesEdge = false;
};

/// Where copies may not lie: a hole of the cloth, or a rectangle with a hide as its hole. The
/// border is kept from it where nothing else is said, but no gap. Obstacles may lie on each other
/// and beyond the strip, and count as cloth in what is used.
struct NestObstacle {
    std::string name;
    std::vector<geometry::Polygon> rings;  ///< as those of an item
    std::vector<int> items;                ///< that may not lie there; empty: none may
    std::optional<double> apart{};         ///< kept from it instead of the border
};

/// A stretch of the strip where nothing lies, between sheets laid one after the other: from <= to,
/// and `to` may be infinite, where the cloth ends. The border is kept from its ends.
struct NestBand {
    double from = 0, to = 0;
};

struct NestInstance {
    std::string name;
    double width = 0;  ///< of the strip
    std::vector<NestItem> items;
    std::vector<NestObstacle> obstacles{};
    std::vector<NestBand> bands{};  ///< in any order
};

struct NestOptions {
    double gap = 0;     ///< between two copies at least
    double border = 0;  ///< between a copy and the edges of the strip, also at both its ends
    std::uint64_t seed = 1;
    /// Searches that go on side by side, and share the best after each round. The nest depends on
    /// their number, and so it is stated, and never that of the machine's cores.
    int searches = 2;
    /// Places that each search looks at in a round; states the nest, too.
    std::int64_t evaluations = 50'000;
    int threads = 0;  ///< to work with, 0: as the machine has; the nest does not depend on it
};

struct NestResult {
    std::vector<NestPlacement> placements;  ///< of all copies, by item
    double length = 0;                      ///< of the strip, with the border at its end
    double use = 0;                         ///< area of the shapes / (width x length)
    int rounds = 0;
    bool valid = false;    ///< nothing overlaps and all is inside, by exact arithmetic
    bool optimal = false;  ///< as short as the areas and sizes let any nest be: no use to go on
};

/// The rings of an item as they lie; whole quarter turns without rounding.
std::vector<geometry::Polygon> placedRings(const NestItem& item, const NestPlacement& placement);

/// The error of Nester::make where more copies are asked for than are laid at once.
std::optional<Error> wrongCopies(const std::string& name, std::int64_t copies);

/// Improves a nest round by round, for as long as one lets it. After round k the nest depends on
/// instance and options alone, and of these not on `threads`. The best so far is valid from the
/// start.
class Nester {
public:
    /// With a first nest, laid one by one. The instance is kept.
    /// Errors: PageTooSmall naming the item that does not fit the strip at any of its angles or
    /// finds no room, or the instance where width, gap and border leave no strip; MalformedFile
    /// naming an item without an area, with an unusable ring, number, lattice or angle, or a fixed
    /// one that lies outside, in a band, on an obstacle or on another fixed one; MalformedFile
    /// naming an obstacle with unusable rings, the instance with an unusable band or with more
    /// copies than are laid at once; Cancelled. What has no copies is not looked at. Cost: about
    /// n^2 m in n copies, m points each, and m^2.
    static Result<Nester> make(NestInstance instance, const NestOptions& options,
                               const Progress& progress = {});
    ~Nester();
    Nester(Nester&&) noexcept;
    Nester& operator=(Nester&&) noexcept;

    const NestInstance& instance() const;
    const NestResult& best() const;
    /// One round: a fixed amount of search, usually about a tenth of a second for each search. A
    /// cancelled round adds nothing to the best.
    void step(const Progress& progress);

private:
    struct State;
    explicit Nester(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace toile
