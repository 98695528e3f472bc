// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report_pictures.h"

#include <QBuffer>
#include <QGuiApplication>
#include <functional>
#include <memory>
#include <utility>

#include "app/document/document.h"
#include "app/jobs/derivation.h"
#include "app/jobs/proof_job.h"
#include "app/platform_choice.h"
#include "app/render/gl_support.h"
#include "app/render/offscreen.h"
#include "app/settings/theme.h"
#include "app/views/view_picture.h"

namespace toile::app {

namespace {

constexpr QSize kPictureSize{1400, 700};

/// Qt needs an application to draw text; the command line has none.
void makeApplication() {
    if (QCoreApplication::instance()) {
        return;
    }
    static char name[] = "toile";
    static char* arguments[] = {name, nullptr};
    static int count = 1;
    loadResources();
    quietenQt();
    qputenv("QT_QPA_PLATFORM", "offscreen");
    static const QGuiApplication* const application = new QGuiApplication(count, arguments);
    Q_UNUSED(application);
}

/// Opens the source like a new window.
void openIn(Document& document, const ExportSource& source) {
    Derived derived;
    derived.garment = {std::shared_ptr<const Garment>(), &source.garment()};
    derived.results = source.results();
    derived.lines = source.lines();
    Progress progress;
    draw(derived, progress);
    DocumentState state;
    state.lines = source.lines();
    state.fabric = source.fabric();
    state.materials = source.laid().pattern.materials;
    const LaidOutPattern& laid = source.laid();
    for (const PlacedCopy& copy : laid.whole.copies) {
        const PatternPiece& piece = laid.wholePattern.pieces[static_cast<std::size_t>(copy.piece)];
        PieceSettings& said = state.settings[piece.id];
        static_cast<Cutting&>(said) = piece;
        said.placement = copy.placement;
        state.labels[piece.id].name = piece.name;
    }
    document.open(std::move(state), std::move(derived));
}

/// Returns an empty array if drawing fails.
QByteArray drawnAsPng(const Document& document, const PictureOptions& options) {
    QString problem;
    const QImage picture = drawViews(document, options, problem);
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    return !picture.isNull() && picture.save(&buffer, "PNG") ? png : QByteArray();
}

/// Calls `draw` with the source's document; does nothing without OpenGL.
void drawWith(const ExportSource& source, const std::function<void(Document&)>& draw) {
    makeApplication();
    const auto context = makeEglContext();
    if (context && hasGl()) {
        Document document;
        openIn(document, source);
        draw(document);
    }
}

PictureOptions optionsOf(const Document& document, QSize size, bool isDark = false) {
    PictureOptions options;
    options.size = size;
    options.legend = isMeasured(document.view().overlay);
    options.font = QFont("Sans Serif", 9);
    options.palette = isDark ? darkPalette() : lightPalette();
    return options;
}

}  // namespace

std::vector<ReportPicture> reportPictures(const ExportSource& source) {
    std::vector<ReportPicture> pictures;
    drawWith(source, [&pictures](Document& document) {
        for (const OverlayTraits& known : kOverlays) {
            if (!known.reportCaption) {
                continue;
            }
            document.setOverlay(known.overlay);
            const QByteArray png = drawnAsPng(document, optionsOf(document, kPictureSize));
            if (png.isEmpty()) {
                return pictures.clear();
            }
            pictures.push_back({known.reportCaption, png.toBase64().toStdString()});
        }
    });
    return pictures;
}

std::string proofPicture(const ExportSource& source, const std::shared_ptr<const Proof>& proof,
                         const ProofPicture& wanted) {
    std::string picture;
    drawWith(source, [&](Document& document) {
        document.setOverlay(wanted.overlay);
        showProof(document, proof);
        PictureOptions options =
            optionsOf(document, QSize(wanted.width, wanted.height), wanted.dark);
        options.views = wanted.views;
        options.direction = wanted.direction;
        options.sewn = wanted.sewn;
        picture = drawnAsPng(document, options).toStdString();
    });
    return picture;
}

}  // namespace toile::app
