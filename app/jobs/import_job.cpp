// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/import_job.h"

#include <QCoreApplication>
#include <utility>

#include "app/document/document.h"
#include "app/render/scene_builder.h"

namespace toile {

namespace {

/// Of the job's time, about, on garments of 10 000 to 100 000 triangles; the rest is the scene.
constexpr double kReadingShare = 0.97;

}  // namespace

ImportJob::ImportJob(Document& document, std::vector<std::filesystem::path> files,
                     LoadOptions options)
    : document_(document), files_(std::move(files)), options_(std::move(options)) {}

QString ImportJob::title() const {
    const QString name = files_.empty()
                             ? QString()
                             : QString::fromStdU16String(files_.front().filename().u16string());
    return QCoreApplication::translate("ImportJob", "Reading %1").arg(name);
}

Result<void> ImportJob::process(Progress& progress) {
    progress.setShare(0, kReadingShare);
    Result<Garment> garment = loadGarment(files_, options_, progress);
    if (!garment) {
        return garment.error();
    }
    garment_ = std::make_shared<const Garment>(std::move(garment).value());
    progress.setShare(kReadingShare, 1);
    scene_ = buildScene(*garment_, {}, {}, progress);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, {}, {}};
    }
    return {};
}

void ImportJob::finalize() {
    document_.setGarment(std::move(garment_), std::move(scene_));
}

}  // namespace toile
