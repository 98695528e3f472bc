// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/document/document_change.h"

class QLabel;
class QTreeWidget;

namespace toile {

class Document;

/// The cuts that were made before flattening: what was cut, by whom, how long. Hides itself where
/// there are none.
class CutsPanel : public QWidget {
    Q_OBJECT

public:
    explicit CutsPanel(const Document& document, QWidget* parent = nullptr);

private:
    void onChanged(DocumentChanges what);
    void rebuild();

    const Document& document_;
    QLabel* count_;
    QTreeWidget* table_;
};

}  // namespace toile
