// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/export_job.h"

#include <QCoreApplication>
#include <utility>

#include "app/base/path_text.h"
#include "app/document/document.h"
#include "app/text/drawing_words.h"

namespace toile {

ExportJob::ExportJob(const Document& document, std::filesystem::path path, Done done)
    : garment_(document.garment()),
      results_(document.results()),
      words_(drawingWords()),
      path_(std::move(path)),
      done_(std::move(done)) {
    for (const PieceSettings& piece : document.settings()) {
        places_.push_back(onSheet(piece));
    }
}

QString ExportJob::title() const {
    return QCoreApplication::translate("ExportJob", "Writing %1").arg(textOf(path_.filename()));
}

Result<void> ExportJob::process(Progress& progress) {
    return exportFile(path_, *garment_, results_, places_, progress, words_);
}

void ExportJob::finalize() {
    done_(path_);
}

}  // namespace toile
