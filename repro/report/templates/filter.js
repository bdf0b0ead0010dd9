// Which numbers are shown, in which order of rows, and how much of each.
{
  const find = name => document.getElementById(name);
  const tools = find("tools");
  const boxes = [...tools.querySelectorAll("[name=verdict]")];
  const marked = find("only-marked");
  const order = find("row-order");
  const compact = find("compact");
  const judged = [...document.querySelectorAll("[data-verdict]")];
  const grids = [...document.querySelectorAll("table.grid.sortable")];
  const printed = new Map(grids.map(grid => [grid, [...grid.tBodies[0].rows]]));

  const filter = () => {
    const wanted = new Set(boxes.filter(box => box.checked).map(box => box.value));
    const isOff = ({ dataset }) =>
      !wanted.has(dataset.verdict) || (marked.checked && !("marked" in dataset));
    let count = 0;
    let rowsHidden = 0;
    for (const one of judged) {
      const off = isOff(one);
      count += !off;
      one.classList.toggle("off", off);
    }
    for (const row of [...printed.values()].flat()) {
      row.hidden = Boolean(row.querySelector(".cell.off") && !row.querySelector(".cell:not(.off)"));
      rowsHidden += row.hidden;
    }
    const hidden = judged.length - count;
    const rows = rowsHidden ? `, and ${rowsHidden} whole ${rowsHidden === 1 ? "row" : "rows"}` : "";
    find("shown-count").textContent = hidden
      ? `${count} of ${judged.length} numbers shown: the filter hides ${hidden}${rows}.`
      : `All ${judged.length} numbers shown.`;
    find("show-all").hidden = !hidden;
  };
  const arrange = () => {
    const kind = order.value;
    const count = row => row.querySelectorAll(`.cell.${kind}`).length;
    for (const [grid, rows] of printed) {
      const sorted = kind === "printed" ? rows : [...rows].sort((a, b) => count(b) - count(a));
      grid.tBodies[0].append(...sorted);
      for (const heading of grid.tHead.rows[0].cells) heading.removeAttribute("aria-sort");
    }
  };
  const press = () => document.body.classList.toggle("compact", compact.checked);
  const only = kind => {
    for (const box of boxes) box.checked = kind === undefined || box.value === kind;
    marked.checked = false;
    filter();
  };
  const showAll = () => {
    order.value = "printed";
    compact.checked = false;
    only();
    arrange();
    press();
  };

  tools.hidden = false;
  for (const box of [...boxes, marked]) box.addEventListener("change", filter);
  order.addEventListener("change", arrange);
  compact.addEventListener("change", press);
  find("show-all").addEventListener("click", showAll);
  // a link to a number that the filter hides shows everything again
  addEventListener("hashchange", () => {
    const target = find(decodeURIComponent(location.hash.slice(1)));
    if (target?.matches("[hidden], .off")) only();
  });
  // the index names a verdict in the address; a browser that comes back keeps what was ticked
  const asked = new URLSearchParams(location.search).get("only");
  if (boxes.some(box => box.value === asked)) only(asked);
  else filter();
  arrange();
  press();
}
