#pragma once

#include <string_view>

namespace planish {

/// The style of the part of a page where the patch stands beside its pattern, of the marks of
/// limits and of what the page's script adds.
inline constexpr std::string_view k_html_viewer_style = R"css(
.title { display: flex; flex-wrap: wrap; gap: 2px 14px; align-items: baseline; margin-bottom: 14px; }
.title h1 { margin: 0; font-size: 17px; font-weight: 600; line-height: 1.4; letter-spacing: 0; }
.verdict { max-width: 72em; font-size: 17px; }
.verdict b { display: block; margin-bottom: 6px; font-size: 29px; line-height: 1.2; font-weight: 650;
             letter-spacing: -.015em; }
.checks { display: flex; flex-wrap: wrap; gap: 8px; list-style: none; margin: 14px 0 0; padding: 0;
          font-size: 14px; }
.checks li { padding: 3px 12px 3px 10px; border: 1px solid var(--rule); border-radius: 999px;
             background: var(--card); }
.met { color: var(--better); }
.missed { color: var(--worse); font-weight: 600; }
.tiles .met, .tiles .missed { display: block; margin-top: 3px; font-size: 13px; line-height: 1.4;
                              letter-spacing: 0; font-weight: 500; }
.bench { display: grid; grid-template-columns: minmax(0, 1.45fr) minmax(0, 1fr); gap: 16px 32px;
         padding: 18px 24px 20px; }
.bench.solo { grid-template-columns: minmax(0, 1fr); }
.bench > .terms { grid-column: 1 / -1; }
.bench > div { display: flex; flex-direction: column; min-width: 0; }
h3 { margin: 0 0 12px; font-size: 17px; font-weight: 650; line-height: 1.35; }
h3 small { margin-left: 6px; color: var(--dim); font-size: 13px; font-weight: 400; }
.sheet { flex: 1; display: flex; align-items: center; justify-content: center; min-height: 260px; }
.sheet svg.pattern { max-height: 620px; }
.sheet { border-radius: 8px; background: var(--paper); }
.pattern #bar path { stroke: #1e1f21; }
.pattern #seam path { stroke: #1e1f21; stroke-width: 1px; stroke-dasharray: 5 3; }
.pattern #notch path, .pattern #drill path { stroke: #8a1f8a; stroke-width: 1.4px; }
.pattern #grain path { stroke: #0a6b3d; stroke-width: 1.4px; }
.pattern #internal path { stroke: #00707a; stroke-width: 1.2px; }
.pattern #directions path { stroke: #23262a; stroke-width: .9px; stroke-linecap: round; opacity: .8; }
.lines { display: flex; flex-wrap: wrap; gap: 4px 18px; list-style: none; margin: 14px 0 0;
         padding: 0; font-size: 13px; color: var(--dim); }
.lines li, .lines label { display: inline-flex; align-items: center; gap: 7px; }
.lines label { cursor: pointer; min-height: 26px; }
.lines input { margin: 0; width: 15px; height: 15px; accent-color: var(--ink); }
.lines svg { width: 24px; height: 8px; overflow: visible; }
.lines path { fill: none; stroke: var(--ink); stroke-width: 1.6; }
.lines .key-cut path { stroke: #d0201a; }
.lines .key-seam path { stroke-dasharray: 5 3; }
.lines .key-notch path, .lines .key-drill path { stroke: var(--purple); }
.lines .key-grain path { stroke: var(--better); }
.lines .key-internal path { stroke: var(--green); }
.lines .key-strain path { stroke: #d69081; stroke-width: 8; }
.flat .legend { width: 100%; margin-top: 12px; }
.terms { font-size: 14px; color: var(--dim); }
.terms summary { cursor: pointer; width: fit-content; font-size: 13px; text-decoration: underline dotted;
                 text-underline-offset: 4px; }
.terms summary:hover { color: var(--ink); }
.terms dl { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: 4px 16px;
            margin: 10px 0 0; max-width: 62em; }
.terms dt { color: var(--ink); }
.terms dd { margin: 0; }
.note { margin: 14px 0 0; color: var(--dim); font-size: 13px; }
.bar-before { fill: var(--dim); opacity: .45; }
.bar-after { fill: var(--blue); }
.chart .bound { stroke: var(--better); stroke-width: 1.4; stroke-dasharray: 5 4; fill: none; }
.line-reference { --line: #9a9a96; }
section > svg.chart + .terms { margin-top: 12px; }
.run code { font-size: 13px; overflow-wrap: anywhere; }
:focus-visible { outline: 2px solid var(--blue); outline-offset: 2px; }
.unseen { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
.tools { display: flex; flex-wrap: wrap; gap: 10px 14px; align-items: center; margin-bottom: 12px; }
.choice { display: flex; margin: 0; padding: 2px; border: 1px solid var(--rule); border-radius: 9px;
          background: var(--plate); }
.choice label { position: relative; }
.choice input { position: absolute; inset: 0; margin: 0; opacity: 0; cursor: pointer; }
.choice span { display: block; padding: 5px 12px; border-radius: 7px; font-size: 14px; line-height: 1.5;
               color: var(--dim); }
.choice label:hover span { color: var(--ink); }
.choice input:checked + span { background: var(--card); color: var(--ink); font-weight: 600;
                               box-shadow: 0 1px 3px rgb(0 0 0 / 14%); }
.choice input:focus-visible + span { outline: 2px solid var(--blue); outline-offset: 1px; }
.actions { display: flex; gap: 8px; margin-left: auto; }
#stage button, #stage select { font: inherit; font-size: 13px; line-height: 1.5; color: var(--ink);
  padding: 5px 11px; border: 1px solid var(--rule); border-radius: 8px; background: var(--card);
  cursor: pointer; }
#stage button:hover { border-color: var(--dim); }
#stage { display: none; }
.view { position: relative; height: clamp(300px, 60vh, 600px); overflow: hidden; border-radius: 8px;
        background: var(--ground); }
.view canvas { display: block; width: 100%; height: 100%; touch-action: pan-y; cursor: grab;
               outline-offset: -3px; }
.view canvas:active { cursor: grabbing; }
.split-line { position: absolute; inset: 0 auto 0 var(--split); width: 2px; margin-left: -1px;
              background: var(--ink); pointer-events: none; }
.split { position: absolute; left: -22px; bottom: 10px; width: calc(100% + 44px); height: 44px;
         margin: 0; appearance: none; background: none; pointer-events: none; }
.split:focus-visible { outline: none; }
.split::-webkit-slider-thumb { appearance: none; width: 44px; height: 44px; border-radius: 50%;
  border: 0; pointer-events: auto; cursor: ew-resize; background:
    linear-gradient(var(--card) 0 0) 18px 50% / 2px 14px no-repeat,
    linear-gradient(var(--card) 0 0) 24px 50% / 2px 14px no-repeat, var(--ink); }
.split::-moz-range-thumb { width: 44px; height: 44px; border-radius: 50%; border: 0;
  pointer-events: auto; cursor: ew-resize; background:
    linear-gradient(var(--card) 0 0) 18px 50% / 2px 14px no-repeat,
    linear-gradient(var(--card) 0 0) 24px 50% / 2px 14px no-repeat, var(--ink); }
.split::-webkit-slider-runnable-track { background: none; }
.split:focus-visible::-webkit-slider-thumb { box-shadow: 0 0 0 3px var(--card), 0 0 0 5px var(--blue); }
.split:focus-visible::-moz-range-thumb { box-shadow: 0 0 0 3px var(--card), 0 0 0 5px var(--blue); }
.tag { position: absolute; top: 12px; padding: 2px 11px; border-radius: 999px; background: var(--ink);
       color: var(--card); font-size: 13px; pointer-events: none; }
.tag.before { left: 12px; }
.tag.after { right: 12px; }
.only-after .tag.before, .only-before .tag.after { visibility: hidden; }
.spot { position: absolute; top: -8px; left: -8px; width: 16px; height: 16px; border-radius: 50%;
        border: 2px solid #fff; outline: 2px solid #111; pointer-events: none; }
.mark circle { fill: none; vector-effect: non-scaling-stroke; }
.mark .halo { stroke: #fff; stroke-width: 5px; }
.mark .ring { stroke: #111; stroke-width: 2px; }
.flat svg.pattern { cursor: crosshair; touch-action: manipulation; }
.scale { display: grid; grid-template-columns: auto minmax(0, 1fr) auto; gap: 0 12px; align-items: start;
         margin-top: 12px; }
.scale .bar { height: 12px; margin-top: 4px; border-radius: 3px; }
.scale .labels { display: grid; grid-template-columns: 1fr auto 1fr; gap: 10px; margin-top: 4px;
                 font-size: 13px; line-height: 1.3; color: var(--dim); }
.scale .labels span:last-child { text-align: right; }
#stage .scale button { width: 30px; height: 30px; padding: 0; font-size: 17px; line-height: 1; }
.readout { margin-top: 8px; }
.readout table { font-size: 14px; table-layout: fixed; }
.readout th, .readout td { padding: 4px 0 4px 12px; }
.readout th:first-child { width: 26%; }
.readout thead th { padding-top: 6px; }
.readout td:nth-child(3) { font-weight: 600; }
.readout.empty td { color: var(--dim); font-weight: 400; }
.readout.empty th b { color: var(--dim); font-weight: 400; }
.readout th b { color: var(--ink); font-size: 14px; }
.hint { margin: 10px 0 0; color: var(--dim); font-size: 13px; }
.bench.solo { display: none; }
@media screen {
  .live .bench.solo { display: grid; }
  .live #stage { display: flex; flex-direction: column; flex: 1; }
  .live .view { flex: 1; min-height: 300px; }
  .live .still { display: none; }
}
@media screen and (max-width: 900px) {
  .bench { grid-template-columns: minmax(0, 1fr); padding: 16px; }
  .live .view { flex: none; height: 62vh; max-height: 460px; }
}
@media screen and (max-width: 760px) {
  .verdict b { font-size: 22px; }
  .verdict { font-size: 16px; }
  .choice { width: 100%; }
  .choice label { flex: 1 1 auto; text-align: center; }
  .choice span { padding: 7px 4px; font-size: 13px; }
  .actions { margin-left: 0; }
  #stage button { min-height: 36px; }
  #stage .scale button { width: 36px; height: 36px; }
  .lines label { min-height: 34px; }
  .terms dl { grid-template-columns: minmax(0, 1fr); gap: 2px; }
  .terms dd { margin-bottom: 8px; }
  .chart text { font-size: 15.5px; }
  .readout th:first-child { width: 34%; }
}
@media print {
  .bench:not(.solo) { display: block; padding: 10px 0; }
  .flat { margin-top: 10px; }
  .sheet svg.pattern { max-height: 110mm; }
  .lines input, .terms, .note { display: none; }
  .checks { font-size: 9.5pt; margin-top: 8px; }
  .verdict b { font-size: 15pt; }
  .bar-before, .bar-after, .lines svg { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)css";

/// What a page has beside that where strain is shown beside its limit: more to choose from, a scale
/// with a field apart.
inline constexpr std::string_view k_html_limit_style = R"css(
.choice { flex-wrap: wrap; }
.choice span { padding: 5px 6px; }
.scale.bounded .labels { grid-template-columns: 3fr 4fr 3fr 3fr; gap: 0; }
.scale.bounded .labels span { text-align: right; }
.scale.bounded .labels span:first-child { text-align: left; }
.scale.bounded .labels span:nth-child(2) { text-align: center; }
.scale.bounded button { visibility: hidden; }
.legend.bounded div { grid-template-columns: 3fr 4fr 3fr 3fr; gap: 0; }
.legend.bounded span { text-align: right; }
.legend.bounded span:first-child { text-align: left; }
.legend.bounded span:nth-child(2) { text-align: center; }
)css";

}  // namespace planish
