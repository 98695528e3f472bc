// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/seam_palette.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

namespace toile {

namespace {

/// The same on every computer, unlike std::hash (FNV-1a).
std::uint32_t hashOf(std::string_view text) {
    std::uint32_t hash = 2166136261U;
    for (const char letter : text) {
        hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619U;
    }
    return hash;
}

using Uses = std::array<int, kSeamColours>;

/// Which colours are taken, where.
class Taken {
public:
    /// The less the better: on a seam of the same two pieces, on either piece, anywhere.
    std::tuple<int, int, int> cost(const Seam& seam, std::size_t colour) const {
        int between = 0, beside = 0;
        if (const auto pair = between_.find(piecesOf(seam)); pair != between_.end()) {
            between = pair->second[colour];
        }
        for (const int piece : {seam.left.piece, seam.right.piece}) {
            const auto uses = beside_.find(piece);
            beside += piece >= 0 && uses != beside_.end() ? uses->second[colour] : 0;
        }
        return {between, beside, anywhere_[colour]};
    }

    void add(const Seam& seam, std::size_t colour) {
        ++anywhere_[colour];
        ++beside_[seam.left.piece][colour];
        if (seam.right.piece != seam.left.piece) {
            ++beside_[seam.right.piece][colour];
        }
        if (seam.left.piece >= 0 && seam.right.piece >= 0) {
            ++between_[piecesOf(seam)][colour];
        }
    }

private:
    static std::pair<int, int> piecesOf(const Seam& seam) {
        return std::minmax({seam.left.piece, seam.right.piece});
    }

    std::map<std::pair<int, int>, Uses> between_;
    std::map<int, Uses> beside_;
    Uses anywhere_{};
};

}  // namespace

const std::array<Rgb, kSeamColours>& seamPalette(bool onDark) {
    static constexpr std::array<Rgb, kSeamColours> kColours = {{
        {214, 48, 30},   // red
        {22, 92, 212},   // blue
        {10, 132, 62},   // green
        {236, 122, 8},   // orange
        {112, 58, 196},  // violet
        {0, 158, 186},   // cyan
        {134, 76, 34},   // brown
        {108, 146, 0},   // olive
        {24, 34, 108},   // navy
        {142, 12, 52},   // wine
    }};
    static constexpr std::array<Rgb, kSeamColours> kLight = {{
        {255, 84, 60},    // red
        {70, 146, 255},   // blue
        {44, 190, 104},   // green
        {255, 162, 46},   // orange
        {178, 130, 255},  // violet
        {40, 210, 232},   // cyan
        {184, 124, 76},   // brown
        {172, 204, 40},   // olive
        {104, 112, 190},  // navy
        {190, 62, 110},   // wine
    }};
    return onDark ? kLight : kColours;
}

std::vector<int> seamColours(const SeamGraph& graph) {
    std::vector<int> colours(graph.seams.size(), -1);
    Taken taken;
    for (std::size_t i = 0; i < graph.seams.size(); ++i) {
        const Seam& seam = graph.seams[i];
        if (seam.kind == SeamKind::Free) {
            continue;
        }
        const std::size_t wanted = hashOf(seam.name) % kSeamColours;
        std::size_t best = wanted;
        for (std::size_t step = 1; step < kSeamColours; ++step) {
            const std::size_t colour = (wanted + step) % kSeamColours;
            if (taken.cost(seam, colour) < taken.cost(seam, best)) {
                best = colour;
            }
        }
        taken.add(seam, best);
        colours[i] = static_cast<int>(best);
    }
    return colours;
}

}  // namespace toile
