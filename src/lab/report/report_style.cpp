#include "lab/report/report_style.h"

#include <fmt/format.h>

#include "lab/report/plot_looks.h"

namespace weft::lab {

namespace {

constexpr std::string_view light_page =
    "--text:#1f2328;--soft:#57606a;--link:#0a55b8;--rule:#d4d8dd;--tint:#f3f5f7;"
    "--answer:#eaf3ee;--answer-rule:#0d7756;--note:#fff4d6;--note-rule:#b88902;";
constexpr std::string_view dark_page =
    "--text:#e4e7eb;--soft:#a7b0ba;--link:#8db9ff;--rule:#363d46;--tint:#1d2229;"
    "--answer:#14291f;--answer-rule:#35b07e;--note:#2e2712;--note-rule:#ffd435;";

std::string variables(bool dark) {
    std::string text{dark ? dark_page : light_page};
    const auto of = [&](const PlotColour& colour) { return dark ? colour.dark : colour.light; };
    text += fmt::format("--page:{};--grid:{};", of(page_background), of(grid_colour));
    for (std::size_t n = 0; n < plot_colours().size(); ++n) {
        text += fmt::format("--line{}:{};", n, of(plot_colours()[n]));
    }
    return text;
}

constexpr std::string_view page_rules = R"css(
*{box-sizing:border-box}
html{color-scheme:light dark;scroll-padding-top:1rem;
  -webkit-text-size-adjust:100%;text-size-adjust:100%}
body{margin:0;background:var(--page);color:var(--text);
  font:1rem/1.6 system-ui,-apple-system,"Segoe UI",Roboto,"Noto Sans","Liberation Sans",sans-serif}
a{color:var(--link);text-underline-offset:.15em;text-decoration-thickness:.06em}
:focus-visible{outline:2px solid var(--link);outline-offset:2px;border-radius:2px}
.skip{position:absolute;left:-99rem}
.skip:focus{left:1rem;top:.5rem;background:var(--page);padding:.3rem .6rem;z-index:3}
main{min-width:0;width:100%;max-width:62rem;margin:0 auto;padding:2.5rem 1.25rem 4rem}
h1,h2,h3{line-height:1.2;text-wrap:balance;overflow-wrap:anywhere}
h1{font-size:clamp(1.75rem,1.2rem + 2.4vw,2.6rem);letter-spacing:-.02em;margin:.1em 0 .35em}
h2{font-size:1.6rem;letter-spacing:-.012em;margin:0 0 .5rem}
h3{font-size:1.15rem;margin:0 0 .75rem;padding-bottom:.3rem;border-bottom:1px solid var(--rule)}
p,ul,ol{max-width:70ch;margin:0 0 1rem;overflow-wrap:anywhere}
code,pre{font-family:ui-monospace,"SF Mono",Menlo,Consolas,"Liberation Mono",monospace;font-size:.9em}
code{background:var(--tint);border-radius:3px;padding:.08em .3em}
pre{background:var(--tint);border:1px solid var(--rule);border-radius:6px;padding:.7rem .9rem;
  margin:0 0 1rem;overflow-x:auto}
pre code{background:none;padding:0}
.kicker{font-size:.8rem;letter-spacing:.09em;text-transform:uppercase;color:var(--soft);margin:0}
.scene{font-size:1.1rem;color:var(--soft)}
.facts{list-style:none;padding:.9rem 1.1rem;max-width:none;background:var(--tint);border-radius:6px;
  font-size:.92rem}
.facts li+li{margin-top:.25rem}
.quick,.skipped,.answer{padding:.75rem 1rem;border-left:.3rem solid;border-radius:0 6px 6px 0}
.quick,.skipped{background:var(--note);border-color:var(--note-rule)}
.answer{background:var(--answer);border-color:var(--answer-rule);font-size:1.1rem;line-height:1.5;
  margin:1.5rem 0}
.answer code,.quick code,.skipped code{background:none;padding:0}
.question{font-size:1.15rem;font-style:italic;color:var(--soft);line-height:1.45}
.command-title{font-size:.85rem;color:var(--soft);margin-bottom:.3rem}
main>section{margin-top:3.5rem;padding-top:2rem;border-top:1px solid var(--rule)}
div+.command-title{margin-top:1.5rem}
#summary{border-top:0;margin-top:1.5rem;padding-top:0}
@media (prefers-reduced-motion:no-preference){html{scroll-behavior:smooth}}
footer{margin-top:4rem;font-size:.85rem;color:var(--soft)}
)css";

constexpr std::string_view nav_rules = R"css(
nav{padding:1.25rem;background:var(--tint);font-size:.92rem}
nav ol{list-style:none;margin:0;padding:0;columns:15rem}
nav a{display:block;padding:.28rem .6rem;border-left:.2rem solid transparent;text-decoration:none;
  color:var(--text)}
nav a:hover{text-decoration:underline}
nav a[aria-current]{border-color:var(--link);color:var(--link)}
.nav-title{font-size:.8rem;letter-spacing:.09em;text-transform:uppercase;color:var(--soft);
  margin:0 0 .4rem .8rem}
@media (min-width:72rem){
  body:not(.comparison){display:grid;grid-template-columns:15.5rem minmax(0,1fr)}
  body:not(.comparison) nav{padding:0}
  body:not(.comparison) nav>div{position:sticky;top:0;max-height:100vh;overflow-y:auto;
    padding:3rem 1.25rem}
  body:not(.comparison) nav ol{columns:auto}
}
.comparison main{max-width:112rem}
.beside>section+section{margin-top:2rem}
@media (min-width:64rem){
  .beside{display:grid;grid-template-columns:repeat(2,minmax(0,1fr));gap:2.25rem}
  .beside>section+section{margin-top:0}
}
)css";

constexpr std::string_view figure_rules = R"css(
figure,.table{margin:1.75rem 0}
.scroll{overflow-x:auto;max-width:100%;container-type:inline-size}
figcaption{font-size:.92rem;margin-top:.5rem}
figcaption p{max-width:75ch}
/* A caption stays where it is while its table scrolls. */
caption>span{display:block;position:sticky;left:0;width:min(75ch,100cqi)}
figcaption p{margin-bottom:.25rem}
.files{font-size:.82rem;color:var(--soft);margin:.2rem 0}
.files a{margin-right:.6rem}
details{font-size:.9rem;color:var(--soft)}
summary{cursor:pointer;width:max-content}
svg.plot{display:block;width:100%;min-width:40rem;height:auto;font-family:inherit}
.comparison svg.plot{min-width:30rem}
img,video{display:block;max-width:100%;height:auto;border-radius:4px}
img.wide{width:100%;min-width:40rem}
.comparison img.wide{min-width:30rem}
video{max-width:min(100%,60rem);background:#000}
table{border-collapse:collapse;font-size:.9rem;line-height:1.4;font-variant-numeric:tabular-nums}
caption{text-align:left;padding:0 0 .5rem;font-size:.92rem;line-height:1.5}
th,td{padding:.38rem .8rem .38rem 0;text-align:left;vertical-align:top}
td+td,th+th,th+td{padding-left:.4rem}
thead th{border-bottom:2px solid var(--rule);vertical-align:bottom;font-weight:600}
tbody tr{border-bottom:1px solid var(--rule)}
tbody th{font-weight:500}
.sortable tbody :is(th,td):not(.long){white-space:nowrap}
td.number,th.number{text-align:right}
td.number{white-space:nowrap}
td.long{min-width:14rem;max-width:34rem}
td sup{line-height:0;font-size:.75em}
.scroll>table:not(.summary) th:first-child{position:sticky;left:0;background:var(--page);z-index:1}
.summary{width:100%}
.summary th[scope=row]{min-width:9rem;max-width:14rem}
.summary td{min-width:14rem}
th button{font:inherit;color:inherit;background:none;border:0;padding:.1rem 0;margin:0;cursor:pointer;
  text-align:inherit}
th button::after{content:"\2195";color:var(--soft);font-weight:400;margin-left:.3em}
th[aria-sort=ascending] button::after{content:"\2191";color:var(--link)}
th[aria-sort=descending] button::after{content:"\2193";color:var(--link)}
@media (max-width:40rem){
  main{padding:1.5rem 1rem 3rem}
  .summary tr{display:block;padding:.6rem 0}
  .summary thead{position:absolute;left:-99rem}
  .comparison .summary td::before{content:attr(data-scene) ": ";font-weight:600}
  .summary th[scope=row],.summary td{display:block;max-width:none;min-width:0;padding:.1rem 0}
  .scroll>table:not(.summary) tbody th{max-width:9rem;white-space:normal}
}
)css";

constexpr std::string_view print_rules = R"css(
@page{margin:16mm}
html{color-scheme:light;scroll-behavior:auto}
body,body:not(.comparison){display:block;font-size:10pt;line-height:1.45}
nav,.skip,.files,details,th button::after{display:none!important}
main,.comparison main{max-width:none;padding:0}
main>section.experiment{break-before:page;border-top:0;margin-top:0;padding-top:0}
h2,h3,caption,.question{break-after:avoid}
figure,tr,.answer,pre{break-inside:avoid}
.scroll{overflow:visible;container-type:normal}
caption>span{width:auto}
svg.plot,.comparison svg.plot,img.wide,.comparison img.wide{min-width:0;max-height:22cm}
table{font-size:8pt}
th,td{padding-right:.5rem}
td.long,.summary td{min-width:0}
.sortable tbody :is(th,td){white-space:normal}
pre{white-space:pre-wrap;overflow-wrap:anywhere}
a{color:inherit;text-decoration:none}
)css";

}  // namespace

std::string page_style() {
    const std::string light = variables(false), dark = variables(true);
    std::string text =
        ":root{" + light + "}\n@media (prefers-color-scheme:dark){:root{" + dark + "}}";
    text += page_rules;
    text += nav_rules;
    text += figure_rules;
    text += "@media print{\n:root{" + light + "}";
    text += print_rules;
    return text + "}\n";
}

std::string_view page_script() {
    return R"js(
'use strict';
// A cell as what it sorts by: numbers before text, cells without a value last.
function keyOf(cell) {
  const value = cell.dataset.value;
  if (value !== undefined) {
    const number = Number(value.replace('inf', 'Infinity'));
    return Number.isNaN(number) ? [2, 0] : [0, number];
  }
  const text = cell.textContent.trim();
  return text === '' ? [2, 0] : [1, text];
}

function compare(a, b, direction) {
  if (a[0] !== b[0]) return a[0] - b[0];
  if (a[0] === 2) return 0;
  const order = a[0] === 1 ? a[1].localeCompare(b[1], 'en', { numeric: true })
                           : (a[1] > b[1]) - (a[1] < b[1]);
  return direction * order;
}

function sortBy(table, heads, column) {
  const head = heads[column], body = table.tBodies[0];
  const direction = head.getAttribute('aria-sort') === 'ascending' ? -1 : 1;
  heads.forEach((other) => other.removeAttribute('aria-sort'));
  head.setAttribute('aria-sort', direction > 0 ? 'ascending' : 'descending');
  const rows = [...body.rows].map((row) => ({ row, key: keyOf(row.cells[column]) }));
  rows.sort((a, b) => compare(a.key, b.key, direction));
  body.append(...rows.map(({ row }) => row));
}

for (const table of document.querySelectorAll('table.sortable')) {
  const heads = [...table.tHead.rows[0].cells];
  heads.forEach((head, column) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.title = 'Sort by this column';
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener('click', () => sortBy(table, heads, column));
  });
}

// The contents mark the section at the top of the window.
const links = new Map([...document.querySelectorAll('nav a')].map(
  (link) => [document.getElementById(link.hash.slice(1)), link]));
const seen = new IntersectionObserver((entries) => {
  for (const { target, isIntersecting } of entries) {
    if (!isIntersecting) continue;
    links.forEach((link) => link.removeAttribute('aria-current'));
    links.get(target).setAttribute('aria-current', 'true');
  }
}, { rootMargin: '-10% 0px -85% 0px' });
links.forEach((link, section) => seen.observe(section));
)js";
}

}  // namespace weft::lab
