// browser.mjs — a headless browser, told what to do by the DevTools protocol over a pipe: no further
// package, no open port.

import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const kNames = ['chromium', 'chromium-browser', 'google-chrome'];

/** Resolves when the process runs; rejects if there is no such program. */
function started(name, args) {
  return new Promise((resolve, reject) => {
    const child = spawn(name, args, { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    child.once('spawn', () => resolve(child));
    child.once('error', reject);
  });
}

export class Browser {
  /** `flags` besides those that every test needs. */
  static async open(flags = []) {
    const profile = mkdtempSync(join(tmpdir(), 'kadr-page-'));
    const args = [
      '--headless=new', '--no-sandbox', '--remote-debugging-pipe', `--user-data-dir=${profile}`,
      '--no-first-run', '--disable-extensions', '--disable-background-networking', '--disable-sync',
      '--disable-component-update', '--hide-scrollbars', '--mute-audio', '--disable-dev-shm-usage',
      ...flags, 'about:blank',
    ];
    for (const name of kNames) {
      try {
        return new Browser(await started(name, args), profile);
      } catch (error) {
        if (error.code !== 'ENOENT') throw error;
      }
    }
    throw new Error(`none of ${kNames.join(', ')} is there: ./scripts/setup --tests installs chromium`);
  }

  constructor(child, profile) {
    this.child = child;
    this.profile = profile;
    this.next = 1;
    this.waiting = new Map();
    this.listeners = [];
    let rest = '';
    child.stdio[4].setEncoding('utf8');
    child.stdio[4].on('data', (piece) => {
      const messages = (rest + piece).split('\0');
      rest = messages.pop();
      for (const message of messages) this.#take(JSON.parse(message));
    });
  }

  send(method, params = {}, sessionId = undefined) {
    const id = this.next++;
    this.child.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject, method }));
  }

  async newTab(width, height) {
    const { targetId } = await this.send('Target.createTarget', { url: 'about:blank', newWindow: true, width, height });
    const { sessionId } = await this.send('Target.attachToTarget', { targetId, flatten: true });
    const tab = new Tab(this, sessionId);
    await tab.prepare(width, height);
    return tab;
  }

  async close() {
    const ended = new Promise((resolve) => this.child.once('exit', resolve));
    await this.send('Browser.close').catch(() => this.child.kill());
    await ended;
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }

  #take(message) {
    const waiting = this.waiting.get(message.id);
    if (waiting) {
      this.waiting.delete(message.id);
      if (message.error) waiting.reject(new Error(`${waiting.method}: ${message.error.message}`));
      else waiting.resolve(message.result);
    } else {
      for (const listener of this.listeners) listener(message);
    }
  }
}

class Tab {
  constructor(browser, sessionId) {
    this.browser = browser;
    this.sessionId = sessionId;
    this.complaints = []; // of the console, exceptions that nobody caught, requests that failed
    browser.listeners.push((message) => message.sessionId === sessionId && this.#listen(message));
  }

  send(method, params) {
    return this.browser.send(method, params, this.sessionId);
  }

  async prepare(width, height) {
    for (const domain of ['Page', 'Runtime', 'Log', 'Network']) await this.send(`${domain}.enable`);
    const offline = { offline: true, latency: 0, downloadThroughput: 0, uploadThroughput: 0 };
    await this.send('Network.emulateNetworkConditions', offline);
    await this.size(width, height);
  }

  size(width, height, mobile = false) {
    const metrics = { width, height, deviceScaleFactor: 1, mobile };
    return this.send('Emulation.setDeviceMetricsOverride', metrics);
  }

  theme(name) {
    return this.send('Emulation.setEmulatedMedia', {
      features: [{ name: 'prefers-color-scheme', value: name }],
    });
  }

  async open(url) {
    const loaded = new Promise((resolve) => {
      this.onLoad = resolve;
    });
    await this.send('Page.navigate', { url });
    await loaded;
  }

  /** The value of an expression, or of what it promises. */
  async evaluate(expression) {
    const { result, exceptionDetails } = await this.send('Runtime.evaluate', {
      expression, awaitPromise: true, returnByValue: true,
    });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  /** Two frames later what was changed is on the screen. */
  settled() {
    return this.evaluate('new Promise(r => requestAnimationFrame(() => requestAnimationFrame(() => r(true))))');
  }

  async key(key, { shift = false } = {}) {
    const code = key === ' ' ? 'Space' : key;
    const text = key === ' ' ? ' ' : undefined;
    const event = { key, code, text, modifiers: shift ? 8 : 0 };
    await this.send('Input.dispatchKeyEvent', { type: 'keyDown', ...event });
    await this.send('Input.dispatchKeyEvent', { type: 'keyUp', ...event });
  }

  async click(x, y) {
    const event = { x, y, button: 'left', clickCount: 1 };
    await this.send('Input.dispatchMouseEvent', { type: 'mouseMoved', x, y });
    await this.send('Input.dispatchMouseEvent', { type: 'mousePressed', ...event });
    await this.send('Input.dispatchMouseEvent', { type: 'mouseReleased', ...event });
  }

  /** On the middle of an element, as a person would; scrolled to if need be. */
  async clickOn(selector) {
    const place = await this.evaluate(`(() => {
      const element = document.querySelector(${JSON.stringify(selector)});
      element.scrollIntoView({ block: 'nearest' });
      const box = element.getBoundingClientRect();
      return [box.x + box.width / 2, box.y + box.height / 2];
    })()`);
    await this.click(...place);
  }

  text(selector) {
    return this.evaluate(`document.querySelector(${JSON.stringify(selector)}).textContent`);
  }

  /** PNG, as base64. */
  async screenshot() {
    return (await this.send('Page.captureScreenshot', { format: 'png' })).data;
  }

  #listen({ method, params }) {
    if (method === 'Page.loadEventFired') this.onLoad?.();
    if (method === 'Runtime.exceptionThrown') {
      const { exception, text } = params.exceptionDetails;
      this.complaints.push(exception?.description ?? text);
    }
    if (method === 'Runtime.consoleAPICalled' && ['error', 'warning', 'assert'].includes(params.type)) {
      this.complaints.push(`${params.type}: ${params.args.map((a) => a.value ?? a.description).join(' ')}`);
    }
    if (method === 'Log.entryAdded' && params.entry.level === 'error') this.complaints.push(params.entry.text);
    if (method === 'Network.requestWillBeSent' && /^(https?|wss?):/.test(params.request.url)) {
      this.complaints.push(`asks the network for ${params.request.url}`);
    }
  }
}
