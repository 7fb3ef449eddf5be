// SPDX-License-Identifier: Apache-2.0
'use strict';
// "What is this colour?": a typed or picked colour, or a pixel of a picture, and the materials that it could be.

const colour = {
  token: 0, spot: [0, 0],

  open() {
    $('ask').addEventListener('submit', event => { event.preventDefault(); this.ask($('typed').value); });
    $('picked').addEventListener('input', event => this.ask(event.target.value));
    $('picture-file').addEventListener('change', event => this.picture(event.target.files[0]));
    if ('EyeDropper' in window) {
      $('dropper').hidden = false;
      $('dropper').addEventListener('click', async () => {
        try { this.ask((await new EyeDropper().open()).sRGBHex); } catch { say('No colour was picked.'); }
      });
    }
    $('picture').addEventListener('click', event => {
      const box = event.target.getBoundingClientRect();
      this.take((event.clientX - box.left) / box.width * event.target.width, (event.clientY - box.top) / box.height * event.target.height);
    });
    $('picture').addEventListener('keydown', event => {
      const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1], Enter: [0, 0]}[event.key];
      if (!step) return;
      const far = event.shiftKey ? 16 : 1;
      this.take(this.spot[0] + step[0] * far, this.spot[1] + step[1] * far);
      event.preventDefault();
    });
  },

  async ask(typed) {
    const token = ++this.token, text = typed.trim();
    $('typed').value = text;
    if (/^#[0-9a-f]{6}$/i.test(text)) {
      $('picked').value = text.toLowerCase();
      state.colour = text.toLowerCase().slice(1);
      writeFragment();
    }
    try {
      // Behind "--", so that what is typed is a colour and never an option.
      const [found, near] = await Promise.all([engine.json(['identify', ...computeWords(), '--', text]),
        engine.json(['nearest', '-n', '6', ...computeWords(), '--', text])]);
      const said = await engine.run(['identify', ...computeWords(), '--', text]);
      if (token === this.token) this.show(text, found.results[0], near.nearest, said.out.split('\n')[0]);
    } catch (error) {
      if (token === this.token) $('answer').replaceChildren(el('p', {class: 'problem', role: 'alert'}, error.message));
    }
  },

  show(text, found, near, verdict) {
    const rows = found.candidates.filter(each => each.p >= 0.005).slice(0, 12).map(each => {
      const entry = library.get(each.id);
      return [el('button', {type: 'button', class: 'link', click: () => choose(each.id)}, swatch(entry?.row?.hex ?? entry?.hex), entry?.name ?? each.id),
        fixed(each.p, 2), fixed(each.delta_e, 1), each.band_share === null ? '-' : fixed(each.band_share, 2), entry?.class ?? ''];
    });
    const groups = found.groups.map(group => el('li', {}, `Not told apart by this colour: ${group.map(id => library.get(id)?.name ?? id).join(', ')}.`));
    $('answer').replaceChildren(
      el('p', {class: 'verdict'}, swatch(/^#/.test(text) ? text : null, 'patch'), verdict),
      rows.length ? table(['material', 'probability', 'ΔE', 'of band', 'family'], rows) : el('p', {class: 'empty'}, 'No material comes near this colour.'),
      el('p', {class: 'soft'}, 'ΔE is CIEDE2000; "of band" is ΔE over the distance within which nine of ten new publications of the material would lie.'),
      el('ul', {class: 'soft'}, groups), el('h3', {}, 'Nearest in colour alone'),
      nearList(near.map(each => ({...each, text: `ΔE ${fixed(each.delta_e2000, 2)}`}))));
    say(verdict);
  },

  /** Shows a picture to pick from. */
  async picture(file) {
    if (!file) return;
    try {
      const image = await createImageBitmap(file), share = Math.min(1, 1600 / Math.max(image.width, image.height));
      const canvas = $('picture');
      canvas.width = Math.max(1, Math.round(image.width * share));
      canvas.height = Math.max(1, Math.round(image.height * share));
      canvas.getContext('2d', {willReadFrequently: true}).drawImage(image, 0, 0, canvas.width, canvas.height);
      this.spot = [canvas.width / 2, canvas.height / 2];
      canvas.hidden = $('picture-said').hidden = false;
      complain('');
    } catch {
      complain(`${file.name}: this browser cannot show it as a picture.`);
    }
  },

  take(x, y) {
    const canvas = $('picture');
    this.spot = [Math.min(canvas.width - 1, Math.max(0, Math.floor(x))), Math.min(canvas.height - 1, Math.max(0, Math.floor(y)))];
    const [r, g, b] = canvas.getContext('2d', {willReadFrequently: true}).getImageData(...this.spot, 1, 1).data;
    this.ask(`#${[r, g, b].map(code => code.toString(16).padStart(2, '0')).join('')}`);
  },
};
