// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

class QLabel;
class QSlider;
class QToolButton;
class QVariantAnimation;

namespace toile::app {

/// A bar at the foot of a view that shows a way from one end to the other: a slider, and a button
/// that plays it. Derived bars say what is at a place of the way, and lay out the rest.
class PlayBar : public QWidget {
    Q_OBJECT

public:
    /// Goes to the other end of the way by itself; called again, it stops. Nothing while hidden.
    void play();
    /// To the beginning, and stops.
    void rewind();
    /// Of the whole way, in [0, 1].
    double share() const;

signals:
    /// The share is another.
    void moved(double share);

protected:
    /// Logical pixels: at least so far from the view's left edge, so wide, so far above its foot.
    struct Room {
        int left = 12, width = 300, foot = 12;
    };

    /// @param view  where it lies; owns it
    /// @param name  "morph": of the bar "morphBar", its "morphSlider" and "morphPlay"
    PlayBar(QWidget& view, const QString& name, int milliseconds, Room room);

    /// Of the slider.
    static double step();
    /// Shares that steps of the slider do not pass, and at which it catches when dragged.
    void setStops(const std::vector<double>& shares);
    /// Plays no more.
    void stop();
    /// To the middle of the view's foot, as far as there is room.
    void place();
    QSlider& slider() { return *slider_; }
    QToolButton& button() { return *button_; }
    /// Small writing.
    QLabel* makeLabel(const QString& text);

    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    /// Before the slider's value follows where it was moved to.
    void stopOnTheWay(int action);

    QWidget& view_;
    int milliseconds_;  ///< for the whole way
    Room room_;
    QSlider* slider_;
    QToolButton* button_;
    QVariantAnimation* animation_;
    std::vector<int> stops_;  ///< values of the slider
};

}  // namespace toile::app
