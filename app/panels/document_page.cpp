// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/document_page.h"

#include <QDialogButtonBox>
#include <QPushButton>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

namespace toile::app {

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

}  // namespace toile::app
