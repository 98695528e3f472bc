// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

#include "app/actions/help_table.h"

class QLineEdit;
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

/// "Keyboard and mouse": every key and gesture by group, with a line to look for one. Stays open
/// beside the work.
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
