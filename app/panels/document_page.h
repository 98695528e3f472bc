// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QTextBrowser;

namespace toile::app {

/// A page of the documentation, with its pictures, and the others by its links. Stays open beside
/// the work.
class DocumentPage : public QDialog {
    Q_OBJECT

public:
    explicit DocumentPage(QWidget* parent);

    /// @param path  a file in Markdown
    void read(const QString& path);

private:
    QTextBrowser* text_;
};

}  // namespace toile::app
