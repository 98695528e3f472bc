// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/pattern_printing.h"

#include <QCoreApplication>
#include <QPointer>
#include <QPrinter>
#include <QWidget>
#include <memory>
#include <utility>

#include "app/actions/file_dialogs.h"
#include "app/document/document.h"
#include "app/document/layout.h"
#include "app/export/print_dialog.h"
#include "app/session/workspace.h"
#include "app/settings/preferences.h"

namespace toile::app {

namespace {

QString sizeText(const QSizeF& size) {
    return QString("%1 x %2 mm").arg(qRound(size.width())).arg(qRound(size.height()));
}

QString lackText(const RoomLacking& lack) {
    return lack.isMargin
               ? PatternPrinting::tr(
                     "The printer's margins are wider than the pattern's, so lines at the edges "
                     "would be missing. Choose another page: the one that fits A4 and Letter has "
                     "the widest margins.")
               : PatternPrinting::tr(
                     "The printer's page is %1, but the pattern's pages are %2 and cannot be "
                     "scaled down. Choose another page here or larger paper for the printer.")
                     .arg(sizeText(lack.page), sizeText(lack.paper));
}

QString nameOf(const QPrinter& printer) {
    return printer.outputFileName().isEmpty() ? printer.printerName() : printer.outputFileName();
}

}  // namespace

PatternPrinting::PatternPrinting(Workspace& workspace, Preferences& preferences,
                                 const FileDialogs& dialogs, QWidget& window, QObject* parent)
    : QObject(parent),
      workspace_(workspace),
      preferences_(preferences),
      dialogs_(dialogs),
      window_(window) {}

void PatternPrinting::ask() {
    auto* dialog = new PrintDialog(preferences_.exportOptions(), dialogs_.hasPrinter(), &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const std::vector<int> flat = selectedFlat(workspace_.document());
    dialog->offerSelected(static_cast<int>(flat.size()));
    showPattern(*dialog, {});
    connect(dialog, &PrintDialog::piecesChanged, this,
            [this, dialog, selected = Document::Selection(flat.begin(), flat.end())] {
                showPattern(*dialog, dialog->isSelectedOnly() ? selected : Document::Selection{});
            });
    connect(dialog, &QDialog::finished, this, [this] { workspace_.writing().drop(drawing_); });
    connect(dialog, &PrintDialog::printWanted, this, [this, dialog] { printFrom(*dialog); });
    connect(dialog, &PrintDialog::fileWanted, this, [this, dialog] {
        preferences_.setExportOptions(dialog->options());
        const bool onlySelected = dialog->isSelectedOnly();
        dialog->accept();
        emit fileWanted(onlySelected);
    });
    dialog->open();
}

/// Draws and paints the pattern in jobs, because both take time, and then shows it.
void PatternPrinting::showPattern(PrintDialog& dialog, const std::set<int>& only) {
    using Made = std::shared_ptr<const InkedPattern>;
    const QPointer asked(&dialog);
    const auto show = [asked](Made made) {
        if (asked) {
            asked->setPattern(std::move(made));
        }
    };
    workspace_.writing().drop(drawing_);
    drawing_ = workspace_.drawPattern(
        [this, asked, show](const std::shared_ptr<const DrawnPattern>& drawn) {
            if (asked) {
                drawing_ = workspace_.writing().start(makeJob(
                    QCoreApplication::translate("ExportJob", "Drawing the pattern"),
                    [drawn](Progress&) { return Result<Made>(inked(drawn)); }, show));
            }
        },
        only);
}

void PatternPrinting::printFrom(PrintDialog& dialog) {
    const std::shared_ptr<const PrintedPattern> sheets = dialog.sheets();
    const auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
    printer->setDocName(sheets->title());
    printer->setDuplex(QPrinter::DuplexNone);  // tiles are joined side by side
    printer->setFullPage(true);
    if (dialog.options().pdf.paper != Paper::Shared) {  // Shared is centred on the printer's paper
        choosePaper(*printer, sheets->paper(sheets->count() - 1));
    }
    if (!dialogs_.choosePrinter(&dialog, *printer, sheets->count())) {
        return;
    }
    printer->setFullPage(true);  // ignore margins from the printer dialog
    if (const auto lack = roomLacking(*printer, *sheets)) {
        dialog.say(lackText(*lack));
        return;
    }
    preferences_.setExportOptions(dialog.options());
    dialog.accept();
    workspace_.writing().start(makeJob(
        tr("Printing the pattern"),
        [printer, sheets](Progress& progress) { return print(*printer, *sheets, progress); },
        [this, name = nameOf(*printer)](bool isTaken) {
            if (isTaken) {
                emit printed(tr("Printed: %1").arg(name));
            } else {
                emit failed(tr("%1 does not accept the print job. Check that it is switched on, or "
                               "print a PDF file from another program.")
                                .arg(name));
            }
        }));
}

}  // namespace toile::app
