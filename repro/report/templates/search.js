// The search box: what has every word of it in its place, its paper or its verdict.
{
  const most = 40;
  const search = document.getElementById("search");
  const box = search.querySelector("input");
  const status = search.querySelector("[role=status]");
  const list = search.querySelector("ol");
  const rows = JSON.parse(document.getElementById("search-rows").textContent)
    .map(row => ({ row, text: row.join(" ").toLowerCase() }));

  const entry = ({ row: [key, address, text, verdict] }) => {
    const item = document.createElement("li");
    const link = document.createElement("a");
    link.href = address;
    link.textContent = text;
    item.append(link, ` ${verdict}, ${key}`);
    return item;
  };
  const look = () => {
    const words = box.value.toLowerCase().split(/\s+/).filter(Boolean);
    const found = words.length
      ? rows.filter(({ text }) => words.every(word => text.includes(word)))
      : [];
    list.replaceChildren(...found.slice(0, most).map(entry));
    const more = found.length > most ? `, the first ${most} shown` : "";
    status.textContent = words.length ? `${found.length} found${more}` : "";
  };

  search.hidden = false;
  box.addEventListener("input", look);
  look();
}
