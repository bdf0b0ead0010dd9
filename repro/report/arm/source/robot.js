// One arm: rods along its links, drums where joints turn, a cone at the tool.
import { ConeGeometry, CylinderGeometry, Group, Mesh, MeshLambertMaterial, Quaternion, SphereGeometry, Vector3 } from "three";

const UP = new Vector3(0, 1, 0); // along which three.js builds cylinders and cones
const HULL = { opacity: 0.3, size: 1.3 };
const CORE = 0.3; // a see-through arm keeps a thin solid core, to be told apart without colour

export class Robot extends Group {
  // `motion` has times and, for each, the numbers of corners and axes; `thick` is a link's radius.
  constructor(motion, joints, thick, seeThrough) {
    super();
    this.motion = motion;
    this.joints = joints;
    this.materials = [];
    this.bodies = seeThrough
      ? [this.#body(thick * CORE, 1), this.#body(thick * HULL.size, HULL.opacity)]
      : [this.#body(thick, 1)];
    this.at(0);
  }

  set colour(colour) {
    for (const material of this.materials) material.color.set(colour);
  }

  #body(radius, opacity) {
    const material = new MeshLambertMaterial({ opacity, transparent: opacity < 1, depthWrite: opacity === 1 });
    this.materials.push(material);
    const mesh = geometry => {
      const made = new Mesh(geometry, material);
      this.add(made);
      return made;
    };
    const corners = this.motion.corners[0].length / 3;
    const thin = index => radius * (1 - 0.5 * index / corners); // towards the tool
    return {
      radius,
      links: Array.from({ length: corners - 1 }, (_, i) => mesh(new CylinderGeometry(thin(i + 1), thin(i), 1, 20))),
      balls: Array.from({ length: corners - 1 }, (_, i) => mesh(new SphereGeometry(thin(i), 20, 12))),
      drums: this.joints.map(corner => mesh(new CylinderGeometry(1.5 * thin(corner), 1.5 * thin(corner), 3.2 * thin(corner), 24))),
      tool: mesh(new ConeGeometry(1.5 * thin(corners), 4 * thin(corners), 20)),
    };
  }

  // Place everything for an instant, halfway between samples where it falls between them.
  at(time) {
    const [i, share] = this.#sample(time);
    const corners = this.#points("corners", i, share);
    const axes = this.#points("axes", i, share).map(axis => axis.normalize());
    for (const body of this.bodies) {
      body.links.forEach((link, k) => lay(link, corners[k], corners[k + 1]));
      body.balls.forEach((ball, k) => ball.position.copy(corners[k]));
      body.drums.forEach((drum, k) => point(drum, corners[this.joints[k]], axes[k]));
      const end = corners.at(-1), axis = axes.at(-1);
      point(body.tool, end.clone().addScaledVector(axis, body.radius), axis);
    }
  }

  #sample(time) {
    const { times } = this.motion;
    let low = 0, high = times.length - 1;
    if (time >= times[high]) return [high - 1, 1];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= time) low = middle; else high = middle;
    }
    return [low, (time - times[low]) / (times[high] - times[low] || 1)];
  }

  #points(name, i, share) {
    const [before, after] = [this.motion[name][i], this.motion[name][i + 1]];
    const value = k => (before[k] + share * (after[k] - before[k])) / 1000;
    return Array.from({ length: before.length / 3 }, (_, k) => new Vector3(value(3 * k), value(3 * k + 1), value(3 * k + 2)));
  }
}

function lay(mesh, start, end) {
  const along = end.clone().sub(start), length = along.length();
  mesh.visible = length > 1e-6;
  if (!mesh.visible) return;
  mesh.position.copy(start).addScaledVector(along, 0.5);
  mesh.scale.set(1, length, 1);
  mesh.quaternion.setFromUnitVectors(UP, along.divideScalar(length));
}

function point(mesh, place, axis) {
  mesh.position.copy(place);
  mesh.quaternion.copy(new Quaternion().setFromUnitVectors(UP, axis));
}
