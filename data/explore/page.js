'use strict';
// The page of blackhole explore. It keeps no scene of its own making: it sends what the
// user does, and shows the scene and the pictures that come back. The history and the
// keyframes live here. docs/explore.md describes the messages.

const $ = id => document.getElementById(id);
const element = (name, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};

// ---------------------------------------------------------------------------------------
// State

let table = null;              // what the program knows of settings and presets
let values = {};               // the present scene: text by path
let idle = {};                 // settings without effect, with what they need
let preset = 'default';
let socket = null;
let input = 0;                 // number of the latest input sent
let awaited = 0;               // scenes of earlier inputs are those of a new connection
let confirmed = 0;             // number of the latest input whose scene has come back
let size = [0, 0];             // of the latest picture
let retry = 250;
// For measurements: when inputs were sent, and what was drawn when.
const stats = { frames: 0, stage: -1, done: 0, latencies: [], drawn: [], input: 0, errors: [] };
const sentAt = new Map();

const settingsByPath = new Map();
const controls = new Map();    // path → functions that show a value

// ---------------------------------------------------------------------------------------
// Talking

function send(text) {
  if (socket && socket.readyState === WebSocket.OPEN) socket.send(text);
}

// An input that changes the picture: a word, arguments, and lines.
function act(word, args = [], lines = []) {
  input += 1;
  sentAt.set(input, performance.now());
  if (sentAt.size > 500) sentAt.delete(sentAt.keys().next().value);
  send([[word, input, ...args].join(' '), ...lines].join('\n'));
}

// Inputs that come faster than the screen are sent once for each of its frames.
const waiting = { steer: null, settings: new Map(), scheduled: false };

function schedule() {
  if (waiting.scheduled) return;
  waiting.scheduled = true;
  requestAnimationFrame(flush);
}

function flush() {
  waiting.scheduled = false;
  if (waiting.steer) {
    const { word, args } = waiting.steer;
    waiting.steer = null;
    act(word, args.map(number));
  }
  if (waiting.settings.size) {
    const lines = [...waiting.settings].map(([path, value]) => path + ' ' + value);
    waiting.settings.clear();
    act('change', [], lines);
  }
}

function number(v) {
  return String(+v.toFixed(6));
}

function steer(word, args, combine = (a, b) => a + b) {
  if (waiting.steer && waiting.steer.word !== word) flush();
  waiting.steer = { word, args: waiting.steer ? waiting.steer.args.map((a, k) => combine(a, args[k])) : args };
  schedule();
}

function change(path, value, label) {
  waiting.settings.set(path, value);
  schedule();
  settle(label || nameOf(path));
}

function connect() {
  socket = new WebSocket(location.href.replace(/^http/, 'ws').replace(/[^/]*$/, '') + 'talk');
  socket.binaryType = 'arraybuffer';
  socket.onopen = () => {
    retry = 250;
    newest = -1;
    $('lost').hidden = true;
    sendWindow(true);
    if (Object.keys(values).length) {
      act('restore', [preset], linesOf(values));
      awaited = input;
    }
    if (keys.length) defineAnimation();
  };
  socket.onmessage = event => {
    if (typeof event.data === 'string') receive(JSON.parse(event.data));
    else showFrame(event.data);
  };
  socket.onclose = () => {
    $('lost').hidden = false;
    setTimeout(connect, retry);
    retry = Math.min(4000, retry * 1.6);
  };
}

function linesOf(scene) {
  return Object.entries(scene).map(([path, value]) => path + ' ' + value);
}

function receive(message) {
  switch (message.type) {
    case 'scene': return showScene(message);
    case 'refused':
      toast(message.lines.join('\n'), true);
      stats.errors.push(message.lines.join('; '));
      if (message.input) {
        confirmed = Math.max(confirmed, message.input);
        stats.input = Math.max(stats.input, message.input);
      }
      return refresh();
    case 'pixel': return showPixel(message);
    case 'command': return copyCommand(message);
    case 'saved': return toast('Saved ' + message.file);
    case 'exists': return askAgain(message.file);
    case 'animation': return showAnimation(message);
    case 'job': return showJob(message);
  }
}

// ---------------------------------------------------------------------------------------
// Scene and history

function showScene(message) {
  if (message.input < awaited) return;
  if (inspected && !same(values, message.values)) {
    inspected = null;
    placeMark();
  }
  values = message.values;
  idle = message.idle;
  preset = message.preset;
  confirmed = Math.max(confirmed, message.input);
  refresh();
  remember();
  if (!steps.length) push('Start');
  else if (settling && confirmed >= input) finishStep();
}

function refresh() {
  for (const [path, shown] of controls) for (const show of shown) show(values[path], idle[path]);
  for (const button of $('presets').children) button.setAttribute('aria-pressed', String(button.dataset.name === preset));
}

// A reload of the page keeps the scene and the animation.
function remember() {
  try {
    sessionStorage.setItem('scene', JSON.stringify({ values, preset, keys, length: +$('duration').value, rate: +$('rate').value, way: $('way').value }));
  } catch (_) { /* it is only a convenience */ }
}

function recall() {
  try {
    const kept = JSON.parse(sessionStorage.getItem('scene'));
    if (!kept) return;
    values = kept.values;
    preset = kept.preset;
    keys = kept.keys;
    $('duration').value = kept.length;
    $('rate').value = kept.rate;
    $('way').value = kept.way;
  } catch (_) { /* as above */ }
}

const steps = [];
let step = -1;
let settling = null;           // the label of the step in the making
let settleTimer = 0;
let held = false;              // a gesture is going on

// Changes that follow each other closely are one step of the history.
function settle(label) {
  if (settling && settling !== label) finishStep();
  settling = label;
  clearTimeout(settleTimer);
  settleTimer = setTimeout(() => {
    if (held) settle(label);
    else if (confirmed >= input) finishStep();
  }, 400);
}

function finishStep() {
  if (held || waiting.scheduled) return;
  clearTimeout(settleTimer);
  const label = settling;
  settling = null;
  if (label && !same(values, steps[step].values)) push(label);
}

function same(a, b) {
  const names = Object.keys(a);
  return names.length === Object.keys(b).length && names.every(name => a[name] === b[name]);
}

function push(label) {
  steps.splice(step + 1);
  steps.push({ label, values, preset });
  if (steps.length > 300) steps.shift();
  step = steps.length - 1;
  showSteps();
}

function goTo(index) {
  if (index < 0 || index >= steps.length || index === step) return;
  settling = null;
  step = index;
  act('restore', [steps[step].preset], linesOf(steps[step].values));
  showSteps();
}

function showSteps() {
  $('undo').disabled = step <= 0;
  $('redo').disabled = step >= steps.length - 1;
  $('steps').replaceChildren(...steps.map(({ label }, index) => {
    const button = element('button', { type: 'button', textContent: label, className: index > step ? 'undone' : '' });
    if (index === step) button.setAttribute('aria-current', 'step');
    button.onclick = () => goTo(index);
    return element('li', {}, button);
  }));
  if (!$('history').hidden) $('steps').lastChild?.scrollIntoView({ block: 'nearest' });
}

// ---------------------------------------------------------------------------------------
// The view

const view = $('view');
const context = view.getContext('2d', { alpha: false });
let newest = -1;

function sendWindow(force) {
  const box = $('frame').getBoundingClientRect();
  const ratio = window.devicePixelRatio || 1;
  const w = Math.max(1, Math.min(7680, Math.round(box.width * ratio)));
  const h = Math.max(1, Math.min(7680, Math.round(box.height * ratio)));
  if (force || w !== sendWindow.w || h !== sendWindow.h) send(`window ${w} ${h}`);
  sendWindow.w = w;
  sendWindow.h = h;
}

async function showFrame(data) {
  const head = new DataView(data);
  const [stage, done] = [head.getUint8(0), head.getUint8(1) / 255];
  const [width, height] = [head.getUint16(2), head.getUint16(4)];
  const [frame, seen] = [head.getUint32(6), head.getUint32(10)];
  const kind = stage === 2 ? 'image/png' : 'image/jpeg';
  try {
    const picture = await createImageBitmap(new Blob([new Uint8Array(data, 16)], { type: kind }));
    if (frame > newest) {
      newest = frame;
      drawPicture(picture, width, height);
      report(stage, done, width, height, seen);
      if (stage === 2) stats.finished = new Blob([new Uint8Array(data, 16)], { type: kind });
    }
    picture.close();
  } catch (problem) {
    stats.errors.push(String(problem));
  }
  send('drawn ' + frame);
}

function drawPicture(picture, width, height) {
  const box = $('frame').getBoundingClientRect();
  const ratio = window.devicePixelRatio || 1;
  const share = Math.min(box.width / width, box.height / height);
  const across = Math.max(1, Math.round(width * share * ratio));
  const down = Math.max(1, Math.round(height * share * ratio));
  // A picture of about the view's size is shown pixel for pixel.
  const exact = Math.abs(width - across) < 3 && Math.abs(height - down) < 3;
  const [w, h] = exact ? [width, height] : [across, down];
  if (view.width !== w || view.height !== h) {
    view.width = w;
    view.height = h;
    view.style.width = w / ratio + 'px';
    view.style.height = h / ratio + 'px';
    placeMark();
  }
  context.imageSmoothingQuality = 'high';
  context.drawImage(picture, 0, 0, w, h);
  size = [width, height];
  drawHistogram(picture);
}

function report(stage, done, width, height, seen) {
  const now = performance.now();
  stats.frames += 1;
  stats.stage = stage;
  stats.done = done;
  stats.size = [width, height];
  stats.drawn.push({ at: now, stage, width, height, input: seen });
  if (stats.drawn.length > 5000) stats.drawn.splice(0, 1000);
  if (seen > stats.input && sentAt.has(seen)) {
    stats.latencies.push(now - sentAt.get(seen));
    if (stats.latencies.length > 5000) stats.latencies.splice(0, 1000);
  }
  stats.input = Math.max(stats.input, seen);
  const word = ['moving', done > 0 ? 'refining, ' + Math.round(100 * done) + ' %' : 'refining', 'finished'][stage];
  $('status').textContent = `${width} × ${height} · ${word}`;
  $('progress').hidden = stage !== 1;
  $('progress').firstElementChild.style.width = 100 * done + '%';
}

// The codes of the picture on the display, as in photo editors.
const small = new OffscreenCanvas(160, 90).getContext('2d', { willReadFrequently: true });
let histogramAt = 0;

function drawHistogram(picture) {
  const now = performance.now();
  if (now - histogramAt < 150 && stats.stage === 0) return;
  histogramAt = now;
  small.drawImage(picture, 0, 0, 160, 90);
  const pixels = small.getImageData(0, 0, 160, 90).data;
  const bins = [0, 1, 2].map(() => new Uint32Array(64));
  let bright = 0;
  let dark = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    for (let c = 0; c < 3; c += 1) bins[c][pixels[i + c] >> 2] += 1;
    const most = Math.max(pixels[i], pixels[i + 1], pixels[i + 2]);
    if (most >= 254) bright += 1;
    if (most <= 1) dark += 1;
  }
  const canvas = $('histogram');
  const ink = canvas.getContext('2d');
  const [w, h] = [canvas.width, canvas.height];
  ink.clearRect(0, 0, w, h);
  ink.globalCompositeOperation = 'lighter';
  // The dark sky would leave nothing of the rest.
  const top = Math.log1p(Math.max(...bins.map(b => Math.max(...b.subarray(1)))) || 1);
  bins.forEach((b, c) => {
    ink.fillStyle = ['rgb(158 32 28)', 'rgb(28 126 38)', 'rgb(26 54 148)'][c];
    ink.beginPath();
    ink.moveTo(0, h);
    b.forEach((n, k) => ink.lineTo((k + 0.5) * w / 64, h - Math.min(1, Math.log1p(n) / top) * (h - 4)));
    ink.lineTo(w, h);
    ink.fill();
  });
  ink.globalCompositeOperation = 'source-over';
  const part = n => (100 * n / (pixels.length / 4)).toFixed(n ? 1 : 0) + ' %';
  $('clipped').textContent = `${part(bright)} at full white · ${part(dark)} black`;
}

// Drag, pinch, wheel.
const pointers = new Map();
let gesture = null;

view.addEventListener('pointerdown', event => {
  if (event.button !== 0) return;
  view.setPointerCapture(event.pointerId);
  pointers.set(event.pointerId, [event.clientX, event.clientY]);
  gesture = { moved: pointers.size > 1, look: event.shiftKey, x: event.clientX, y: event.clientY, spread: spread() };
  held = true;
  view.classList.add('held');
  hideTip();
});

view.addEventListener('pointermove', event => {
  const before = pointers.get(event.pointerId);
  if (!before || !gesture) return;
  const [dx, dy] = [event.clientX - before[0], event.clientY - before[1]];
  pointers.set(event.pointerId, [event.clientX, event.clientY]);
  if (pointers.size > 1) {
    const now = spread();
    if (gesture.spread > 0 && now > 0) approach(gesture.spread / now);
    gesture.spread = now;
    return;
  }
  if (!gesture.moved && Math.hypot(event.clientX - gesture.x, event.clientY - gesture.y) < 4) return;
  if (!gesture.moved) {
    gesture.moved = true;
    drag(event.clientX - gesture.x, event.clientY - gesture.y, gesture.look);
  } else {
    drag(dx, dy, gesture.look);
  }
});

function endPointer(event) {
  if (!pointers.delete(event.pointerId) || pointers.size) return;
  held = false;
  view.classList.remove('held');
  if (event.type === 'pointerup' && gesture && !gesture.moved) inspectAt(event.clientX, event.clientY);
  gesture = null;
}
view.addEventListener('pointerup', endPointer);
view.addEventListener('pointercancel', endPointer);

function spread() {
  const points = [...pointers.values()];
  return points.length < 2 ? 0 : Math.hypot(points[0][0] - points[1][0], points[0][1] - points[1][1]);
}

// Pixels on the screen, turned back by the camera's roll.
function drag(dx, dy, look) {
  const roll = (parseFloat(values['camera.roll']) || 0) * Math.PI / 180;
  const right = dx * Math.cos(roll) - dy * Math.sin(roll);
  const down = dx * Math.sin(roll) + dy * Math.cos(roll);
  const width = view.getBoundingClientRect().width || 1;
  if (look) {
    const angle = (parseFloat(values['camera.fov']) || 40) / width;
    steer('look', [-dx * angle, dy * angle]);
    settle('Look around');
  } else {
    orbit(right * 180 / width, -down * 180 / width);
  }
}

function orbit(azimuth, inclination) {
  steer('orbit', [azimuth, inclination]);
  settle('Orbit');
}

function approach(factor) {
  steer('approach', [Math.max(0.1, Math.min(10, factor))], (a, b) => Math.max(0.02, Math.min(50, a * b)));
  settle('Move nearer or farther');
}

view.addEventListener('wheel', event => {
  event.preventDefault();
  const unit = event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1;
  approach(Math.exp(Math.max(-240, Math.min(240, event.deltaY * unit)) * (event.ctrlKey ? 0.006 : 0.0012)));
}, { passive: false });

document.addEventListener('keydown', event => {
  if ((event.target !== view && event.target !== document.body) || document.querySelector('dialog[open]')) return;
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const turn = event.shiftKey ? (parseFloat(values['camera.fov']) || 40) / 40 : 1.5;
  const arrow = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
  const rolls = { q: -1, e: 1 }[event.key.toLowerCase()];
  if (arrow) {
    if (event.shiftKey) { steer('look', arrow.map(a => a * turn)); settle('Look around'); }
    else orbit(-arrow[0] * turn, -arrow[1] * turn);
  } else if (event.key === '+' || event.key === '=') approach(0.95);
  else if (event.key === '-' || event.key === '_') approach(1 / 0.95);
  else if (rolls) { steer('roll', [rolls]); settle('Roll'); }
  else if (event.key === '[' || event.key === ']') {
    const most = values['camera.projection'] === 'perspective' ? 170 : 360;
    const fov = (parseFloat(waiting.settings.get('camera.fov') || values['camera.fov']) || 40) * (event.key === '[' ? 0.96 : 1 / 0.96);
    change('camera.fov', String(+Math.min(most, Math.max(0.1, fov)).toPrecision(4)), 'Field of view');
  } else if (event.key.toLowerCase() === 'h') { act('face'); settle('Look at the hole'); }
  else if (event.key.toLowerCase() === 'k') addKey();
  else if (event.key === ' ') togglePlay();
  else if (event.key === 'Enter') {
    const box = view.getBoundingClientRect();
    inspectAt(box.left + box.width / 2, box.top + box.height / 2);
  } else return;
  event.preventDefault();
});

addEventListener('keydown', event => {
  const typing = event.target.matches?.('input[type="text"], input[type="search"], input[type="number"]');
  if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === 'z' && !typing && !document.querySelector('dialog[open]')) {
    event.preventDefault();
    goTo(step + (event.shiftKey ? 1 : -1));
  } else if (event.key === '?' && !typing && !document.querySelector('dialog[open]')) {
    event.preventDefault();
    $('keys-help').showModal();
  } else if (event.key === 'Escape') hideTip();
});

// ---------------------------------------------------------------------------------------
// Pixels

let inspected = null;

function inspectAt(clientX, clientY) {
  const box = view.getBoundingClientRect();
  inspected = [(clientX - box.left) / box.width, (clientY - box.top) / box.height].map(v => Math.min(1, Math.max(0, v)));
  send(`inspect ${inspected.map(number).join(' ')}`);
  placeMark();
  choose('pixel');
}

function placeMark() {
  $('mark').hidden = !inspected;
  if (!inspected) return;
  const [outer, inner] = [$('frame').getBoundingClientRect(), view.getBoundingClientRect()];
  $('mark').style.left = inner.left - outer.left + inspected[0] * inner.width + 'px';
  $('mark').style.top = inner.top - outer.top + inspected[1] * inner.height + 'px';
}

function showPixel(message) {
  $('pixel-hint').hidden = true;
  $('pixel-found').hidden = false;
  $('report').textContent = message.lines.join('\n');
  const [x, y, z] = message.camera;
  const out = Math.hypot(x, z) || 1;
  // To the right is towards the camera, also from above.
  const toCamera = p => (p[0] * x + p[2] * z) / out;
  const beside = p => (p[0] * z - p[2] * x) / out;
  const reach = 1.25 * Math.max(5, message.disk ? message.disk.outer : 0, 3 * message.horizon);
  drawPath($('side'), message, reach, p => [toCamera(p), -p[1]], true);
  drawPath($('top'), message, reach, p => [toCamera(p), -beside(p)], false);
}

function drawPath(svg, message, reach, project, fromSide) {
  const scale = 96 / reach;
  const shape = (name, attributes) => {
    const made = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    return made;
  };
  const at = p => project(p).map(v => Math.max(-4000, Math.min(4000, v * scale)).toFixed(2));
  const parts = [];
  const disk = message.disk;
  if (disk && fromSide) {
    const [a, b] = [disk.inner * scale, disk.outer * scale];
    const [s, t] = disk.thickness.map(v => Math.max(0.4, v * scale));
    for (const side of [-1, 1]) parts.push(shape('polygon', { points: `${side * a},${-s} ${side * b},${-t} ${side * b},${t} ${side * a},${s}`, fill: '#ffb454', 'fill-opacity': 0.45 }));
  } else if (disk) {
    const middle = (disk.inner + disk.outer) / 2 * scale;
    parts.push(shape('circle', { r: middle, fill: 'none', stroke: '#ffb454', 'stroke-opacity': 0.3, 'stroke-width': Math.max(0, disk.outer - disk.inner) * scale }));
  }
  parts.push(shape('circle', { r: message.horizon * scale, fill: '#000', stroke: '#e9ebee', 'stroke-width': 0.6 }));
  parts.push(shape('polyline', { points: message.path.map(p => at(p).join(',')).join(' '), fill: 'none', stroke: '#7cc7ff', 'stroke-width': 1, 'stroke-linejoin': 'round' }));
  const [cx, cy] = at(message.camera);
  if (Math.abs(cx) < 100 && Math.abs(cy) < 62) parts.push(shape('circle', { cx, cy, r: 2, fill: '#fff' }));
  svg.replaceChildren(...parts);
}

// ---------------------------------------------------------------------------------------
// The panel

function nameOf(path) {
  const setting = settingsByPath.get(path);
  const name = setting ? setting.name : path;
  return name.charAt(0).toUpperCase() + name.slice(1);
}

function buildPanel() {
  for (const setting of table.settings) settingsByPath.set(setting.path, setting);
  for (const topic of table.topics) {
    const inside = element('div');
    for (const setting of table.settings.filter(s => s.topic === topic)) inside.append(row(setting));
    if (inside.children.length) $('groups').append(element('details', { open: topic === 'Camera' }, element('summary', { textContent: topic }), inside));
  }
  $('exposure').append(row(settingsByPath.get('output.exposure')));
  for (const { name, shows } of table.presets) {
    const picture = element('img', { alt: '', width: 240, height: 135, loading: 'lazy', decoding: 'async' });
    picture.dataset.src = 'preset/' + name + '.jpg';
    const button = element('button', { type: 'button' }, picture, element('span', { textContent: name }), element('small', { textContent: shows }));
    button.dataset.name = name;
    button.setAttribute('aria-pressed', 'false');
    button.onclick = () => { act('preset', [name]); settle('Preset ' + name); };
    $('presets').append(button);
  }
  for (const name of table.interpolations) $('way').append(element('option', { value: name, textContent: name }));
  $('way').value = 'smooth';
}

let rows = 0;

// A setting's label, its control, and for numbers a slider.
function row(setting) {
  rows += 1;
  const id = 'control-' + rows;
  const wide = setting.kind === 'vector' || setting.kind === 'choice-or-file';
  const box = element('div', { className: wide ? 'setting wide' : 'setting' });
  box.dataset.path = setting.path;
  const control = element('div', { className: 'control' });
  const make = { number: numberControl, whole: numberControl, seed: seedControl, switch: switchControl, choice: choiceControl, 'choice-or-file': fileControl, vector: vectorControl }[setting.kind];
  const show = make(setting, id, control, box);
  const label = setting.kind === 'vector' ? element('span', { className: 'label', id: id + '-label' }) : element('label', { htmlFor: id });
  label.textContent = nameOf(setting.path);
  box.prepend(label, control);
  const listed = controls.get(setting.path) || [];
  listed.push((value, needs) => {
    const missing = value === undefined;
    box.classList.toggle('idle', missing || needs !== undefined);
    box.classList.toggle('changed', !missing && isChanged(setting.path, value));
    for (const part of box.querySelectorAll('input, select, button')) part.disabled = missing && !settable(setting.path);
    if (!missing) show(value);
  });
  controls.set(setting.path, listed);
  describe(box, setting);
  return box;
}

// Settings that a scene has no value of, but that may be set.
function settable(path) {
  return /^camera\.(distance|inclination|azimuth|position|look-at)$/.test(path) || path === 'disk.temperature' || path === 'sky.points.count';
}

function isChanged(path, value) {
  const standard = table.presets.find(p => p.name === preset)?.values[path];
  return standard !== value;
}

function numberControl(setting, id, control, box) {
  const field = element('input', { type: 'number', id, step: 'any' });
  if (setting.least !== undefined) field.min = setting.least;
  if (setting.most !== undefined) field.max = setting.most;
  const read = () => {
    const v = Number(field.value);
    return field.value.trim() === '' || !Number.isFinite(v) ? null : setting.kind === 'whole' ? Math.round(v) : v;
  };
  field.addEventListener('change', () => {
    const v = read();
    if (v === null) refresh();
    else change(setting.path, String(v));
  });
  control.append(field);
  const unit = shortUnit(setting.unit);
  if (unit) control.append(element('span', { className: 'unit', textContent: unit, title: setting.unit }));
  const bar = setting.slider ? sliderOf(setting, v => { field.value = v; change(setting.path, v); }) : null;
  if (bar) box.append(bar.element);
  return value => {
    if (document.activeElement !== field || !field.matches(':focus') || Number(field.value) === Number(value) || !dirty(field)) field.value = shown(value);
    if (bar) bar.show(parseFloat(value));
  };
}

// Whether the user is typing in a field.
function dirty(field) {
  return field === dirty.field;
}
addEventListener('input', event => { if (event.target.matches('input[type="number"], input[type="text"]')) dirty.field = event.target; });
addEventListener('change', () => { dirty.field = null; });

// A number as people read it, up to six digits.
function shown(text) {
  const v = parseFloat(text);
  return Number.isFinite(v) && !Number.isInteger(v) ? String(+v.toPrecision(6)) : text;
}

function shortUnit(unit) {
  if (!unit) return '';
  if (unit.startsWith('degrees')) return '°';
  return { 'Schwarzschild radii': 'r_s', kelvin: 'K', pixels: 'px', 'r_s/c': 'r_s/c', radians: 'rad' }[unit] || '';
}

function sliderOf(setting, act) {
  const { scale, low, high, zero } = setting.slider;
  const bar = element('input', { type: 'range', min: 0, max: 1, step: 0.0025 });
  bar.setAttribute('aria-label', nameOf(setting.path));
  const valueAt = t => {
    if (scale === 'log') return zero && t <= 0 ? 0 : low * (high / low) ** t;
    return low + t * (high - low);
  };
  const placeOf = v => {
    if (scale === 'log') return v <= low ? 0 : Math.log(v / low) / Math.log(high / low);
    return (v - low) / (high - low);
  };
  const text = v => {
    if (setting.kind === 'whole') return String(Math.round(v));
    if (scale === 'log') return String(+v.toPrecision(3));
    return String(+v.toFixed(Math.max(0, Math.ceil(-Math.log10((high - low) / 400)))));
  };
  // Excluded bounds cannot be set.
  const inside = v => {
    if (setting.above && v <= setting.least) return low + (high - low) / 400;
    if (setting.below && v >= setting.most) return high - (high - low) / 400;
    return v;
  };
  bar.addEventListener('input', () => act(text(inside(valueAt(+bar.value)))));
  bar.addEventListener('pointerdown', () => { held = true; bar.dataset.held = '1'; });
  const release = () => { held = false; delete bar.dataset.held; };
  bar.addEventListener('pointerup', release);
  bar.addEventListener('pointercancel', release);
  return {
    element: bar,
    show: v => {
      if (!bar.dataset.held) bar.value = Math.max(0, Math.min(1, placeOf(v)));
      bar.setAttribute('aria-valuetext', shown(String(v)) + ' ' + (setting.unit || ''));
    }
  };
}

function seedControl(setting, id, control) {
  const field = element('input', { type: 'text', id, inputMode: 'numeric', pattern: '[0-9]+' });
  field.addEventListener('change', () => change(setting.path, field.value.trim() || '0'));
  const dice = element('button', { type: 'button', textContent: 'Random' });
  dice.setAttribute('aria-label', 'Random ' + setting.name);
  dice.onclick = () => change(setting.path, String(crypto.getRandomValues(new Uint32Array(1))[0]));
  control.append(field, dice);
  return value => { if (!dirty(field)) field.value = value; };
}

function switchControl(setting, id, control) {
  const box = element('input', { type: 'checkbox', id });
  box.addEventListener('change', () => change(setting.path, box.checked ? 'on' : 'off'));
  control.append(box);
  return value => { box.checked = value === 'on'; };
}

function options(choices) {
  return choices.map(({ name, meaning }) => element('option', { value: name, textContent: name, title: meaning }));
}

function choiceControl(setting, id, control) {
  const list = element('select', { id }, ...options(setting.choices));
  list.addEventListener('change', () => change(setting.path, list.value));
  control.append(list);
  return value => { list.value = value; };
}

function fileControl(setting, id, control) {
  const list = element('select', { id }, ...options(setting.choices), element('option', { value: './', textContent: 'file:' }));
  const field = element('input', { type: 'text', placeholder: 'name of a picture', spellcheck: false });
  field.setAttribute('aria-label', 'File of the ' + setting.name);
  const toFile = () => list.value === './';
  list.addEventListener('change', () => {
    field.hidden = !toFile();
    if (toFile()) field.focus();
    else change(setting.path, list.value);
  });
  field.addEventListener('change', () => {
    const name = field.value.trim();
    if (name) change(setting.path, /[./]/.test(name) ? name : './' + name);
  });
  control.append(list, field);
  return value => {
    const known = setting.choices.some(({ name }) => name === value);
    if (document.activeElement === field) return;
    list.value = known ? value : './';
    field.hidden = known;
    if (!known) field.value = value;
  };
}

function vectorControl(setting, id, control) {
  const fields = ['X', 'Y', 'Z'].map(axis => {
    const field = element('input', { type: 'number', step: 'any', placeholder: axis });
    field.setAttribute('aria-label', nameOf(setting.path) + ' ' + axis);
    field.addEventListener('change', () => {
      if (fields.every(f => f.value.trim() !== '')) change(setting.path, fields.map(f => String(Number(f.value))).join(','));
    });
    return field;
  });
  control.append(...fields);
  return value => value.split(',').forEach((part, k) => { if (!dirty(fields[k])) fields[k].value = shown(part); });
}

// The description of a setting, beside it while the pointer or the focus is on it.
function describe(box, setting) {
  const show = () => {
    const needs = idle[setting.path];
    const option = setting.option ? `${setting.option} · ${setting.path}` : setting.path;
    const lines = [element('span', { textContent: setting.doc + '.' })];
    if (needs) lines.push(element('span', { textContent: ' It has no effect now: it needs ' + needs + '.' }));
    lines.push(element('code', { textContent: option }));
    $('tip').replaceChildren(...lines);
    $('tip').hidden = false;
    const [target, tip] = [box.getBoundingClientRect(), $('tip').getBoundingClientRect()];
    const left = target.left - tip.width - 14;
    $('tip').style.left = Math.max(8, left > 8 ? left : Math.min(target.left, innerWidth - tip.width - 8)) + 'px';
    $('tip').style.top = Math.max(8, left > 8 ? Math.min(innerHeight - tip.height - 8, target.top) : target.top > tip.height + 16 ? target.top - tip.height - 8 : target.bottom + 8) + 'px';
  };
  let timer = 0;
  box.addEventListener('pointerenter', event => { if (event.pointerType === 'mouse') timer = setTimeout(show, 350); });
  box.addEventListener('pointerleave', () => { clearTimeout(timer); hideTip(); });
  box.addEventListener('focusin', event => { if (event.target.matches(':focus-visible') && !held) show(); });
  box.addEventListener('focusout', hideTip);
  for (const part of box.querySelectorAll('input, select')) part.setAttribute('aria-description', setting.doc);
}

function hideTip() {
  $('tip').hidden = true;
}
document.addEventListener('scroll', hideTip, true);

$('find').addEventListener('input', () => {
  const words = $('find').value.toLowerCase().split(/\s+/).filter(Boolean);
  let any = false;
  for (const group of $('groups').children) {
    let found = 0;
    for (const box of group.querySelectorAll('.setting')) {
      const setting = settingsByPath.get(box.dataset.path);
      const text = [setting.path, setting.name, setting.doc, setting.option, setting.topic].join(' ').toLowerCase();
      box.hidden = !words.every(word => text.includes(word));
      if (!box.hidden) found += 1;
    }
    group.hidden = !found;
    any = any || found > 0;
    if (words.length) group.open = true;
  }
  $('none').hidden = any;
});

const tabs = ['settings', 'presets', 'pixel', 'history'];

function choose(name) {
  for (const tab of tabs) {
    const chosen = tab === name;
    $(tab).hidden = !chosen;
    $('tab-' + tab).setAttribute('aria-selected', String(chosen));
    $('tab-' + tab).tabIndex = chosen ? 0 : -1;
  }
  // The presets are rendered when somebody looks.
  if (name === 'presets') for (const picture of $('presets').querySelectorAll('img[data-src]')) {
    picture.src = picture.dataset.src;
    delete picture.dataset.src;
  }
  if (name === 'history') showSteps();
}
tabs.forEach((name, k) => {
  $('tab-' + name).onclick = () => choose(name);
  $('tab-' + name).addEventListener('keydown', event => {
    const move = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!move) return;
    const next = tabs[(k + move + tabs.length) % tabs.length];
    choose(next);
    $('tab-' + next).focus();
  });
});

// ---------------------------------------------------------------------------------------
// Taking it home

let asked = null;

// Ask for the name of a file; act receives it with whether it may be replaced.
function ask({ title, text, name, button, extensions, act: use }) {
  asked = { use, extensions, replace: null };
  $('ask-title').textContent = title;
  $('ask-text').textContent = text;
  $('ask-yes').textContent = button;
  $('ask-name').value = name;
  $('ask-problem').textContent = '';
  $('ask').showModal();
  $('ask-name').select();
}

$('ask').querySelector('form').addEventListener('submit', event => {
  event.preventDefault();
  const name = $('ask-name').value.trim();
  const problem = !name ? 'A file needs a name.'
    : /[/\\]/.test(name) || /^[.-]/.test(name) ? 'Files go to the folder in which the program was started: give a plain name.'
    : !asked.extensions.some(e => name.toLowerCase().endsWith(e)) ? 'The name must end in ' + asked.extensions.join(', ') + '.' : '';
  $('ask-problem').textContent = problem;
  if (problem) return;
  $('ask').close();
  asked.name = name;
  asked.use(asked.replace === name ? 'replace' : 'keep', name);
});
$('ask-no').onclick = () => $('ask').close();
$('ask-name').addEventListener('input', () => {
  $('ask-problem').textContent = '';
  if (asked) $('ask-yes').textContent = asked.replace === $('ask-name').value.trim() ? 'Replace' : asked.button || $('ask-yes').textContent;
});

function askAgain(file) {
  if (!asked || asked.name !== file) return;
  asked.button = $('ask-yes').textContent;
  asked.replace = file;
  $('ask-problem').textContent = file + ' exists. Replace it, or choose another name.';
  $('ask-yes').textContent = 'Replace';
  $('ask').showModal();
  $('ask-name').select();
}

$('copy').onclick = () => send('command');

async function copyCommand({ command, settings }) {
  if (!command) {
    toast(settings.length ? 'Only a scene file can hold ' + settings.join(', ') + '. Save the scene, then: blackhole render scene.yaml' : 'Options cannot make this scene. Save it, then: blackhole render scene.yaml', true);
    return;
  }
  try {
    await navigator.clipboard.writeText(command);
    toast('Copied: ' + command);
  } catch (_) {
    toast('Copy this: ' + command);
  }
}

$('save').onclick = () => ask({
  title: 'Save the scene',
  text: 'A scene file with every setting, for blackhole render and for an editor.',
  name: 'scene.yaml', button: 'Save', extensions: ['.yaml', '.yml'],
  act: (how, name) => send(`save-scene ${how} ${name}`)
});

$('render').onclick = () => ask({
  title: 'Render a picture',
  text: `${values['image.width']} × ${values['image.height']} pixels (Settings, Image), with the bytes that blackhole render writes. The ending chooses the format: ${table.extensions.join(', ')}.`,
  name: 'blackhole.png', button: 'Render', extensions: table.extensions,
  act: (how, name) => send(`render ${how} ${name}`)
});

$('help').onclick = () => $('keys-help').showModal();
$('undo').onclick = () => goTo(step - 1);
$('redo').onclick = () => goTo(step + 1);
$('job-cancel').onclick = () => send('cancel');

function showJob({ state, file, done, seconds, problem }) {
  $('job').hidden = state !== 'runs';
  if (state === 'runs') {
    $('job-bar').value = done;
    $('job-text').textContent = `${file}: ${Math.round(100 * done)} %`;
  } else if (state === 'done') toast(`${file} is finished, after ${seconds.toFixed(1)} s`);
  else if (state === 'stopped') toast(`${file} is cancelled`);
  else if (state === 'failed') toast(`${file}: ${problem}`, true);
}

function toast(text, bad = false) {
  const shownToast = element('p', { textContent: text, className: bad ? 'bad' : '' });
  $('toasts').append(shownToast);
  while ($('toasts').children.length > 3) $('toasts').firstChild.remove();
  setTimeout(() => shownToast.remove(), Math.min(15000, 4000 + 60 * text.length));
}

// ---------------------------------------------------------------------------------------
// The animation

let keys = [];                 // { time, values }, in order
let selected = null;
let playing = null;

const length = () => Math.max(0.1, Math.min(3600, parseFloat($('duration').value) || 5));
const timeNow = () => $('scrub').value / 1000 * length();

function defineAnimation() {
  keys.sort((a, b) => a.time - b.time);
  showKeys();
  remember();
  const rate = Math.max(1, Math.min(240, parseFloat($('rate').value) || 24));
  send([`animation ${number(length())} ${number(rate)} ${$('way').value}`, ...keys.flatMap(key => ['key ' + number(key.time), ...linesOf(key.values)])].join('\n'));
}

function showAnimation({ problems, fixed }) {
  const note = $('animation-note');
  note.classList.toggle('bad', problems.length > 0 && keys.length > 0);
  if (!keys.length) note.textContent = 'No keyframes yet: choose a view and add one, move the time, change the view, and add the next.';
  else if (problems.length) note.textContent = problems.join(' ');
  else if (fixed.length) note.textContent = 'Cannot change within an animation, and stay as in the first key: ' + fixed.join(', ');
  else note.textContent = keys.length === 1 ? '1 keyframe: an animation needs a second one to move.' : keys.length + ' keyframes. Drag the diamonds to move them in time.';
  const ready = keys.length > 0 && !problems.length;
  $('play').disabled = !ready;
  $('save-animation').disabled = !ready;
}

function addKey() {
  const time = +timeNow().toFixed(3);
  keys = keys.filter(key => Math.abs(key.time - time) > 1e-6);
  selected = { time, values };
  keys.push(selected);
  defineAnimation();
}

function deleteKey() {
  keys = keys.filter(key => key !== selected);
  selected = null;
  defineAnimation();
}

function showKeys() {
  $('key-delete').disabled = !selected;
  $('keys').replaceChildren(...keys.map((key, index) => {
    const button = element('button', { type: 'button' });
    button.style.left = 100 * Math.min(1, key.time / length()) + '%';
    button.setAttribute('aria-label', `Keyframe ${index + 1} at ${key.time.toFixed(2)} seconds; arrow keys move it, Delete deletes it`);
    button.setAttribute('aria-pressed', String(key === selected));
    button.addEventListener('pointerdown', event => dragKey(event, key, button));
    button.addEventListener('keydown', event => {
      const by = { ArrowLeft: -0.1, ArrowRight: 0.1 }[event.key];
      if (by) moveKey(key, key.time + by);
      else if (event.key === 'Delete' || event.key === 'Backspace') { selected = key; deleteKey(); }
      else if (event.key === 'Enter' || event.key === ' ') pick(key);
      else return;
      event.preventDefault();
      $('keys').children[keys.indexOf(key)]?.focus();
    });
    return button;
  }));
}

function moveKey(key, time) {
  const to = +Math.max(0, Math.min(length(), time)).toFixed(3);
  if (keys.some(other => other !== key && Math.abs(other.time - to) < 1e-6)) return;
  key.time = to;
  selected = key;
  defineAnimation();
}

function pick(key) {
  selected = key;
  $('scrub').value = 1000 * key.time / length();
  showTime();
  act('restore', [preset], linesOf(key.values));
  settle('Keyframe');
  showKeys();
}

function dragKey(event, key, button) {
  event.preventDefault();
  const start = event.clientX;
  const from = key.time;
  const wide = $('keys').getBoundingClientRect().width;
  let moved = false;
  const move = e => {
    if (Math.abs(e.clientX - start) > 3) moved = true;
    if (!moved) return;
    key.time = +Math.max(0, Math.min(length(), from + (e.clientX - start) / wide * length())).toFixed(3);
    button.style.left = 100 * key.time / length() + '%';
  };
  const end = () => {
    removeEventListener('pointermove', move);
    removeEventListener('pointerup', end);
    removeEventListener('pointercancel', end);
    if (!moved) return pick(key);
    const to = key.time;
    key.time = from;
    moveKey(key, to);
  };
  addEventListener('pointermove', move);
  addEventListener('pointerup', end);
  addEventListener('pointercancel', end);
}

function showTime() {
  $('time').textContent = timeNow().toFixed(2) + ' s';
}

function scrubTo() {
  showTime();
  if (keys.length && !$('play').disabled) act('scrub', [number(timeNow())]);
}

function togglePlay() {
  if ($('play').disabled) return;
  if (playing) {
    cancelAnimationFrame(playing);
    playing = null;
    $('play').textContent = 'Play';
    settle('Play the animation');
    return;
  }
  $('play').textContent = 'Pause';
  let before = performance.now();
  let at = timeNow() >= length() - 1e-3 ? 0 : timeNow();
  let last = 0;
  const tick = now => {
    at += (now - before) / 1000;
    before = now;
    const over = at >= length();
    $('scrub').value = 1000 * Math.min(1, at / length());
    showTime();
    // Only as fast as the pictures come.
    if (stats.input >= last || over) {
      act('scrub', [number(Math.min(length(), at))]);
      last = input;
    }
    if (over) return togglePlay();
    playing = requestAnimationFrame(tick);
  };
  playing = requestAnimationFrame(tick);
}

$('play').onclick = togglePlay;
$('key-add').onclick = addKey;
$('key-delete').onclick = deleteKey;
$('scrub').addEventListener('input', () => { if (playing) togglePlay(); scrubTo(); });
$('scrub').addEventListener('change', () => { if (keys.length) settle('Scrub'); });
for (const id of ['duration', 'rate', 'way']) $(id).addEventListener('change', () => { showTime(); if (keys.length) defineAnimation(); });
$('save-animation').onclick = () => ask({
  title: 'Save the animation',
  text: `An animation scene of ${Math.round(length() * (parseFloat($('rate').value) || 24))} frames. Render it with: blackhole animate animation.yaml -o frames/%05d.png`,
  name: 'animation.yaml', button: 'Save', extensions: ['.yaml', '.yml'],
  act: (how, name) => send(`save-animation ${how} ${name}`)
});

// ---------------------------------------------------------------------------------------

async function begin() {
  table = await (await fetch('table.json')).json();
  buildPanel();
  recall();
  showKeys();
  connect();
  new ResizeObserver(() => {
    clearTimeout(begin.timer);
    begin.timer = setTimeout(() => { sendWindow(false); placeMark(); }, 80);
  }).observe($('frame'));
}

// For tests and measurements.
window.explore = {
  stats, act, change, send, resize: () => sendWindow(true),
  get values() { return values; },
  get idle() { return idle; },
  get steps() { return steps; },
  get step() { return step; },
  get keys() { return keys; },
  get socket() { return socket; },
  get input() { return input; },
  // Whether every input has been answered, with its scene and with a final picture.
  settledScene: () => !waiting.scheduled && confirmed >= input,
  settled: () => !waiting.scheduled && confirmed >= input && stats.input >= input && stats.stage === 2
};
window.choosePanel = choose;

begin().catch(problem => { $('status').textContent = String(problem); });
