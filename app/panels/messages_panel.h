// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>

#include "app/document/document_change.h"

namespace toile {

class Document;

/// What reading and flattening had to say, one sentence each. A message about a piece selects it.
class MessagesPanel : public QListWidget {
    Q_OBJECT

public:
    explicit MessagesPanel(Document& document, QWidget* parent = nullptr);

signals:
    /// Number of messages, for the dock's title.
    void countChanged(int count);

private:
    void onChanged(DocumentChanges what);
    void rebuild();
    void add(const QString& sentence, bool serious, int piece);

    Document& document_;
};

}  // namespace toile
