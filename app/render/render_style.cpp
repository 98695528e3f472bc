// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/render_style.h"

#include <QPalette>
#include <algorithm>
#include <cstdint>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

namespace toile::app {

namespace {

struct MarkColours {
    QColor selection, seam;
};

/// Global, like the window's palette.
MarkColours& markColours() {
    static MarkColours colours;
    return colours;
}

RenderStyle usualStyle(const QPalette& palette) {
    const bool dark = isDark(palette);
    const auto tone = [dark](const QColor& onLight, const QColor& onDark) {
        return dark ? onDark : onLight;
    };
    return {.top = tone({250, 250, 251}, {52, 55, 61}),
            .bottom = tone({232, 235, 239}, {36, 38, 43}),
            .onDark = dark,
            .grid = tone({196, 203, 212}, {82, 87, 96}),
            .outline = tone({52, 58, 68}, {14, 15, 18}),
            .wire = tone({40, 46, 56}, {10, 11, 14}),
            .selection = tone({214, 16, 118}, {255, 92, 178}),
            .seam = QColor(255, 214, 10),
            .seamHalo = QColor(18, 20, 24),
            .freeEdge = tone({128, 136, 148}, {150, 156, 166}),
            .reference = tone({0, 92, 230}, {92, 214, 255}),
            .exactOutline = tone({70, 78, 90}, {214, 219, 226}),
            .cuttingLine = tone({12, 14, 18}, {246, 248, 250}),
            .text = tone({40, 45, 53}, {226, 229, 234}),
            .faintText = tone({104, 112, 123}, {158, 164, 174}),
            .labelFill = tone({255, 255, 255, 200}, {24, 26, 30, 200})};
}

/// FNV-1a: unlike std::hash, the same on every computer.
std::uint32_t hashOf(std::string_view text) {
    std::uint32_t hash = 2166136261U;
    for (const char letter : text) {
        hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619U;
    }
    return hash;
}

using Uses = std::array<int, kSeamColours>;

/// Counts the uses of colours.
class Taken {
public:
    /// Uses to avoid: on a seam of the same two pieces, on either piece, anywhere.
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

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() < 128;
}

void setMarkColours(const QColor& selection, const QColor& seam) {
    markColours() = {selection, seam};
}

RenderStyle renderStyle(const QPalette& palette) {
    RenderStyle style = usualStyle(palette);
    const auto& [selection, seam] = markColours();
    style.selection = selection.isValid() ? selection : style.selection;
    style.seam = seam.isValid() ? seam : style.seam;
    return style;
}

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

}  // namespace toile::app
