// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/report_parts.hpp"
#include "drawing/style.hpp"

namespace lanefuse {
namespace {

constexpr const char* kPage = R"(
:root{--paper:#fff;--text:#1f2933;--muted:#5f6b7a;--line:#dde3ea;--soft:#f5f7fa;--accent:#0072b2;--warn:#8a5200;--warn-soft:#fff4df}
@media(prefers-color-scheme:dark){:root{--paper:#14181f;--text:#e4e7eb;--muted:#9aa5b4;--line:#2b323c;--soft:#1b212a;--accent:#56b4e9;--warn:#ffcf85;--warn-soft:#33270f}}
*{box-sizing:border-box}
html{color-scheme:light dark}
body{margin:0;background:var(--paper);color:var(--text);font:15px/1.55 system-ui,-apple-system,'Segoe UI','Helvetica Neue',Arial,sans-serif}
main{max-width:1200px;margin:0 auto;padding:36px 28px 60px}
h1{font-size:27px;line-height:1.2;margin:0 0 4px}
h2{font-size:18px;margin:42px 0 12px;padding-top:14px;border-top:1px solid var(--line)}
.drive{color:var(--muted);margin:0 0 14px}
.witness{display:inline-block;margin:0 0 16px;padding:3px 11px;border-radius:5px;border:1px solid var(--line);background:var(--soft);font-size:14px}
.witness.other{background:var(--warn-soft);border-color:var(--warn);color:var(--warn)}
.verdict{font-size:18px;line-height:1.5;margin:0 0 24px;padding-left:14px;border-left:4px solid var(--accent);max-width:62em}
.tiles{display:grid;grid-template-columns:repeat(auto-fill,minmax(145px,1fr));gap:10px;margin:0;padding:0}
.tiles div{background:var(--soft);border-radius:6px;padding:9px 13px}
.tiles dt{color:var(--muted);font-size:13px}
.tiles dd{margin:0;font-size:18px;font-weight:600;font-variant-numeric:tabular-nums}
.tiles small{display:block;font-weight:400;font-size:13px;color:var(--muted)}
.charts{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,460px),1fr));gap:22px}
.figure{display:block;width:100%;height:auto}
figure{margin:0 0 26px}
figcaption{color:var(--muted);font-size:14px;max-width:72em;margin-top:2px}
.scroll{overflow-x:auto}
table{border-collapse:collapse;font-variant-numeric:tabular-nums;font-size:14px;width:100%;margin-top:14px}
th,td{text-align:right;padding:4px 10px;white-space:nowrap}
th{font-weight:600;color:var(--muted)}
th.group{text-align:center;color:var(--text);border-bottom:2px solid var(--line)}
th.group:first-child{border:0}
thead tr:last-child th{border-bottom:1px solid var(--muted)}
tbody tr:nth-child(odd){background:var(--soft)}
.first{padding-left:26px}
td:first-child{font-weight:600}
.glossary{color:var(--muted);font-size:14px;max-width:80em}
.glossary b{color:var(--text)}
@media print{main{max-width:none;padding:0}figure,table{break-inside:avoid}}
)";

}  // namespace

std::string report_css() { return kPage + figure_css(); }

}  // namespace lanefuse
