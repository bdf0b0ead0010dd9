// What stands packed in the page under a name, as text; nothing where the browser cannot unpack.
const unpacked = async name => {
  if (!window.DecompressionStream) return null;
  const packed = atob(document.getElementById(name).textContent);
  const bytes = Uint8Array.from(packed, letter => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).text();
};
