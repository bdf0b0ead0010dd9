// The page where a table is pasted. All that was pasted is shown as text, never as markup.

const EXAMPLE = `Table 1: Results of 30 runs (made up)
Function,Statistic,WOA,PSO
F1,Best,1.20E-03,4.10E+00
F1,Mean,2.50E-03,5.00E+00
F1,Worst,4.00E-03,6.20E+00
F1,Std,9.00E-04,3.00E+00
`;
const GRAVITY = ["noted", "inconsistent", "impossible"];
const byId = (id) => document.getElementById(id);

// a worker from a blob keeps to the page's policy, so that it reaches this server alone
const script = JSON.stringify(new URL("audit_worker.js", import.meta.url).href);
const blob = new Blob([`import ${script};`], { type: "text/javascript" });
const worker = new Worker(URL.createObjectURL(blob), { type: "module" });

function node(name, text = "", attributes = {}) {
  const made = document.createElement(name);
  made.textContent = text;
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

function listed(name, items) {
  const list = node(name);
  list.append(...items);
  return list;
}

function chosen() {
  const fields = [...new FormData(byId("asked"))].filter(([, value]) => value.trim());
  return Object.fromEntries(fields.map(([name, value]) => [name, value.trim()]));
}

function gravest(marks) {
  return marks.reduce((one, other) =>
    GRAVITY.indexOf(other.grade) > GRAVITY.indexOf(one.grade) ? other : one,
  ).grade;
}

function printed(table, prefix) {
  const marks = new Map();
  table.rows.forEach((row, number) =>
    row.at.forEach((place) => {
      const key = String(place);
      marks.set(key, [...(marks.get(key) ?? []), { grade: row.grade, number }]);
    }),
  );
  const lines = table.grid.map((line, k) => {
    const cells = line.map((text, column) => {
      const cell = node("td", text);
      const here = marks.get(String([k, column]));
      if (!here) return cell;
      cell.className = gravest(here);
      for (const { number } of here) {
        cell.append(" ", node("a", `[${number + 1}]`, { href: `#${prefix}-${number + 1}` }));
      }
      return cell;
    });
    return listed("tr", cells);
  });
  const wide = node("div", "", { class: "wide", tabindex: "0", role: "region", "aria-label": "the table as read" });
  wide.append(listed("table", lines));
  return wide;
}

function said(row, number, prefix) {
  const condition = row.condition ? `; holds if ${row.condition}` : "";
  const where = [row.row, row.column].filter(Boolean).join(", ");
  const item = node("li", "", { id: `${prefix}-${number + 1}` });
  item.append(node("strong", row.grade), ` ${where}: ${row.explanation}${condition}`);
  return item;
}

function paragraph(text) {
  const box = node("div");
  const shown = node("pre", text);
  const copy = node("button", "Copy", { type: "button" });
  copy.addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(text);
      byId("state").textContent = "Copied.";
    } catch {
      getSelection().selectAllChildren(shown);
      byId("state").textContent = "Selected: copy it with the keyboard.";
    }
  });
  box.append(shown, copy);
  return box;
}

function guessed(guess) {
  const item = node("li", guess.says);
  const control = guess.option && byId("asked").elements[guess.option];
  if (!control) return item;
  const menu = control.cloneNode(true);
  menu.value = control.value;
  menu.setAttribute("aria-label", `instead of: ${guess.says}`);
  menu.addEventListener("change", () => {
    control.value = menu.value;
    byId("asked").requestSubmit();
  });
  item.append(" ", menu);
  return item;
}

function section(table, k) {
  const prefix = `table-${k + 1}`;
  const part = node("section", "", { "aria-label": table.label });
  part.append(node("h2", table.label), paragraph(table.paragraph));
  part.append(node("h3", "As it was read"), listed("ul", table.guesses.map(guessed)));
  part.append(printed(table, prefix));
  if (table.rows.length) {
    part.append(node("h3", "What it says about itself"));
    part.append(listed("ol", table.rows.map((row, number) => said(row, number, prefix))));
  }
  if (table.read.skipped.length) {
    part.append(node("h3", "What was skipped"));
    part.append(
      listed("ul", table.read.skipped.map((one) => node("li", `${one.text} (${one.where}): ${one.because}`))),
    );
  }
  return part;
}

function show(answer) {
  byId("answer").replaceChildren(...answer.tables.map(section));
  byId("state").textContent = answer.error ?? `Read: ${answer.tables.length === 1 ? "1 table" : `${answer.tables.length} tables`}.`;
}

worker.addEventListener("message", ({ data }) => {
  byId("audit").disabled = Boolean(data.broken);
  if (data.broken) byId("state").textContent = `It does not work here: ${data.broken}`;
  else if (data.answer) show(data.answer);
  else byId("state").textContent = "Ready.";
});
worker.addEventListener("error", (event) => {
  byId("state").textContent = `It does not work here: ${event.message ?? "Python could not be loaded"}`;
});
byId("example").addEventListener("click", () => {
  byId("table").value = EXAMPLE;
  byId("table").focus();
});
byId("asked").addEventListener("submit", (event) => {
  event.preventDefault();
  byId("audit").disabled = true;
  byId("state").textContent = "Auditing …";
  worker.postMessage({ text: byId("table").value, options: chosen() });
});
