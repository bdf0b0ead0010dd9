// Draws the links of an arm between the origins of its frames, turned by hand and moved in time.
function showArm(place, scene) {
  const canvas = place.querySelector("canvas"), pen = canvas.getContext("2d");
  if (!pen) return;
  const slider = place.querySelector("input"), button = place.querySelector("button");
  const words = place.querySelector(".angles");
  const all = scene.corners.flat();
  const middle = [0, 1, 2].map(k => (Math.min(0, ...all.map(p => p[k])) + Math.max(0, ...all.map(p => p[k]))) / 2);
  const radius = Math.max(1e-6, ...all.map(p => Math.hypot(...p.map((v, k) => v - middle[k]))));
  let azimuth = 0.6, elevation = 0.35, playing = false, begun = 0;
  function at(share) {
    let k = scene.times.findIndex(t => t >= share);
    if (k < 0) k = scene.times.length - 1;
    if (k === 0) return scene.corners[0];
    const u = (share - scene.times[k - 1]) / (scene.times[k] - scene.times[k - 1]);
    return scene.corners[k].map((p, i) => p.map((v, j) => scene.corners[k - 1][i][j] * (1 - u) + v * u));
  }
  function seen(p) {
    const [x, y, z] = p.map((v, k) => (v - middle[k]) / radius);
    const c = Math.cos(azimuth), s = Math.sin(azimuth), size = 0.46 * Math.min(canvas.width, canvas.height);
    const across = -s * x + c * y, deep = c * x + s * y;
    const up = Math.cos(elevation) * z - Math.sin(elevation) * deep;
    return [canvas.width / 2 + size * across, canvas.height / 2 - size * up];
  }
  function line(points, colour, width) {
    pen.strokeStyle = colour; pen.lineWidth = width * devicePixelRatio; pen.beginPath();
    points.map(seen).forEach(([x, y], k) => k ? pen.lineTo(x, y) : pen.moveTo(x, y));
    pen.stroke();
  }
  function draw() {
    canvas.width = canvas.clientWidth * devicePixelRatio; canvas.height = canvas.clientHeight * devicePixelRatio;
    const share = slider.value / 1000, posture = at(share), ink = getComputedStyle(document.body).color;
    for (let k = -4; k <= 4; k++) for (const turn of [0, 1]) {
      const a = k * radius / 4, b = radius;
      line(turn ? [[a, -b, 0], [a, b, 0]] : [[-b, a, 0], [b, a, 0]], "#8885", 1);
    }
    line(scene.corners.map(p => p[p.length - 1]), "#009e73", 2);
    line(posture, "#0072b2", 6);
    pen.fillStyle = ink;
    posture.map(seen).forEach(([x, y]) => { pen.beginPath(); pen.arc(x, y, 4 * devicePixelRatio, 0, 7); pen.fill(); });
    const near = scene.times.reduce((best, t, k) => Math.abs(t - share) < Math.abs(scene.times[best] - share) ? k : best, 0);
    words.textContent = `${(share * scene.seconds).toPrecision(4)} s: ` + scene.names.map((n, k) => `${n} ${scene.angles[near][k]}`).join(", ");
  }
  function step(now) {
    if (!playing) return;
    const share = (now - begun) / 1000 / Math.min(20, Math.max(2, scene.seconds));
    slider.value = Math.min(1, share) * 1000; draw();
    if (share < 1) requestAnimationFrame(step); else stop();
  }
  function stop() { playing = false; button.textContent = "play"; }
  button.onclick = () => {
    if (playing) return stop();
    playing = true; button.textContent = "stop"; begun = performance.now(); requestAnimationFrame(step);
  };
  slider.oninput = () => { stop(); draw(); };
  canvas.onpointermove = e => { if (e.buttons) { azimuth -= e.movementX / 120; elevation += e.movementY / 120; draw(); } };
  canvas.onkeydown = e => {
    const turn = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[e.key];
    if (turn) { azimuth += turn[0]; elevation += turn[1]; e.preventDefault(); draw(); }
  };
  place.hidden = false;
  new ResizeObserver(draw).observe(canvas);
  draw();
}
