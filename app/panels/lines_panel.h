// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/document/line_facts.h"
#include "app/widgets/setting_fields.h"

class QLabel;

namespace toile::app {

class DartForm;
class Document;
class DocumentChange;
class SeamEndsList;
class SegmentForm;

/// How the lines of the pattern are drawn: fair or exact, true at the ends of seams, with seam
/// allowances and notches, and what is said of the selected dart and segment. Works out segments
/// and kinks only while it is seen.
class LinesPanel : public QWidget {
    Q_OBJECT

public:
    /// The document must outlive the panel.
    explicit LinesPanel(Document& document, QWidget* parent = nullptr);

    /// Where the keyboard goes.
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
    void showSelected();
    void take(const SettingChange& change);

    Document& document_;
    SettingFields fields_;
    QLabel* straying_;
    SeamEndsList* ends_;
    DartForm* dart_;
    SegmentForm* segment_;
    LineFacts facts_;
    NotchRules notches_{};  ///< the last ones: notches that the user placed return with them
    bool isStale_ = true;
};

}  // namespace toile::app
