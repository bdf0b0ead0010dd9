// The evidence of a number. Without script it unfolds in its cell; with script it is a dialog beside
// the cell that opens by click or Enter, and closes by its button, Escape, or a click elsewhere.
{
  const least = 160; // px: what a panel keeps where its cell has left the window
  let open = null;

  const made = (name, attributes, ...children) => {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    element.append(...children);
    return element;
  };
  const numbers = element => element.dataset.n.split(",").map(text => text ? Number(text) : NaN);

  // One line: what is accepted as a band, where such tables lie as a bar, what is printed as a tick.
  const plot = panel => {
    const [printed, ...ends] = numbers(panel);
    const bars = [ends.slice(2, 4), ...[...panel.querySelectorAll("li[data-n]")].map(numbers)];
    const all = [printed, ...ends, ...bars.flat()].filter(Number.isFinite);
    const decades = Math.min(...all) > 0 && Math.max(...all) > 30 * Math.min(...all);
    const scaled = value => decades ? Math.log10(value) : value;
    const [low, high] = [Math.min(...all), Math.max(...all)].map(scaled);
    const across = (value, missing = 200) => {
      if (!Number.isFinite(value) || !(high > low)) return missing;
      return 20 + 360 * (scaled(value) - low) / (high - low);
    };
    const bottom = 20 + 11 * bars.length;
    const rect = (kind, [from, to], top, height) => {
      const left = across(from, 0);
      const wide = Math.max(3, across(to, 400) - left);
      return `<rect class="${kind}" x="${left}" y="${top}" width="${wide}" height="${height}"/>`;
    };
    const tick = (kind, value, y, text) => {
      if (!Number.isFinite(value)) return "";
      const x = across(value);
      const side = x > 300 ? "end" : x < 100 ? "start" : "middle";
      return `<path class="${kind}" d="M${x} 14V${bottom}"/>`
        + `<text x="${x}" y="${y}" text-anchor="${side}">${text}</text>`;
    };
    return `<svg class="line-plot" viewBox="0 0 400 ${bottom + 14}" aria-hidden="true">`
      + rect("band", ends, 14, bottom - 14)
      + bars.map((ends, line) => rect(line ? "other" : "own", ends, 17 + 11 * line, 7)).join("")
      + tick("printed-tick", printed, 10, "printed")
      + tick("proved-tick", ends[4], bottom + 12, "proved least") + "</svg>";
  };

  // once for each number that is opened: button, plot, and what all numbers of its table share
  const furnish = (panel, cell) => {
    const title = panel.querySelector(".panel-title");
    title.id = "panel-title";
    if (panel.hasAttribute("role")) return;
    panel.setAttribute("role", "dialog");
    panel.setAttribute("aria-labelledby", "panel-title");
    const button = made("button", { type: "button", class: "close", "aria-label": "Close" }, "✕");
    button.addEventListener("click", () => close(true));
    panel.prepend(button);
    if (panel.dataset.n) panel.querySelector("dl").insertAdjacentHTML("beforebegin", plot(panel));
    const shared = cell.closest(".wrap")?.nextElementSibling;
    const [file, command] = [shared?.querySelector("a"), shared?.querySelector("code")];
    const line = panel.querySelector("[data-line]");
    if (!file || !line) return;
    line.append(` of `, file.cloneNode(true));
    if (line.dataset.line === "run") {
      const name = line.querySelector("a").hash.slice(1);
      const typed = made("code", {}, command.textContent.replace("NAME", name));
      line.parentElement.append(
        made("dt", {}, "again"), made("dd", {}, typed, ` ${command.dataset.where}`),
      );
    }
  };

  const close = (back = false) => {
    if (!open) return;
    const summary = open.querySelector("summary");
    open.querySelector(".panel-title").removeAttribute("id");
    open.open = false;
    open = null;
    if (back) summary.focus({ preventScroll: true });
  };
  const place = () => {
    if (!open) return;
    const cell = open.getBoundingClientRect();
    const panel = open.querySelector(".panel");
    const { width } = panel.getBoundingClientRect();
    const height = panel.scrollHeight + 2; // and its borders
    // never over its own cell: where there is no room it scrolls
    const [above, under] = [cell.top - 8, innerHeight - cell.bottom - 8];
    const below = height <= under || above <= under;
    const room = Math.max(below ? under : above, least);
    const shown = Math.min(height, room);
    const left = Math.max(8, Math.min(cell.left, document.documentElement.clientWidth - width - 8));
    const top = below ? Math.min(cell.bottom, innerHeight - shown - 8) : cell.top - shown;
    panel.style.setProperty("--room", `${room}px`);
    panel.style.setProperty("--left", `${left}px`);
    panel.style.setProperty("--top", `${Math.max(8, top)}px`);
  };
  const show = (details, focus = true) => {
    close();
    open = details;
    const panel = details.querySelector(".panel");
    furnish(panel, details);
    details.open = true;
    place();
    if (focus) panel.querySelector(".close").focus({ preventScroll: true });
  };

  addEventListener("click", event => {
    const summary = event.target.closest?.("details.evidence > summary");
    if (summary) {
      event.preventDefault();
      if (open === summary.parentElement) close(true);
      else show(summary.parentElement);
    } else if (open && !open.contains(event.target)) {
      // what is clicked keeps the focus; a click on nothing gives it back
      close(document.activeElement === document.body || open.contains(document.activeElement));
    }
  });
  addEventListener("keydown", event => {
    if (event.key === "Escape") close(true);
  });
  addEventListener("focusin", event => {
    if (open && !open.contains(event.target)) close();
  });
  addEventListener("scroll", place, { capture: true, passive: true });
  addEventListener("resize", place);
  // a link to a number shows it with its evidence
  const follow = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    const details = target?.querySelector(":scope > details.evidence, :scope > td > details.evidence");
    if (details) show(details);
  };
  addEventListener("hashchange", follow);
  addEventListener("load", follow);
}
