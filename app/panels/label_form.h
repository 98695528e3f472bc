// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/pattern/line_settings.h"

class QLineEdit;

namespace toile::app {

class Document;

/// What stands on the labels of all pieces: size and date. Says what is to be said.
class LabelForm : public QWidget {
    Q_OBJECT

public:
    explicit LabelForm(Document& document, QWidget* parent = nullptr);

    /// Shows what the document says now.
    void refresh();

signals:
    /// @param gesture  as for Document::edit
    void wanted(const toile::LineSettings& lines, const QString& text, int gesture);

private:
    void take(std::string LabelTexts::*field, const QString& typed, const QString& text);

    Document& document_;
    QLineEdit *size_, *date_;
};

}  // namespace toile::app
