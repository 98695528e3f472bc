// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/marker/marker_settings.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QListWidget;

namespace toile::app {

class AngleEdit;
class FieldGuard;
class LengthEdit;
class MarkerDesk;

/// What is said of the cloth and of how the pieces may lie on it: one step of the history each, or
/// one for as long as a field is typed in.
class MarkerForm : public QWidget {
    Q_OBJECT

public:
    /// `desk` must outlive this.
    explicit MarkerForm(MarkerDesk& desk, QWidget* parent = nullptr);

    bool eventFilter(QObject* watched, QEvent* event) override;
    /// What the document says, whatever was chosen and came to nothing.
    void showAgain();

signals:
    /// Hides are to be laid on: they are to be chosen.
    void hidesWanted();

private:
    using Change = std::function<void(MarkerSettings&)>;

    void addCloth(QGridLayout& grid);
    void addPieces(QGridLayout& grid);
    void addStripes(QGridLayout& grid);
    LengthEdit* addLength(QGridLayout& grid, const char* name, const QString& title,
                          const QString& tip, double least, double most,
                          std::function<void(MarkerSettings&, double)> set);
    void addRow(QGridLayout& grid, const char* name, const QString& title, const QString& tip,
                QWidget& field);
    void addHeading(QGridLayout& grid, const QString& text);
    void change(const QString& text, const Change& change, bool isTyped = false);
    void chooseKind(int kind);
    void match(const std::string& seam, bool isMatched);
    /// What is typed and not taken yet is not touched by a marker that gets better.
    void refresh();
    void showMaterials();
    void showSeams();
    std::vector<std::string> seamNames() const;

    /// What the fields show.
    struct Shown {
        MarkerSettings settings{};
        std::vector<std::string> materials{};
        std::string material{};
        double width = 0;  ///< of the fabric
        std::vector<std::string> seams{};
        bool isOpen = false;

        bool operator==(const Shown&) const = default;
    };

    MarkerDesk& desk_;
    FieldGuard& guard_;
    QComboBox *material_, *kind_, *turns_;
    LengthEdit *width_ = nullptr, *along_ = nullptr, *across_ = nullptr;
    LengthEdit *gap_ = nullptr, *border_ = nullptr;
    LengthEdit *warp_ = nullptr, *weft_ = nullptr;
    QListWidget* matched_;
    QLabel* matchedTitle_ = nullptr;
    AngleEdit* tolerance_;
    QCheckBox* folded_;
    QDoubleSpinBox* garments_;
    int gesture_ = -1;
    std::optional<Shown> shown_;
};

}  // namespace toile::app
