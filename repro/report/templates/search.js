// The search box: what has every word of it in its text, its place, its paper or its verdict.
unpacked("search-rows").then(text => {
  if (!text) return;
  const most = 6; // of one kind, until all of them are asked for
  const names = {
    paper: "Papers", part: "Parts of a paper's pages", algorithm: "Algorithms", optimum: "Proved optima",
    number: "Numbers", claim: "Claims of the text", audit: "Audit", reading: "Readings",
    assumption: "Assumptions, misprints and gaps", equation: "Equations", word: "Words",
  };
  const search = document.getElementById("search");
  const box = search.querySelector("input");
  const status = search.querySelector("[role=status]");
  const results = document.getElementById("search-results");
  const help = status.textContent;
  const { marks, groups } = JSON.parse(text);
  const plain = text => text.toLowerCase().replaceAll("−", "-");
  const anchor = text => text.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "");
  const rows = groups.flatMap(({ kind, paper, page, of, rows }) => rows.map(
    ([text, says = "", mark = 0, name]) => {
      const title = of ? `${of}, ${text}` : text;
      const place = name ?? anchor(title);
      return {
        kind, paper, title, says, mark: marks[mark], address: place ? `${page}#${place}` : page,
        words: plain([title, says, marks[mark], paper, page, names[kind]].join(" ")),
      };
    }));

  // a number stands for itself: 4.69 is not found in 14.69, and is found in 4.690
  const test = word => {
    if (!/^-?\d/.test(word)) return words => words.includes(word);
    const own = word.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
    const whole = new RegExp(`(?<![\\d.])${own}`);
    return words => whole.test(words);
  };
  const entry = ({ address, title, says, mark, paper }) => {
    const item = document.createElement("li");
    const link = document.createElement("a");
    link.href = address;
    link.textContent = title;
    item.append(link, ` ${[says, mark, paper].filter(Boolean).join(" · ")}`);
    return item;
  };
  const section = (kind, found) => {
    const part = document.createElement("section");
    const heading = document.createElement("h2");
    const list = document.createElement("ol");
    heading.textContent = `${names[kind]} (${found.length})`;
    list.append(...found.slice(0, most).map(entry));
    part.append(heading, list);
    if (found.length > most) {
      const more = document.createElement("button");
      more.type = "button";
      more.textContent = `all ${found.length}`;
      more.addEventListener("click", () => {
        list.append(...found.slice(most).map(entry));
        more.remove();
        list.children[most].querySelector("a").focus();
      });
      part.append(more);
    }
    return part;
  };
  const look = () => {
    const tests = plain(box.value).split(/\s+/).filter(Boolean).map(test);
    const found = tests.length ? rows.filter(({ words }) => tests.every(fits => fits(words))) : [];
    const kinds = Object.keys(names).map(kind => [kind, found.filter(row => row.kind === kind)])
      .filter(([, some]) => some.length);
    results.replaceChildren(...kinds.map(([kind, some]) => section(kind, some)));
    const counts = kinds.map(([kind, some]) => `${some.length} ${names[kind].toLowerCase()}`);
    status.textContent = !tests.length ? "" : found.length
      ? `${found.length} found: ${counts.join(", ")}` : `Nothing found. ${help}`;
  };

  search.hidden = false;
  box.value = new URLSearchParams(location.search).get("q") ?? "";
  box.addEventListener("input", look);
  // from the box the arrow keys go through what is found, and Escape goes back
  search.addEventListener("keydown", event => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step && event.key !== "Escape") return;
    const stops = [box, ...results.querySelectorAll("a")];
    const at = stops.indexOf(document.activeElement);
    if (event.key === "Escape" && at > 0) box.focus();
    else if (step && at >= 0) stops[Math.max(0, Math.min(stops.length - 1, at + step))].focus();
    else return;
    event.preventDefault();
  });
  look();
});
