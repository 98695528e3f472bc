// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/help_pages.h"

#include <QDialogButtonBox>
#include <QEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

namespace toile::app {
namespace {

/// Fainter than text. Mixed without alpha, which rich text does not support.
QString faintColour(const QPalette& palette) {
    const QColor ink = palette.color(QPalette::Text), paper = palette.color(QPalette::Base);
    constexpr double kInk = 0.66;
    const auto mixed = [](int of, int with) { return qRound(kInk * of + (1 - kInk) * with); };
    return QColor(mixed(ink.red(), paper.red()), mixed(ink.green(), paper.green()),
                  mixed(ink.blue(), paper.blue()))
        .name();
}

bool fits(const HelpRow& row, const QString& typed) {
    return row.keys.contains(typed, Qt::CaseInsensitive) ||
           row.title.contains(typed, Qt::CaseInsensitive) ||
           row.tip.contains(typed, Qt::CaseInsensitive);
}

QString htmlRow(const HelpRow& row, const QString& faint) {
    const QString tip =
        row.tip.isEmpty()
            ? QString()
            : QString("<br><span style='color:%1'>%2</span>").arg(faint, row.tip.toHtmlEscaped());
    return QString(
               "<tr><td width='190' style='padding:3px 14px 3px 0'><b>%1</b></td>"
               "<td style='padding:3px 0'>%2%3</td></tr>")
        .arg(row.keys.toHtmlEscaped(), row.title.toHtmlEscaped(), tip);
}

}  // namespace

DocumentPage::DocumentPage(QWidget* parent) : QDialog(parent), text_(new QTextBrowser(this)) {
    setObjectName("documentPage");
    setWindowTitle(tr("Documentation"));
    resize(760, 720);
    text_->setOpenExternalLinks(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* back = buttons->addButton(tr("&Back"), QDialogButtonBox::ActionRole);
    back->setEnabled(false);
    connect(back, &QPushButton::clicked, text_, &QTextBrowser::backward);
    connect(text_, &QTextBrowser::backwardAvailable, back, &QPushButton::setEnabled);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(text_, 1);
    layout->addWidget(buttons);
}

void DocumentPage::read(const QString& path) {
    text_->setSource(QUrl::fromLocalFile(path), QTextDocument::MarkdownResource);
}

HelpPage::HelpPage(std::vector<HelpGroup> groups, QWidget* parent)
    : QDialog(parent),
      groups_(std::move(groups)),
      line_(new QLineEdit(this)),
      text_(new QTextBrowser(this)) {
    setObjectName("helpPage");
    setWindowTitle(tr("Keyboard and mouse"));
    line_->setObjectName("helpLine");
    line_->setPlaceholderText(tr("Search for a key or a command"));
    line_->setAccessibleName(tr("Search"));
    line_->setClearButtonEnabled(true);
    text_->setObjectName("helpText");
    text_->setFrameShape(QFrame::NoFrame);
    text_->document()->setDocumentMargin(14);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(line_);
    layout->addWidget(text_, 1);
    connect(line_, &QLineEdit::textChanged, this, &HelpPage::updateText);
    resize(620, 720);
    updateText();
}

void HelpPage::updateText() {
    const QString faint = faintColour(palette());
    const QString typed = line_->text().trimmed();
    QString html;
    for (const HelpGroup& group : groups_) {
        QString rows;
        for (const HelpRow& row : group.rows) {
            if (fits(row, typed)) {
                rows += htmlRow(row, faint);
            }
        }
        if (!rows.isEmpty()) {
            html += QString("<h3 style='margin-top:14px'>%1</h3><table width='100%'>%2</table>")
                        .arg(group.title.toHtmlEscaped(), rows);
        }
    }
    text_->setHtml(html.isEmpty() ? QString("<p>%1</p>").arg(tr("No matches")) : html);
}

void HelpPage::changeEvent(QEvent* event) {
    QDialog::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        updateText();  // the HTML contains the old colours
    }
}

}  // namespace toile::app
