// Headings that sort: up, down, then as printed again.
for (const table of document.querySelectorAll("table.sortable")) {
  const body = table.tBodies[0];
  const printed = [...body.rows];
  const { compare } = new Intl.Collator("en", { numeric: true });
  const headings = [...table.tHead.rows[0].cells];
  const keyOf = (row, column) => {
    const cell = row.cells[column];
    return cell.dataset.sort ?? cell.textContent.trim();
  };
  const ordered = (column, sign) => [...printed].sort((a, b) => {
    const [first, second] = [keyOf(a, column), keyOf(b, column)];
    const gap = Number(first) - Number(second);
    return sign * (Number.isNaN(gap) ? compare(first, second) : gap);
  });
  // one tab stop for all headings: arrow keys move between them
  const reach = button => {
    for (const other of headings) other.querySelector("button").tabIndex = -1;
    button.tabIndex = 0;
  };
  headings.forEach((heading, column) => {
    const button = document.createElement("button");
    button.className = "sort";
    button.tabIndex = column ? -1 : 0;
    button.addEventListener("focus", () => reach(button));
    button.addEventListener("keydown", event => {
      const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      const next = step && headings[column + step];
      if (!next) return;
      event.preventDefault();
      next.querySelector("button").focus();
    });
    button.append(...heading.childNodes);
    heading.append(button);
    button.addEventListener("click", () => {
      const next = { ascending: "descending", descending: null }[heading.ariaSort];
      const order = next === undefined ? "ascending" : next;
      for (const other of headings) other.removeAttribute("aria-sort");
      if (order) heading.setAttribute("aria-sort", order);
      body.append(...(order ? ordered(column, order === "ascending" ? 1 : -1) : printed));
    });
  });
}
