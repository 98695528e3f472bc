// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include <Eigen/Core>

#include "core/base/units.h"

namespace toile {

/// Writer of DXF files of all profiles: group codes and values, one per line, codes three
/// characters wide as in AutoCAD, CRLF line ends.
class DxfTags {
public:
    /// @param unit  of the file's lengths, with enough decimals for 0.0002 mm
    explicit DxfTags(LengthUnit unit);

    void tag(int code, std::string_view value);
    void tag(int code, int value);
    void length(int code, double millimetres);
    /// A number that is not a length, such as degrees or factors; 4 decimals.
    void number(int code, double value);
    /// A point in millimetres as codes `first` and `first` + 10.
    void flatPoint(int first, const Eigen::Vector2d& point);
    /// The same with a height of 0 as code `first` + 20.
    void point(int first, const Eigen::Vector2d& point);

    void beginSection(const char* name);
    void endSection();
    void beginTable(const char* name, int entries);
    void endTable();

    /// As `length` writes it: equal places give equal texts.
    std::string digits(double millimetres) const;

    std::string take() { return std::move(out_); }

private:
    std::string out_;
    double perUnit_;  ///< mm
    int decimals_;
};

/// Text that R12 shows unchanged: ASCII, at most 250 characters, and without "%%" and '^', which
/// start control codes.
std::string dxfText(std::string_view line);

}  // namespace toile
