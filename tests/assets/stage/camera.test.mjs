import assert from "node:assert/strict";
import { test } from "node:test";
import { Camera, NEAR } from "../../../assets/stage/camera.mjs";

function seen(camera, points) {
  const n = points.length / 3;
  const [x, y, scale, depth] = [0, 1, 2, 3].map(() => new Float32Array(n));
  camera.project(points, n, x, y, scale, depth);
  return { x, y, scale, depth };
}

test("the target is in the middle of the picture, nearer things are larger", () => {
  const camera = new Camera();
  camera.prepare(800, 600);
  const { x, y, scale, depth } = seen(camera, [...camera.target, ...camera.eye.map((v, k) => v + 0.5 * (camera.target[k] - v))]);
  assert.ok(Math.abs(x[0] - 400) < 1e-2 && Math.abs(y[0] - 300) < 1e-2);
  assert.ok(Math.abs(depth[0] - camera.distance) < 1e-4);
  assert.ok(Math.abs(scale[1] - 2 * scale[0]) < 1e-2);
});

test("at yaw 0 the left of a figure that faces us is on our right, and up is up", () => {
  const camera = new Camera();
  camera.reset({ yaw: 0, pitch: 0.2 });
  camera.prepare(800, 600);
  const { x, y } = seen(camera, [0.5, 1, 0, 0, 2, 0]);
  assert.ok(x[0] > 400);
  assert.ok(y[1] < y[0]);
});

test("a cloud is framed: nothing is cut, and it is not much too far", () => {
  for (const aspect of [0.6, 1, 2.4]) {
    const camera = new Camera();
    const cloud = [];
    for (let k = 0; k < 60; k++) cloud.push(3 * Math.cos(k), 0.03 * k, 3 * Math.sin(k));
    camera.fit(cloud, aspect);
    camera.prepare(600 * aspect, 600);
    const { x, y, depth } = seen(camera, cloud);
    assert.ok(Math.min(...depth) > NEAR);
    assert.ok(Math.min(...x) >= 0 && Math.max(...x) <= 600 * aspect && Math.min(...y) >= 0 && Math.max(...y) <= 600);
    const used = Math.max((Math.max(...x) - Math.min(...x)) / (600 * aspect), (Math.max(...y) - Math.min(...y)) / 600);
    assert.ok(used > 0.6, `uses ${used} of the picture`);
  }
});

test("a distance that a person has chosen stays", () => {
  const camera = new Camera();
  camera.zoom(0.5);
  camera.fit([9, 0, 9, -9, 0, -9], 1);
  assert.equal(camera.distance, 2.5);
  camera.orbit(0, 9);
  assert.equal(camera.pitch, 1.55);
});
