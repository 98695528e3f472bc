// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "app/document/line_facts.h"

class QGridLayout;
class QWidget;

namespace toile::app {

class Document;
class FieldGuard;
class LengthEdit;

/// The rows of the form of a segment that are about strips along it: by how much a free edge is
/// drawn out, and how wide its facing is; 0: there is none. Says what is to be said of it and of
/// its mirror image.
class StripRows : public QObject {
    Q_OBJECT

public:
    StripRows(Document& document, FieldGuard& guard, QWidget* form);

    /// @return the next free row
    int addTo(QGridLayout& grid, int row);
    /// @param facts  of the document's garment as it is shown; stay until the next call
    void show(const LineFacts& facts, const SegmentAt& at);
    /// Shows that there is nothing.
    void clear();

signals:
    /// A decision about a segment. @param gesture  as for Document::edit
    void wanted(const toile::LineSettings& lines, const QString& text, int gesture);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::vector<SegmentAt> segments() const;
    void setExtension(std::optional<double> width);
    void setFacing(std::optional<double> width);
    void say(const LineSettings& lines, const QString& text);

    Document& document_;
    LengthEdit *extension_, *facing_;
    const LineFacts* facts_ = nullptr;  ///< null where no segment is shown
    SegmentAt at_{};
    int gesture_ = -1;
};

}  // namespace toile::app
