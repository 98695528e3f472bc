// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/garment_jobs.h"

#include <QCoreApplication>
#include <unordered_map>
#include <utility>

#include "app/base/path_text.h"
#include "app/document/disposal.h"
#include "app/document/document.h"
#include "app/render/scene_builder.h"
#include "core/pipeline/garment_flattener.h"
#include "core/project/place_pieces.h"
#include "core/quality/best_grain.h"

namespace toile {

namespace {

/// Of the jobs' times, about, on garments of 10 000 to 100 000 triangles; the rest is laying out
/// and the scene.
constexpr double kReadingShare = 0.97, kCuttingShare = 0.8, kFlatteningShare = 0.5;

struct Flattened {
    PieceResults results;
    std::vector<std::optional<FlatMotion>> motions;
    std::vector<Eigen::Vector2d> proposed;  ///< offsets, per piece
    std::shared_ptr<const Scene> scene;
};

/// Pieces that are flat already keep their very positions: after steps back and forth the flattener
/// comes from another version of the garment, and what it finds is as good, but not the same to the
/// last bit.
void keepWhatFits(const PieceResults& before, const Garment& garment, const FlattenOptions& options,
                  PieceResults& results) {
    for (std::size_t i = 0; i < results.size() && i < before.size(); ++i) {
        const PieceResult* known = before[i].get();
        if (known && known->flat && known->piece == garment.pieces[i] &&
            known->options == options) {
            results[i] = before[i];
        }
    }
}

}  // namespace

std::unique_ptr<Job> importJob(std::vector<std::filesystem::path> files, LoadOptions options,
                               std::optional<DocumentState> before,
                               std::function<void(MadeGarment)> done) {
    const QString name = files.empty() ? QString() : textOf(files.front().filename());
    auto work = [files = std::move(files), options = std::move(options),
                 before = std::move(before)](Progress& progress) -> Result<MadeGarment> {
        progress.setShare(0, kReadingShare);
        LoadOptions reading = options;
        if (before) {
            reading.known = knownPieces(*before->garment);
        }
        Result<Garment> garment =
            loadGarment(files, reading, progress, before ? before->garment.get() : nullptr);
        if (!garment) {
            return garment.error();
        }
        MadeGarment made;
        made.garment =
            sharedForDisposal(std::make_unique<const Garment>(std::move(garment).value()));
        if (before) {
            made.carried =
                carriedFrom(*before->garment, before->settings, before->results, *made.garment);
        }
        progress.setShare(kReadingShare, 1);
        made.scene = buildScene(*made.garment, {}, progress);
        return made;
    };
    return makeJob(QCoreApplication::translate("ImportJob", "Reading %1").arg(name),
                   std::move(work), std::move(done));
}

std::unique_ptr<Job> cutJob(DocumentState before, LoadOptions options,
                            std::function<void(MadeGarment)> done) {
    auto work = [before = std::move(before),
                 options = std::move(options)](Progress& progress) -> Result<MadeGarment> {
        progress.setShare(0, kCuttingShare);
        Result<Garment> garment = cutGarment(*before.garment, options, progress);
        if (!garment) {
            return garment.error();
        }
        MadeGarment made;
        made.garment =
            sharedForDisposal(std::make_unique<const Garment>(std::move(garment).value()));
        made.carried = carriedFrom(*before.garment, before.settings, before.results, *made.garment);
        progress.setShare(kCuttingShare, 1);
        made.scene =
            buildScene(*made.garment, carriedResults(before.results, *made.garment), progress);
        return made;
    };
    return makeJob(QCoreApplication::translate("CutJob", "Cutting the pieces"), std::move(work),
                   std::move(done));
}

PieceResults carriedResults(const PieceResults& results, const Garment& after) {
    std::unordered_map<const Piece*, std::shared_ptr<const PieceResult>> known;
    for (const auto& result : results) {
        if (result) {
            known.emplace(result->piece.get(), result);
        }
    }
    PieceResults carried;
    for (const auto& piece : after.pieces) {
        const auto found = known.find(piece.get());
        carried.push_back(found == known.end() ? nullptr : found->second);
    }
    return carried;
}

std::unique_ptr<Job> flattenJob(Document& document) {
    Q_ASSERT(document.garment());
    auto work = [garment = document.garment(), options = document.options(),
                 before = document.results(),
                 flattener = document.state().letGo
                                 ? std::make_shared<GarmentFlattener>()
                                 : document.flattener()](Progress& progress) -> Result<Flattened> {
        progress.setShare(0, kFlatteningShare);
        Flattened made;
        made.results = flattener->flatten(*garment, options, progress);
        keepWhatFits(before, *garment, options, made.results);
        if (!progress.isCancelled()) {
            progress.setShare(kFlatteningShare, 1);
            made.motions = flatMotions(before, made.results);
            made.proposed = layOut(*garment, made.results).offsets;
            made.scene = buildScene(*garment, made.results, progress);
        }
        return made;
    };
    auto done = [&document](Flattened made) {
        // Places that were given meanwhile are kept.
        std::vector<PieceSettings> settings =
            placedSettings(document.settings(), made.results, made.motions, made.proposed);
        document.setResults(std::move(made.results), std::move(made.scene), std::move(settings));
    };
    return makeJob(QCoreApplication::translate("FlattenJob", "Flattening the pieces"),
                   std::move(work), std::move(done), {.revision = document.revision()});
}

std::unique_ptr<Job> sceneJob(Document& document) {
    Q_ASSERT(document.garment());
    const auto& garment = document.garment();
    const auto& results = document.results();
    auto work = [garment, results](Progress& progress) -> Result<std::shared_ptr<const Scene>> {
        return buildScene(*garment, results, progress);
    };
    auto done = [&document, garment, results](std::shared_ptr<const Scene> scene) {
        if (document.garment() == garment && document.results() == results) {
            document.setScene(std::move(scene));
        }
    };
    return makeJob(QCoreApplication::translate("SceneJob", "Drawing the pieces"), std::move(work),
                   std::move(done));
}

std::unique_ptr<Job> grainJob(const Document& document, const std::vector<int>& pieces,
                              std::function<void(const PieceGrains& found, bool outdated)> done) {
    std::map<int, std::shared_ptr<const PieceResult>> results;
    for (const int piece : pieces) {
        results[piece] = document.results()[static_cast<std::size_t>(piece)];
    }
    auto work = [results, fabric = document.fabric()](Progress& progress) -> Result<PieceGrains> {
        PieceGrains found;
        progress.start(static_cast<double>(results.size()));
        for (const auto& [piece, result] : results) {
            if (progress.isCancelled()) {
                break;
            }
            if (const auto grain = bestGrain(result->piece->mesh, result->flat->Q, fabric)) {
                found[piece] = *grain;
            }
            progress.advance(1);
        }
        return found;
    };
    auto taken = [&document, results, fabric = document.fabric(),
                  done = std::move(done)](PieceGrains found) {
        // The grain is a direction in the flat coordinates it was found in.
        const auto dropped = std::erase_if(found, [&](const auto& entry) {
            const int piece = entry.first;
            return document.result(piece) != results.at(piece).get() ||
                   !(document.fabric() == fabric);
        });
        done(found, dropped > 0);
    };
    return makeJob(QCoreApplication::translate("GrainJob", "Looking for the best grain"),
                   std::move(work), std::move(taken));
}

}  // namespace toile
