// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/style_lines.h"

#include <algorithm>
#include <numeric>

#include "core/geometry/shortest_paths.h"

namespace toile::tailor {
namespace {

constexpr double kLikely = 0.8, kShortest = 60;  // mm
/// A line is known where more than this part of it is this near to known ones, mm.
constexpr double kKnownPart = 0.4, kByKnown = 20;
/// What leads on from its ends: likely, or short, mm.
constexpr double kLikelyLead = 0.7, kShortLead = 40;
/// Of its mirror image, what must lie on other likely lines.
constexpr double kMirroredPart = 0.7;

class StyleLines {
public:
    StyleLines(const BodyWays& ways, const MeshLines& lines, const SeamPull& pull)
        : ways_(ways),
          lines_(lines),
          pull_(pull),
          easedLengths_(pull.eased(ways.lengths())),
          isInNetwork_(static_cast<std::size_t>(ways.links().vertexCount()), 0) {
        for (int v = 0; v < ways.links().vertexCount(); ++v) {
            isInNetwork_[v] = ways.links().isInner(v) ? 0 : 1;
        }
        likely_ = network();
        for (std::size_t line = 0; line < lines.ways.size(); ++line) {
            if (isLikely(line)) {
                likely_.insert(likely_.end(), lines.ways[line].begin(), lines.ways[line].end());
            }
        }
    }

    void addKnown(const std::vector<int>& way) {
        for (const int v : way) {
            isInNetwork_[v] = 1;
        }
    }

    std::vector<std::vector<int>> run() {
        std::vector<std::size_t> order;
        for (std::size_t line = 0; line < lines_.ways.size(); ++line) {
            if (isLikely(line)) {
                order.push_back(line);
            }
        }
        std::ranges::stable_sort(order, std::ranges::greater{}, [this](std::size_t line) {
            return ways_.length(lines_.ways[line]) * lines_.likeliness[line];
        });
        std::vector<std::vector<int>> found;
        for (const std::size_t line : order) {
            const std::vector<int>& way = lines_.ways[line];
            if (nearPart(way, network(), false) >= kKnownPart ||
                nearPart(way, likely_, true) < kMirroredPart) {
                continue;
            }
            const std::vector<int> whole = ledOn(way);
            if (!whole.empty() && pull_.along(whole) >= kLikely) {
                found.push_back(whole);
                addKnown(whole);
            }
        }
        return found;
    }

private:
    bool isLikely(std::size_t line) const {
        return lines_.likeliness[line] > kLikely && ways_.length(lines_.ways[line]) > kShortest;
    }

    std::vector<int> network() const {
        std::vector<int> vertices;
        for (int v = 0; v < static_cast<int>(isInNetwork_.size()); ++v) {
            if (isInNetwork_[v] != 0) {
                vertices.push_back(v);
            }
        }
        return vertices;
    }

    /// Which part of a way, or of its mirror image, is near to some vertices.
    double nearPart(const std::vector<int>& way, const std::vector<int>& others,
                    bool isMirrored) const {
        int near = 0;
        for (const int v : way) {
            const Eigen::Vector3d here =
                isMirrored ? ways_.body().plane.reflected(ways_.at(v)) : ways_.at(v);
            near += std::ranges::any_of(others, [&](int other) {
                return (ways_.at(other) - here).squaredNorm() < kByKnown * kByKnown;
            });
        }
        return static_cast<double>(near) / static_cast<double>(way.size());
    }

    /// The way with both ends led on to the network; empty where one does not reach it.
    std::vector<int> ledOn(const std::vector<int>& way) const {
        std::vector<int> whole = way;
        if (way.front() == way.back()) {
            return whole;
        }
        const std::vector<int> targets = network();
        for (int end = 0; end < 2; ++end) {
            std::ranges::reverse(whole);
            if (isInNetwork_[whole.back()] != 0) {
                continue;
            }
            const std::vector<int> lead = ways_.cheapest(easedLengths_, {whole.back()}, targets);
            if (lead.empty() ||
                (pull_.along(lead) <= kLikelyLead && ways_.length(lead) >= kShortLead)) {
                return {};
            }
            whole.insert(whole.end(), lead.begin() + 1, lead.end());
        }
        return whole;
    }

    const BodyWays& ways_;
    const MeshLines& lines_;
    const SeamPull& pull_;
    const std::vector<double> easedLengths_;
    std::vector<char> isInNetwork_;
    std::vector<int> likely_;
};

}  // namespace

std::vector<std::vector<int>> styleLines(const BodyWays& ways, const MeshLines& lines,
                                         const SeamPull& pull,
                                         const std::vector<std::vector<int>>& known) {
    StyleLines style(ways, lines, pull);
    for (const std::vector<int>& way : known) {
        style.addKnown(way);
    }
    return style.run();
}

}  // namespace toile::tailor
