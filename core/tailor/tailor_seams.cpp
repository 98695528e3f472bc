// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/tailor_seams.h"

#include <array>
#include <utility>

#include "core/tailor/bands.h"
#include "core/tailor/leg_seams.h"
#include "core/tailor/middle_seams.h"
#include "core/tailor/scraps.h"
#include "core/tailor/seam_pull.h"
#include "core/tailor/style_lines.h"
#include "core/tailor/top_seams.h"

namespace toile {
namespace {

class TailorSeams {
public:
    TailorSeams(const BodyWays& ways, const MeshLines& lines,
                const std::vector<std::vector<int>>& cuts)
        : ways_(ways),
          lines_(lines),
          unbanded_(tailor::withoutBands(ways, lines)),
          pull_(ways, unbanded_),
          cuts_(cuts) {}

    void addTop() {
        std::array<std::vector<int>, 2> sides;
        bool isSleeveless = false;
        for (const int side : {-1, 1}) {
            const auto top = tailor::topSide(ways_, pull_, side);
            if (!top) {
                continue;
            }
            const auto armpit = static_cast<std::ptrdiff_t>(top->armpit);
            const auto shoulder = static_cast<std::ptrdiff_t>(top->shoulder);
            isSleeveless = isSleeveless || !top->hasSleeve;
            sides[side < 0 ? 0 : 1].assign(top->under.begin() + armpit, top->under.end());
            add(TailorLine::Side, side, sides[side < 0 ? 0 : 1]);
            add(TailorLine::Shoulder, side,
                {top->ridge.begin(), top->ridge.begin() + shoulder + 1});
            if (top->hasSleeve) {
                add(TailorLine::Underarm, side,
                    {top->under.begin(), top->under.begin() + armpit + 1});
                add(TailorLine::Armhole, side, top->armhole);
            }
        }
        if (isSleeveless && !sides[0].empty() && !sides[1].empty()) {
            const GarmentBody& body = ways_.body();
            add(TailorLine::Centre, 0,
                tailor::centreLine(ways_, pull_, body.find(OpeningKind::Neck)->loop.vertices,
                                   body.find(OpeningKind::Hem)->loop.vertices));
            add(TailorLine::Waist, 0, tailor::waistLine(ways_, pull_, sides));
        }
    }

    void addLegs() {
        if (const auto legs = tailor::legSeams(ways_, pull_)) {
            add(TailorLine::Centre, 0, legs->centre);
            for (int k = 0; k < 2; ++k) {
                add(TailorLine::Inseam, 2 * k - 1, legs->inseam[k]);
                add(TailorLine::Side, 2 * k - 1, legs->side[k]);
            }
        }
    }

    void addSkirt() {
        const auto sides = tailor::skirtSides(ways_, pull_);
        add(TailorLine::Side, -1, sides[0]);
        add(TailorLine::Side, 1, sides[1]);
    }

    void addStyleLines() {
        std::vector<std::vector<int>> known = cuts_;
        for (const TailorSeam& seam : seams_) {
            known.push_back(seam.way);
        }
        const tailor::SeamPull pull(ways_, lines_);
        std::vector<std::vector<int>> found = tailor::styleLines(ways_, lines_, pull, known);
        const std::vector<char> isBand = tailor::bandsAmong(ways_, found);
        for (std::size_t k = 0; k < found.size(); ++k) {
            add(isBand[k] != 0 ? TailorLine::Band : TailorLine::Style, 0, std::move(found[k]));
        }
    }

    /// Leaves out what runs along the cuts.
    void leaveOutCuts() {
        const std::vector<TailorSeam> left = tailor::withoutScraps(ways_, seams_, cuts_);
        seams_.clear();
        for (const TailorSeam& seam : left) {
            add(seam.line, seam.side, seam.way);
        }
    }

    std::vector<TailorSeam> take() { return std::move(seams_); }

private:
    void add(TailorLine line, int side, std::vector<int> way) {
        if (way.size() > 1) {
            const double likeliness = tailor::alongLines(ways_, lines_, way);
            seams_.push_back({line, side, std::move(way), likeliness});
        }
    }

    const BodyWays& ways_;
    const MeshLines& lines_;
    const MeshLines unbanded_;
    const tailor::SeamPull pull_;  ///< not to bands
    const std::vector<std::vector<int>>& cuts_;
    std::vector<TailorSeam> seams_;
};

}  // namespace

std::vector<TailorSeam> tailorSeams(const BodyWays& ways, const MeshLines& lines,
                                    const std::vector<std::vector<int>>& cuts,
                                    const Progress& progress) {
    TailorSeams seams(ways, lines, cuts);
    switch (ways.body().form) {
        case BodyForm::Top:
            seams.addTop();
            break;
        case BodyForm::Trousers:
            seams.addLegs();
            break;
        case BodyForm::Skirt:
            seams.addSkirt();
            break;
        case BodyForm::Unknown:
            break;
    }
    if (!progress.isCancelled()) {
        seams.addStyleLines();
    }
    if (!cuts.empty()) {
        seams.leaveOutCuts();
    }
    return seams.take();
}

}  // namespace toile
