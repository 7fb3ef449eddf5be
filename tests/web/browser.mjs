// SPDX-License-Identifier: Apache-2.0
// A headless Chromium by its debugging pipe, without any package: opens a page, asks it, drops files on it, takes pictures,
// and notes every request that leaves it and everything that it prints.
import {spawn} from 'node:child_process';
import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

const pause = ms => new Promise(done => setTimeout(done, ms));

export class Browser {
  static async open({webgl = true} = {}) {
    const out = new Browser();
    out.profile = mkdtempSync(join(tmpdir(), 'etak-web-'));
    const drawing = webgl ? ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] : ['--disable-gpu', '--disable-3d-apis'];
    out.chromium = spawn(process.env.CHROMIUM ?? 'chromium', ['--headless', '--no-sandbox', '--lang=de-DE', ...drawing,
      `--user-data-dir=${out.profile}`, '--remote-debugging-pipe', 'about:blank'], {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
    out.waiting = new Map();
    out.pages = new Map();
    let rest = '';
    out.chromium.stdio[4].on('data', data => {
      const texts = (rest + data).split('\0');
      rest = texts.pop();
      for (const text of texts) out.take(JSON.parse(text));
    });
    out.chromium.on('exit', () => { for (const {failed} of out.waiting.values()) failed(new Error('Chromium has ended')); });
    await out.call('Browser.setDownloadBehavior', {behavior: 'allow', downloadPath: out.profile});
    return out;
  }

  take(message) {
    if (message.id === undefined) { this.pages.get(message.sessionId)?.event(message); return; }
    const {done, failed} = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.error) failed(new Error(message.error.message)); else done(message.result);
  }

  call(method, params = {}, sessionId = undefined) {
    const id = this.next = (this.next ?? 0) + 1;
    return new Promise((done, failed) => {
      this.waiting.set(id, {done, failed});
      this.chromium.stdio[3].write(`${JSON.stringify({id, method, params, sessionId})}\0`);
    });
  }

  async page(url, {width = 1280, height = 900, dark = false} = {}) {
    const {targetId} = await this.call('Target.createTarget', {url: 'about:blank'});
    const {sessionId} = await this.call('Target.attachToTarget', {targetId, flatten: true});
    const page = new Page(this, targetId, sessionId);
    this.pages.set(sessionId, page);
    for (const domain of ['Page', 'Runtime', 'Network', 'DOM', 'Log']) await page.call(`${domain}.enable`);
    await page.call('Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value: dark ? 'dark' : 'light'}]});
    await page.size(width, height);
    await page.call('Page.navigate', {url});
    return page;
  }

  async close() {
    const ended = new Promise(done => this.chromium.on('exit', done));
    this.call('Browser.close').catch(() => {});
    await ended;
    rmSync(this.profile, {recursive: true, force: true, maxRetries: 20, retryDelay: 100});
  }
}

class Page {
  constructor(browser, targetId, sessionId) {
    Object.assign(this, {browser, targetId, sessionId, requests: [], printed: []});
  }
  call(method, params) { return this.browser.call(method, params, this.sessionId); }
  close() { return this.browser.call('Target.closeTarget', {targetId: this.targetId}); }
  size(width, height) { return this.call('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: 1, mobile: width < 500}); }

  event({method, params}) {
    if (method === 'Network.requestWillBeSent') this.requests.push(params.request.url);
    if (method === 'Runtime.consoleAPICalled') this.printed.push(params.args.map(each => each.value ?? each.description).join(' '));
    if (method === 'Runtime.exceptionThrown') this.printed.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === 'Log.entryAdded') this.printed.push(params.entry.text);
    if (method === 'Page.javascriptDialogOpening') this.printed.push(`a dialogue: ${params.message}`);
  }

  /** The value of an expression, which may be a promise. */
  async value(expression) {
    const {result, exceptionDetails} = await this.call('Runtime.evaluate', {expression, returnByValue: true, awaitPromise: true, userGesture: true});
    if (exceptionDetails) throw new Error(`${expression}: ${exceptionDetails.exception?.description ?? exceptionDetails.text}`);
    return result.value;
  }

  /** Waits until an expression is true. */
  async until(expression, seconds = 30) {
    for (const end = Date.now() + seconds * 1000; Date.now() < end; await pause(50)) if (await this.value(expression).catch(() => false)) return;
    throw new Error(`after ${seconds} s still not: ${expression}; the page says: ${await this.value('document.body.innerText.slice(0, 600)')}; ${this.printed.join('; ')}`);
  }

  async key(key, {shift = false} = {}) {
    const text = key.length === 1 ? key : undefined;
    for (const type of ['keyDown', 'keyUp']) await this.call('Input.dispatchKeyEvent', {type, key, code: key, text, modifiers: shift ? 8 : 0,
      windowsVirtualKeyCode: {Enter: 13, Escape: 27, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40, Tab: 9}[key] ?? 0});
  }

  /** Drops files and folders of the disk in the middle of the window. */
  async drop(...files) {
    const data = {items: [], files, dragOperationsMask: 1};
    for (const type of ['dragEnter', 'dragOver', 'drop']) await this.call('Input.dispatchDragEvent', {type, x: 300, y: 400, data});
  }

  async picture(file) { writeFileSync(file, Buffer.from((await this.call('Page.captureScreenshot', {})).data, 'base64')); }
}
