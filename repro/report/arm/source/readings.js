// What is told of an instant: a table of the joints' angles, and a line for each motion.
import { told } from "./clock.js";

export class Readings {
  constructor(table, list, { motions, names, limits }) {
    Object.assign(this, { list, motions, limits });
    const cell = (row, kind, text) => row.appendChild(Object.assign(document.createElement(kind), { textContent: text }));
    const known = motions.filter(motion => motion.angles.length);
    table.hidden = !known.length;
    const head = table.createTHead().insertRow();
    cell(head, "th", "joint").scope = "col";
    for (const { name } of motions) cell(head, "th", name).scope = "col";
    const body = table.createTBody();
    this.cells = names.map(name => {
      const row = body.insertRow();
      cell(row, "th", name).scope = "row";
      return motions.map(() => cell(row, "td", ""));
    });
  }

  // Show the robots at an instant; return the lines as one text.
  show(robots, now) {
    const lines = robots.map((robot, m) => {
      const { angles, nearest } = robot.reads(now);
      angles.forEach((angle, k) => {
        const cell = this.cells[k][m], binds = nearest && nearest[0] % angles.length === k;
        cell.textContent = angle.toFixed(1).replace("-", "\u2212");
        cell.classList.toggle("arm-binds", Boolean(binds) && nearest[1] > 0);
      });
      const parts = [progress(this.motions[m], now), height(robot)];
      if (nearest && nearest[1] > 0) parts.push(`nearest limit: ${this.limits[nearest[0]]}, ${nearest[1]} %`);
      return `${this.motions[m].name}: ${parts.filter(Boolean).join("; ")}`;
    });
    this.list.replaceChildren(...lines.map(line => Object.assign(document.createElement("li"), { textContent: line })));
    return lines.join(". ");
  }
}

function height({ height, lowest }) {
  const below = metres => `${Math.round(-1000 * metres)} mm below the base plane`;
  if (height < -5e-4) return `tool ${below(height)}`;
  return lowest < -5e-4 ? `lowest link ${below(lowest)}` : "";
}

function progress(motion, now) {
  let end = 0;
  for (const [k, duration] of motion.durations.entries()) {
    end += duration;
    if (now < end) return motion.durations.length > 1 ? `segment ${k + 1} of ${motion.durations.length}` : "on its way";
  }
  return `arrived at ${told(end, end)}`;
}
