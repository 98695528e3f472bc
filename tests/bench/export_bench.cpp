// SPDX-License-Identifier: GPL-3.0-or-later
// What a pattern to cut and sew costs in each format, but for pictures: `export/dress/svg` to make
// the bytes, `readBack/dress/svg` to read them and compare, and `.../all` one after the other from
// one drawing, as the command line does.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/formats/formats.h"
#include "core/toile/pipeline.h"
#include "tests/bench/bench_pieces.h"
#include "tests/bench/benchmarks.h"
#include "tests/core/support/laid_rows.h"

namespace toile::bench {
namespace {

/// A garment as read, flat and laid out.
struct LaidGarment {
    Garment garment;
    LineSettings lines;
    PieceResults results;
    LaidOutPattern laid;

    ExportSource source() const { return {garment, results, laid, {}, {}, lines}; }
};

const LaidGarment* laidGarment(const std::string& name) {
    static std::unique_ptr<const LaidGarment> kept;  // there is one
    if (!kept) {
        Progress progress;
        LoadOptions load;
        load.unit = LengthUnit::Centimetre;  // as its README says
        auto garment = loadGarment({sharedFile(name)}, load, progress);
        if (!garment) {
            return nullptr;
        }
        const LineSettings lines = withPattern({});
        PieceResults results = flattenGarment(*garment, {}, progress, 0, lines);
        LaidOutPattern laid = inRows(*garment, results, lines);
        kept = std::make_unique<LaidGarment>(
            LaidGarment{std::move(*garment), lines, std::move(results), std::move(laid)});
    }
    return kept.get();
}

using Chosen = std::vector<const Format*>;

void measureMaking(benchmark::State& state, const std::string& garment, const Chosen& chosen) {
    const LaidGarment* laid = laidGarment(garment);
    if (!laid) {
        state.SkipWithError("its file is not there");
        return;
    }
    double bytes = 0;
    for (auto _ : state) {
        const ExportSource source = laid->source();
        bytes = 0;
        for (const Format* format : chosen) {
            const auto files = format->write(source);
            bytes += files ? static_cast<double>(files->front().bytes.size()) : 0;
        }
    }
    state.counters["MB"] = 1e-6 * bytes;
}

void measureReadingBack(benchmark::State& state, const std::string& garment, const Chosen& chosen) {
    const LaidGarment* laid = laidGarment(garment);
    if (!laid) {
        state.SkipWithError("its file is not there");
        return;
    }
    const ExportSource source = laid->source();
    std::vector<ExportedFiles> made;
    for (const Format* format : chosen) {
        made.push_back(*format->write(source));
    }
    for (auto _ : state) {
        for (std::size_t k = 0; k < chosen.size(); ++k) {
            if (!chosen[k]->readBack(made[k], source)) {
                state.SkipWithError(chosen[k]->name);
                return;
            }
        }
    }
}

void registerOne(const std::string& what, const Chosen& chosen,
                 void (*measure)(benchmark::State&, const std::string&, const Chosen&)) {
    const std::string how = chosen.size() == 1 ? chosen.front()->endings.front() + 1 : "all";
    auto* added = benchmark::RegisterBenchmark(
        (what + "/dress/" + how).c_str(),
        [chosen, measure](benchmark::State& state) { measure(state, "dress", chosen); });
    measured(added, 5);
}

}  // namespace

void registerExport() {
    Chosen written, read;
    for (const Format& format : formats()) {
        if (!format.write || format.id == FormatId::Html) {
            continue;
        }
        registerOne("export", {&format}, measureMaking);
        written.push_back(&format);
        if (format.readBack) {
            registerOne("readBack", {&format}, measureReadingBack);
            read.push_back(&format);
        }
    }
    registerOne("export", written, measureMaking);
    registerOne("readBack", read, measureReadingBack);
}

}  // namespace toile::bench
