// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

#include "app/actions/help_table.h"

class QLineEdit;
class QTextBrowser;

namespace toile::app {

/// Shows a page of the documentation with its pictures, and follows links to other pages. Modeless.
class DocumentPage : public QDialog {
    Q_OBJECT

public:
    explicit DocumentPage(QWidget* parent);

    /// @param path  a Markdown file
    void read(const QString& path);

private:
    QTextBrowser* text_;
};

/// "Keyboard and mouse": every key and gesture by group, with a search field. Modeless.
class HelpPage : public QDialog {
    Q_OBJECT

public:
    HelpPage(std::vector<HelpGroup> groups, QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;

private:
    void updateText();

    std::vector<HelpGroup> groups_;
    QLineEdit* line_;
    QTextBrowser* text_;
};

}  // namespace toile::app
