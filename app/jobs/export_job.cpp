// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/export_job.h"

#include <QCoreApplication>
#include <utility>

#include "app/document/document.h"

namespace toile {

ExportJob::ExportJob(const Document& document, std::filesystem::path path, Done done)
    : garment_(document.garment()),
      results_(document.results()),
      path_(std::move(path)),
      done_(std::move(done)) {}

QString ExportJob::title() const {
    return QCoreApplication::translate("ExportJob", "Writing %1")
        .arg(QString::fromStdU16String(path_.filename().u16string()));
}

Result<void> ExportJob::process(Progress&) {
    return exportFile(path_, *garment_, results_);
}

void ExportJob::finalize() {
    done_(path_);
}

}  // namespace toile
