// The evidence of a number. Without script it unfolds in its cell; with script it is a panel beside
// the cell that opens under the pointer and on keyboard focus, stays after a click, closes on Esc.
{
  const pause = 150; // ms: a pointer that only crosses the table opens nothing
  const least = 160; // px: what a panel keeps where its cell has left the window
  let open = null;
  let pinned = false;
  let timer = 0;

  const close = () => {
    if (open) open.open = false;
    open = null;
    pinned = false;
  };
  const place = () => {
    if (!open) return;
    const cell = open.getBoundingClientRect();
    const panel = open.querySelector(".panel");
    const { width } = panel.getBoundingClientRect();
    const height = panel.scrollHeight + 2; // and its borders
    // never over its own cell, which is clicked to close it: where there is no room it scrolls
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
  const show = (details, stays = false) => {
    clearTimeout(timer);
    if (open !== details) {
      close();
      open = details;
      open.open = true;
    }
    pinned ||= stays;
    place();
  };

  for (const details of document.querySelectorAll("details.evidence")) {
    const summary = details.querySelector("summary");
    details.addEventListener("pointerenter", event => {
      clearTimeout(timer);
      if (event.pointerType === "mouse" && !pinned) timer = setTimeout(show, pause, details);
    });
    details.addEventListener("pointerleave", () => {
      clearTimeout(timer);
      if (!pinned && !details.contains(document.activeElement)) timer = setTimeout(close, pause);
    });
    details.addEventListener("focusin", () => {
      if (summary.matches(":focus-visible") || open !== details) show(details);
    });
    details.addEventListener("focusout", event => {
      if (open === details && !details.contains(event.relatedTarget) && event.relatedTarget) close();
    });
    summary.addEventListener("click", event => {
      event.preventDefault();
      if (open === details && pinned) close();
      else show(details, true);
    });
  }
  addEventListener("keydown", event => {
    if (event.key !== "Escape" || !open) return;
    if (open.contains(document.activeElement)) open.querySelector("summary").focus();
    close();
  });
  addEventListener("pointerdown", event => {
    if (open && !open.contains(event.target)) close();
  });
  addEventListener("scroll", place, { capture: true, passive: true });
  addEventListener("resize", place);
  // a link to a number shows it with its evidence
  const follow = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    const details = target?.querySelector(":scope > details.evidence, :scope > td > details.evidence");
    if (details) show(details, true);
  };
  addEventListener("hashchange", follow);
  addEventListener("load", follow);
}
