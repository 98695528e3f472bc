// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "app/widgets/setting_fields.h"
#include "core/marker/marker_settings.h"

class QComboBox;
class QListWidget;

namespace toile::app {

class MarkerDesk;

/// The settings of the cloth and of the placement rules. Each change is one undo step.
class MarkerForm : public QWidget {
    Q_OBJECT

public:
    /// `desk` must outlive this.
    explicit MarkerForm(MarkerDesk& desk, QWidget* parent = nullptr);

    /// Shows the document's settings again, after a cancelled choice.
    void showAgain();

signals:
    /// The user wants to select hides.
    void hidesWanted();

private:
    void addCloth(QGridLayout& grid);
    void addPieces(QGridLayout& grid);
    void addStripes(QGridLayout& grid);
    void addHeading(QGridLayout& grid, const QString& text);
    void addChoice(QGridLayout& grid, QComboBox& field, const char* name, const QString& title,
                   const QString& tip);
    void take(const SettingChange& change);
    void chooseKind(int kind);
    void match(const std::string& seam, bool isMatched);
    /// Updates only changed settings, so that a better marker does not disturb typing.
    void refresh();
    void showMaterials();
    void showSeams();
    std::vector<std::string> seamNames() const;

    /// The values shown in the fields.
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
    SettingFields fields_;
    QComboBox *material_, *kind_;
    QListWidget* matched_;
    QLabel* matchedTitle_;
    std::optional<Shown> shown_{};
};

}  // namespace toile::app
