// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/seam_settings.h"

#include <algorithm>
#include <utility>

#include "core/base/unique_names.h"

namespace toile {
namespace {

constexpr double kHalf = 0.5;
constexpr double kSame = 1e-9;  ///< shares of a line

/// The part of `a` that `b` has, 0 to 1.
double covered(const LineStretch& a, const LineStretch& b) {
    if (!a.line || a.line != b.line || (a.from < a.to) != (b.from < b.to) || a.from == a.to) {
        return 0;
    }
    const auto [low, high] = std::minmax(a.from, a.to);
    const auto [first, last] = std::minmax(b.from, b.to);
    double common = 0;
    for (const double turn : {-1.0, 0.0, 1.0}) {
        common += std::max(0.0, std::min(high, last + turn) - std::max(low, first + turn));
    }
    return std::min(1.0, common / (high - low));
}

double covered(const SeamPlace& a, const SeamPlace& b) {
    const double left = covered(a.left, b.left);
    const bool areFree = !a.right.line && !b.right.line;
    return areFree ? left : std::min(left, covered(a.right, b.right));
}

SeamPlace turned(const SeamPlace& place) {
    return {place.right, place.left};
}

/// 0.1 longer on one side is as much shorter on the other.
std::optional<double> seenFromRight(std::optional<double> ease) {
    return ease ? std::optional(1 / (1 + *ease) - 1) : std::nullopt;
}

/// How well a place fits a seam; negative where it says nothing of it.
double fit(const SeamPlace& seam, const SeamPlace& place) {
    return covered(seam, place) > kHalf ? covered(place, seam) : -1;
}

/// What fits a seam best, as seen from its left side.
std::optional<SeamSettings> settingsOf(const Seam& seam,
                                       const std::vector<SeamSettings>& settings) {
    double best = 0;
    std::optional<SeamSettings> found;
    for (const SeamSettings& one : settings) {
        const double direct = fit(seam.place, one.place), back = fit(seam.place, turned(one.place));
        if (std::max(direct, back) < best - kSame || std::max(direct, back) < 0) {
            continue;
        }
        best = std::max(direct, back);
        found = one;
        if (direct < back) {
            found->place = turned(one.place);
            found->ease = seenFromRight(one.ease);
        }
    }
    return found;
}

}  // namespace

int seamAt(const SeamGraph& graph, const SeamPlace& place) {
    double most = 0;
    int found = -1;
    for (std::size_t s = 0; s < graph.seams.size(); ++s) {
        const SeamPlace& there = graph.seams[s].place;
        const double has = std::max(covered(place, there), covered(turned(place), there));
        if (has > most + kSame) {
            most = has;
            found = static_cast<int>(s);
        }
    }
    return found;
}

void applySettings(SeamGraph& graph, const std::vector<SeamSettings>& settings) {
    if (settings.empty()) {
        return;
    }
    UniqueNames names;
    for (const Seam& seam : graph.seams) {
        names.take(seam.name);
    }
    for (Seam& seam : graph.seams) {
        if (const auto said = settingsOf(seam, settings)) {
            seam.ease = seam.kind == SeamKind::Free ? std::nullopt : said->ease;
            if (!said->name.empty() && said->name != seam.name) {
                seam.name = names.free(said->name);
            }
        }
    }
}

std::vector<SeamSettings> withEase(std::vector<SeamSettings> settings, const Seam& seam,
                                   std::optional<double> ease) {
    SeamSettings said = settingsOf(seam, settings).value_or(SeamSettings{});
    std::erase_if(settings, [&seam](const SeamSettings& one) {
        return covered(one.place, seam.place) > 1 - kSame ||
               covered(turned(one.place), seam.place) > 1 - kSame;
    });
    said.place = seam.place;
    said.ease = ease;
    if (ease || !said.name.empty() || settingsOf(seam, settings)) {
        settings.push_back(std::move(said));
    }
    return settings;
}

std::vector<SeamSettings> settingsByName(const SeamGraph& graph,
                                         const std::map<std::string, double>& ease,
                                         Problems& problems) {
    std::map<std::string, std::vector<const Seam*>> byName;
    for (const Seam& seam : graph.seams) {
        if (seam.kind != SeamKind::Free) {
            byName[seam.name].push_back(&seam);
        }
    }
    std::vector<SeamSettings> settings;
    std::vector<std::string> unknown;
    for (const auto& [name, value] : ease) {
        const std::vector<const Seam*>& seams = byName[name];
        if (seams.size() == 1) {
            settings.push_back({seams.front()->place, value});
        } else {
            unknown.push_back(name);
        }
    }
    const Problems found =
        aboutEach(ErrorCode::NoSuchSeam, unknown, worded("the seams file gives it an ease"));
    problems.insert(problems.end(), found.begin(), found.end());
    return settings;
}

std::map<std::string, double> easeByName(const SeamGraph& graph) {
    std::map<std::string, double> ease;
    for (const Seam& seam : graph.seams) {
        if (seam.ease) {
            ease[seam.name] = *seam.ease;
        }
    }
    return ease;
}

}  // namespace toile
