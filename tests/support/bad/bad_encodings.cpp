#include "support/bad/sound_files.h"

namespace planish::bad {
namespace {

using namespace std::string_literals;

const std::string k_mark = "\xef\xbb\xbf";

/// ASCII in code units of some bytes.
std::string widened(const std::string& text, std::size_t bytes, bool high_first) {
  std::string wide;
  for (const char c : text) {
    std::string unit(bytes, '\0');
    unit[high_first ? bytes - 1 : 0] = c;
    wide += unit;
  }
  return wide;
}

/// Every third line ends in its own way.
std::string with_mixed_ends(const Lines& lines) {
  const std::array<std::string, 3> ends = {"\n", "\r\n", "\r"};
  std::string text;
  for (std::size_t line = 1; line <= lines.count(); ++line)
    text += lines.at(line) + ends[line % 3];
  return text;
}

void add_line_ends(const SoundText& text, Collection& files) {
  const Lines& lines = text.lines;
  files.same("line_ends_crlf", lines.text("\r\n"));
  files.same("line_ends_cr", lines.text("\r"));
  if (text.format != "ply") files.same("line_ends_mixed", with_mixed_ends(lines));
  files.same("line_end_missing", lines.text().substr(0, lines.text().size() - 1));
  files.same("blanks_behind", lines.text(" \t \n"));
  files.same("form_feeds", lines.text(" \f\v\n"));
  if (text.format != "ply") files.same("blank_lines", lines.text("\n\n \n\t\n"));
  if (text.format == "ply") return;
  std::string indented;
  for (std::size_t line = 1; line <= lines.count(); ++line)
    indented += "\t  " + lines.at(line) + "\n";
  files.same("indented", indented);
  files.same("blank_lines_in_front", "\n\n\n" + lines.text());
  std::string tabs = lines.text();
  for (char& c : tabs) {
    if (c == ' ') c = '\t';
  }
  files.same("tabs", tabs);
}

void add_encodings(const SoundText& text, Collection& files) {
  const std::string plain = text.lines.text();
  files.same("byte_order_mark", k_mark + plain);
  const auto wide = [&](const std::string& name, const std::string& bytes) {
    files.at_line(name, bytes, k_malformed, 1, "UTF-");
  };
  wide("utf16_le", "\xff\xfe" + widened(plain, 2, false));
  wide("utf16_be", "\xfe\xff" + widened(plain, 2, true));
  wide("utf16_le_no_mark", widened(plain, 2, false));
  wide("utf16_be_no_mark", widened(plain, 2, true));
  wide("utf32_le", "\xff\xfe\0\0"s + widened(plain, 4, false));
  wide("utf32_be", "\0\0\xfe\xff"s + widened(plain, 4, true));
  wide("utf32_le_no_mark", widened(plain, 4, false));
  wide("utf32_be_no_mark", widened(plain, 4, true));
}

void add_cuts(const SoundText& text, Collection& files) {
  // Cut at any place: refused, or what is left is a patch.
  const std::string plain = text.lines.text();
  for (std::size_t share = 1; share < 10; ++share)
    files.either("cut_" + std::to_string(share) + "0_percent",
                 plain.substr(0, plain.size() * share / 10));
  files.either("twice", plain + plain);
  files.either("nul_bytes_behind", plain + std::string(512, '\0'));
  files.either("end_of_text_sign_behind", plain + "\x1a");
  files.either("zeros_in_the_middle", plain.substr(0, plain.size() / 2) + std::string(64, '\0') +
                                          plain.substr(plain.size() / 2 + 64));
  files.as_a_whole("empty", "", ErrorCode::no_triangles, "empty");
}

struct Foreign {
  std::string name, bytes, part;
};

std::string png() {
  return "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\1\0\0\0\1\0\b\2\0\0\0"s + std::string(200, '\x5a');
}

const std::vector<Foreign>& foreign_files() {
  static const std::vector<Foreign> files = {
      {"gzip", "\x1f\x8b\b\0\0\0\0\0\0\3"s + std::string(300, '\x41'), "gzip"},
      {"zip", "PK\3\4\x14\0\0\0\b\0"s + std::string(300, '\x42'), "zip"},
      {"zstd", "\x28\xb5\x2f\xfd\x04"s + std::string(300, '\x43'), "zstd"},
      {"xz",
       "\xfd"
       "7zXZ\0\0\4"s +
           std::string(300, '\x44'),
       "xz"},
      {"bzip2", "BZh91AY&SY" + std::string(300, '\x45'), "bzip2"},
      {"7z", "7z\xbc\xaf\x27\x1c\0\4"s + std::string(300, '\x46'), "7z"},
      {"rar", "Rar!\x1a\7\1\0"s + std::string(300, '\x47'), "rar"},
      {"png", png(), "PNG"},
      {"jpeg", "\xff\xd8\xff\xe0\0\x10JFIF\0"s + std::string(300, '\x48'), "JPEG"},
      {"pdf", "%PDF-1.7\n%\xe2\xe3\xcf\xd3\n1 0 obj\n<<>>\nendobj\n", "PDF"},
      {"glb", "glTF\2\0\0\0"s + std::string(300, '\x49'), "glTF"},
      {"fbx", "Kaydara FBX Binary  \0\x1a\0"s + std::string(300, '\x50'), "FBX"},
      {"blend", "BLENDER-v300" + std::string(300, '\x51'), "Blender"},
      {"step", "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nENDSEC;\nDATA;\n#1=X();\n",
       "STEP"},
      {"dxf", "  0\nSECTION\n  2\nHEADER\n  0\nENDSEC\n  0\nEOF\n", ""},
      {"xml", "<?xml version=\"1.0\"?>\n<COLLADA>\n<a>1</a>\n</COLLADA>\n", "XML or HTML"},
      {"html", "<!DOCTYPE html>\n<html><head><title>404</title></head>\n<body>Not found</body>",
       "XML or HTML"},
      {"json", "{\"asset\": {\"version\": \"2.0\"},\n \"meshes\": []}\n", ""},
      {"vrml", "#VRML V2.0 utf8\nShape { geometry IndexedFaceSet { } }\n", ""},
      {"lfs_pointer", "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n",
       ""},
      {"prose",
       "Dear reader,\n\nvery few letters are meshes; this one, for all that it says,\n"
       "is none. Nor would be one that were longer than this.\n",
       ""},
      {"words_of_obj", "please call the surface by its name:\nit will end there.\n", ""},
      {"zeros", std::string(1000, '\0'), ""},
      {"ones", std::string(1000, '\xff'), ""},
      {"blank", " \n \n\n", ""}};
  return files;
}

BadMeshes files_in(const SoundText& text) {
  Collection files(text.format + "_", text.extension());
  add_line_ends(text, files);
  add_encodings(text, files);
  add_cuts(text, files);
  for (const Foreign& foreign : foreign_files()) {
    const std::string name = "foreign_" + foreign.name;
    const bool nothing = foreign.name == "blank" || foreign.name == "zeros" ||
                         foreign.name == "vrml" || foreign.name == "ones";
    if (nothing) {
      BadMesh mesh{.name = text.format + "_" + name,
                   .extension = text.extension(),
                   .bytes = foreign.bytes,
                   .verdict = Verdict::refuse,
                   .unreadable = true};
      files.add(std::move(mesh));
    } else {
      files.as_a_whole(name, foreign.bytes, k_malformed, foreign.part);
    }
  }
  for (const SoundText& other : {sound_obj(), sound_off(), sound_ply(), sound_stl()}) {
    if (other.format != text.format)
      files.as_a_whole("foreign_" + other.format, other.lines.text(), k_malformed);
  }
  return files.take();
}

}  // namespace

BadMeshes bad_encodings() {
  BadMeshes all;
  for (const SoundText& text : {sound_obj(), sound_off(), sound_ply(), sound_stl()})
    append(all, files_in(text));
  return all;
}

}  // namespace planish::bad
