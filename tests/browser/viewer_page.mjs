// The parts of web/viewer in a page of their own, which knows nothing of reports.
//   node viewer_page.mjs PROGRAM NODE_MODULES
/* global calls, drawings, heights, observing, openPattern, patch, pattern, places, view */
import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import test, { after, before } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { openPage, skip, skipUnlessThere, startBrowser, temporaryFolder } from './browser.mjs';
import { decodePng, shareChanged } from './png.mjs';

const [, modules] = process.argv.slice(2);
skipUnlessThere(modules);
const tools = resolve(modules, '../../report/node_modules');
if (!existsSync(join(tools, 'esbuild'))) skip('there is no esbuild under build/npm/report');

const viewer = fileURLToPath(new URL('../../web/viewer', import.meta.url));
const { outputFiles } = await createRequire(join(tools, 'none.js'))('esbuild').build({
  stdin: { contents: "export * from './patch_view.js'; export * from './pattern_view.js';", resolveDir: viewer },
  nodePaths: [tools],
  bundle: true,
  write: false,
  format: 'iife',
  globalName: 'viewer',
});

// Runs in the page: a flat square of points as both states, with a drawing of it below.
function build() {
  const side = 21;
  const heights = (height) =>
    Float32Array.from({ length: 3 * side * side }, (_, i) => {
      const [x, y] = [Math.floor(i / 3) % side, Math.floor(i / 3 / side)];
      return [x, y, height(x, y)][i % 3];
    });
  const triangles = [];
  for (let v = 0; v < side * (side - 1); ++v) {
    if (v % side < side - 1) triangles.push(v, v + 1, v + side, v + 1, v + side + 1, v + side);
  }
  const patch = {
    positions: [heights(() => 0), heights(() => 0)],
    triangles: new Uint16Array(triangles),
    view: { right: [1, 0, 0], up: [0, 1, 0], towards: [0, 0, 1] },
    shown: 1,
    maps: new Map([['grey', new Uint8Array([40, 40, 40, 230, 230, 230])]]),
  };
  const places = (scale) =>
    Float32Array.from({ length: 2 * side * side }, (_, i) => {
      const [x, y] = [(i >> 1) % side, Math.floor(i / 2 / side)];
      return scale * [x, y][i % 2];
    });
  const calls = [];
  const listener = {
    hovered: (vertex) => calls.push(['hovered', vertex]),
    clicked: (vertex) => calls.push(['clicked', vertex]),
  };
  const open = () => {
    const view = new viewer.PatchView(viewer.spaceCanvas(), patch, listener);
    document.getElementById('room').append(view.root);
    const column = Float32Array.from({ length: side * side }, (_, v) => (v % side) / side);
    view.color({ values: [column, column], map: 'grey', limit: 1, isSigned: false });
    return view;
  };
  // The square in one state, as two pieces that go to the left and to the right, with a line along each.
  const openPieces = () => {
    const of = Uint16Array.from({ length: side * side }, (_, v) => Number(v % side > side / 2));
    const line = (x) => Uint32Array.from({ length: side }, (_, y) => x + side * y);
    const pieces = {
      of,
      ways: Float32Array.of(-6, 0, 0, 6, 0, 0),
      colors: [[230, 120, 120], [120, 120, 230]],
      lines: [10, 11].map((x, i) => ({ number: 7 + i, vertices: line(x) })),
    };
    const inOne = patch.triangles.filter((_, i) => {
      const [a, b, c] = patch.triangles.subarray(3 * Math.floor(i / 3)).map((v) => of[v]);
      return a === b && a === c;
    });
    const one = { ...patch, triangles: inOne, positions: patch.positions.slice(0, 1), shown: 0, pieces };
    const view = new viewer.PatchView(viewer.spaceCanvas(), one, listener, { what: 'Product' });
    document.getElementById('room').append(view.root);
    view.plain();
    view.paintLines([[200, 0, 0], [0, 0, 200]], [255, 255, 255]);
    return view;
  };
  const openPattern = () => new viewer.PatternView(document.querySelector('svg'), places(1), listener);
  Object.assign(window, { side, heights, patch, places, calls, open, openPieces, openPattern });
}

const url = (() => {
  const path = join(temporaryFolder(), 'viewer.html');
  const style =
    ':root { --ground: #fff; --card: #fff; --ink: #000; --blue: #00f; } .view { width: 600px; height: 600px; }';
  writeFileSync(
    path,
    `<!DOCTYPE html><meta charset="utf-8"><title>Parts</title>
<style>${readFileSync(join(viewer, 'viewer.css'), 'utf8')}${style}</style>
<div id="room"></div><svg width="400" height="400" viewBox="0 0 40 40"></svg>
<script>${outputFiles[0].text.replaceAll('</script', '<\\/script')}(${build})();</script>`,
  );
  return pathToFileURL(path).href;
})();

let browser;
before(async () => {
  browser = await startBrowser(modules);
});
after(() => browser?.close());

// Whatever a page says in the console fails the test.
async function withPage(run) {
  const { page, context, requests } = await openPage(browser, url);
  const messages = [];
  page.on('console', (message) => messages.push(message.text()));
  page.on('pageerror', (error) => messages.push(String(error)));
  try {
    await run(page, context);
    assert.deepEqual(messages, []);
    assert.deepEqual(requests, []);
  } finally {
    await context.close();
  }
}

const openView = async (page) => {
  await page.evaluate(() => void (window.view = window.open()));
  await page.waitForSelector('.view[data-ready]');
};
const picture = async (page) => {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return page.locator('.view').screenshot();
};
// The share of a picture in which there is no patch.
const groundIn = (png) => {
  const { width, height, channels, pixels } = decodePng(png);
  let count = 0;
  for (let i = 0; i < pixels.length; i += channels) count += pixels[i] > 240;
  return count / (width * height);
};
const inPage = (page, what) => page.evaluate(what);

test('positions that are updated are drawn, on their side only', async () => {
  await withPage(async (page) => {
    await openView(page);
    const first = await picture(page);
    await inPage(page, () => view.update(heights((x) => 6 * Math.sin(x / 2))));
    const right = await picture(page);
    assert.ok(shareChanged(first, right) > 0.1, 'lit as the new form is');
    await inPage(page, () => view.update(heights((x) => 6 * Math.sin(x / 2)), 0));
    assert.ok(shareChanged(right, await picture(page)) > 0.1);
    await inPage(page, () => {
      view.update(patch.positions[0], 0);
      view.update(patch.positions[1], 1);
    });
    assert.equal(shareChanged(first, await picture(page)), 0, 'the positions that were given first are as they were');
  });
});

test('what is picked and marked is where the positions are', async () => {
  await withPage(async (page) => {
    await openView(page);
    const spot = () =>
      page.locator('.spot').evaluate((element) => {
        const { m41, m42 } = new DOMMatrix(element.style.transform);
        return [m41, m42];
      });
    const center = (vertex) => inPage(page, `(() => { const p = view.places(1), box = view.root.getBoundingClientRect();
      return [box.left + p[3 * ${vertex}], box.top + p[3 * ${vertex} + 1]]; })()`);
    const vertex = 16 * 21 + 15;
    const at = await center(vertex);
    await page.mouse.move(...at);
    assert.deepEqual((await inPage(page, () => calls)).at(-1), ['hovered', vertex]);
    await inPage(page, `view.mark(${vertex})`);
    const first = await spot();
    await inPage(page, () => view.update(heights(() => 0).map((x, i) => (i % 3 === 1 ? 0.5 * x : x))));
    await picture(page);
    const second = await spot();
    assert.ok(Math.hypot(first[0] - second[0], first[1] - second[1]) > 20, 'the mark went along');
    await page.mouse.move(at[0] + 1, at[1]);
    assert.deepEqual((await inPage(page, () => calls)).at(-1), ['hovered', -1], 'it has gone from there');
    await page.mouse.move(...(await center(vertex)));
    assert.deepEqual((await inPage(page, () => calls)).at(-1), ['hovered', vertex]);
  });
});

test('the camera stays where vertices are updated, holds all of them, and frames them when reset', async () => {
  await withPage(async (page) => {
    await openView(page);
    const first = await picture(page);
    // Far in front of what was there at first and far behind: seen from there the outline is the same.
    await inPage(page, () => view.update(heights((x, y) => (x < y ? 500 : -500))));
    const [shallow, deep] = [first, await picture(page)].map(groundIn);
    assert.ok(Math.abs(shallow - deep) < 0.005, `nothing is cut off: ${deep}, not ${shallow}`);
    await inPage(page, () => [0, 1].forEach((state) => view.update(heights(() => 0).map((x) => 3 * x), state)));
    assert.ok(shareChanged(first, await picture(page)) > 0.1, 'only a part of it is in the picture');
    await inPage(page, () => view.reset());
    assert.ok(shareChanged(first, await picture(page)) < 0.02, 'all of it is');
  });
});

test('positions of another number of vertices are refused', async () => {
  await withPage(async (page) => {
    await openView(page);
    const refusal = (what) =>
      page.evaluate((code) => {
        try {
          eval(code);
          return 'none';
        } catch (error) {
          return `${error.name}: ${error.message}`;
        }
      }, what);
    assert.equal(
      await refusal('view.update(new Float32Array(30))'),
      'RangeError: positions of 10 vertices, not of 441',
    );
    assert.equal(
      await refusal('openPattern().update(new Float32Array(30))'),
      'RangeError: positions of 15 vertices, not of 441',
    );
  });
});

test('the view of a pattern follows its positions', async () => {
  await withPage(async (page) => {
    await inPage(page, () => void (window.pattern = openPattern()));
    const box = await page.locator('svg').boundingBox();
    const pixel = box.width / 40;
    const hover = async (x, y) => {
      await page.mouse.move(box.x + pixel * x, box.y + pixel * y);
      return (await inPage(page, () => calls)).at(-1);
    };
    const vertex = 4 * 21 + 7;
    assert.deepEqual(await hover(7, 4), ['hovered', vertex]);
    await inPage(page, `pattern.mark(${vertex})`);
    const place = () =>
      page.locator('.mark .ring').evaluate((ring) => ['cx', 'cy'].map((name) => Number(ring.getAttribute(name))));
    assert.deepEqual(await place(), [7, 4]);
    await inPage(page, () => pattern.update(places(1.5)));
    assert.deepEqual(await place(), [10.5, 6]);
    assert.deepEqual(await hover(10.5, 6), ['hovered', vertex]);
    await page.mouse.click(box.x + pixel * 10.5, box.y + pixel * 6);
    assert.deepEqual((await inPage(page, () => calls)).at(-1), ['clicked', vertex]);
    assert.deepEqual(await hover(38, 38), ['hovered', -1]);
  });
});

test('pieces go apart along their ways, with their vertices and lines, and all stay in the picture', async () => {
  await withPage(async (page) => {
    await page.evaluate(() => void (window.view = window.openPieces()));
    await page.waitForSelector('.view[data-ready]');
    const together = await picture(page);
    const vertex = (x, y) => x + 21 * y;
    const placed = (v) => inPage(page, `Array.from(view.places(1).slice(3 * ${v}, 3 * ${v} + 2))`);
    const size = () => inPage(page, () => 1 / view.scene.pixel());
    const near = { left: await placed(vertex(3, 5)), right: await placed(vertex(17, 5)), size: await size() };
    assert.ok(Math.abs(near.right[0] - near.left[0] - 14 * near.size) < 0.01);
    await inPage(page, () => view.moveApart(0.5));
    const far = { left: await placed(vertex(3, 5)), right: await placed(vertex(17, 5)), size: await size() };
    assert.ok(Math.abs(far.right[0] - far.left[0] - (14 + 2 * 0.5 * 6) * far.size) < 0.01, JSON.stringify(far));
    assert.ok(far.size < near.size, 'they are smaller, as there is more to see');
    assert.ok(groundIn(await picture(page)) > groundIn(together), 'there is a gap between them');
    const box = await page.locator('.view').boundingBox();
    await page.mouse.move(box.x + far.right[0], box.y + far.right[1]);
    assert.deepEqual((await inPage(page, () => calls)).at(-1), ['hovered', vertex(17, 5)]);
    await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
    assert.deepEqual((await inPage(page, () => calls)).at(-1), ['hovered', -1], 'in the gap');
    await inPage(page, () => view.moveApart(0));
    assert.equal(shareChanged(together, await picture(page)), 0);
  });
});

test('a piece that is chosen stands out, and lines have their colours', async () => {
  await withPage(async (page) => {
    await page.evaluate(() => void (window.view = window.openPieces()));
    await page.waitForSelector('.view[data-ready]');
    const { width, height, channels, pixels } = decodePng(await picture(page));
    const count = (is) => {
      let all = 0;
      for (let i = 0; i < pixels.length; i += channels) all += Number(is(pixels[i], pixels[i + 1], pixels[i + 2]));
      return all / (width * height);
    };
    assert.ok(count((r, g, b) => r > 180 && g < 20 && b < 20) > 0.002, 'the red line');
    assert.ok(count((r, g, b) => b > 180 && g < 20 && r < 20) > 0.002, 'the blue line');
    const all = await picture(page);
    await inPage(page, () => view.choose(1));
    const chosen = await picture(page);
    const changed = shareChanged(all, chosen);
    assert.ok(changed > 0.2 && changed < 0.6, `the other one only: ${changed}`);
    await inPage(page, () => view.choose(-1));
    assert.equal(shareChanged(all, await picture(page)), 0);
    const { geometries, textures } = await inPage(page, () => {
      const { info } = view.scene.renderer;
      view.dispose();
      return { ...info.memory };
    });
    assert.deepEqual({ geometries, textures }, { geometries: 0, textures: 0 }, 'freed');
  });
});

// How many listeners there are on what an expression gives.
async function listenersOn(session, expression) {
  const { result } = await session.send('Runtime.evaluate', { expression });
  const { listeners } = await session.send('DOMDebugger.getEventListeners', { objectId: result.objectId });
  return listeners.length;
}

test('a view that was disposed leaves nothing behind', async () => {
  await withPage(async (page, context) => {
    const session = await context.newCDPSession(page);
    const objects = ['window', 'document', 'document.body', 'document.querySelector("svg")'];
    const own = ['view.canvas', 'view.slider', 'view.root'];
    const counted = async (list) => Promise.all(list.map((expression) => listenersOn(session, expression)));
    await page.waitForSelector('svg'); // for which the driver of the browser listens to the window
    const clean = await counted(objects);
    await inPage(page, () => {
      window.observing = 0;
      const { observe, disconnect } = ResizeObserver.prototype;
      ResizeObserver.prototype.observe = function (...all) {
        ++window.observing;
        observe.apply(this, all);
      };
      ResizeObserver.prototype.disconnect = function () {
        --window.observing;
        disconnect.call(this);
      };
    });
    await openView(page);
    await inPage(page, () => void (window.pattern = openPattern()));
    const { memory, programs } = await inPage(page, () => {
      const { info } = view.scene.renderer;
      return { memory: info.memory, programs: info.programs.length };
    });
    assert.ok(memory.geometries === 2 && memory.textures >= 1 && programs === 1, JSON.stringify(memory));
    assert.ok((await counted(own.slice(0, 2))).every((count) => count > 0));
    assert.equal(await inPage(page, () => observing), 1);

    const left = await inPage(page, () => {
      view.redraw();
      view.dispose();
      pattern.dispose();
      calls.length = 0;
      window.drawings = 0;
      view.scene.draw = () => ++window.drawings;
      return document.querySelectorAll('canvas, .view, .mark').length;
    });
    assert.equal(left, 0, 'nothing is in the page');
    assert.deepEqual(await counted(objects), clean);
    assert.deepEqual(await counted(own), [0, 0, 0]);
    const rest = await inPage(page, async () => {
      for (const kind of ['pointerdown', 'pointermove', 'pointerup', 'pointerleave', 'keydown', 'wheel', 'click']) {
        view.canvas.dispatchEvent(new Event(kind));
        document.querySelector('svg').dispatchEvent(new Event(kind));
      }
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      const { info } = view.scene.renderer;
      const { geometries, textures } = info.memory;
      return { geometries, textures, programs: info.programs.length, drawings, observing, calls };
    });
    assert.deepEqual(rest, { geometries: 0, textures: 0, programs: 0, drawings: 0, observing: 0, calls: [] });
  });
});

test('many views, one after another, are as one', async () => {
  await withPage(async (page) => {
    for (let i = 0; i < 20; ++i) {
      await openView(page);
      await inPage(page, () => view.dispose());
    }
    await openView(page);
    assert.equal(await inPage(page, () => view.scene.renderer.getContext().isContextLost()), false);
    await inPage(page, () => view.dispose());
  });
});
