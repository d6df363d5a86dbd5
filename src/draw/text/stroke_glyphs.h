#pragma once

#include <string_view>

// The tables of stroke_font.cpp. Drawn for Planish.

namespace planish {

// A glyph is written as points "xy": x a digit, y a letter from 'a' (-3, where descenders end) over
// 'd' (0, the baseline), 'i' (5, the height of small letters) and 'l' (8, of capitals) to 'o' (11).
// A blank lifts the pen.
struct DrawnGlyph {
  char32_t code_point;
  std::string_view points;
};

// From '!' on.
inline constexpr std::string_view k_ascii[] = {
    "0l0g 0e0d",                           // !
    "0l0j 2l2j",                           // "
    "1e2k 4e5k 0i6i 0g6g",                 // #
    "0e1d4d5e5g4h1h0i0k1l4l5k 2c3m",       // $
    "0d6l 1l2k1j0k1l 5f6e5d4e5f",          // %
    "6d1j1k2l3l4k4j0f0e1d3d6g",            // &
    "0l0j",                                // '
    "2m0j0e2b",                            // (
    "0m2j2e0b",                            // )
    "2g2k 0h4j 0j4h",                      // *
    "0g4g 2e2i",                           // +
    "1e1d0b",                              // ,
    "0g3g",                                // -
    "0d0e",                                // .
    "0d4l",                                // /
    "2d3d5f5j3l2l0j0f2d",                  // 0
    "1j3l3d 1d5d",                         // 1
    "0j0k1l4l5k5i0d5d",                    // 2
    "0k1l4l5k5i4h2h 4h5g5e4d1d0e",         // 3
    "4d4l0f5f",                            // 4
    "5l0l0h1i4i5h5e4d1d0e",                // 5
    "5k4l2l0j0e1d4d5e5g4h1h0g",            // 6
    "0l5l2d",                              // 7
    "1h0i0k1l4l5k5i4h1h0g0e1d4d5e5g4h",    // 8
    "0e1d3d5f5k4l1l0k0i1h4h5i",            // 9
    "0d0e 0h0i",                           // :
    "1e1d0b 1h1i",                         // ;
    "4j0g4d",                              // <
    "0h4h 0f4f",                           // =
    "0j4g0d",                              // >
    "0k1l3l4k4i2h2g 2e2d",                 // ?
    "6e5d2d0f0j2l4l6j6g5f4g4i3j2i2g3f4g",  // @
    "0d3l6d 1g5g",                         // A
    "0d0l4l5k5i4h0h 4h5g5e4d0d",           // B
    "6j4l2l0j0f2d4d6f",                    // C
    "0d0l3l5j5f3d0d",                      // D
    "5d0d0l5l 0h4h",                       // E
    "0d0l5l 0h4h",                         // F
    "6j4l2l0j0f2d4d6f6h4h",                // G
    "0d0l 5d5l 0h5h",                      // H
    "0d2d 1d1l 0l2l",                      // I
    "0f1d3d4f4l",                          // J
    "0d0l 5l0g 2i5d",                      // K
    "0l0d5d",                              // L
    "0d0l3h6l6d",                          // M
    "0d0l5d5l",                            // N
    "2d4d6f6j4l2l0j0f2d",                  // O
    "0d0l4l5k5i4h0h",                      // P
    "2d4d6f6j4l2l0j0f2d 4f6d",             // Q
    "0d0l4l5k5i4h0h 3h5d",                 // R
    "0e1d4d5e5g4h1h0i0k1l4l5k",            // S
    "0l6l 3l3d",                           // T
    "0l0f2d3d5f5l",                        // U
    "0l3d6l",                              // V
    "0l2d4j6d8l",                          // W
    "0d5l 0l5d",                           // X
    "0l3h6l 3h3d",                         // Y
    "0l5l0d5d",                            // Z
    "2m0m0b2b",                            // [
    "0l4d",                                // the backslash
    "0m2m2b0b",                            // ]
    "0j2l4j",                              // ^
    "0c5c",                                // _
    "0m1k",                                // `
    "4d4i 4h3i1i0h0e1d3d4e",               // a
    "0l0d 0e1d3d4e4h3i1i0h",               // b
    "4h3i1i0h0e1d3d4e",                    // c
    "4l4d 4e3d1d0e0h1i3i4h",               // d
    "0g4g4h3i1i0h0e1d3d4e",                // e
    "1d1k2l3l 0i3i",                       // f
    "4i4b3a1a0b 4h3i1i0h0e1d3d4e",         // g
    "0d0l 0h1i3i4h4d",                     // h
    "0d0i 0k0l",                           // i; all behind the stem is the dot, as in j
    "2i2b1a0a 2k2l",                       // j
    "0d0l 3i0f 1g4d",                      // k
    "0l0e1d",                              // l
    "0d0i 0h1i2i3h3d 3h4i5i6h6d",          // m
    "0d0i 0h1i3i4h4d",                     // n
    "1d3d4e4h3i1i0h0e1d",                  // o
    "0a0i 0h1i3i4h4e3d1d0e",               // p
    "4a4i 4h3i1i0h0e1d3d4e",               // q
    "0d0i 0g2i3i",                         // r
    "0d3d4e4f3g1g0h1i4i",                  // s
    "1l1e2d3d 0i3i",                       // t
    "0i0e1d3d4e 4i4d",                     // u
    "0i2d4i",                              // v
    "0i2d3h4d6i",                          // w
    "0d4i 0i4d",                           // x
    "0i2d 4i1a0a",                         // y
    "0i4i0d4d",                            // z
    "2m1l1i0h1g1c2b",                      // {
    "0m0b",                                // |
    "0m1l1i2h1g1c0b",                      // }
    "0g1h3g4h",                            // ~
};

// In the order of their code points.
inline constexpr DrawnGlyph k_others[] = {
    {U'¡', "0a0f 0h0i"},
    {U'¢', "4h3i1i0h0e1d3d4e 2c2j"},
    {U'£', "5k4l3l2k2e1d0d5d 0h4h"},
    {U'¥', "0l3h6l 3h3d 1h5h 1f5f"},
    {U'§', "4k3l1l0k0j4g4f3e 1i0h0g4d4c3b1b0c"},
    {U'«', "2i0g2e 5i3g5e"},
    {U'°', "1l2l3k3j2i1i0j0k1l"},
    {U'±', "0h4h 2f2j 0d4d"},
    {U'²', "0k1l2l3k0h3h"},
    {U'³', "0l3l1j2j3i2h0h"},
    {U'´', "1m0k"},
    {U'µ', "0a0i 0e1d3d4e 4i4d"},
    {U'·', "0g0h"},
    {U'¹', "0k1l1h"},
    {U'»', "0i2g0e 3i5g3e"},
    {U'¿', "4b3a1a0b0c2e2g 2h2i"},
    {U'Æ', "0d4l8l 4l4d8d 2h7h"},
    {U'Ð', "1d1l4l6j6f4d1d 0h3h"},
    {U'×', "0e4i 0i4e"},
    {U'Ø', "2d4d6f6j4l2l0j0f2d 0d6l"},
    {U'Þ', "0d0l 0j4j5i5g4f0f"},
    {U'ß', "0d0k1l3l4k4j2i4g4e3d2d"},
    {U'æ', "1i3i4h4g1g0f0e1d3d4e 4h5i7i8h8g4g4e5d7d8e"},
    {U'ð', "4h3i1i0h0e1d3d4e4i2l 1j4l"},
    {U'÷', "0g4g 2i2j 2d2e"},
    {U'ø', "1d3d4e4h3i1i0h0e1d 0d4i"},
    {U'þ', "0a0l 0h1i3i4h4e3d1d0e"},
    {U'Đ', "1d1l4l6j6f4d1d 0h3h"},
    {U'đ', "4l4d 4e3d1d0e0h1i3i4h 2k5k"},
    {U'Ħ', "1d1l 6d6l 1h6h 0j7j"},
    {U'ħ', "1d1l 1h2i4i5h5d 0k3k"},
    {U'ı', "0d0i"},
    {U'Ł', "1l1d6d 0g3i"},
    {U'ł', "1l1e2d 0g2i"},
    {U'Œ', "8l2l0j0f2d8d 4l4d 4h7h"},
    {U'œ', "4h3i1i0h0e1d3d4e4h5i7i8h8g4g 4e5d7d8e"},
    {U'Ŧ', "0l6l 3l3d 1h5h"},
    {U'ŧ', "1l1e2d3d 0i3i 0g3g"},
    {U'–', "0g5g"},
    {U'—', "0g8g"},
    {U'‘', "1l0k0j"},
    {U'’', "1l1k0j"},
    {U'‚', "1e1d0b"},
    {U'“', "1l0k0j 3l2k2j"},
    {U'”', "1l1k0j 3l3k2j"},
    {U'„', "1e1d0b 3e3d2b"},
    {U'•', "0g1h2g1f0g"},
    {U'…', "0d0e 3d3e 6d6e"},
    {U'€', "6k5l3l1j1f3d5d6e 0i4i 0g4g"},
    {U'−', "0g4g"},
    {U'≈', "0h1i3h4i 0e1f3e4f"},
    {U'≠', "0h4h 0f4f 1d3j"},
    {U'≤', "4j0h4f 0d4d"},
    {U'≥', "0j4h0f 0d4d"},
    {U'⌀', "2d4d6f6j4l2l0j0f2d 0d6l"},
};

// Accents are drawn over a small letter whose middle is at x = 2, and raised over taller ones.
struct Accent {
  std::string_view points;
  std::string_view pairs;  // a letter, then the same with the accent
};

inline constexpr Accent k_accents[] = {
    {"1l3j", "AÀEÈIÌOÒUÙaàeèiìoòuù"},
    {"3l1j", "AÁEÉIÍOÓUÚYÝaáeéiíoóuúyýCĆcćLĹlĺNŃnńRŔrŕSŚsśZŹzź"},
    {"0j2l4j", "AÂEÊIÎOÔUÛaâeêiîoôuûCĈcĉGĜgĝHĤhĥJĴjĵSŜsŝWŴwŵYŶyŷ"},
    {"0j1k3j4k", "AÃNÑOÕaãnñoõIĨiĩUŨuũ"},
    {"1j1k 3j3k", "AÄEËIÏOÖUÜYŸaäeëiïoöuüyÿ"},
    {"1k2l3k2j1k", "AÅaåUŮuů"},
    {"0k4k", "AĀaāEĒeēIĪiīOŌoōUŪuū"},
    {"0l1j3j4l", "AĂaăEĔeĕGĞgğIĬiĭOŎoŏUŬuŭ"},
    {"2j2k", "CĊcċEĖeėGĠgġIİZŻzż"},
    {"0l2j4l", "CČcčDĎdďEĚeěLĽlľNŇnňRŘrřSŠsšTŤtťZŽzž"},
    {"1j2l 3j4l", "OŐoőUŰuű"},
};

inline constexpr Accent k_accents_below[] = {
    {"2d2c3b2a1a", "CÇcçSŞsşTŢtţ"},
    {"3d2c2b3a", "AĄaąEĘeęIĮiįUŲuų"},
    {"2c2b1a", "GĢgģKĶkķLĻlļNŅnņRŖrŗSȘsșTȚtț"},
};

}  // namespace planish
