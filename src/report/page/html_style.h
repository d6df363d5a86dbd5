#pragma once

#include <string_view>

namespace planish {

/// The style sheet of the report: quiet, for wide and narrow, light and dark screens and for paper.
inline constexpr std::string_view k_html_style = R"css(
:root {
  color-scheme: light dark;
  --page: #faf9f6; --card: #ffffff; --plate: #eef0f1; --ink: #1e1f21; --dim: #66676b;
  --rule: #e2e1dc; --better: #1b6e43; --worse: #a8411a; --blue: #0067a5; --orange: #c05000;
  --green: #007a5a; --purple: #9c3587; --olive: #7d6b00; --sky: #3d86c6; --brown: #7a4a28; --red: #c2183c;
  --ground: #dfe3e6; --paper: none;
  --shade: 0 1px 2px rgb(0 0 0 / 5%);
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --page: #16181b; --card: #1e2125; --plate: #272b30; --ink: #e9e8e4; --dim: #9fa2a8;
    --rule: #33373d; --better: #6fcf97; --worse: #f2a272; --blue: #6cb6f0; --orange: #f0a050;
    --green: #4fc9a4; --purple: #e391cf; --olive: #d8c552; --sky: #a9c8ff; --brown: #cfa884; --red: #ff8296;
    --ground: #272b30; --paper: #e3e5e7;
    --shade: none;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0; background: var(--page); color: var(--ink);
  font: 16px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", sans-serif;
  font-variant-numeric: tabular-nums;
}
main { max-width: 1280px; margin: 0 auto; padding: 28px 28px 28px; }
.brand { margin: 0; color: var(--dim); font-size: 13px; letter-spacing: .08em;
         text-transform: uppercase; }
h1 { margin: 2px 0 12px; font-size: 34px; line-height: 1.15; font-weight: 650;
     letter-spacing: -.015em; overflow-wrap: anywhere; }
h2 { margin: 0 0 4px; font-size: 17px; font-weight: 650; }
.verdict { margin: 0; max-width: 46em; font-size: 19px; line-height: 1.45; text-wrap: pretty; }
header { margin-bottom: 24px; }
.tiles { display: grid; grid-template-columns: repeat(4, 1fr); gap: 12px; margin: 22px 0; padding: 0; }
.tiles div, section { background: var(--card); border: 1px solid var(--rule); border-radius: 10px;
                      box-shadow: var(--shade); }
.tiles div { padding: 14px 18px; }
.tiles dt { color: var(--dim); font-size: 13px; }
.tiles dd { margin: 0; font-size: 23px; line-height: 1.25; font-weight: 600;
            letter-spacing: -.01em; }
.tiles dd small { display: block; color: var(--dim); font-size: 13px; font-weight: 400;
                  letter-spacing: 0; }
section { margin: 0 0 20px; padding: 20px 24px 22px; }
section > p { margin: 0 0 14px; max-width: 62em; color: var(--dim); font-size: 14px; }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 20px; }
.wide { display: grid; grid-template-columns: 1fr 1fr; gap: 20px; align-items: stretch; }
.wide section { min-width: 0; }
figure { margin: 0; }
figcaption { margin-top: 8px; color: var(--dim); font-size: 14px; }
figcaption b { color: var(--ink); font-weight: 600; }
.plate { padding: 6px; background: var(--plate); border-radius: 8px; }
.plate img { display: block; width: 100%; height: auto; }
svg.pattern { display: block; width: 100%; height: auto; max-height: 560px; }
.pattern path { vector-effect: non-scaling-stroke; }
#cut path { stroke: #d0201a; stroke-width: 1.6px; }
#bar path { stroke: var(--ink); stroke-width: 1.2px; }
.legend { max-width: 460px; margin: 16px auto 0; }
.legend svg { display: block; width: 100%; height: 12px; border-radius: 3px; }
.legend div { display: grid; grid-template-columns: 1fr auto 1fr; gap: 10px; margin-top: 4px;
              font-size: 13px; line-height: 1.3; color: var(--dim); }
.legend span:last-child { text-align: right; }
.legend b { color: var(--ink); font-weight: 600; white-space: nowrap; }
svg.chart { display: block; width: 100%; overflow: visible; height: auto; max-width: 620px; margin: 0 auto; }
.chart text { fill: var(--dim); font-size: 13px; }
.chart .point { font-size: 10.5px; }
.chart .grid { stroke: var(--rule); fill: none; }
.chart polyline { fill: none; stroke-width: 2.2; stroke-linejoin: round; stroke: var(--line); }
.chart text[class^="line"] { fill: var(--line); font-weight: 600; }
.line-e-max { --line: var(--orange); }
.line-e-avg { --line: var(--blue); }
.line-energy { --line: var(--ink); }
polyline.line-e-avg { stroke-dasharray: 9 5; }
polyline.line-energy { stroke-dasharray: 2 4; stroke-linecap: round; }
.chart circle { fill: var(--line); }
.chart .leader { stroke: var(--line); stroke-width: .8; opacity: .55; fill: none; }
.line-0 { --line: var(--ink); }
.line-1 { --line: var(--blue); }
.line-2 { --line: var(--orange); }
.line-3 { --line: var(--green); }
.line-4 { --line: var(--purple); }
.line-5 { --line: var(--olive); }
.line-6 { --line: var(--sky); }
.line-7 { --line: var(--brown); }
.line-8 { --line: var(--red); }
polyline.line-1 { stroke-dasharray: 9 5; }
polyline.line-2 { stroke-dasharray: 2 4; stroke-linecap: round; }
polyline.line-3 { stroke-dasharray: 10 4 2 4; }
polyline.line-4 { stroke-dasharray: 5 3; }
polyline.line-5 { stroke-dasharray: 16 4; }
polyline.line-6 { stroke-dasharray: 8 3 2 3 2 3; }
polyline.line-7 { stroke-dasharray: 1 3; }
polyline.line-8 { stroke-width: 3; }
.charts { display: grid; grid-template-columns: 1fr 1fr; gap: 18px 20px; }
.charts figcaption { text-align: center; margin-top: 0; }
svg.swatch { width: 36px; height: 8px; margin-right: 9px; vertical-align: middle; }
.swatch polyline { fill: none; stroke: var(--line); stroke-width: 2.6; }
.cards { display: grid; grid-template-columns: 1fr 1fr; gap: 0 20px; }
.cards section { min-width: 0; }
.cards .pair { align-items: end; }
.cards .plate { background: var(--ground); }
.key { list-style: none; margin: 10px 0 0; padding: 0; font-size: 14px; }
.key svg { width: 13px; height: 13px; margin-right: 8px; vertical-align: -1px;
           outline: 1px solid var(--dim); outline-offset: -1px; }
.scroll { overflow-x: auto; }
table { width: 100%; border-collapse: collapse; font-size: 15px; }
th, td { padding: 7px 0 7px 20px; text-align: right; vertical-align: baseline;
         border-bottom: 1px solid var(--rule); }
td { white-space: nowrap; }
th:first-child { padding-left: 0; text-align: left; font-weight: 500; }
th small { display: block; color: var(--dim); font-size: 13px; line-height: 1.35;
           font-weight: 400; }
thead th { color: var(--dim); font-size: 13px; font-weight: 500; }
tbody tr:last-child > * { border-bottom: 0; }
th[scope="rowgroup"] { padding-top: 22px; font-weight: 650; }
td:nth-child(3) { font-weight: 600; }
.better { color: var(--better); }
.worse { color: var(--worse); }
.same { color: var(--dim); }
td b { font-weight: 600; }
.compare { font-size: 13px; }
.compare th, .compare td { padding-left: 9px; white-space: nowrap; }
.compare th:first-child { padding-left: 0; }
.compare thead th { font-size: 12px; line-height: 1.3; white-space: normal; vertical-align: bottom; }
.compare th small { display: block; font-size: inherit; }
.compare td:nth-child(3) { font-weight: inherit; }
.compare .input > * { color: var(--dim); }
.compare .failed { text-align: left; color: var(--worse); white-space: normal; }
.best span { color: var(--better); }
.problems { margin: 8px 0 0; padding-left: 20px; }
.problems code { color: var(--worse); font-size: 14px; }
.run { display: grid; grid-template-columns: max-content 1fr; gap: 3px 16px; margin: 18px 0 0;
       padding-top: 14px; border-top: 1px solid var(--rule); font-size: 13px; }
.run dt { color: var(--dim); }
.run dd { margin: 0; overflow-wrap: anywhere; }
footer { color: var(--dim); font-size: 13px; }
@media screen and (max-width: 760px) {
  main { padding: 24px 14px; }
  h1 { font-size: 27px; }
  .verdict { font-size: 17px; }
  .tiles { grid-template-columns: 1fr 1fr; }
  .tiles div { padding: 11px 13px; }
  .tiles dd { font-size: 21px; }
  .pair, .wide, .charts, .cards { grid-template-columns: minmax(0, 1fr); }
  .cards .pair { grid-template-columns: 1fr 1fr; gap: 10px; }
  .wide { gap: 0; }
  section { padding: 16px; }
  table { font-size: 13.5px; line-height: 1.35; }
  th, td { padding-left: 10px; }
  td { white-space: normal; }
  th small { font-size: 12px; }
  section > .scroll > table:not(.compare) th:first-child { width: 42%; }
}
@page { size: A4; margin: 14mm; }
@media print {
  body { background: none; font-size: 10.5pt; }
  main { max-width: none; padding: 0; }
  section, .tiles div { border: 0; border-top: 1px solid var(--rule); border-radius: 0;
                        padding: 10px 0; box-shadow: none; }
  figure, section.keep, tr, .tiles { break-inside: avoid; }
  .plate, .legend svg, .pattern { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  .tiles { margin: 14px 0; }
  .tiles dd { font-size: 14pt; }
  table { font-size: 9.5pt; }
  th, td { padding-top: 3px; padding-bottom: 3px; }
  .scroll { overflow: visible; }
  .compare, .compare thead th { font-size: 6.4pt; }
  .compare th, .compare td { padding-left: 4px; }
  .compare .swatch { width: 20px; margin-right: 4px; }
}
)css";

}  // namespace planish
