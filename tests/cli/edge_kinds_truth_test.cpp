// SPDX-License-Identifier: GPL-3.0-or-later
// Whether free edges are what they look like, on garments with known panels and on garments of one
// skin that are cut as tailors do.
#include <algorithm>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "core/base/text.h"
#include "core/pattern/edge_kinds.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

/// What the free edges are: for each boundary loop written down by hand from pictures of the worn
/// garment, without the finder's answers. A line for each garment has its unit, its division and
/// whether it is cut. Then kinds follow with middles of edges, mm; each edge is of the kind of the
/// nearest place. Where the trade has no single answer, several kinds are right: the upper edge of
/// a shirt collar below a jacket, the notch below the buttons of a coat, a neckline that ends in an
/// opening, the edge of a hood at the front, the end of a sleeve between elbow and wrist, the edge
/// of a brim, a sock or a bag. A sleeve that ends above the wrist has a hem, the edge of a hood
/// too.
constexpr const char* kTrueEdges = R"(
= garments/dress.obj cm uv whole
neckline: -82 1221 45, -83 1162 -165, 140 1336 -64, 69 1250 26, -165 1343 -87, -139 1280 -10
neckline: 74 1183 -151, -120 1240 21, -128 1250 -154, -149 1307 -35, 121 1273 -130, 104 1299 -14
neckline: -146 1297 -122, -102 1198 -167, -159 1333 -61, 4 1215 56, -153 1320 -48, -144 1294 -22
neckline: 12 1149 -158, 121 1320 -37, 104 1237 -143, -129 1251 12, 133 1306 -109, 86 1276 7
neckline: 130 1329 -50, 50 1153 -153, -157 1328 -99, 143 1334 -79, 138 1321 -95, -92 1180 -166
neckline: -39 1148 -161, 44 1234 41
armhole: -99 1150 -159, 78 1245 24, -138 1247 8, 141 1331 -60, -173 1338 -89, 81 1179 -146
armhole: -153 1292 -21, -137 1245 -153, -163 1318 -46, 123 1267 -122, 112 1296 -10, -166 1154 -50
armhole: 104 1161 -44, -155 1294 -123, -110 1194 -164, -148 1278 -10, -168 1329 -60, -158 1305 -33
armhole: 130 1318 -32, 108 1232 -137, 136 1300 -102, 95 1271 9, 139 1326 -45, -166 1325 -101
armhole: 118 1149 -115, 141 1326 -76, 141 1314 -90, 90 1202 11, -157 1203 -3, -94 1160 -162
armhole: -101 1177 -164, -156 1148 -119
hem: 96 132 60
= garments/dress14_pieces.obj m auto whole
neckline: 10 385 66, 37 549 -87
hem: -65 -118 40, 222 500 -47, -214 469 -34
= garments/longsleeve.obj cm uv whole
collar-edge: 66 1358 2
hem: -158 759 -100, 419 1099 10, -412 1103 8
= garments/polo.obj cm uv whole
front-edge: 36 1434 107, -28 1451 97, 43 1443 102, -11 1409 107
collar-edge: 7 1499 -59, 48 1453 99, -89 1430 76, -38 1455 93, 96 1482 3, 101 1434 76, 74 1450 95
hem: -109 888 -121, 322 1337 -11, -324 1330 -8
= garments/polo_pieces.obj cm auto whole
front-edge: 36 1434 107, -28 1451 97, 43 1443 102, -11 1409 107
collar-edge: 7 1499 -59, 48 1453 99, -89 1430 76, -38 1455 93, 96 1482 3, 101 1434 76, 74 1450 95
hem: -109 888 -121, 322 1337 -11, -324 1330 -8
= garments/skirt_clo.obj mm auto whole
waist: 54 1110 -106
hem: 88 704 -92
= garments/tee_sim.obj cm uv whole
neckline: -10 56 149
hem: 434 120 -49, -430 36 -8, 49 -284 136
= garments/tee_sim_pieces.obj cm auto whole
neckline: -10 56 149
hem: 434 120 -49, -430 36 -8, 49 -284 136
= garments/tshirt.obj cm uv whole
neckline: -87 1650 -73
hem: 121 1041 60, -379 1396 -68, 381 1409 -67
= garments/wetsuit_patches.obj 400mm auto whole
neckline: -62 643 25
cuff: -436 45 49, 497 80 65
hem: -210 -1028 -99
= garments/suit_mh.obj - auto cut
collar-edge|neckline: -54 697 13
cuff: -467 261 228, 500 244 192
waist: -97 206 126, 120 210 -48, -86 214 -74, 85 206 133, 14 217 -80, -27 216 -80, -9 208 149
slit: -4 74 -118, -1 203 -101, 11 57 -117
hem: -115 44 -105, 4 49 146, 197 -750 -49, 146 46 -75, 15 49 -119, -188 44 85, 187 49 101
hem: -93 41 152, -39 53 146, -28 44 -116, 97 41 145, 62 44 -117
front-edge|slit: -23 104 154, -4 63 146, -32 64 147
= garments/elegant_mh.obj - auto cut
collar-edge: -48 530 -35, -37 525 63, 87 529 11, 36 525 67, -81 522 25, 81 504 60, -70 491 71
collar-edge: 56 495 80
front-edge: 6 71 148, -33 526 64, 8 297 150, 7 153 148, 9 433 126, 8 109 148, 33 526 66, 17 482 98
front-edge: -19 500 90, 24 507 78
hem: -166 68 32, -21 -293 -88, 44 56 149, 32 61 -88, 162 82 15, 189 -291 81, -80 57 128
hem: -86 62 -77, -142 -296 122, -9 56 145, 95 -290 -64, 135 71 104, 110 74 -61, -130 -290 -44
hem: -142 63 96, 40 -293 -84, 93 63 127, 163 78 64, 18 56 154, 141 80 -25, -139 69 -35
hem: -64 -291 -77
cuff: -412 144 156, 435 144 138
waist: -41 126 -37, 23 98 141, -148 113 56, 131 122 -3, -65 101 135, 137 110 84, -120 106 107
waist: -23 98 141, 41 126 -37, 98 103 123, -131 122 -3, 148 117 26
slit: -12 -287 -89, -1 -142 -85, -8 -225 -89
= garments/leggings.ply - auto cut
waist: -113 104 -15
hem: -101 -819 -37
= garments/arcsim/tshirt.obj m uv whole
neckline: -56 320 107
hem: 23 -237 -170, -424 283 54, 441 243 56
= garments/arcsim/pants3.obj m uv whole
waist: 28 -73 -111
hem: 117 -1122 -164
= garments/arcsim/robew.obj m auto whole
front-edge: 62 34 244, 55 -1008 167, 28 283 288
hem: 98 -1147 175, -437 -1079 -93, 394 -1112 -224, -288 -1124 244, -21 -1181 -203, -90 -1144 244
cuff: -974 346 198, 1035 189 71
front-edge|hem: 22 778 281, 63 386 206, -169 479 84
= tailor/mh_tee_m4.obj dm auto cut
neckline: 68 679 36
hem: 249 504 -36, -274 553 35, -14 134 158
= tailor/mh_trousers_f1.obj dm auto cut
waist: -48 77 -67
hem: -173 -728 73
= tailor/mh_jacket_elegant_f.obj dm auto cut
collar-edge: -48 530 -35, -37 525 63, 87 529 11, 36 525 67, -81 522 25, 81 504 60, -70 491 71
collar-edge: 56 495 80
front-edge: 6 71 148, -33 526 64, -1 320 155, -4 437 118, 33 526 66, 7 193 147, -17 488 97
front-edge: 21 500 83
hem: -2 58 -87, 18 56 154, -164 66 56, 166 81 39, -80 57 128, 107 66 121, -9 56 145
cuff: -412 144 156, 435 144 138
= tailor/mh_skirt_elegant_f.obj dm auto cut
waist: -41 126 -37
slit: -12 -287 -89, -1 -142 -85, 12 -287 -89, -8 -225 -89
hem: 34 -299 139, -21 -293 -88, 164 -290 -15, -195 -289 52, 64 -291 -77, 21 -293 -88
hem: -130 -290 -44, -64 -291 -77
= tailor/mh_overall_m1.obj dm auto cut
collar-edge|neckline: -4 703 -14, -55 661 56, 61 655 67, 47 688 22
front-edge|neckline: 6 563 106, -54 644 61, 54 639 68
cuff: 504 245 190, -509 275 217
hem: -189 -739 -47
= tailor/mh_sweater_m2.obj dm auto cut
neckline: 68 679 36
cuff: 475 277 240, -505 233 198
hem: -143 83 122, 182 83 45
= tailor/mh_jacket_m3.obj dm auto cut
collar-edge: -21 675 -44, -56 655 82, 104 655 61, 54 654 92, -98 674 13
front-edge: 14 122 152, -39 671 79, -9 429 165, 10 558 132, 44 669 84, 21 626 98, -3 267 165
front-edge: -18 636 93
hem: -5 105 -120, 17 102 154, -181 109 41, 173 123 2, -82 99 141, 112 108 132
cuff|hem: -422 352 70, 375 316 76
= tailor/mh_suitjacket.obj dm auto cut
collar-edge|neckline: -54 697 13
cuff: -467 261 228, 500 244 192
slit: -4 74 -118, -3 51 -118, 11 57 -117, -1 203 -101
hem: 19 44 147, -9 47 -118, -195 45 62, 180 51 -17, -93 41 152, -39 53 146, 89 45 -110
hem: -138 45 -92, 39 44 -121, 15 49 -119, 152 45 132, -55 44 -116, 4 49 146
front-edge|slit: -23 104 154, -4 63 146, -32 64 147
= tailor/mh_fedora_cocked.obj dm auto cut
hem|unknown: -23 774 -40
= tailor/mh_croptee_sport_f.obj dm auto cut
neckline: 61 527 33
hem: -249 358 -11, 259 385 30, 14 318 -44
= tailor/pf_dress.obj mm auto cut
neckline: 40 421 -116, 150 429 85, -71 452 71, -64 465 -54, 164 461 -54, 173 476 23, -75 493 13
armhole: 210 307 29, -123 438 -57, -132 425 83, 224 445 46, 212 406 -75, 224 455 -28, -133 469 15
armhole: 218 373 79, -134 321 3
hem: -221 -267 47, 257 -278 41
= tailor/pf_longsleeve_apose.obj m auto cut
neckline: 37 1544 178
cuff: 601 1149 196, -590 1233 205
hem: 30 946 -10
= tailor/pf_wetsuit.obj m auto cut
neckline: -12 580 -3
cuff: -346 -24 53, 392 15 36
hem: -173 -822 -2
= tailor/cf_puffer_zup.obj m auto cut
hem: 20802 -22 142, 21139 860 116, 20917 803 205, 21270 -16 45, 20915 939 -52, 21119 810 135
hem: 20877 890 100
front-edge|neckline|hem: 21028 679 209, 20936 778 206, 21104 781 145
cuff: 20363 10 51, 21728 68 93
= tailor/dc_skirt.obj m auto cut
waist: 99 1146 55
hem: -90 912 -156, 184 916 183, -170 917 189, 172 916 -90
= tailor/dc_tshirt.obj 60mm auto cut
neckline: 64 742 23
hem: 145 92 102, -311 679 45, 314 676 49
= tailor/dc_sock.obj m auto cut
hem|cuff: 52 327 -144
= tailor/p_raglan_tee.obj mm auto cut
neckline: -123 5 74
hem: 320 -235 75, -383 -172 12, -81 -680 96
= tailor/p_hoodie.obj mm auto cut
hem: -163 -680 24, 82 234 85
cuff: -612 -330 -29, 554 -413 12
= tailor/p_jumpsuit_tpose.obj mm auto cut
neckline: 68 42 -23
cuff: 680 -40 41, -680 -20 -24
hem: -185 -1400 -25
= tailor/p_tank.obj mm auto cut
neckline: 85 27 15
armhole: -178 -158 -37, 178 9 19, 178 -171 -18
hem: 167 -680 -6
= tailor/p_vest_open.obj mm auto cut
armhole: -178 -158 -37, 178 9 -19, -178 -7 43, 178 -170 19, 178 -61 70
hem: 167 -680 7, -70 -680 100, 67 -680 101, -3 -679 110, -15 -680 -110, -35 -680 108, 30 -680 109
front-edge: -2 -16 85, -3 -672 110, -2 -334 112, -0 -505 111, -2 -165 112, -3 -594 111, -3 -87 104
front-edge: -3 -633 111
neckline: 17 55 -56, -2 -7 83, -82 29 12, 85 27 15, 45 8 67, -48 8 65
= tailor/p_leotard.obj mm auto cut
neckline: 77 27 18, -81 30 8
armhole: 168 -118 -61, -168 9 24, 168 9 23, -168 -175 -16
hem: -175 -641 -27
= tailor/p_skirt_aline_zup.obj cm auto cut
waist: -132 -0 4
hem: -304 -620 9, 304 -620 -9
= tailor/p_skirt_round_zup.obj m auto cut
waist: -110 -0 4
hem: -440 -436 14, 440 -404 -14, 14 -415 440, -14 -425 -440
= tailor/p_shorts_zup_inch.obj in auto cut
waist: 163 30 21
hem: 34 -416 14
= tailor/p_beanie.obj mm auto cut
hem: 94 -10 13
= tailor/p_bag.obj mm auto cut
hem|unknown: 163 150 52
= tailor/v_sweater_opened.obj dm auto cut
front-edge: 0 552 125, 0 98 152, 0 648 87, 0 289 149, 0 606 98, 0 178 151
neckline: -11 690 -24, 12 650 80, -61 670 50, -12 650 80, 70 687 20
hem: 18 78 -118, -22 83 151, 182 83 45, 86 83 144, -173 83 -11, 22 83 151, -143 83 122
cuff: 475 277 240, -515 270 219
= tailor/v_sweater_tpose.obj dm auto cut
neckline: 68 679 36
cuff: 577 521 240, -621 500 201
hem: -143 83 122
= tailor/v_tee_60k.obj 60mm auto cut
neckline: 66 745 30
hem: 151 93 97, -312 681 52, 314 677 42
= tailor/v_trousers_wrinkled.obj dm auto cut
waist: -97 206 126
hem: -197 -735 115
)";

struct TrueEdge {
    std::string kinds;
    Eigen::Vector3d place;
};

struct LookedAt {
    std::string file;
    LoadOptions loading{};
    std::vector<TrueEdge> edges{};
};

std::vector<LookedAt> garmentsLookedAt() {
    std::vector<LookedAt> list;
    std::istringstream text(kTrueEdges);
    std::string word, kinds;
    while (text >> word) {
        if (word == "=") {
            LookedAt& added = list.emplace_back();
            std::string unit, split, cut;
            text >> added.file >> unit >> split >> cut;
            added.loading.unit = unit == "-" ? std::nullopt : parseFileUnit(unit);
            added.loading.split = *parseSplitMode(split);
            added.loading.autoCut = cut == "cut";
            added.loading.cutStyle = CutStyle::Auto;
        } else if (word.ends_with(':')) {
            kinds = word.substr(0, word.size() - 1);
        } else {
            Eigen::Vector3d place(std::stod(word), 0, 0);
            char comma = ' ';
            text >> place.y() >> place.z();
            if (text.peek() == ',') {
                text >> comma;
            }
            list.back().edges.push_back({kinds, place});
        }
    }
    return list;
}

struct Score {
    double right = 0, whole = 0;  ///< mm
};

/// Of a garment's free edges: each against the nearest place looked at.
Score scoreOf(const LookedAt& looked, const Garment& garment, std::string& wrong) {
    const auto outlines = seam::buildOutlines(garment.pieces);
    const auto found = findEdgeKinds(garment, outlines);
    Score score;
    std::map<std::string, double> faults;  // mm
    for (const Seam& seam : garment.seams.seams) {
        if (seam.kind != SeamKind::Free) {
            continue;
        }
        const seam::Outline& outline = outlines.list[seam.left.piece];
        for (int k = seam.left.first; k < seam.left.first + seam.left.count; ++k) {
            const FoundEdge& edge = found[seam.left.piece][outline.wrapIndex(k)];
            if (edge.opening < 0) {
                continue;  // a seam ends within this edge
            }
            const double from = outline.arcOf(k), to = outline.arcOf(k + 1);
            const Eigen::Vector3d middle = outline.pointAt((from + to) / 2);
            const auto truth = std::ranges::min_element(
                looked.edges, {},
                [&](const TrueEdge& place) { return (place.place - middle).norm(); });
            const std::string kind(wordOf(kEdgeKindWords, edge.kind));
            score.whole += to - from;
            if (('|' + truth->kinds + '|').find('|' + kind + '|') != std::string::npos) {
                score.right += to - from;
            } else {
                faults[garment.pieces[seam.left.piece]->name + ": " + truth->kinds + " taken for " +
                       kind] += to - from;
            }
        }
    }
    for (const auto& [fault, length] : faults) {
        wrong += "\n  " + fault + ", " + fixed(length, 0) + " mm";
    }
    return score;
}

TEST(EdgeKindsOfGarments, AreWhatTheyLookLike) {
    TOILE_NEEDS_SHARED(test::sharedFile("garments/dress.obj"));
    Score all;
    for (const LookedAt& looked : garmentsLookedAt()) {
        Progress progress;
        const auto garment = loadGarment({test::sharedFile(looked.file)}, looked.loading, progress);
        ASSERT_TRUE(garment) << looked.file;
        std::string wrong;
        const Score score = scoreOf(looked, *garment, wrong);
        all.right += score.right;
        all.whole += score.whole;
        std::printf("%-36s %5.1f %% of %6.0f mm%s\n", looked.file.c_str(),
                    100 * score.right / score.whole, score.whole, wrong.c_str());
        EXPECT_GE(score.right, 0.8 * score.whole) << looked.file << wrong;
    }
    EXPECT_GE(all.right, 0.9 * all.whole);
}

}  // namespace
}  // namespace toile
