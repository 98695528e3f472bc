// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/marker_job.h"

#include <QCoreApplication>
#include <utility>

#include "app/base/text.h"
#include "app/jobs/derivation.h"
#include "app/text/error_text.h"
#include "core/formats/drawing/marker_drawing.h"
#include "core/formats/export_file.h"

namespace toile::app {

Result<std::shared_ptr<const ClothGround>> clothGround(const PatternNow& now, Progress& progress) {
    using Made = std::shared_ptr<const ClothGround>;
    return now.with({}, progress, [](const ExportSource& source, const Progress&) {
        return Result<Made>(std::make_shared<const ClothGround>(
            ClothGround{source.garment(), source.results(), source.laid(), source.words(),
                        source.lines(), source.fabric()}));
    });
}

MarkerSearch::MarkerSearch(QObject* parent) : QObject(parent) {
    poll_.setInterval(kPause);
    connect(&poll_, &QTimer::timeout, this, &MarkerSearch::fetch);
}

MarkerSearch::~MarkerSearch() = default;

void MarkerSearch::begin(MarkerOrder order, std::optional<int> rounds) {
    if (order.pattern != order_.pattern || order.material != order_.material) {
        best_.reset();  // otherwise it is shown until there is a better one
    }
    order_ = std::move(order);
    rounds_ = rounds;
    nester_.reset();
    mailbox_ = std::make_shared<Mailbox<ClothMarker>>();
    problem_.reset();
    isWanted_ = true;
    ++begun_;
    worker_.cancel();
    start();
    emit changed();
}

void MarkerSearch::goOn() {
    if (!order_.pattern || problem_) {
        return;
    }
    rounds_.reset();
    isWanted_ = true;
    worker_.cancel();  // it counts its rounds
    start();
    emit changed();
}

void MarkerSearch::stop() {
    isWanted_ = false;
    worker_.cancel();
    emit changed();
}

void MarkerSearch::clear() {
    stop();
    ++begun_;
    order_ = {};
    nester_.reset();
    best_.reset();
    problem_.reset();
    mailbox_ = std::make_shared<Mailbox<ClothMarker>>();
    emit changed();
}

void MarkerSearch::start() {
    if (!isWanted_ || worker_.isBusy()) {
        return;  // it is cancelled, and this follows
    }
    working_ = begun_;
    poll_.start();
    worker_.start(
        [order = order_, nester = std::exchange(nester_, nullptr), mailbox = mailbox_,
         rounds = rounds_](Progress& progress) mutable -> Outcome {
            if (!nester) {
                auto made = MarkerNester::make(order.pattern, order.material, order.fabric,
                                               order.plan.settings, order.plan.kept, progress);
                if (!made) {
                    return {nullptr, made.error()};
                }
                nester = std::make_shared<MarkerNester>(std::move(*made));
            }
            const auto show = [&] {
                mailbox->put(std::make_shared<const ClothMarker>(nester->best()));
            };
            show();
            for (int k = 0;
                 !progress.isCancelled() && !nester->best().isOptimal && (!rounds || k < *rounds);
                 ++k) {
                nester->step(progress);
                show();
            }
            return {std::move(nester), {}};
        },
        [this](const Attempt<Outcome>& made, const Progress& progress) {
            onDone(made, progress.isCancelled());
        });
}

void MarkerSearch::fetch() {
    if (auto found = mailbox_->take()) {
        best_ = std::move(found);
        bestOf_ = begun_;  // each order has its own mailbox
        emit changed();
    }
}

void MarkerSearch::onDone(const Attempt<Outcome>& made, bool isCancelled) {
    poll_.stop();
    if (working_ != begun_) {  // it belongs to an earlier order
        start();
        return;
    }
    fetch();
    if (!made.answer) {
        isWanted_ = false;
        emit failed(faultText(made.fault));
    } else if (made.answer->nester) {
        nester_ = made.answer->nester;
        isWanted_ = isWanted_ && isCancelled;  // stopped only to continue in another way
        start();
    } else if (!isCancelled) {
        isWanted_ = false;
        problem_ = made.answer->problem;
    } else {
        start();
    }
    emit changed();
}

std::unique_ptr<Job> markerFileJob(MarkerSheet sheet, std::filesystem::path path,
                                   const ExportOptions& options,
                                   std::function<void(const Exported&)> done) {
    const QString name = textOf(path.filename());
    auto work = [sheet = std::move(sheet), path = std::move(path),
                 options](Progress& progress) -> Result<Exported> {
        const ClothGround& ground = *sheet.ground;
        const DrawnMarker drawn =
            drawMarker(*sheet.pattern, sheet.marker, sheet.settings, sheet.title, ground.words);
        return exportFile(path,
                          ExportSource(ground.garment, ground.results, drawn.laid, options,
                                       ground.words, ground.lines, ground.fabric, drawn.drawing),
                          progress);
    };
    return makeJob(QCoreApplication::translate("ExportJob", "Writing %1").arg(name),
                   std::move(work), std::move(done));
}

}  // namespace toile::app
