// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/seam/seam_settings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/base/text.h"
#include "core/seam/seam_measure.h"

namespace toile {
namespace {

/// Number of points that identify a seam, and the direction of a closed one.
constexpr int kJoinPoints = 9;
/// A cut that covers less than this fraction of an edge only touches it.
constexpr double kOnLine = 1e-6;
/// Parts of an outline that are closer than this are joined, mm.
constexpr double kTouching = 1e-6;

/// The length of a side that comes from one line.
struct Share {
    LineStretch stretch;
    double length = 0;  ///< mm
};

/// The line that most of a side comes from; adds all cuts that it comes from to `cuts`.
LineStretch tracedStretch(const SeamSide& side, const seam::Outline& outline,
                          const std::vector<EdgeOrigin>& origins, std::vector<CutId>* cuts) {
    std::vector<Share> shares;
    const auto [low, high] = std::minmax(side.start, side.end);
    for (int k = side.first; k < side.first + side.count; ++k) {
        const EdgeOrigin* origin = originAt(origins, outline.vertices[outline.wrapIndex(k)]);
        const double start = outline.arcOf(k), length = outline.arcOf(k + 1) - start;
        const double from = std::max(low, start) - start;
        const double to = std::min(high, start + length) - start;
        if (!origin || !(from < to)) {
            continue;
        }
        const auto placeAt = [&](double s) -> double {
            return origin->from + s / length * (origin->to - origin->from);
        };
        auto known = std::ranges::find_if(shares, [origin](const Share& share) {
            return share.stretch.line == origin->line &&
                   (share.stretch.from < share.stretch.to) == (origin->from < origin->to);
        });
        if (known == shares.end()) {
            shares.push_back({{origin->line, placeAt(from), placeAt(from)}, 0});
            known = shares.end() - 1;
        }
        known->stretch.to += placeAt(to) - placeAt(from);
        known->length += to - from;
        if (cuts && origin->cut && to - from > kOnLine * length &&
            std::ranges::find(*cuts, origin->cut) == cuts->end()) {
            cuts->push_back(origin->cut);
        }
    }
    const auto most = std::ranges::max_element(shares, {}, &Share::length);
    return most == shares.end() ? LineStretch{} : most->stretch;
}

}  // namespace

LineStretch stretchOf(const SeamSide& side, const seam::Outline& outline, const Piece& piece) {
    return tracedStretch(side, outline, piece.origins, nullptr);
}

std::vector<geometry::Interval> partsOf(const LineStretch& stretch, const seam::Outline& outline,
                                        const Piece& piece) {
    const bool isForward = stretch.from < stretch.to;
    const auto [first, last] = std::minmax(stretch.from, stretch.to);
    std::vector<geometry::Interval> parts;
    const auto add = [&parts](double from, double to) {
        if (!parts.empty() && from <= parts.back().high + kTouching) {
            parts.back().high = std::max(parts.back().high, to);
        } else {
            parts.push_back({from, to});
        }
    };
    for (int k = 0; k < outline.size(); ++k) {
        const EdgeOrigin* origin = originAt(piece.origins, outline.vertices[k]);
        if (!origin || origin->line != stretch.line || origin->from == origin->to ||
            (origin->from < origin->to) != isForward) {
            continue;
        }
        const auto [low, high] = std::minmax(origin->from, origin->to);
        const auto arcAt = [&](double share) -> double {
            return outline.arcOf(k) + (share - origin->from) / (origin->to - origin->from) *
                                          (outline.arcOf(k + 1) - outline.arcOf(k));
        };
        for (const auto& part : geometry::commonParts({low, high}, {first, last}, 1)) {
            const auto [begin, end] = std::minmax({arcAt(part.low), arcAt(part.high)});
            add(begin, end);
        }
    }
    return parts;
}

void traceOrigins(const Pieces& pieces, const seam::Outlines& outlines, std::vector<Seam>& seams) {
    const auto trace = [&](const SeamSide& side, std::vector<CutId>* cuts) -> LineStretch {
        return tracedStretch(side, outlines.list[outlines.indexOf(side)],
                             pieces[side.piece]->origins, cuts);
    };
    std::map<std::pair<LineId, LineId>, std::uint64_t> count;
    for (Seam& seam : seams) {
        const bool isFree = seam.kind == SeamKind::Free;
        seam.place.left = trace(seam.left, isFree ? nullptr : &seam.cuts);
        if (!isFree) {
            seam.place.right = trace(seam.right, nullptr);
        }
        const auto [one, other] = std::minmax(seam.place.left.line, seam.place.right.line);
        seam.id.value = hashOf({one.value, other.value, count[{one, other}]++});
    }
}

void nameAfterCuts(SeamGraph& graph, const std::vector<AppliedCut>& cuts) {
    std::map<CutId, std::size_t> order;
    for (std::size_t c = 0; c < cuts.size(); ++c) {
        if (cuts[c].author == CutAuthor::User || !cuts[c].evidence.empty()) {
            order.emplace(cuts[c].id, c);
        }
    }
    std::set<std::string> taken;
    std::map<CutId, std::vector<Seam*>> seamsOf;  // if two cuts make one seam, the first names it
    for (Seam& seam : graph.seams) {
        taken.insert(seam.name);
        std::size_t first = cuts.size();
        for (const CutId cut : seam.cuts) {
            const auto found = order.find(cut);
            first = found == order.end() ? first : std::min(first, found->second);
        }
        if (first < cuts.size()) {
            seamsOf[cuts[first].id].push_back(&seam);
        }
    }
    for (const AppliedCut& cut : cuts) {
        const std::vector<Seam*>& seams = seamsOf[cut.id];
        int number = 0;
        for (Seam* seam : seams) {
            taken.erase(seam->name);
            std::string name = cut.name;
            while (taken.contains(name) || (seams.size() > 1 && name == cut.name)) {
                name = cut.name + " " + std::to_string(++number);
            }
            seam->name = *taken.insert(std::move(name)).first;
        }
    }
}

UserJoin joinAlong(const Seam& seam, const Pieces& pieces) {
    const Points3 line = spaceLine(seam.left, *pieces[seam.left.piece]);
    std::vector<double> arc{0};
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
        arc.push_back(arc.back() + (line.row(i) - line.row(i - 1)).norm());
    }
    UserJoin join{seam.name, {}};
    Eigen::Index last = -1;
    for (int k = 0; k < kJoinPoints; ++k) {
        // The exact ends, and between them the vertices next to evenly spaced places.
        const auto at = std::ranges::lower_bound(arc, arc.back() * k / (kJoinPoints - 1.0));
        Eigen::Index i = std::min<Eigen::Index>(at - arc.begin(), line.rows() - 1);
        i = k == kJoinPoints - 1 ? line.rows() - 1 : i;
        if (i != last) {
            join.points.emplace_back(line.row(i).transpose());
            last = i;
        }
    }
    return join;
}

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

SeamSettings turned(SeamSettings stated) {
    stated.place = turned(stated.place);
    stated.ease = seenFromRight(stated.ease);
    if (stated.drawn) {  // sides that swap run the other way
        stated.drawn = SeamPart{1 - stated.drawn->to, 1 - stated.drawn->from};
    }
    return stated;
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
        for (const SeamSettings& stated : settings) {
            byLine_[stated.place.left.line].push_back(&stated);
            if (stated.place.right.line != stated.place.left.line) {
                byLine_[stated.place.right.line].push_back(&stated);
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
            const SeamSettings& stated = *known->second[k];
            const double direct = fit(seam.place, stated.place);
            const double back = fit(seam.place, turned(stated.place));
            const double fits = std::max(direct, back);
            if (fits > 0 && fits >= best - kSame) {
                best = fits;
                found = direct >= back ? stated : turned(stated);
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
        if (const auto stated = known.of(seam)) {
            seam.ease = seam.kind == SeamKind::Free ? std::nullopt : stated->ease;
            seam.drawn = seam.ease ? stated->drawn : std::nullopt;
            if (!stated->name.empty() && stated->name != seam.name) {
                seam.name = names.free(stated->name);
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
    SeamSettings stated = SettingsByLine(settings).of(seam).value_or(SeamSettings{});
    std::erase_if(settings, [&seam](const SeamSettings& one) {
        return covered(one.place, seam.place) > 1 - kSame ||
               covered(turned(one.place), seam.place) > 1 - kSame;
    });
    stated.place = seam.place;
    stated.ease = ease;
    stated.drawn = ease ? drawn : std::nullopt;
    if (!stated.place.left.line) {
        stated = turned(stated);
    }
    const bool isStated = ease || !stated.name.empty() || SettingsByLine(settings).of(seam);
    if (isStated && stated.place.left.line) {
        settings.push_back(std::move(stated));
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
        aboutEach(ErrorCode::NoSuchSeam, unknown, worded("the seams file sets its ease"));
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
