#include "model/model_text.h"

#include <algorithm>

#include "shell/text.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

/// "left out 3 triangles without loss to the surface (2 there twice, 1 ...)"
std::string redundant_text(const ModelWork& work) {
  const std::size_t all = work.collapsed + work.repeated + work.backs + work.fins;
  std::string kinds;
  const auto add = [&](std::size_t count, const std::string& words) {
    if (count > 0) kinds += (kinds.empty() ? "" : ", ") + std::to_string(count) + " " + words;
  };
  add(work.collapsed, "with a corner twice");
  add(work.repeated, "there twice");
  add(work.backs, "of the back of a doubled sheet");
  add(work.fins, "of scraps on the surface");
  return "left out " + counted(all, "triangle") + " without loss to the surface (" + kinds + ")";
}

std::string holes_text(const ModelWork& work) {
  std::string text = "closed " + counted(work.filled, "hole");
  if (work.unfilled > 0)
    text += "; " + std::to_string(work.unfilled) + " short enough could not be closed";
  return text;
}

std::string weld_text(const ModelWork& work, const ShownLengths& lengths) {
  const std::string within = lengths.thickness_text(work.weld_length);
  std::string text = "joined " + counted(work.joined, "pair") + " of border edges within " + within;
  if (work.unjoined > 0) {
    text += "; " + counted(work.unjoined, "edge") +
            " beside another could not be joined: is the length of --weld too large, or too small?";
  }
  if (work.held > 0) {
    text += "; that is more than a third of a border edge at " + std::to_string(work.held) +
            (work.held == 1 ? " vertex" : " vertices") +
            ", where only what is nearer was joined: look at the result, or make --weld less";
  }
  return text;
}

std::string unjoined_text(const ModelWork& work, const ShownLengths& lengths) {
  const ModelWork::NothingJoined& nothing = *work.nothing_joined;
  const std::string text = "--weld joined nothing: ";
  if (nothing.is_between_names)
    return text + "pieces of different names stay apart; --divide parts joins them too";
  if (!nothing.gap) return text + "there are no two borders beside each other";
  return text + "the nearest borders of two pieces are " + lengths.text(*nothing.gap) +
         " apart, more than " + lengths.thickness_text(work.weld_length) +
         "; --weld=LENGTH says how far apart they may be";
}

}  // namespace

std::vector<std::string> work_notes(const ModelWork& work, const ShownLengths& lengths) {
  std::vector<std::string> notes;
  if (work.collapsed + work.repeated + work.backs + work.fins > 0)
    notes.push_back(redundant_text(work));
  if (work.joined + work.unjoined > 0) notes.push_back(weld_text(work, lengths));
  if (work.nothing_joined) notes.push_back(unjoined_text(work, lengths));
  if (work.turned > 0) {
    notes.push_back("turned over " + counted(work.turned, "triangle") +
                    " that ran against the neighbours");
  }
  if (work.parted_edges > 0) {
    notes.push_back("divided at " + counted(work.parted_edges, "edge") +
                    " of more than two triangles");
  }
  if (work.parted_vertices > 0) {
    notes.push_back("divided at " + std::to_string(work.parted_vertices) +
                    (work.parted_vertices == 1 ? " vertex" : " vertices") +
                    " in which parts touch without a common edge");
  }
  if (work.crumbs > 0) {
    notes.push_back(counted(work.crumbs, "crumb") + " left out (" + percent(work.crumb_share) +
                    " of the area)");
  }
  if (work.filled + work.unfilled > 0) notes.push_back(holes_text(work));
  for (const ModelWork::FoundWall& wall : work.walls) {
    notes.push_back(wall.name + (wall.is_open ? " looks like a wall of " : " is a wall of ") +
                    lengths.thickness_text(wall.thickness) +
                    ": --side outer or --side inner takes one side" +
                    (wall.is_open ? "; if both are meant, as of a flat sleeve, go on" : ""));
  }
  for (const ModelWork::Lying& lying : work.lying) {
    notes.push_back(lying.piece + " lies on " + lying.on +
                    " all over; if they are one sheet, --without " + lying.piece +
                    " leaves it out");
  }
  if (work.touching > 0) {
    notes.push_back(std::to_string(work.touching) +
                    " pieces touch along whole borders; if they are one surface, --weld makes " +
                    counted(work.welded, "piece") + " of them");
  }
  if (!work.level_walls.empty()) {
    notes.push_back("nothing tells which side is the outer one of " +
                    list_of_some(work.level_walls) +
                    ", flat or bent both ways: the side with the first triangle of the file is "
                    "taken for it");
  }
  for (const ModelWork::ClashingSides& sides : work.clashing_sides) {
    notes.push_back("the sides of " + sides.one + " and " + sides.other +
                    " that were taken do not meet, as the walls curve in opposite directions: "
                    "take one of them by itself, with --only and the other --side");
  }
  if (!work.without_wall.empty()) {
    notes.push_back("no wall was found in " + list_of_some(work.without_wall) +
                    ": --side changes nothing there");
  }
  if (work.renumbered) notes.emplace_back("vertices are renumbered, as some of the file are gone");
  return notes;
}

}  // namespace planish::cli
