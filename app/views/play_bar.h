// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

class QLabel;
class QSlider;
class QToolButton;
class QVariantAnimation;

namespace toile::app {

/// A bar at the bottom of a view with a slider between two states and a button that plays the
/// animation. Derived bars describe the current position and do the layout.
class PlayBar : public QWidget {
    Q_OBJECT

public:
    /// Plays to the other end; a second call stops. Does nothing while hidden.
    void play();
    /// Stops and returns to the beginning.
    void rewind();
    /// Position in [0, 1].
    double share() const;

signals:
    /// The position has changed.
    void moved(double share);

protected:
    /// Logical pixels: minimum distance from the view's left edge, width, distance from the bottom.
    struct Room {
        int left = 12, width = 300, foot = 12;
    };

    /// @param view  parent and owner
    /// @param name  "morph" names the bar "morphBar", with "morphSlider" and "morphPlay"
    PlayBar(QWidget& view, const QString& name, int milliseconds, Room room);

    /// Share of one slider step.
    static double step();
    /// Sets positions at which slider steps stop and to which drags snap.
    void setStops(const std::vector<double>& shares);
    /// Stops the animation.
    void stop();
    /// Centres the bar at the bottom of the view, as far as there is room.
    void place();
    QSlider& slider() { return *slider_; }
    QToolButton& button() { return *button_; }
    /// Makes a label in a small font.
    QLabel* makeLabel(const QString& text);

    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    /// Runs before the slider takes its new value.
    void stopOnTheWay(int action);

    QWidget& view_;
    int milliseconds_;  ///< for the full range
    Room room_;
    QSlider* slider_;
    QToolButton* button_;
    QVariantAnimation* animation_;
    std::vector<int> stops_;  ///< slider values
};

}  // namespace toile::app
