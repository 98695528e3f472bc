// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/marker/laid_pieces.h"

// For the sources of this folder only.
namespace toile::cloth {

/// What is to be laid on a cloth, until all of it has room: copies that a person keeps where they
/// are, and others, of which those are left out, with a note, that are too large or too many.
class ClothItems {
public:
    /// @param pattern  as it lies (`patternOnCloth`)
    ClothItems(std::shared_ptr<const Pattern> pattern, const std::string& material,
               const Fabric& fabric, const MarkerSettings& settings,
               const std::vector<KeptCopy>& kept);

    /// For the nest: its items are those of `copyOf` until something gives way.
    NestInstance instance() const;
    /// Makes room where that has none: leaves out the piece that the error names, or has it stay
    /// where it was laid.  @return whether that could be the reason for the error
    bool giveWay(const Error& error);

    const Pattern& pattern() const { return *pattern_; }
    double width() const { return instance_.width; }
    std::size_t itemCount() const { return laid_.size(); }
    /// @param nth  of the item's copies
    LaidCopy copyOf(std::size_t item, std::size_t nth, const NestPlacement& placed) const;
    /// Those that a person has laid on others or beyond the cloth, where they are.
    const std::vector<LaidCopy>& onTop() const { return onTop_; }
    /// Sheets or hides; none: a roll.
    const std::vector<ClothPart>& parts() const { return parts_; }
    /// Whether nothing is left out.
    bool isWhole() const { return isWhole_; }
    std::vector<Wording> notes() const;

private:
    const PatternPiece& pieceOf(const LaidPiece& piece) const {
        return pattern_->pieces[static_cast<std::size_t>(piece.piece)];
    }
    bool areHides() const { return !settings_.hides.empty(); }
    bool areSheets() const { return !areHides() && settings_.sheet; }

    void add(const LaidPiece& piece, const std::vector<KeptCopy>& kept);
    void erase(std::size_t item);
    bool leaveOutTooLarge(const std::string& name);
    void leaveOutOne(std::size_t item);
    bool leaveOut(const std::string& name);
    void leaveOutBeyondArea();
    bool layOnTop(const std::string& name);
    void note(const Wording& said);

    std::shared_ptr<const Pattern> pattern_;
    MarkerSettings settings_;
    NestInstance instance_;
    std::vector<LaidPiece> laid_;  ///< one per item of the instance
    std::vector<LaidCopy> onTop_;
    std::vector<ClothPart> parts_;
    std::size_t copies_ = 0;  ///< that were to be laid
    bool isWhole_ = true;
    std::vector<Wording> notes_, ofStripes_;
    std::map<std::string, int> missing_;  ///< copies for which there is no room
};

}  // namespace toile::cloth
