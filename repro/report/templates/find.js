// The search box in the bar of a paper's page leads to the index, which has what can be found.
{
  const box = document.getElementById("find");
  box.parentElement.hidden = false;
  box.addEventListener("keydown", event => {
    const asked = box.value.trim();
    if (event.key !== "Enter" || !asked) return;
    event.preventDefault();
    location.href = `index.html?q=${encodeURIComponent(asked)}`;
  });
}
