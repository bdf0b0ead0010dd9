"""What a test asks a page itself: scripts that run in it and return what is wrong."""

REPEATED = """() => {
  const names = [...document.querySelectorAll("[id]")].map(each => each.id);
  return names.filter((name, place) => names.indexOf(name) !== place);
}"""
DANGLING = """() => [...document.querySelectorAll('a[href*="#"]')]
  .filter(link => link.pathname === location.pathname && link.hash.length > 1)
  .filter(link => !document.getElementById(decodeURIComponent(link.hash.slice(1))))
  .map(link => link.hash)"""
WIDE = """() => [...document.querySelectorAll("body *")]
  .filter(each => each.getBoundingClientRect().right > document.documentElement.clientWidth + 1)
  .filter(each => !each.closest(".wrap") && !each.closest("pre") && !each.closest("svg"))
  .map(each => each.outerHTML.slice(0, 80))"""
# WCAG 2: (lighter + 0.05) / (darker + 0.05) of the relative luminances
FAINT = """() => {
  const channels = colour => colour.match(/[\\d.]+/g).map(Number);
  const linear = part => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  const luminance = ([r, g, b]) =>
    0.2126 * linear(r / 255) + 0.7152 * linear(g / 255) + 0.0722 * linear(b / 255);
  const page = luminance(channels(getComputedStyle(document.body).backgroundColor));
  return [...document.querySelectorAll("svg text")].flatMap(text => {
    const ink = luminance(channels(getComputedStyle(text).fill));
    const contrast = (Math.max(ink, page) + 0.05) / (Math.min(ink, page) + 0.05);
    return contrast < 4.5 ? [`${text.textContent}: ${contrast.toFixed(2)}`] : [];
  });
}"""
LETTERS = """() => [...document.querySelectorAll("figure svg text")]
  .map(text => {
    const { a, b } = text.getScreenCTM();
    return Math.hypot(a, b) * parseFloat(getComputedStyle(text).fontSize);
  })"""

# verdicts and explanations are never beyond the edge, not even in a frame that scrolls
BEYOND = """() => [...document.querySelectorAll(".verdict, .prose td, .cell td, dd, .reasons p")]
  .filter(each => each.offsetParent && !each.closest("table.heat"))
  .filter(each => each.getBoundingClientRect().right > document.documentElement.clientWidth + 1)
  .map(each => each.outerHTML.slice(0, 80))"""
# tab stops before the first number of a table, past a skip link where that is nearer
STOPS = """() => {
  const seen = each => each.checkVisibility({ visibilityProperty: true });
  const first = [...document.querySelectorAll("main td")]
    .find(cell => seen(cell) && /\\d|=|\\+|−/.test(cell.textContent));
  if (!first) return 0;
  const kinds = "a[href], button, input, select, summary, canvas, [tabindex]";
  const stops = [...document.querySelectorAll(kinds)]
    .filter(each => each.tabIndex >= 0 && seen(each) && !first.contains(each));
  const follows = (each, other) =>
    each.compareDocumentPosition(other) & Node.DOCUMENT_POSITION_FOLLOWING;
  const between = from => stops
    .filter(each => follows(each, first) && (!from || follows(from, each))).length;
  const skips = [...document.querySelectorAll("a.skip")]
    .map((skip, k) => [k + 1, document.querySelector(skip.hash)])
    .filter(([, place]) => follows(place, first));
  return Math.min(between(null), ...skips.map(([k, place]) => k + between(place)));
}"""
# WCAG 2.2, 1.4.11: whatever a line or mark says stands out by 3 to 1; grids and bands say nothing
FAINT_MARKS = """() => {
  const channels = colour => colour.match(/[\\d.]+/g).map(Number);
  const linear = part => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  const luminance = rgb => rgb.map(part => linear(part / 255))
    .reduce((sum, part, k) => sum + part * [0.2126, 0.7152, 0.0722][k], 0);
  const page = channels(getComputedStyle(document.body).backgroundColor).slice(0, 3);
  const faint = new Set();
  for (const mark of document.querySelectorAll("figure svg path, figure svg use")) {
    const { stroke, strokeOpacity, opacity, strokeWidth } = getComputedStyle(mark);
    const clear = Number(strokeOpacity) * Number(opacity);
    if (stroke === "none" || parseFloat(strokeWidth) === 0 || clear < 0.5) continue;
    const ink = channels(stroke).slice(0, 3).map((part, k) => part * clear + page[k] * (1 - clear));
    const [a, b] = [luminance(ink), luminance(page)];
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (contrast < 3) faint.add(`${stroke} at ${clear}: ${contrast.toFixed(2)}`);
  }
  return [...faint];
}"""
# headings of what has a unit, without one
UNITLESS = """() => {
  const quantity = /\\b(time|duration|velocity|speed|acceleration|jerk|angle|length)s?\\b/i;
  return [...document.querySelectorAll("main thead th")].map(each => each.textContent)
    .filter(text => quantity.test(text) && !/\\[.+\\]/.test(text));
}"""
# the lines of cells on a phone begin right of their names, or below them
UNDER_NAMES = """() => {
  const under = cell => {
    const all = document.createRange();
    all.selectNodeContents(cell);
    const lines = [...all.getClientRects()].filter(line => line.width);
    return lines.some(line => line.left < cell.getBoundingClientRect().left + 90);
  };
  return [...document.querySelectorAll(".stacked:not(.prose) td[data-name]")].filter(under)
    .map(cell => cell.outerHTML.slice(0, 80));
}"""
# axe parses each colour anew for every element, for a third of its time: here, each colour once
PARSED_ONCE = """() => {
  const colour = axe.commons.color.Color.prototype;
  const { parseString } = colour;
  const known = new Map();
  colour.parseString = function (text) {
    if (!known.has(text)) {
      const { r, g, b, alpha } = parseString.call(this, text);
      known.set(text, { r, g, b, alpha });
    }
    return Object.assign(this, known.get(text));
  };
}"""
