// What stands still about the arms: floor, axes, the tool's path, the waypoints.
import {
  BufferGeometry, CatmullRomCurve3, DoubleSide, Group, Line, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, PlaneGeometry,
  SphereGeometry, TubeGeometry, Vector3,
} from "three";

// Return the floor: squares of that step in metres, as many as reach so far.
export function floor(step, reach) {
  const lines = Math.ceil(reach / step), points = [];
  for (let k = -lines; k <= lines; k++) {
    points.push(new Vector3(k * step, -lines * step, 0), new Vector3(k * step, lines * step, 0));
    points.push(new Vector3(-lines * step, k * step, 0), new Vector3(lines * step, k * step, 0));
  }
  return new LineSegments(new BufferGeometry().setFromPoints(points), new LineBasicMaterial());
}

// Return the plane z = 0, through which one sees: what is below it looks veiled.
export function plane(reach) {
  const veil = new MeshBasicMaterial({ side: DoubleSide, transparent: true, opacity: 0.55, depthWrite: false });
  return new Mesh(new PlaneGeometry(2 * reach, 2 * reach), veil);
}

// Return the three axes of the base, and where their names and lengths stand.
export function axes(length) {
  const ends = [new Vector3(length, 0, 0), new Vector3(0, length, 0), new Vector3(0, 0, length)];
  const group = new Group(), material = new LineBasicMaterial();
  for (const end of ends) group.add(new Line(new BufferGeometry().setFromPoints([new Vector3(), end]), material));
  return { group, material, names: ends.map((end, k) => ({ text: `${"xyz"[k]} ${Number(length.toPrecision(3))} m`, place: end.clone().multiplyScalar(1.12), kind: "axis" })) };
}

// Return the path of a motion's tool as a tube, nothing where it stays in place.
export function path(motion, radius) {
  const points = motion.corners.map(numbers => new Vector3(...numbers.slice(-3)).divideScalar(1000));
  const apart = points.filter((point, k) => k === 0 || point.distanceTo(points[k - 1]) > 1e-6);
  if (apart.length < 2) return new Mesh(new BufferGeometry(), new MeshBasicMaterial()); // the tool stays where it is
  const curve = new CatmullRomCurve3(apart, false, "centripetal");
  return new Mesh(new TubeGeometry(curve, 2 * apart.length, radius, 8), new MeshBasicMaterial());
}

// Return balls at the waypoints, and their numbers.
export function waypoints(places, radius) {
  const group = new Group(), material = new MeshBasicMaterial(), names = [];
  places.forEach((numbers, k) => {
    const place = new Vector3(...numbers).divideScalar(1000);
    const ball = new Mesh(new SphereGeometry(radius, 16, 12), material);
    ball.position.copy(place);
    group.add(ball);
    names.push({ text: String(k + 1), place, kind: "waypoint" });
  });
  return { group, material, names };
}
