// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/garment_jobs.h"

#include <QCoreApplication>
#include <QLocale>
#include <atomic>
#include <mutex>
#include <utility>

#include "app/base/text.h"
#include "app/document/document.h"
#include "core/quality/metric_tensor.h"
#include "core/toile/garment_flattener.h"

namespace toile::app {

namespace {

/// Approximate shares of the time on garments of 10 000 to 100 000 triangles; the rest is layout
/// and scene.
constexpr double kGarmentShare = 0.3, kGarmentAloneShare = 0.97, kFlatteningShare = 0.6;

}  // namespace

namespace {

/// The piece that is being flattened: set by the workers, read by the window.
class Underway {
public:
    explicit Underway(PieceLabels labels) : labels_(std::move(labels)) {}

    void note(int flat, int count, const Piece& begun) {
        const std::lock_guard lock(mutex_);
        number_ = flat + 1;
        count_ = count;
        name_ = nameOf(labels_, begun);
    }
    /// Empty if there is only one piece, or none yet.
    QString text() const {
        const std::lock_guard lock(mutex_);
        return count_ < 2 ? QString()
                          : QCoreApplication::translate("RecomputeJob", "%1 of %2: %3")
                                .arg(number_)
                                .arg(count_)
                                .arg(QString::fromStdString(name_));
    }

private:
    const PieceLabels labels_;
    mutable std::mutex mutex_;
    int number_ = 0, count_ = 0;
    std::string name_;
};

}  // namespace

std::unique_ptr<Job> readingJob(std::vector<std::filesystem::path> paths,
                                std::function<void(ReadFiles)> done) {
    const QString name = paths.empty() ? QString() : textOf(paths.front().filename());
    auto work = [paths = std::move(paths)](Progress& progress) {
        return readFiles(paths, progress);
    };
    return makeJob(QCoreApplication::translate("ImportJob", "Reading %1").arg(name),
                   std::move(work), std::move(done));
}

std::unique_ptr<Job> importJob(std::vector<std::filesystem::path> paths, LoadOptions loading,
                               std::function<void(Derived)> done) {
    const QString name = paths.empty() ? QString() : textOf(paths.front().filename());
    const auto faces = std::make_shared<std::atomic<int>>(0);
    auto work = [paths = std::move(paths), loading = std::move(loading),
                 faces](Progress& progress) {
        return readGarment(paths, loading, progress, faces.get());
    };
    auto detail = [faces] {
        return *faces == 0 ? QString()
                           : QCoreApplication::translate("ImportJob", "%1 faces")
                                 .arg(QLocale().toString(faces->load()));
    };
    return makeJob(QCoreApplication::translate("ImportJob", "Reading %1").arg(name),
                   std::move(work), std::move(done), true, std::move(detail));
}

std::unique_ptr<Job> recomputeJob(const Document& document, const RecomputeOrder& order,
                                  std::shared_ptr<GarmentFlattener> flattener,
                                  std::function<void(Derivation)> onGarment,
                                  std::function<void(Derivation)> done) {
    const bool isOther = !document.isCurrent();
    const auto underway = std::make_shared<Underway>(document.state().labels);
    auto work = [isOther, underway, order, state = document.state(), before = document.derived(),
                 settings = document.settings(), flattener = std::move(flattener),
                 onGarment = std::move(onGarment)](Progress& progress) -> Result<Derivation> {
        Derivation made{before};
        double from = 0;
        if (isOther) {
            from = order.flatten ? kGarmentShare : kGarmentAloneShare;
            progress.setShare(0, from);
            Result<Derivation> garment = deriveGarment(state, before, settings, progress);
            if (!garment) {
                return garment.error();
            }
            made = std::move(garment).value();
            Progress drawing(progress, 0);
            draw(made.derived, drawing);
            if (!order.flatten) {
                return made;
            }
            onGarment(made);
            made.hasOtherGarment = false;
        }
        if (order.leaveOut) {
            leaveOut(made, settings);
        }
        if (order.flatten || order.settle) {
            progress.setShare(from, from + (1 - from) * kFlatteningShare);
            order.flatten ? flatten(made, state, *flattener, progress,
                                    [underway](int flat, int count, const Piece& begun) {
                                        underway->note(flat, count, begun);
                                    })
                          : settle(made, *flattener, progress);
            from += (1 - from) * kFlatteningShare;
        }
        if (!progress.isCancelled()) {
            progress.setShare(from, 1);
            draw(made.derived, progress);
        }
        return made;
    };
    const QString title = isOther ? QCoreApplication::translate("RecomputeJob", "Making the pieces")
                          : order.flatten || order.settle
                              ? QCoreApplication::translate("RecomputeJob", "Flattening the pieces")
                              : QCoreApplication::translate("RecomputeJob", "Drawing the pieces");
    return makeJob(title, std::move(work), std::move(done), true,
                   [underway] { return underway->text(); });
}

namespace {

/// The fabric of each piece.
std::vector<Fabric> fabricsOf(const Document& document) {
    std::vector<Fabric> fabrics;
    fabrics.reserve(static_cast<std::size_t>(document.pieceCount()));
    for (int piece = 0; piece < document.pieceCount(); ++piece) {
        fabrics.push_back(document.fabricOf(piece));
    }
    return fabrics;
}

}  // namespace

std::unique_ptr<Job> grainJob(
    const Document& document, GrainRule rule, const std::vector<int>& pieces,
    std::function<void(const PieceGrains& found, bool outdated, const GrainShares& shares)> done) {
    struct Found {
        PieceGrains grains;
        GrainShares shares;
    };
    std::map<int, std::shared_ptr<const PieceResult>> results;
    std::map<int, double> before;
    for (const int piece : pieces) {
        results[piece] = document.results()[static_cast<std::size_t>(piece)];
        before[piece] = grainOf(document.settings()[static_cast<std::size_t>(piece)]);
    }
    auto work = [derived = document.derived(), results, before, rule,
                 fabrics = fabricsOf(document)](Progress&) -> Result<Found> {
        const auto grains =
            findGrains(*derived.garment, derived.results, derived.symmetry.get(), rule, fabrics);
        Found found;
        StrainedArea was, is;
        for (const auto& [piece, result] : results) {
            const auto& grain = grains[static_cast<std::size_t>(piece)];
            if (!grain) {
                continue;
            }
            found.grains[piece] = grain;
            if (rule == GrainRule::LeastStrain && result->flat) {
                const auto add = [&shown = *result,
                                  &fabric = fabrics[static_cast<std::size_t>(piece)]](
                                     StrainedArea& sum, double angle) {
                    const StrainedArea one =
                        strainedArea(shown.piece->mesh, shown.flat->Q, fabric, angle);
                    sum.all += one.all;
                    sum.beyond += one.beyond;
                };
                add(was, before.at(piece));
                add(is, *grain);
            }
        }
        found.shares = {was.share(), is.share()};
        return found;
    };
    auto taken = [&document, results, fabrics = fabricsOf(document),
                  done = std::move(done)](Found found) {
        // The grain is a direction in the flat coordinates it was found in.
        const auto dropped = std::erase_if(found.grains, [&](const auto& entry) {
            const int piece = entry.first;
            return document.result(piece) != results.at(piece).get() ||
                   !(document.fabricOf(piece) == fabrics[static_cast<std::size_t>(piece)]);
        });
        done(found.grains, dropped > 0, found.shares);
    };
    return makeJob(QCoreApplication::translate("GrainJob", "Finding the grain"), std::move(work),
                   std::move(taken));
}

}  // namespace toile::app
