// SPDX-License-Identifier: GPL-3.0-or-later
// consumer GARMENT PATTERN...: reads a garment and writes its pattern, with the usual allowances.
#include <cstdio>

#include <toile/toile.h>

int main(int argc, char** argv) {
    const toile::PatternOrder order{.lines = toile::withPattern({})};
    const auto garment = toile::read({argc > 2 ? argv[1] : ""});
    if (!garment) {
        std::fprintf(stderr, "%s\n", toile::sentence(garment.error()).c_str());
        return 1;
    }
    const auto pattern = toile::makePattern(*garment, toile::flatten(*garment, order), order);
    for (int i = 2; i < argc; ++i) {
        if (const auto written = toile::write(argv[i], pattern); !written) {
            std::fprintf(stderr, "%s\n", toile::sentence(written.error()).c_str());
            return 1;
        }
    }
}
