// Finds the views on the page. A still drawing stands in each place until its view has started.
import { startView } from "./view.js";

const near = new IntersectionObserver(entries => {
  for (const { target, isIntersecting } of entries) {
    if (!isIntersecting) continue;
    near.unobserve(target);
    startView(target);
  }
}, { rootMargin: "600px" });

for (const figure of document.querySelectorAll("figure:has(.arm)")) near.observe(figure);
