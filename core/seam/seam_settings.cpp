// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/seam_settings.h"

#include <algorithm>
#include <utility>

#include "core/base/unique_names.h"

namespace toile {
namespace {

constexpr double kHalf = 0.5;
constexpr double kMaxSeenEase = 10;  ///< largest ease in a file
constexpr double kSame = 1e-9;       ///< tolerance of shares of a line

/// The smaller coverage of both sides; a side without a known line, as of a free edge, is ignored.
double covered(const SeamPlace& a, const SeamPlace& b) {
    if (!a.left.line && !b.left.line) {
        return covered(a.right, b.right);
    }
    const double left = covered(a.left, b.left);
    return !a.right.line && !b.right.line ? left : std::min(left, covered(a.right, b.right));
}

SeamPlace turned(const SeamPlace& place) {
    return {place.right, place.left};
}

/// A tenth longer on one side is a little less than a tenth shorter on the other.
std::optional<double> seenFromRight(std::optional<double> ease) {
    return ease ? std::optional(std::min(kMaxSeenEase, 1 / (1 + *ease) - 1)) : std::nullopt;
}

SeamSettings turned(SeamSettings said) {
    said.place = turned(said.place);
    said.ease = seenFromRight(said.ease);
    if (said.drawn) {  // sides that swap run the other way
        said.drawn = SeamPart{1 - said.drawn->to, 1 - said.drawn->from};
    }
    return said;
}

/// How well a place fits a seam; 0 if it covers at most half of the seam.
double fit(const SeamPlace& seam, const SeamPlace& place) {
    const double has = covered(seam, place);
    return has > kHalf ? has * covered(place, seam) : 0;
}

/// Settings indexed by their lines: a garment may have thousands.
class SettingsByLine {
public:
    explicit SettingsByLine(const std::vector<SeamSettings>& settings) {
        for (const SeamSettings& said : settings) {
            byLine_[said.place.left.line].push_back(&said);
            if (said.place.right.line != said.place.left.line) {
                byLine_[said.place.right.line].push_back(&said);
            }
        }
    }

    /// The settings that fit a seam best, as seen from its left side.
    std::optional<SeamSettings> of(const Seam& seam) const {
        const LineId line = seam.place.left.line ? seam.place.left.line : seam.place.right.line;
        const auto known = byLine_.find(line);
        double best = 0;
        std::optional<SeamSettings> found;
        for (std::size_t k = 0; known != byLine_.end() && k < known->second.size(); ++k) {
            const SeamSettings& said = *known->second[k];
            const double direct = fit(seam.place, said.place);
            const double back = fit(seam.place, turned(said.place));
            const double fits = std::max(direct, back);
            if (fits > 0 && fits >= best - kSame) {
                best = fits;
                found = direct >= back ? said : turned(said);
            }
        }
        return found;
    }

private:
    std::map<LineId, std::vector<const SeamSettings*>> byLine_;
};

}  // namespace

double covered(const LineStretch& a, const LineStretch& b) {
    if (!a.line || a.line != b.line || (a.from < a.to) != (b.from < b.to) || a.from == a.to) {
        return 0;
    }
    const auto [low, high] = std::minmax(a.from, a.to);
    const auto [first, last] = std::minmax(b.from, b.to);
    double common = 0;
    for (const auto& part : geometry::commonParts({low, high}, {first, last}, 1)) {
        common += part.length();
    }
    return std::min(1.0, common / (high - low));
}

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
    const SettingsByLine known(settings);
    for (Seam& seam : graph.seams) {
        if (const auto said = known.of(seam)) {
            seam.ease = seam.kind == SeamKind::Free ? std::nullopt : said->ease;
            seam.drawn = seam.ease ? said->drawn : std::nullopt;
            if (!said->name.empty() && said->name != seam.name) {
                seam.name = names.free(said->name);
            }
        }
    }
}

std::vector<SeamSettings> withEase(std::vector<SeamSettings> settings, const Seam& seam,
                                   std::optional<double> ease) {
    return withEase(std::move(settings), seam, ease, seam.drawn);
}

std::vector<SeamSettings> withEase(std::vector<SeamSettings> settings, const Seam& seam,
                                   std::optional<double> ease, std::optional<SeamPart> drawn) {
    SeamSettings said = SettingsByLine(settings).of(seam).value_or(SeamSettings{});
    std::erase_if(settings, [&seam](const SeamSettings& one) {
        return covered(one.place, seam.place) > 1 - kSame ||
               covered(turned(one.place), seam.place) > 1 - kSame;
    });
    said.place = seam.place;
    said.ease = ease;
    said.drawn = ease ? drawn : std::nullopt;
    if (!said.place.left.line) {
        said = turned(said);
    }
    const bool isSaid = ease || !said.name.empty() || SettingsByLine(settings).of(seam);
    if (isSaid && said.place.left.line) {
        settings.push_back(std::move(said));
    }
    return settings;
}

std::vector<SeamSettings> withEaseByName(std::vector<SeamSettings> settings, const SeamGraph& graph,
                                         const std::map<std::string, double>& ease,
                                         Problems& problems) {
    if (ease.empty()) {
        return settings;
    }
    std::map<std::string, std::vector<const Seam*>> byName;
    for (const Seam& seam : graph.seams) {
        if (seam.kind != SeamKind::Free) {
            byName[seam.name].push_back(&seam);
        }
    }
    std::vector<Subject> unknown;
    for (const auto& [name, value] : ease) {
        const std::vector<const Seam*>& seams = byName[name];
        if (seams.size() == 1) {
            settings = withEase(std::move(settings), *seams.front(), value);
        } else {
            unknown.push_back(Subject::seam(name));
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
