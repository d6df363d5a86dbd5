#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>

#include <planish/draw/drawing.h>

namespace planish {

/// For whom a DXF file is. None of the programs was at hand to try a file with: docs/formats.md.
enum class DxfProfile {
  generic,  ///< lasers, plotters, CAD: all layers under their own names, nothing in blocks
  aama,     ///< apparel CAD, ANSI/AAMA-292: a block per piece, numbered layers
  astm,     ///< apparel CAD, ASTM D6673: the same with its system texts
  clo,      ///< as aama, marked as DXF R10
  lectra,   ///< as aama
  optitex,  ///< as astm
  gerber,   ///< as astm
};

inline constexpr std::array k_dxf_profiles = {
    DxfProfile::generic, DxfProfile::aama,    DxfProfile::astm,  DxfProfile::clo,
    DxfProfile::lectra,  DxfProfile::optitex, DxfProfile::gerber};

/// "generic", "aama", ...
std::string_view to_string(DxfProfile profile);

/// @throws Error unknown_name
DxfProfile dxf_profile_named(std::string_view name);

struct DxfOptions {
  DxfProfile profile = DxfProfile::generic;
  /// Other names for layers: name in the drawing -> name in the file. Layers with one name become
  /// one layer.
  std::map<std::string, std::string, std::less<>> layer_names = {};
  bool stroked_text = false;  ///< letters as lines in place of TEXT
};

/// The drawing as DXF R12 (AC1009) in millimetres, coordinates to 0.001 mm: what the widest range
/// of programs and machines reads. Lines become POLYLINEs, closed where they are closed. Areas that
/// are filled and have no outline (the strain map) are left out, and so are layers without anything
/// else; widths of lines are not kept. Colours become the nearest of AutoCAD's first nine, hidden
/// layers stay hidden. Text becomes TEXT as high as asked; each UTF-16 unit beyond ASCII becomes
/// \U+ and four hexadecimal digits, as in AutoCAD. Names of layers and blocks are cut to 31 of A-Z
/// a-z 0-9 $ - _, as R12 wants them;
/// every other character becomes _. The same drawing gives the same bytes.
///
/// The other profiles write every piece as a block and know these layers, by their names in the
/// drawing: cut, notch, grain, internal, drill, seam and annotation. Others are left out unless
/// layer_names names them.
/// @throws Error unknown_name where layer_names names a layer that the drawing has not
std::string write_dxf(const Drawing& drawing, const DxfOptions& options = {});

}  // namespace planish
