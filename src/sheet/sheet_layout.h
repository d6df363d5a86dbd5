#pragma once

#include <planish/draw/color.h>

namespace planish::sheet {

// How a pattern's sheet is divided, in millimetres: below the pattern a block with the squares to
// measure and what is to be said.
inline constexpr double k_margin = 10.0;
inline constexpr double k_square = 50.0, k_inch_square = 50.8;  // sides of the test squares
inline constexpr double k_block_height = 56.0;                  // of squares and texts
inline constexpr double k_gap = 8.0;                            // between that and the pattern
inline constexpr double k_column = k_margin + k_square + 6.0;   // where the texts begin
inline constexpr double k_column_width = 115.0;
inline constexpr double k_block_right = k_column + k_column_width + 6.0 + k_inch_square;
inline constexpr double k_letter_width = 0.85;  // over a capital's height, on the safe side

// Of lines and letters. No two layers share a colour, as machines tell by it what to do:
// dxf_layers.cpp has one of AutoCAD's colours for each.
inline constexpr Color k_cut_color = {255, 0, 0}, k_seam_color = {80, 80, 80},
                       k_notch_color = {255, 0, 255}, k_grain_color = {0, 128, 0},
                       k_fold_color = {230, 120, 0}, k_drill_color = {0, 0, 255},
                       k_internal_color = {0, 160, 160}, k_annotation_color = {0, 0, 0},
                       k_label_color = {127, 63, 0}, k_warning_color = {165, 0, 0},
                       k_legend_color = {82, 0, 165}, k_hole_color = {127, 127, 0};

}  // namespace planish::sheet
