// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>
#include <string>

#include "app/document/document_change.h"
#include "core/base/error.h"

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
    /// Index of the piece of that name, or -1.
    int pieceNamed(const std::string& name) const;
    void add(const Error& problem, int piece);

    Document& document_;
};

}  // namespace toile
