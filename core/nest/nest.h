// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geometry/polygon.h"

namespace toile {

/// Places shapes on a strip of given width as densely as possible ([GVW25]): the strip runs along x
/// from 0, its width along y from 0. All lengths in mm, angles in radians.

/// The placement of a copy: a point p of its shape is mirrored (x changes its sign), then turned
/// anti-clockwise, then moved.
struct NestPlacement {
    int item = 0;
    double angle = 0;
    bool mirrored = false;
    double x = 0, y = 0;

    bool operator==(const NestPlacement&) const = default;
};

/// Allowed positions of a point of a shape, as on cloth with stripes: per axis at `phase` and whole
/// multiples of `step` from there (to a millionth of a mm). A step of 0: anywhere along that axis;
/// an infinite one: only at `phase`.
struct NestLattice {
    Eigen::Vector2d anchor, phase, step;  ///< the anchor in the shape's own coordinates
};

/// A shape and the constraints on its copies.
struct NestItem {
    std::string name;
    /// The outline, then its holes; closed, first point not repeated, either winding. No ring
    /// crosses itself or another; the holes lie inside.
    std::vector<geometry::Polygon> rings;
    int demand = 1;                 ///< copies
    std::vector<double> angles{0};  ///< allowed rotations; at least one
    double tolerance = 0;           ///< further rotation to either side; from pi on: freely
    bool mayMirror = false;
    /// Fixed placement of its one copy, overriding angles and lattice. `item` is ignored.
    std::optional<NestPlacement> fixed{};
    std::optional<NestLattice> lattice{};
    /// Its lowest point lies on the strip's edge at y = 0, a fold, without a border; across the
    /// strip the lattice is ignored, and so is the tolerance. A fixed copy can lie above.
    bool touchesEdge = false;
};

/// An area where copies may not lie: a hole of the cloth, or a rectangle with a hide as its hole.
/// Copies keep the border from it unless `apart` is set, but no gap. Obstacles may overlap and
/// extend beyond the strip, and count as cloth in `use`.
struct NestObstacle {
    std::string name;
    std::vector<geometry::Polygon> rings;  ///< like those of an item
    std::vector<int> items;                ///< that must avoid it; empty: all items
    std::optional<double> apart{};         ///< distance to it instead of the border
};

/// A range of the strip where nothing may lie, between consecutive sheets: from <= to, and `to` may
/// be infinite at the end of the cloth. Copies keep the border from its ends.
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
    double gap = 0;     ///< minimum distance of two copies
    double border = 0;  ///< distance of copies to the edges of the strip, also at both its ends
    std::uint64_t seed = 1;
    /// Searches that run in parallel and share the best nest after each round. The nest depends on
    /// their number, so it is an explicit option and not the machine's number of cores.
    int searches = 2;
    /// Places that each search tries in a round; the nest depends on it, too.
    std::int64_t evaluations = 50'000;
    int threads = 0;  ///< number of threads, 0: all cores; does not affect the nest
    /// Seconds since these options were made after which the first nest is laid in haste, in few
    /// places per copy; then it depends on the machine's speed. 0: never.
    double hasteAfter = 0;
    Stopwatch watch{};

    bool isHasty() const { return hasteAfter > 0 && watch.seconds() > hasteAfter; }
};

struct NestResult {
    std::vector<NestPlacement> placements;  ///< of all copies, by item
    double length = 0;                      ///< of the strip, with the border at its end
    double use = 0;                         ///< area of the shapes / (width x length)
    int rounds = 0;
    bool valid = false;    ///< by exact arithmetic, nothing overlaps and all is inside
    bool optimal = false;  ///< as short as areas and sizes allow: stop searching
};

/// The rings of an item as placed; whole quarter turns without rounding.
std::vector<geometry::Polygon> placedRings(const NestItem& item, const NestPlacement& placement);

/// The error of Nester::make if more copies are requested than are supported.
std::optional<Error> wrongCopies(const std::string& name, std::int64_t copies);

/// Improves a nest round by round, as long as the caller continues. After round k the nest depends
/// on instance and options alone, but not on `threads`. The best so far is valid from the start.
class Nester {
public:
    /// Creates a first nest, one copy at a time. The instance is copied. Errors: PageTooSmall
    /// naming the item that does not fit the strip at any of its angles or finds no room, or the
    /// instance if width, gap and border leave no strip; MalformedFile naming an item without an
    /// area, with an unusable ring, number, lattice or angle, or a fixed one that lies outside, in
    /// a band, on an obstacle or on another fixed one; MalformedFile naming an obstacle with
    /// unusable rings, the instance with an unusable band or with too many copies; Cancelled. Items
    /// without copies are not checked. Cost: about n^2 m in n copies, m points each, and m^2.
    static Result<Nester> make(NestInstance instance, const NestOptions& options,
                               const Progress& progress = {});
    ~Nester();
    Nester(Nester&&) noexcept;
    Nester& operator=(Nester&&) noexcept;

    const NestInstance& instance() const;
    const NestResult& best() const;
    /// Runs one round: a fixed amount of search, usually about a tenth of a second for each search.
    /// A cancelled round does not change the best nest.
    void step(const Progress& progress);

private:
    struct State;
    explicit Nester(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace toile
