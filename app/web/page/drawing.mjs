// SPDX-License-Identifier: Apache-2.0
// Balls by etak's own GLSL: `etak shader` gives the texts and the values, one WebGL2 context draws them, and each is copied
// to the canvas that shows it.

// The studio of the balls. In its own dark floor the lower half of a metal is nearly black: a ground of half albedo is under it.
const studioWords = ['--es', '--env', 'studio', '--ground', '0.5,0.5,0.5', '--tone', 'neutral', '--exposure', '0.7', '--background', '0,0,0'];

/** The line that asks for a ball's shader. */
export const ballWords = (subject, model, size, ...words) => ['shader', subject, '--model', model, ...studioWords, '--size', String(size), ...words];

export const conducts = kind => ['metal', 'alloy', 'semiconductor', 'conductor'].includes(kind);
/** The shading model with the form of F that is nearest to the truth for a class of materials. */
export const nearestModel = kind => conducts(kind) ? 'ggx-f82' : 'ggx-from-f0';

/** Pixels of a ball that is `side` wide on the page. */
export const ballSize = side => Math.min(1024, Math.max(32, Math.round(side * Math.min(devicePixelRatio || 1, 2))));

export class Drawing {
  gl = null;
  lit = false;
  canvas = null;
  programs = new Map();
  textures = new Map();
  pictures = new Map();

  /** `restored` is called where a lost context has come back, and all has to be drawn again. */
  constructor(restored) {
    this.canvas = document.createElement('canvas');
    this.canvas.addEventListener('webglcontextlost', event => { event.preventDefault(); this.gl = null; });
    this.canvas.addEventListener('webglcontextrestored', () => { this.open(); restored(); });
  }

  /** Whether this browser has WebGL 2. */
  open() {
    this.programs.clear();
    this.textures.clear();
    this.gl = this.canvas.getContext('webgl2', {alpha: true, antialias: false, depth: false, preserveDrawingBuffer: true});
    // Floats of 32 bits where they can be mixed, else of 16 bits, which is a code of 8 bits now and then.
    this.form = this.gl?.getExtension('OES_texture_float_linear') ? this.gl.RGB32F : this.gl?.RGB16F;
    for (const [name, picture] of this.pictures) this.texture(name, picture);
    return Boolean(this.gl);
  }

  /** Makes the pictures of the studio's light by a run of the program: quickly with blurred details, or in full. */
  async light(program, quick) {
    const answer = await program.aside(['shader', 'f0=1', ...studioWords, '--textures', 'light', ...(quick ? ['--quick'] : []), '-q'], {collect: true});
    if (answer.status) throw new Error(answer.err.replace(/^etak: /gm, '').trim());
    for (const [path, bytes] of Object.entries(answer.files)) {
      const name = path.replace(/^.*\//, '').replace(/\.pfm$/, '');
      this.pictures.set(name, bytes);
      this.texture(name, bytes);
    }
    this.lit = true;
  }

  /** A picture in the form PFM (three floats a pixel, first row at v = 0) as a texture; others until it is there are black. */
  texture(name, bytes) {
    const gl = this.gl;
    if (!gl) return;
    const texture = this.textures.get(name) ?? gl.createTexture();
    this.textures.set(name, texture);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    if (bytes) {
      const head = new TextDecoder('latin1').decode(bytes.subarray(0, 40)).match(/^PF\n(\d+) (\d+)\n-1\.0\n/);
      const texels = new Float32Array(bytes.slice(head[0].length).buffer);
      gl.texImage2D(gl.TEXTURE_2D, 0, this.form, Number(head[1]), Number(head[2]), 0, gl.RGB, gl.FLOAT, texels);
    } else {
      gl.texImage2D(gl.TEXTURE_2D, 0, this.form, 1, 1, 0, gl.RGB, gl.FLOAT, new Float32Array(3));
    }
    for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, name === 'environment_levels' ? gl.CLAMP_TO_EDGE : gl.REPEAT);
  }

  /** The program of a pair of texts, compiled once. Throws Error with what the browser says of the text. */
  program(shader) {
    const key = shader.vertex + shader.fragment, known = this.programs.get(key);
    if (known) return known;
    const gl = this.gl, program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, shader.vertex], [gl.FRAGMENT_SHADER, shader.fragment]]) {
      const part = gl.createShader(kind);
      gl.shaderSource(part, text);
      gl.compileShader(part);
      gl.attachShader(program, part);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
      const logs = gl.getAttachedShaders(program).map(part => gl.getShaderInfoLog(part)).join(' ');
      throw new Error(`a shader does not compile here: ${logs} ${gl.getProgramInfoLog(program)}`);
    }
    const samplers = [];
    for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++i) {
      const uniform = gl.getActiveUniform(program, i);
      if (uniform.type === gl.SAMPLER_2D) samplers.push(uniform.name);
    }
    const out = {program, samplers, places: new Map()};
    this.programs.set(key, out);
    return out;
  }

  /** Draws a shader's picture of size x size pixels; `values` replace those of some uniforms. */
  draw(shader, size, values = {}) {
    const gl = this.gl, {program, samplers, places} = this.program(shader);
    if (this.canvas.width !== size || this.canvas.height !== size) this.canvas.width = this.canvas.height = size;
    gl.viewport(0, 0, size, size);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.useProgram(program);
    const place = name => {
      if (!places.has(name)) places.set(name, gl.getUniformLocation(program, name));
      return places.get(name);
    };
    samplers.forEach((name, unit) => {
      if (!this.textures.has(name)) this.texture(name, null);
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, this.textures.get(name));
      gl.uniform1i(place(name), unit);
    });
    let corners = 3;
    for (const uniform of shader.uniforms) {
      const width = uniform.type === 'float' ? 1 : Number(uniform.type[3]);
      gl[`uniform${width}fv`](place(uniform.name), values[uniform.name] ?? uniform.values);
      if (uniform.name === 'fan_corners') corners = uniform.values[0];
    }
    gl.drawArrays(gl.TRIANGLE_FAN, 0, corners);
  }

  /** Draws into a canvas of the page, which is then of the class `drawn`. */
  show(shader, target, size, values) {
    this.draw(shader, size, values);
    if (target.width !== size) target.width = target.height = size;
    const context = target.getContext('2d');
    context.globalCompositeOperation = 'copy';
    context.drawImage(this.canvas, 0, 0);
    target.classList.add('drawn');
  }
}
