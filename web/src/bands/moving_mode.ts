/** The cell that moves in a mode, with its neighbours in their phases. */

import * as three from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Dataset } from "../dataset";
import { themeColour } from "../parts/colours";

/** A mode of the dataset, and how the cell is turned before it is drawn. */
export interface Motion {
  of: "path" | "zone"; // the variables that contain its amounts
  row: number; // number of the wavevector, from 0
  band: number;
  kappa: [number, number]; // phases, rad
  turn: Turn;
  isReversed: boolean; // in time
}

/** Rows of a turn or a reflection of the plane. */
export type Turn = [[number, number], [number, number]];

export const UNTURNED: Turn = [
  [1, 0],
  [0, 1],
];

const VERTEX = /* glsl */ `
attribute vec3 real;
attribute vec3 imag;
attribute vec3 origin;
attribute vec2 turn;
uniform vec2 phase;
uniform float swing;
uniform mat3 turned;
uniform vec3 middle;
varying vec3 seen;
varying float amount;
void main() {
  vec3 first = real * turn.x - imag * turn.y;
  vec3 second = real * turn.y + imag * turn.x;
  amount = sqrt(dot(real, real) + dot(imag, imag));
  vec3 moved = turned * (position - middle + swing * (first * phase.x - second * phase.y)) + middle + origin;
  vec4 place = modelViewMatrix * vec4(moved, 1.0);
  seen = place.xyz;
  gl_Position = projectionMatrix * place;
}`;

const SURFACE = /* glsl */ `
uniform sampler2D scale;
varying vec3 seen;
varying float amount;
void main() {
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  float light = 0.62 + 0.38 * abs(normal.z) + 0.08 * normal.y;
  gl_FragColor = vec4(texture2D(scale, vec2(clamp(amount, 0.0, 1.0), 0.5)).rgb * light, 1.0);
}`;

const LINE = /* glsl */ `
uniform vec3 ink;
void main() { gl_FragColor = vec4(ink, 1.0); }`;

export type Side = "oblique" | "x" | "y" | "z";
const DIRECTIONS: Record<Side, [number, number, number]> = {
  oblique: [0.45, -0.8, 0.45],
  x: [1, 0, 0],
  y: [0, -1, 0],
  z: [0, -0.001, 1],
};

export class MovingMode {
  private readonly renderer: three.WebGLRenderer;
  private readonly scene = new three.Scene();
  private readonly camera = new three.PerspectiveCamera(28, 1, 0.01, 100);
  private readonly controls: OrbitControls;
  private readonly uniforms = {
    phase: { value: new three.Vector2(1, 0) },
    swing: { value: 0.15 },
    turned: { value: new three.Matrix3() },
    middle: { value: new three.Vector3() },
    scale: { value: new three.DataTexture(new Uint8Array(4), 1, 1) },
    ink: { value: new three.Color(0, 0, 0) },
  };
  private readonly surface = new three.InstancedBufferGeometry();
  private readonly edges = new three.InstancedBufferGeometry();
  private readonly period: number;
  private readonly vectors: [[number, number], [number, number]];
  private readonly box = new three.Box3();
  private copies: [number, number] = [1, 1];
  private kappa: [number, number] = [0, 0];
  /** Number of frames that were drawn, for tests. */
  frames = 0;
  /** Cosine and sine of the phase of each copy, for tests. */
  turns: number[] = [];

  constructor(
    private readonly data: Dataset,
    readonly canvas: HTMLCanvasElement,
    colours: number[][],
  ) {
    this.renderer = new three.WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.vectors = data.header.extra["lattice_vectors"] as [[number, number], [number, number]];
    this.period = Math.hypot(...this.vectors[0]);
    const position = Float32Array.from(data.values("skin_position"), (metres) => metres / this.period);
    const shared = {
      position: new three.BufferAttribute(position, 3),
      real: new three.BufferAttribute(new Float32Array(position.length), 3),
      imag: new three.BufferAttribute(new Float32Array(position.length), 3),
    };
    for (const geometry of [this.surface, this.edges])
      for (const [name, attribute] of Object.entries(shared)) geometry.setAttribute(name, attribute);
    this.surface.setIndex(triangles(data.values("skin_face") as Int32Array));
    this.edges.setIndex(Array.from(data.values("skin_edge")));
    this.box.setFromBufferAttribute(shared.position);
    this.box.getCenter(this.uniforms.middle.value);
    const texture = new three.DataTexture(
      Uint8Array.from(colours.flatMap(([r = 0, g = 0, b = 0]) => [r, g, b, 255])),
      colours.length,
      1,
    );
    texture.minFilter = texture.magFilter = three.LinearFilter;
    texture.needsUpdate = true;
    this.uniforms.scale.value = texture;
    const material = { uniforms: this.uniforms, vertexShader: VERTEX };
    const body = new three.Mesh(
      this.surface,
      new three.ShaderMaterial({
        ...material,
        fragmentShader: SURFACE,
        side: three.DoubleSide,
        polygonOffset: true,
        polygonOffsetFactor: 1,
        polygonOffsetUnits: 1,
      }),
    );
    const lines = new three.LineSegments(
      this.edges,
      new three.ShaderMaterial({ ...material, fragmentShader: LINE }),
    );
    for (const part of [body, lines]) {
      part.frustumCulled = false;
      this.scene.add(part);
    }
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.addEventListener("change", () => this.draw());
    this.colourLines();
  }

  show({ of, row, band, kappa, turn, isReversed }: Motion): void {
    const [, bands = 0, shapes = 0] = this.data.shape(`${of}_mode_real`);
    const start = (row * bands + band) * shapes;
    const field = this.data.values("path_shape");
    for (const part of ["real", "imag"] as const) {
      const name = `${of}_mode_${part}`;
      const amounts = this.data.values(name).subarray(start, start + shapes);
      const sign = isReversed && part === "imag" ? -1 : 1;
      const factor = sign * this.data.scale(name) * this.data.scale("path_shape");
      const attribute = this.surface.getAttribute(part) as three.BufferAttribute;
      combined(attribute.array as Float32Array, field, amounts, factor);
      attribute.needsUpdate = true;
    }
    const [[xx, xy], [yx, yy]] = turn;
    this.uniforms.turned.value.set(xx, xy, 0, yx, yy, 0, 0, 0, 1);
    this.kappa = kappa;
    this.place();
  }

  /** Show this many cells along a1 and a2. */
  repeat(copies: [number, number]): void {
    this.copies = copies;
    this.place();
    this.look("oblique");
  }

  set swing(share: number) {
    this.uniforms.swing.value = share;
  }

  /** Draw the moment of the cycle, from 0 to 1. */
  turn(moment: number): void {
    this.uniforms.phase.value.set(Math.cos(2 * Math.PI * moment), Math.sin(2 * Math.PI * moment));
    this.draw();
  }

  draw(): void {
    this.frames++;
    this.renderer.render(this.scene, this.camera);
  }

  /** Put the camera where the whole body is seen from one side. */
  look(side: Side): void {
    const [m, n] = this.copies;
    const body = this.box.clone();
    for (const [i, j] of [[m - 1, 0], [0, n - 1], [m - 1, n - 1]] as const)
      body.union(this.box.clone().translate(this.shift(i, j)));
    const sphere = body.getBoundingSphere(new three.Sphere());
    const half = (this.camera.fov * Math.PI) / 360;
    const narrow = Math.atan(Math.tan(half) * Math.min(1, this.camera.aspect));
    const away = (1.08 * sphere.radius) / Math.sin(narrow);
    this.controls.target.copy(sphere.center);
    this.camera.position
      .set(...DIRECTIONS[side])
      .normalize()
      .multiplyScalar(away)
      .add(sphere.center);
    this.camera.near = 0.01 * away;
    this.camera.far = 10 * away;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  resize(width: number, height: number): void {
    this.renderer.setPixelRatio(devicePixelRatio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  colourLines(): void {
    this.uniforms.ink.value.set(themeColour("ink"));
  }

  dispose(): void {
    this.controls.dispose();
    this.surface.dispose();
    this.edges.dispose();
    this.uniforms.scale.value.dispose();
    this.renderer.dispose();
  }

  private shift(i: number, j: number): three.Vector3 {
    const [[ax, ay], [bx, by]] = this.vectors;
    return new three.Vector3((i * ax + j * bx) / this.period, (i * ay + j * by) / this.period, 0);
  }

  /** Origins and Bloch phases of the copies: u(r + m a1 + n a2) = exp(i (m kappa1 + n kappa2)) u(r). */
  private place(): void {
    const [m, n] = this.copies;
    const origin: number[] = [];
    const turn: number[] = [];
    for (let i = 0; i < m; i++)
      for (let j = 0; j < n; j++) {
        const angle = i * this.kappa[0] + j * this.kappa[1];
        origin.push(...this.shift(i, j).toArray());
        turn.push(Math.cos(angle), Math.sin(angle));
      }
    this.turns = turn;
    for (const geometry of [this.surface, this.edges]) {
      geometry.instanceCount = m * n;
      geometry.setAttribute("origin", new three.InstancedBufferAttribute(Float32Array.from(origin), 3));
      geometry.setAttribute("turn", new three.InstancedBufferAttribute(Float32Array.from(turn), 2));
    }
  }
}

/** Sum of shapes times their amounts, written into `out`. */
function combined(out: Float32Array, shapes: ArrayLike<number>, amounts: ArrayLike<number>, factor: number): void {
  out.fill(0);
  for (let s = 0; s < amounts.length; s++) {
    const amount = (amounts[s] ?? 0) * factor;
    if (amount === 0) continue;
    const start = s * out.length;
    for (let i = 0; i < out.length; i++) out[i]! += amount * shapes[start + i]!;
  }
}

/** Two triangles for each face of four corners. */
function triangles(faces: Int32Array): number[] {
  const index: number[] = [];
  for (let k = 0; k < faces.length; k += 4) {
    const [a, b, c, d] = faces.subarray(k, k + 4) as unknown as [number, number, number, number];
    index.push(a, b, c, a, c, d);
  }
  return index;
}
