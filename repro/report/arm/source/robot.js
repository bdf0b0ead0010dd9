// One arm: thick links, a cylinder along each joint's axis, a foot, a flange and a cone at the tool.
import {
  ConeGeometry, CylinderGeometry, Group, Mesh, MeshLambertMaterial, Quaternion, SphereGeometry, Vector3,
} from "three";

const UP = new Vector3(0, 1, 0); // along which three.js builds cylinders and cones
const HULL = { opacity: 0.3, size: 1.1 };
const CORE = 0.3; // a see-through arm keeps a thin solid core, to be told apart without colour
const DRUM = { radius: 1.5, length: 3.6, rim: 1.62, rimLength: 0.5 }; // in radii of the link at the joint
const FOOT = { top: 2.2, bottom: 3, height: 1 }; // in radii of the first link

export class Robot extends Group {
  // `motion` has times and, for each, the numbers of corners and axes; `thick` is a link's radius.
  constructor(motion, joints, thick, { seeThrough, column }) {
    super();
    this.motion = motion;
    this.joints = joints;
    this.links = [];
    this.metal = [];
    this.bodies = seeThrough
      ? [this.#body(thick * CORE, 1, false), this.#body(thick * HULL.size, HULL.opacity, column)]
      : [this.#body(thick, 1, column)];
    this.at(0);
  }

  // Links have one colour, joints another.
  dress(link, joint) {
    for (const material of this.links) material.color.set(link);
    for (const material of this.metal) material.color.set(joint);
  }

  #body(radius, opacity, foot) {
    const made = list => {
      const material = new MeshLambertMaterial({ opacity, transparent: opacity < 1, depthWrite: opacity === 1 });
      list.push(material);
      return geometry => {
        const mesh = new Mesh(geometry, material);
        this.add(mesh);
        return mesh;
      };
    };
    const link = made(this.links), metal = made(this.metal);
    const corners = this.motion.corners[0].length / 3;
    const thin = index => radius * (1 - 0.45 * index / corners); // towards the tool
    const cylinder = (r, length) => new CylinderGeometry(r, r, length, 28);
    if (foot) {
      const height = FOOT.height * radius;
      const plinth = metal(new CylinderGeometry(FOOT.top * radius, FOOT.bottom * radius, height, 32));
      point(plinth, new Vector3(0, 0, height / 2), new Vector3(0, 0, 1));
    }
    return {
      radius,
      links: Array.from({ length: corners - 1 }, (_, i) => link(new CylinderGeometry(thin(i + 1), thin(i), 1, 20))),
      balls: Array.from({ length: corners - 1 }, (_, i) => link(new SphereGeometry(thin(i), 20, 12))),
      drums: this.joints.map(corner => link(cylinder(DRUM.radius * thin(corner), DRUM.length * thin(corner)))),
      rims: this.joints.flatMap(corner => [1, -1].map(side => ({
        mesh: metal(cylinder(DRUM.rim * thin(corner), DRUM.rimLength * thin(corner))),
        away: side * (DRUM.length + DRUM.rimLength) / 2 * thin(corner),
      }))),
      flange: metal(cylinder(1.3 * thin(corners), 0.6 * thin(corners))),
      tool: metal(new ConeGeometry(thin(corners), 3 * thin(corners), 20)),
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
      body.rims.forEach(({ mesh, away }, k) => {
        const joint = k >> 1;
        point(mesh, corners[this.joints[joint]].clone().addScaledVector(axes[joint], away), axes[joint]);
      });
      const end = corners.at(-1), axis = axes.at(-1);
      point(body.flange, end, axis);
      point(body.tool, end.clone().addScaledVector(axis, body.radius), axis);
    }
    this.height = corners.at(-1).z;
    this.lowest = Math.min(...corners.map(corner => corner.z));
  }

  // Return what the joints read at an instant, in tenths, and the limit that is nearest.
  reads(time) {
    const [i, share] = this.#sample(time), { angles, nearest } = this.motion;
    return {
      angles: angles.length ? angles[i].map((angle, k) => (angle + share * (angles[i + 1][k] - angle)) / 10) : [],
      nearest: nearest[share < 0.5 ? i : i + 1],
    };
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
