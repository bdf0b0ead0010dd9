// The script of the live view stands in the page packed; it is unpacked and run here.
{
  const packed = atob(document.getElementById("arm-script").textContent);
  const bytes = Uint8Array.from(packed, letter => letter.charCodeAt(0));
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  new Response(unpacked).text().then(text => {
    const script = document.createElement("script");
    script.textContent = text;
    document.body.append(script);
  });
}
