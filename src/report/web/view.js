// A snapshot to be looked at from all sides: grains as spheres drawn on points that face the eye
// (impostors), walls as translucent triangles.

import {
  BufferAttribute, BufferGeometry, Color, DataTexture, DoubleSide, LinearFilter, Mesh, MeshLambertMaterial,
  DirectionalLight, AmbientLight, PerspectiveCamera, Points, RGBAFormat, Scene, ShaderMaterial, Vector3, WebGLRenderer,
} from "three";
import {OrbitControls} from "three/addons/controls/OrbitControls.js";

// viridis at eight places: rises evenly in lightness, for any colour vision and in grey
const RAMP = ["#440154", "#46327e", "#365c8d", "#277f8e", "#1fa187", "#4ac16d", "#a0da39", "#fde725"];
const BACKGROUND = "#ffffff";

const VERTEX = `
  attribute float radius;
  attribute float value;
  uniform float height;
  uniform float low;
  uniform float high;
  uniform vec3 cutNormal;
  uniform float cut;
  varying float tone;
  varying vec3 centre;
  varying float r;
  varying float gone;
  void main() {
    vec4 at = modelViewMatrix * vec4(position, 1.0);
    gone = dot(cutNormal, position) > cut ? 1.0 : 0.0;
    centre = at.xyz;
    r = radius;
    tone = clamp((value - low) / max(high - low, 1e-30), 0.0, 1.0);
    gl_Position = projectionMatrix * at;
    gl_PointSize = height * projectionMatrix[1][1] * radius / gl_Position.w;
  }`;

const FRAGMENT = `
  uniform sampler2D ramp;
  uniform mat4 projection;
  varying float tone;
  varying vec3 centre;
  varying float r;
  varying float gone;
  void main() {
    vec2 p = vec2(2.0 * gl_PointCoord.x - 1.0, 1.0 - 2.0 * gl_PointCoord.y);
    float square = dot(p, p);
    if (gone > 0.5 || square > 1.0) discard;
    vec3 normal = vec3(p, sqrt(1.0 - square));
    vec4 clip = projection * vec4(centre + r * normal, 1.0);
    gl_FragDepth = 0.5 * clip.z / clip.w + 0.5;
    float light = 0.38 + 0.62 * max(dot(normal, normalize(vec3(0.35, 0.6, 0.75))), 0.0);
    vec3 colour = texture2D(ramp, vec2(tone, 0.5)).rgb;
    gl_FragColor = vec4(colour * light * (0.75 + 0.25 * normal.z), 1.0);
  }`;

/** Numbers that the page has packed in 16 bits each. */
export function unpack(packed, count) {
  const result = new Float32Array(count);
  if (packed.data === undefined) {
    return result.fill(packed.min ?? 0);
  }
  const bytes = Uint8Array.from(atob(packed.data), letter => letter.charCodeAt(0));
  const words = new Uint16Array(bytes.buffer);
  for (let k = 0; k < count; k++) {
    result[k] = packed.min + (packed.max - packed.min) * words[k] / 65535;
  }
  return result;
}

/** Points [count * 3] less `origin`, which keeps them exact in single precision. */
function pointsOf(axes, count, origin) {
  const result = new Float32Array(3 * count);
  axes.forEach((axis, a) => unpack(axis, count).forEach((value, k) => { result[3 * k + a] = value - origin[a]; }));
  return result;
}

function rampTexture() {
  const bytes = new Uint8Array(RAMP.flatMap(text => {
    const n = parseInt(text.slice(1), 16);
    return [n >> 16, n >> 8 & 255, n & 255, 255];
  }));
  const texture = new DataTexture(bytes, RAMP.length, 1, RGBAFormat);
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/** "m s-1" of the files as "m/s". */
function unitText(units) {
  if (units === "" || units === "1") return "";
  const parts = units.split(" ").map(part => part.match(/^(.*?)(-?\d+)?$/));
  const of = sign => parts.filter(p => sign * Number(p[2] ?? 1) > 0)
    .map(p => p[1] + (Math.abs(Number(p[2] ?? 1)) > 1 ? Math.abs(Number(p[2])) : ""));
  return of(-1).length ? `${of(1).join(" ") || "1"}/${of(-1).join("/")}` : of(1).join(" ");
}

/** The range that colours span: all but the outermost hundredth at either end. */
function rangeOf(values) {
  const sorted = Float32Array.from(values).sort();
  const at = share => sorted[Math.round(share * (sorted.length - 1))];
  return at(0.01) < at(0.99) ? [at(0.01), at(0.99)] : [sorted[0], sorted[sorted.length - 1]];
}

function element(name, more = {}, ...children) {
  const made = Object.assign(document.createElement(name), more);
  made.append(...children);
  return made;
}

const REST = 1e-3; // of the speed that a grain has when it has fallen its own radius

/** The field that colours the first view: the first, which is the speed, or, where all grains rest, one that varies. */
function firstField(grains) {
  const largest = packed => Math.max(Math.abs(packed.min ?? 0), Math.abs(packed.max ?? packed.min ?? 0));
  const find = name => grains.fields.findIndex(field => field.name === name);
  if (find("speed") !== 0 || largest(grains.fields[0].values) > REST * Math.sqrt(2 * 9.81 * largest(grains.radius.values))) {
    return 0;
  }
  const varied = ["coordination", "radius"].map(find).find(k => k >= 0 && grains.fields[k].values.data !== undefined);
  return varied ?? 0;
}

class View {
  constructor(place, data) {
    this.place = place;
    this.data = data;
    this.box = this.frame();
    this.renderer = new WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
    this.renderer.setClearColor(BACKGROUND);
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.outputColorSpace = "srgb-linear"; // colours are those of the ramp as they stand
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(28, 1, 0.01 * this.box.size, 40 * this.box.size);
    this.camera.up.set(0, 0, 1);
    this.addGrains();
    this.addWalls();
    place.append(this.renderer.domElement);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener("change", () => this.draw());
    place.append(this.bar());
    this.look([0.55, -0.75, 0.45]);
    new ResizeObserver(() => this.resize()).observe(place);
    this.resize();
  }

  /** What is looked at: the grains, or the walls where there are none. */
  frame() {
    const axes = this.data.grains.count > 0 ? this.data.grains.position : this.data.walls.corner;
    const origin = axes.map(axis => (axis.min + axis.max) / 2);
    const half = axes.map(axis => (axis.max - axis.min) / 2);
    const size = Math.hypot(...half) + (this.data.grains.radius?.values.max ?? 0);
    return {origin, half, size};
  }

  addGrains() {
    const {grains} = this.data;
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute("position", new BufferAttribute(pointsOf(grains.position, grains.count, this.box.origin), 3));
    this.geometry.setAttribute("radius", new BufferAttribute(unpack(grains.radius.values, grains.count), 1));
    this.uniforms = {
      height: {value: 1}, low: {value: 0}, high: {value: 1}, ramp: {value: rampTexture()},
      projection: {value: this.camera.projectionMatrix}, cutNormal: {value: new Vector3(0, -1, 0)}, cut: {value: 1e30},
    };
    const material = new ShaderMaterial({vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms: this.uniforms});
    const points = new Points(this.geometry, material);
    points.frustumCulled = false;
    this.scene.add(points);
    this.field = firstField(grains);
    this.colourBy(this.field);
  }

  addWalls() {
    if (!this.data.walls || this.data.walls.triangles === 0) return;
    const count = 3 * this.data.walls.triangles;
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(pointsOf(this.data.walls.corner, count, this.box.origin), 3));
    geometry.computeVertexNormals();
    this.wallMaterial = new MeshLambertMaterial({
      color: new Color("#7d8b9a"), transparent: true, opacity: 0.22, side: DoubleSide, depthWrite: false,
    });
    const sun = new DirectionalLight("#ffffff", 2.2);
    sun.position.set(0.4, -0.6, 1);
    this.scene.add(new Mesh(geometry, this.wallMaterial), sun, new AmbientLight("#ffffff", 1.6));
  }

  colourBy(k) {
    const {grains} = this.data;
    const values = unpack(grains.fields[k].values, grains.count);
    this.geometry.setAttribute("value", new BufferAttribute(values, 1));
    this.range = grains.count > 0 ? rangeOf(values) : [0, 1];
    [this.uniforms.low.value, this.uniforms.high.value] = this.range;
  }

  /** Field, colours, cut, walls, directions. */
  bar() {
    const {grains} = this.data;
    const low = element("span"), high = element("span");
    const say = k => {
      const unit = unitText(grains.fields[k].units);
      low.textContent = this.range[0].toPrecision(3);
      high.textContent = `${this.range[1].toPrecision(3)} ${unit}`;
    };
    const select = element("select", {ariaLabel: "colour by"}, ...grains.fields.map((field, k) => element("option", {value: k}, field.name)));
    select.onchange = () => { this.colourBy(Number(select.value)); say(Number(select.value)); this.draw(); };
    const ramp = element("i");
    ramp.style.background = `linear-gradient(90deg, ${RAMP.join(",")})`;
    const bar = element("div", {className: "bar"}, element("label", {}, "colour by ", select),
      element("span", {className: "ramp", title: "from 1 % to 99 % of the grains"}, low, ramp, high));
    select.value = String(this.field);
    say(this.field);
    const cut = element("input", {type: "range", min: 0, max: 1000, value: 0});
    cut.oninput = () => {
      const share = Number(cut.value) / 1000;
      this.uniforms.cut.value = share === 0 ? 1e30 : this.box.half[1] * (1 - 2 * share);
      this.draw();
    };
    bar.append(element("label", {}, "cut from the front ", cut));
    if (this.wallMaterial) {
      const walls = element("input", {type: "range", min: 0, max: 100, value: 22});
      walls.oninput = () => { this.wallMaterial.opacity = Number(walls.value) / 100; this.draw(); };
      bar.append(element("label", {}, "walls ", walls));
    }
    const sides = {oblique: [0.55, -0.75, 0.45], front: [0, -1, 0], side: [1, 0, 0], top: [0, -0.001, 1]};
    for (const [name, from] of Object.entries(sides)) {
      bar.append(element("button", {type: "button", onclick: () => this.look(from)}, name));
    }
    return bar;
  }

  look(from) {
    const distance = this.box.size / Math.sin(Math.PI * this.camera.fov / 360) / Math.hypot(...from);
    this.camera.position.set(...from.map(value => value * distance * 0.95));
    this.controls.target.set(0, 0, 0);
    this.controls.update();
    this.draw();
  }

  resize() {
    const width = this.place.clientWidth;
    if (width === this.width || width === 0) return;
    this.width = width;
    const height = Math.round(Math.min(width * 0.62, Math.max(300, 0.7 * window.innerHeight), 640));
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.uniforms.height.value = height * this.renderer.getPixelRatio();
    this.draw();
  }

  draw() {
    this.renderer.render(this.scene, this.camera);
  }

  /** What was drawn: grains, triangles (each from both sides), the share of pixels that are not background, and how many colours they have. */
  seen() {
    this.draw();
    const gl = this.renderer.getContext();
    const {drawingBufferWidth: width, drawingBufferHeight: height} = gl;
    const pixels = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const colours = new Set();
    let covered = 0;
    for (let k = 0; k < pixels.length; k += 4) {
      if (pixels[k] < 250 || pixels[k + 1] < 250 || pixels[k + 2] < 250) {
        covered++;
        colours.add(pixels[k] << 16 | pixels[k + 1] << 8 | pixels[k + 2]);
      }
    }
    const {triangles} = this.renderer.info.render;
    return {field: this.data.grains.fields[this.field]?.name, grains: this.data.grains.count, triangles, coverage: covered / (width * height), colours: colours.size};
  }
}

/** Draw the views; what is seen in each. */
export function drawViews(views) {
  return views.map((data, k) => {
    const place = document.getElementById(`view-${k}`);
    try {
      return new View(place, data).seen();
    } catch (error) {
      place.textContent = `This browser shows no 3-D view (${error.message}).`;
      place.style.padding = "1em";
      return {grains: data.grains.count, triangles: 0, coverage: 0, colours: 0};
    }
  });
}
