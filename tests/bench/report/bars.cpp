// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report/bars.h"

#include <cmath>

#include "tests/bench/report/figures.h"

namespace toile::bench {
namespace {

/// Collects the bars for which there are figures.
class Bars {
public:
    explicit Bars(const Measurements& run) : run_(run) {}

    void add(const std::string& what, std::optional<double> measured, double bound,
             bool atLeast = false, const std::string& unit = {}) {
        if (measured) {
            bars_.push_back({what, *measured, bound, atLeast, unit});
        }
    }
    void addRatio(const std::string& name, const std::string& to, double most) {
        add(name + " / " + to, run_.ratio(name, to), most);
    }
    void addTimesFaster(const std::string& name, const std::string& than, double least) {
        add(than + " / " + name, run_.ratio(than, name), least, true);
    }
    /// The same of what one waits for.
    void addTimesSooner(const std::string& method, const std::string& piece,
                        const std::string& peer, double least) {
        const std::string ours = method + "/" + piece;
        const std::string theirs = peer + "/" + piece;
        add(theirs + " / " + ours + ", wall clock", run_.wallRatio(theirs, ours), least, true);
    }
    const Measurements& run() const { return run_; }
    std::vector<Bar> take() { return std::move(bars_); }

private:
    const Measurements& run_;
    std::vector<Bar> bars_;
};

template <class Visit>
void forEachPiece(const Visit& visit) {
    for (const std::string surface : kSurfaces) {
        for (const std::string size : kSizes) {
            visit(surface + "/" + size);
        }
    }
}

void addFloor(Bars& bars) {
    for (const std::string method : {"curvature", "wang2005"}) {
        forEachPiece([&](const std::string& piece) {
            const auto floor = bars.run().floorOf(piece);
            const auto time = bars.run().lowest(method + "/" + piece);
            const bool isLarge = piece.ends_with("500000") || piece.ends_with("1000000");
            if (floor && time) {
                bars.add(method + "/" + piece + " / floor", *time / floor->measurement->lowest(),
                         isLarge ? 1.6 : 1.35);
            }
        });
    }
}

void addPeers(Bars& bars) {
    for (const std::string surface : kSurfaces) {
        const std::string piece = surface + "/45000";
        bars.addTimesSooner("curvature", piece, "cgalLscm", 6);
        bars.addTimesSooner("curvature", surface + "/500000", "cgalLscm", 20);
        bars.addTimesSooner("isometric", piece, "cgalArap", 5);
        const auto ours = bars.run().counter("isometric/" + piece, "energy");
        const auto theirs = bars.run().counter("cgalArap/" + piece, "energy");
        if (ours && theirs) {  // a peer with flipped triangles has no energy: infinite
            bars.add("energy of isometric/" + piece + " / of cgalArap/" + piece, *ours / *theirs,
                     1);
        }
    }
}

void addIsometric(Bars& bars) {
    for (const std::string surface : kSurfaces) {
        for (const std::string size : {"45000", "500000"}) {
            bars.addRatio("isometric/" + surface + "/" + size, "curvature/" + surface + "/" + size,
                          10);
        }
    }
}

/// Pairs such as "resolveDart/panel/45000/isometric" and "coldDart/panel/45000/isometric". The
/// other methods keep nothing: what they differ by is the measurement's own.
void addResolve(Bars& bars) {
    const std::string prefix = "resolve";
    for (const auto& [name, measurement] : bars.run().all()) {
        if (name.starts_with(prefix)) {
            bars.addRatio(name, "cold" + name.substr(prefix.size()),
                          name.ends_with("/curvature") ? 1.1 : 0.5);
        }
    }
}

void addFiles(Bars& bars) {
    bars.addTimesFaster("garment/dress/threads-2", "garment/dress/threads-1", 1.7);
    bars.addRatio("toileReader", "plainScan", 2);
    bars.addRatio("toileReader", "openMeshReader", 1);
    forEachPiece([&](const std::string& piece) {
        bars.addRatio("buildPiece/" + piece, "curvature/" + piece, 1);
    });
    std::optional<double> all = 0;
    for (const std::string format : {"obj", "svg", "dxf"}) {
        const auto time = bars.run().lowest("write/panel/1000000/" + format);
        all = all && time ? std::optional(*all + *time) : std::nullopt;
    }
    bars.add("write/panel/1000000, OBJ and SVG and DXF together", all, 2, false, "s");
}

void addPreparing(Bars& bars) {
    const auto add = [&bars](const char* name, double seconds) {
        bars.add(name, bars.run().lowest(name), seconds, false, "s");
    };
    add("prepare/dress_scan/kept", 3);
    add("prepare/dress_scan/remeshed-10", 10);
    add("prepare/dress_scan/remeshed-5", 10);
    add("tailor/cuts", 2);
    add("tailor/advice", 4);
}

void addMemory(Bars& bars) {
    for (const std::string surface : kSurfaces) {
        for (const std::string method : {"curvature", "isometric"}) {
            const std::string name = "memory/" + surface + "/1000000/" + method;
            bars.add(name, bars.run().counter(name, "peakMiB"), 900, false, "MiB");
        }
    }
}

void addGrowth(Bars& bars) {
    for (const std::string method : {"curvature", "wang2005", "isometric"}) {
        for (const std::string surface : kSurfaces) {
            bars.add("growth of " + method + " on " + surface + ", exponent",
                     growthExponent(bars.run(), method, surface), 1.2);
        }
    }
}

void addOutline(Bars& bars) {
    for (const std::string stage : kOutlineStages) {
        bars.add("outline/" + stage + ", growth of the time per vertex",
                 timePerVertexGrowth(bars.run(), stage), 3);
    }
}

}  // namespace

std::optional<double> timePerVertexGrowth(const Measurements& run, const std::string& stage) {
    const std::string few = std::end(kOutlineSizes)[-2], many = std::end(kOutlineSizes)[-1];
    const auto ratio = run.ratio("outline/" + stage + "/" + many, "outline/" + stage + "/" + few);
    return ratio ? std::optional(*ratio * std::stod(few) / std::stod(many)) : std::nullopt;
}

std::optional<double> growthExponent(const Measurements& run, const std::string& what,
                                     const std::string& surface) {
    const auto at = [&](const std::string& size) -> std::optional<std::pair<double, double>> {
        const std::string piece = surface + "/" + size;
        const Measurement* found = run.find(what + "/" + piece);
        if (what == "floor") {
            const auto floor = run.floorOf(piece);
            found = floor ? floor->measurement : nullptr;
        }
        if (found == nullptr) {
            return std::nullopt;
        }
        const auto triangles = found->counters.find("triangles");
        return std::pair(triangles == found->counters.end() ? std::stod(size) : triangles->second,
                         found->lowest());
    };
    const auto few = at("45000"), many = at("1000000");
    if (!few || !many) {
        return std::nullopt;
    }
    return std::log(many->second / few->second) / std::log(many->first / few->first);
}

std::vector<Bar> barsOf(const Measurements& run) {
    Bars bars(run);
    addFloor(bars);
    addPeers(bars);
    addIsometric(bars);
    addResolve(bars);
    addFiles(bars);
    addPreparing(bars);
    addMemory(bars);
    addGrowth(bars);
    addOutline(bars);
    return bars.take();
}

std::string line(const Bar& bar) {
    const std::string unit = bar.unit.empty() ? "" : " " + bar.unit;
    return bar.what + ": " + significant(bar.measured) + unit + ", at " +
           (bar.atLeast ? "least " : "most ") + significant(bar.bound) + unit + ": " +
           (bar.kept() ? "kept" : "NOT kept");
}

}  // namespace toile::bench
