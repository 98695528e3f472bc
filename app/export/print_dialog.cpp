// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/print_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <utility>

#include "app/export/option_form.h"
#include "app/export/sheet_preview.h"
#include "app/text/error_text.h"

namespace toile::app {

namespace {

constexpr int kChoicesWidth = 250;

/// Replaces the projector's page, which is no paper size.
ExportOptions onPaper(ExportOptions options) {
    if (options.pdf.paper == Paper::Projector) {
        options.pdf.paper = PdfOptions{}.paper;
    }
    return options;
}

}  // namespace

PrintDialog::PrintDialog(const ExportOptions& options, bool hasPrinter, QWidget* parent)
    : QDialog(parent),
      hasPrinter_(hasPrinter),
      pieces_(new PieceChoice(this)),
      form_(new OptionForm(this)),
      preview_(new SheetPreview(this)),
      summary_(new QLabel(this)),
      note_(new QLabel(this)) {
    setObjectName("printDialog");
    setWindowTitle(tr("Print pattern"));
    pieces_->setObjectName("printPieces");
    connect(pieces_, &PieceChoice::chosen, this, [this] {
        setPattern(nullptr);
        emit piecesChanged();
    });
    preview_->setObjectName("printPreview");
    summary_->setObjectName("printSummary");
    summary_->setWordWrap(true);
    note_->setObjectName("printNote");
    note_->setWordWrap(true);

    auto* side = new QWidget(this);
    side->setFixedWidth(kChoicesWidth);
    auto* choices = new QVBoxLayout(side);
    choices->setContentsMargins(0, 0, 0, 0);
    choices->addWidget(pieces_);
    choices->addWidget(form_);
    choices->addSpacing(6);
    choices->addWidget(summary_);
    choices->addSpacing(6);
    choices->addWidget(note_);
    choices->addStretch();
    auto* row = new QHBoxLayout;
    row->setSpacing(14);
    row->addWidget(side);
    row->addWidget(makePages(), 1);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    auto* file = buttons->addButton(tr("&Export as PDF…"), QDialogButtonBox::ActionRole);
    file->setObjectName("printToFile");
    file->setAutoDefault(false);
    print_ = buttons->addButton(tr("&Print…"), QDialogButtonBox::ActionRole);
    print_->setObjectName("printNow");
    print_->setDefault(true);
    connect(file, &QPushButton::clicked, this, &PrintDialog::fileWanted);
    connect(print_, &QPushButton::clicked, this, &PrintDialog::printWanted);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(12);
    layout->addLayout(row, 1);
    layout->addWidget(buttons);

    form_->show(FormatId::Pdf, onPaper(options));
    connect(form_, &OptionForm::optionsChanged, this, &PrintDialog::layOut);
    layOut();
}

/// Makes the preview and the sheet selector.
QWidget* PrintDialog::makePages() {
    auto* pages = new QWidget(this);
    auto* column = new QVBoxLayout(pages);
    column->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(tr("P&age:"), pages);
    page_ = new QSpinBox(pages);
    page_->setObjectName("printPage");
    page_->setAccessibleName(tr("Page"));
    page_->setRange(1, 1);
    label->setBuddy(page_);
    connect(page_, &QSpinBox::valueChanged, this,
            [this](int page) { preview_->setSheet(page - 1); });
    auto* row = new QHBoxLayout;
    row->addStretch();
    row->addWidget(label);
    row->addWidget(page_);
    row->addStretch();
    column->addWidget(preview_, 1);
    column->addLayout(row);
    return pages;
}

void PrintDialog::layOut() {
    sheets_.reset();
    summary_->setText(pattern_ ? QString() : tr("Drawing the pattern…"));
    note_->setText(hasPrinter_ ? QString()
                               : tr("No printer is set up on this computer. Export the pattern as "
                                    "PDF and print it elsewhere."));
    if (options().pdf.paper == Paper::Projector) {
        summary_->setText(tr("A projector needs a file. Export the page as PDF."));
    } else if (pattern_) {
        Result<PrintedPattern> made = PrintedPattern::on(pattern_, options().pdf);
        if (made) {
            sheets_ = std::make_shared<const PrintedPattern>(std::move(made).value());
            const int count = sheets_->count();
            const QSizeF paper = sheets_->paper(count - 1);
            summary_->setText(tr("%1 of %2 x %3 mm, at true scale")
                                  .arg(count == 1 ? tr("1 page") : tr("%n pages", nullptr, count))
                                  .arg(qRound(paper.width()))
                                  .arg(qRound(paper.height())));
        } else {
            summary_->setText(errorDescription(made.error()));
        }
    }
    print_->setEnabled(hasPrinter_ && sheets_);
    page_->setEnabled(sheets_ != nullptr);
    page_->setRange(1, sheets_ ? sheets_->count() : 1);
    page_->setSuffix(sheets_ ? tr(" of %1").arg(sheets_->count()) : QString());
    preview_->setPattern(sheets_);
}

void PrintDialog::setPattern(std::shared_ptr<const InkedPattern> pattern) {
    pattern_ = std::move(pattern);
    layOut();
}

void PrintDialog::offerSelected(int count) {
    pieces_->offer(count, false);
}

bool PrintDialog::isSelectedOnly() const {
    return pieces_->isSelectedOnly();
}

const ExportOptions& PrintDialog::options() const {
    return form_->options();
}

void PrintDialog::say(const QString& sentence) {
    note_->setText(sentence);
}

}  // namespace toile::app
