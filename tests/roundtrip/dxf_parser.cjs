// Reads our DXF files with dxf-parser: node dxf_parser.cjs PROGRAM NODE_MODULES. Ends as the scripts
// in Python do: 0, 1 with a word on what is wrong, 77 where the reader is not installed.
"use strict";

const { execFileSync } = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");

const [program, modules] = process.argv.slice(2);
const MILLIMETRES = 4;

function loadParser() {
  try {
    return require(path.resolve(modules, "dxf-parser"));
  } catch (error) {
    console.log(`skipped: dxf-parser is not installed (${error.code})`);
    process.exit(77);
  }
}

function check(right, message) {
  if (right) return;
  throw new Error(`WRONG: ${message}`);
}

function near(value, wanted, tolerance, what) {
  check(Math.abs(value - wanted) <= tolerance, `${what} is ${value}, not ${wanted}`);
}

function extents(lines) {
  const points = lines.flatMap((line) => line.vertices);
  const [xs, ys] = [points.map((p) => p.x), points.map((p) => p.y)];
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

function polylines(entities, layer) {
  return entities.filter((e) => e.type === "POLYLINE" && (!layer || e.layer === layer));
}

function checkBox(lines, wanted, what, tolerance = 0.001) {
  extents(lines).forEach((value, k) => near(value, wanted[k], tolerance, `${what}, side ${k}`));
}

function checkGeneric(document, cut, name) {
  check(document.header.$INSUNITS === MILLIMETRES, `${name}: $INSUNITS`);
  const lines = polylines(document.entities, cut);
  check(lines.length === 3, `${name}: ${lines.length} lines on ${cut}`);
  check(lines.every((line) => line.shape), `${name}: a line of ${cut} is open`);
  const [hole, square, circle] = lines; // holes come before the outline around them
  checkBox([square], [20, 30, 120, 130], `${name}: square`);
  // Its 250 corners are not at all four ends of the circle.
  checkBox([hole], [50, 60, 90, 100], `${name}: hole`, 0.005);
  checkBox([circle], [160, 40, 280, 160], `${name}: circle`);
  check(hole.vertices.length === 250, `${name}: corners of the hole`);
  check(circle.vertices.length === 720, `${name}: corners of the circle`);
  const grain = polylines(document.entities, "grain");
  check(grain.length === 1 && !grain[0].shape, `${name}: the grain line is open`);
  const layers = document.tables.layer.layers;
  check(layers[cut] && layers[cut].visible, `${name}: the cut is to be seen`);
  check(layers.notes__hidden && !layers.notes__hidden.visible, `${name}: the notes are hidden`);
}

function checkBlocks(document, name) {
  const inserts = document.entities.filter((e) => e.type === "INSERT").map((e) => e.name);
  check(inserts.join() === "front_ONE,back_ONE", `${name}: pieces ${inserts}`);
  check(polylines(document.entities).length === 0, `${name}: a line outside of the blocks`);
  const front = document.blocks.front_ONE.entities;
  for (const layer of ["1", "11", "14"]) {
    check(polylines(front, layer).length === 1, `${name}: layer ${layer}`);
  }
  checkBox(polylines(front, "1"), [20, 30, 120, 130], `${name}: boundary`);
  checkBox(polylines(document.blocks.back_ONE.entities, "1"), [160, 40, 280, 160], `${name}: back`);
}

function checkAll(folder) {
  const Parser = loadParser();
  const read = (name) =>
    new Parser().parseSync(fs.readFileSync(path.join(folder, `${name}.dxf`), "utf8"));
  checkGeneric(read("generic"), "cut", "generic");
  checkGeneric(read("strokes"), "cut", "strokes");
  for (const profile of ["aama", "astm", "clo", "lectra", "optitex", "gerber"]) {
    checkBlocks(read(profile), profile);
  }
}

loadParser();
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "planish_roundtrip_"));
try {
  execFileSync(program, [folder]);
  checkAll(folder);
  console.log("DXF: all as written");
} catch (error) {
  console.log(error.message);
  process.exitCode = 1;
} finally {
  fs.rmSync(folder, { recursive: true });
}
