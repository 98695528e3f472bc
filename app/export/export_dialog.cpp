// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/base/text.h"
#include "app/export/drawing_preview.h"
#include "app/export/option_form.h"
#include "app/text/error_text.h"
#include "core/formats/drawing/drawing.h"
#include "core/formats/pdf/pdf_writer.h"

namespace toile::app {

namespace {

constexpr int kListWidth = 170, kFormWidth = 250;

/// Whether the preview shows the file's text instead of a page.
bool isText(FormatId format) {
    constexpr FormatId kTexts[] = {FormatId::Obj, FormatId::Usd, FormatId::GarmentCode,
                                   FormatId::Csv, FormatId::Report};
    return std::ranges::find(kTexts, format) != std::end(kTexts);
}

/// Removes a known file extension.
QString withoutEnding(const QString& path) {
    const Format* known = formatOf(pathOf(path));
    if (!known) {
        return path;
    }
    QString shorter = path;
    qsizetype longest = 0;
    for (const char* ending : known->endings) {
        const QString text = QString::fromLatin1(ending);
        if (path.endsWith(text, Qt::CaseInsensitive)) {
            longest = std::max(longest, text.size());
        }
    }
    shorter.chop(longest);
    return shorter;
}

QString usualEnding(const Format& format) {
    return QString::fromLatin1(format.endings.front());
}

/// The areas of the drawing on each page, y down from its upper left corner.
QVector<QRectF> sheetsOf(const PdfPlan& plan, double height) {
    QVector<QRectF> sheets;
    for (const PdfPage& page : plan.pages) {
        const auto back = [&plan](const Eigen::Vector2d& at) {
            return plan.turned ? Eigen::Vector2d(at.y(), -at.x()) : at;
        };
        const Eigen::Vector2d a = back(page.frame.min()), b = back(page.frame.max());
        sheets
            << QRectF(QPointF(a.x(), height - a.y()), QPointF(b.x(), height - b.y())).normalized();
    }
    return sheets;
}

}  // namespace

ExportDialog::ExportDialog(const QString& path, const QString& format, const ExportOptions& options,
                           ExportQuestions questions, QWidget* parent)
    : QDialog(parent),
      questions_(std::move(questions)),
      list_(new QListWidget(this)),
      form_(new OptionForm(this)),
      shown_(new QStackedWidget(this)),
      preview_(new DrawingPreview(this)),
      text_(new QPlainTextEdit(this)),
      use_(new QLabel(this)),
      page_(new QLabel(this)),
      notes_(new QLabel(this)),
      pieces_(new PieceChoice(this)) {
    setObjectName("exportDialog");
    setWindowTitle(tr("Export pattern"));
    list_->setObjectName("exportFormats");
    list_->setAccessibleName(tr("Format"));
    list_->setFixedWidth(kListWidth);
    use_->setWordWrap(true);
    use_->setObjectName("exportUse");
    page_->setObjectName("exportPage");
    page_->setWordWrap(true);
    notes_->setObjectName("exportNotes");
    notes_->setWordWrap(true);
    notes_->hide();
    preview_->setObjectName("exportPreview");
    text_->setObjectName("exportText");
    text_->setAccessibleName(tr("Start of the file"));
    text_->setReadOnly(true);
    text_->setLineWrapMode(QPlainTextEdit::NoWrap);
    text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    shown_->addWidget(preview_);
    shown_->addWidget(text_);

    pieces_->setObjectName("exportPieces");
    connect(pieces_, &PieceChoice::chosen, this, [this] {
        emit piecesChanged();
        showFile();
    });
    auto* choices = new QVBoxLayout;
    choices->addWidget(pieces_);
    choices->addWidget(use_);
    choices->addSpacing(6);
    choices->addWidget(form_);
    choices->addStretch();
    auto* side = new QWidget(this);
    side->setLayout(choices);
    side->setFixedWidth(kFormWidth);
    choices->setContentsMargins(0, 0, 0, 0);
    auto* page = new QVBoxLayout;
    page->addWidget(shown_, 1);
    page->addWidget(page_);
    page->addWidget(notes_);
    auto* row = new QHBoxLayout;
    row->setSpacing(14);
    row->addWidget(list_);
    row->addWidget(side);
    row->addLayout(page, 1);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    export_ = buttons->addButton(tr("&Export"), QDialogButtonBox::AcceptRole);
    export_->setObjectName("exportNow");
    export_->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(12);
    layout->addLayout(row, 1);
    layout->addWidget(makeTarget());
    layout->addWidget(buttons);

    fillFormats();
    form_->show(FormatId::Svg, options);
    path_->setText(path);
    connect(list_, &QListWidget::currentRowChanged, this, &ExportDialog::onFormat);
    connect(form_, &OptionForm::optionsChanged, this, &ExportDialog::describe);
    const auto wanted = std::ranges::find_if(
        formats_, [&](const Format* known) { return usualEnding(*known) == format; });
    list_->setCurrentRow(wanted == formats_.end() ? 0
                                                  : static_cast<int>(wanted - formats_.begin()));
    list_->setFocus();
}

QWidget* ExportDialog::makeTarget() {
    auto* target = new QWidget(this);
    auto* row = new QHBoxLayout(target);
    row->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(tr("&File:"), target);
    path_ = new QLineEdit(target);
    path_->setObjectName("exportPath");
    path_->setAccessibleName(tr("File"));
    label->setBuddy(path_);
    connect(path_, &QLineEdit::editingFinished, this, &ExportDialog::onPathEdited);
    auto* other = new QPushButton(tr("&Browse…"), target);
    other->setObjectName("exportBrowse");
    other->setAutoDefault(false);
    connect(other, &QPushButton::clicked, this, &ExportDialog::browse);
    folder_ = new QCheckBox(tr("&Show in folder"), target);
    folder_->setObjectName("exportShowFolder");
    folder_->setToolTip(tr("Show the folder after writing the file."));
    row->addWidget(label);
    row->addWidget(path_, 1);
    row->addWidget(other);
    row->addWidget(folder_);
    return target;
}

void ExportDialog::fillFormats() {
    for (const Format& known : formats()) {
        if (known.write) {
            formats_.push_back(&known);
            auto* item = new QListWidgetItem(app::tr(known.name), list_);
            item->setToolTip(usualEnding(known));
        }
    }
}

const Format& ExportDialog::format() const {
    return *formats_[static_cast<std::size_t>(std::max(0, list_->currentRow()))];
}

void ExportDialog::onFormat() {
    form_->show(format().id, form_->options());
    path_->setText(withoutEnding(path_->text()) + usualEnding(format()));
    describe();
}

/// The typed extension may select another format.
void ExportDialog::onPathEdited() {
    const Format* typed = formatOf(pathOf(path_->text()));
    const auto row = std::ranges::find(formats_, typed);
    if (row == formats_.end()) {
        path_->setText(path_->text() + usualEnding(format()));
    } else if (*row != &format()) {
        const QString path = path_->text();
        list_->setCurrentRow(static_cast<int>(row - formats_.begin()));
        path_->setText(path);
    }
}

void ExportDialog::browse() {
    const QString filter = QString("%1 (*%2)").arg(app::tr(format().name), usualEnding(format()));
    if (const QString path = questions_.save(this, path_->text(), filter); !path.isEmpty()) {
        path_->setText(path);
        onPathEdited();
        browsed_ = path_->text() == path ? path : QString();
    }
}

/// Shows the page, or the start of a text file.
void ExportDialog::showFile() {
    if (!isText(format().id)) {
        shown_->setCurrentWidget(preview_);
        return;
    }
    shown_->setCurrentWidget(text_);
    text_->clear();
    emit textWanted(format().id, form_->options());
}

void ExportDialog::setText(FormatId format, const QString& text) {
    if (format == this->format().id) {
        text_->setPlainText(text);
    }
}

void ExportDialog::describe() {
    showFile();
    use_->setText(tr("For %1.").arg(app::tr(format().use)));
    if (!drawing_) {
        page_->clear();
        return;
    }
    const auto pieces = static_cast<int>(drawing_->blocks.size());
    QString said = tr("%1 x %2 mm, %3")
                       .arg(drawing_->width)
                       .arg(drawing_->height)
                       .arg(pieces == 1 ? tr("1 piece") : tr("%n pieces", nullptr, pieces));
    QVector<QRectF> sheets;
    if (format().id == FormatId::Pdf) {
        const Result<PdfPlan> plan = planPdf(*drawing_, form_->options().pdf);
        if (plan) {
            sheets = sheetsOf(*plan, drawing_->height);
            const auto pages = static_cast<int>(plan->pages.size());
            said += ", " + (pages == 1 ? tr("1 page") : tr("%n pages", nullptr, pages));
        } else {
            said += "; " + errorDescription(plan.error());
        }
    }
    preview_->setSheets(sheets);
    page_->setText(said);
}

void ExportDialog::offerSelected(int count, bool chosen) {
    pieces_->offer(count, chosen);
}

void ExportDialog::setPattern(const std::shared_ptr<const DrawnPattern>& pattern) {
    drawing_ = {pattern, &pattern->drawing};
    preview_->setDrawing(drawing_);
    QStringList said;
    for (const auto& notes :
         {overlapNotes(pattern->pattern, *drawing_), grainNotes(pattern->pattern, *drawing_)}) {
        for (const Wording& note : notes) {
            said << wordingText(note);
        }
    }
    notes_->setText(said.join('\n'));
    notes_->setVisible(!said.isEmpty());
    describe();
}

ExportChoice ExportDialog::choice() const {
    return {path_->text(), usualEnding(format()), form_->options(), folder_->isChecked(),
            pieces_->isSelectedOnly()};
}

void ExportDialog::accept() {
    onPathEdited();
    const QString path = path_->text();
    const bool isAsked = path == browsed_;  // the file dialog has asked
    if (isAsked || !QFileInfo::exists(path) || questions_.mayReplace(this, path)) {
        QDialog::accept();
    }
}

}  // namespace toile::app
