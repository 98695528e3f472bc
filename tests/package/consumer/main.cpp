// SPDX-License-Identifier: GPL-3.0-or-later
// consumer FILE: flattens a garment in millimetres and prints how long both sides of its seams are.
#include <cstdio>

#include "core/pipeline/pipeline.h"
#include "core/seam/seam_measure.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: consumer FILE\n");
        return 2;
    }
    toile::Progress progress;
    toile::LoadOptions reading;
    reading.unit = toile::LengthUnit::Millimetre;
    const auto garment = toile::loadGarment({argv[1]}, reading, progress);
    if (!garment) {
        std::fprintf(stderr, "%s\n", toile::sentence(garment.error()).c_str());
        return 3;
    }
    const toile::PieceResults results = toile::flattenGarment(*garment, {}, progress);
    const auto& seams = garment->seams.seams;
    for (std::size_t s = 0; s < seams.size(); ++s) {
        const auto measure = toile::measured(*garment, results, static_cast<int>(s));
        if (measure && seams[s].kind == toile::SeamKind::Seam) {
            std::printf("%s: %.6f %.6f\n", seams[s].name.c_str(), measure->length2dLeft,
                        measure->length2dRight);
        }
    }
}
