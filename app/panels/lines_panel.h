// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/document/line_facts.h"
#include "app/widgets/setting_fields.h"

class QLabel;

namespace toile::app {

class Document;
class DocumentChange;
class SeamEndsList;

/// How the lines of the pattern are drawn: fair or exact, trued at seam ends, with seam allowances
/// and notches. Kinks are computed only while the panel is visible.
class LinesPanel : public QWidget {
    Q_OBJECT

public:
    /// The document must outlive the panel.
    explicit LinesPanel(Document& document, QWidget* parent = nullptr);

    /// The field that takes the keyboard focus.
    QWidget& firstField() const;

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeSettings();
    QWidget* makeAdditions();
    void onOpened();
    void onChanged(const DocumentChange& what);
    void refresh();
    void showSettings();
    void showStraying();
    void take(const SettingChange& change);

    Document& document_;
    SettingFields fields_;
    QLabel* straying_;
    SeamEndsList* ends_;
    LineFacts facts_;
    NotchRules notches_{};  ///< last rules in use; restored with the user's notches
    bool isStale_ = true;
};

}  // namespace toile::app
