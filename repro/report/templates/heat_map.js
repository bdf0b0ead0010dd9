// The maps are one tab stop each: arrow keys move from square to square.
for (const map of document.querySelectorAll("table.heat")) {
  const rows = [...map.tBodies[0].rows].map(row => [...row.cells]);
  const squares = rows.flat().flatMap(cell => cell.querySelector("a") ?? []);
  const steps = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0] };
  for (const square of squares) square.title = square.ariaLabel;
  const reach = square => {
    for (const other of squares) other.tabIndex = other === square ? 0 : -1;
  };
  if (squares.length) reach(squares[0]);
  map.addEventListener("focusin", event => reach(event.target));
  map.addEventListener("keydown", event => {
    const step = steps[event.key];
    if (!step) return;
    event.preventDefault();
    const cell = event.target.closest("td");
    let [row, column] = [rows.findIndex(cells => cells.includes(cell)), cell.cellIndex];
    let next = null;
    do {
      row += step[0];
      column += step[1];
      next = rows[row]?.[column];
    } while (next && !next.querySelector("a"));
    next?.querySelector("a").focus();
  });
}
