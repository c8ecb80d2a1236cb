// SPDX-License-Identifier: Apache-2.0
// The page of a pixel: draws the rays in space, turns them, and finds rays of the drawing in the tree.
'use strict';
(() => {
  const data = JSON.parse(document.getElementById('space-data').textContent);
  const svg = document.getElementById('space');
  const finite = (p) => p.every(Number.isFinite);
  const minus = (a, b) => a.map((v, i) => v - b[i]);
  const plus = (a, b, s) => a.map((v, i) => v + s * b[i]);
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const length = (a) => Math.hypot(...a);
  const unit = (a) => { const l = length(a); return l > 0 ? a.map((v) => v / l) : [0, 0, 1]; };
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

  const rays = data.rays.filter((r) => finite(r.from) && finite(r.to));

  // The view turns around the middle of the rays; where they go on for ever does not count.
  const seen = [data.eye];
  for (const r of rays) {
    if (r.kind < 3) seen.push(r.from);
    if (!r.endless && (r.kind < 3 || r.kind === 4)) seen.push(r.to);
  }
  if (seen.length < 3) seen.push(data.window.center, ...rays.map((r) => r.to));
  const low = [0, 1, 2].map((i) => Math.min(...seen.map((p) => p[i])));
  const high = [0, 1, 2].map((i) => Math.max(...seen.map((p) => p[i])));
  const middle = plus(low, minus(high, low), 0.5);
  const reach = Math.max(length(minus(high, low)) / 2, 1e-300);

  // Directions of the picture: right, up, and back towards the eye.
  const right = unit(data.window.right);
  const back = unit(cross(right, data.window.up));
  const up = cross(back, right);

  const view = { turn: 0.9, lift: 0.35, zoom: 1 };
  let axes;
  let scale;
  const aim = () => {
    const box = svg.getBoundingClientRect();
    svg.setAttribute('viewBox', `${-box.width / 2} ${-box.height / 2} ${box.width} ${box.height}`);
    const [c, s] = [Math.cos(view.turn), Math.sin(view.turn)];
    const side = plus(right.map((v) => v * c), back, -s);
    const towards = plus(back.map((v) => v * c), right, s);
    const [cl, sl] = [Math.cos(view.lift), Math.sin(view.lift)];
    axes = [side, plus(up.map((v) => v * cl), towards, -sl), plus(towards.map((v) => v * cl), up, sl)];
    scale = view.zoom * 0.44 * Math.min(box.width, box.height * 1.15) / reach;
  };
  const project = (p) => {
    const d = minus(p, middle);
    return [scale * dot(d, axes[0]), -scale * dot(d, axes[1])];
  };
  const path = (points, closed) =>
    'M' + points.map((p) => project(p).map((v) => v.toFixed(1)).join(' ')).join('L') + (closed ? 'Z' : '');

  const make = (tag, classes, parent) => {
    const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
    element.setAttribute('class', classes);
    parent.append(element);
    return element;
  };
  const draws = [];
  const labels = [];
  const layer = (name) => make('g', name, svg);
  const [shapesLayer, raysLayer, labelsLayer] = [layer('shapes'), layer('rays'), layer('labels')];
  const label = (text, at, dy) => {
    if (!text) return;
    const element = make('text', 'label', labelsLayer);
    element.textContent = text;
    element.setAttribute('text-anchor', 'middle');
    labels.push({ element, at, dy, half: 3.1 * text.length + 2 });
  };
  // Labels stay inside, and go up or down where another one stands.
  const placeLabels = () => {
    const box = svg.viewBox.baseVal;
    const placed = [];
    for (const l of labels) {
      const [x, y] = project(l.at());
      const left = Math.min(Math.max(x, box.x + l.half), box.x + box.width - l.half);
      const free = (row) => row > box.y + 10 && row < box.y + box.height - 3 &&
        placed.every((p) => Math.abs(p.row - row) >= 13 || Math.abs(p.left - left) >= p.half + l.half);
      const wanted = Math.min(Math.max(y + l.dy, box.y + 11), box.y + box.height - 4);
      const row = [0, -13, 13, -26, 26, -39, 39].map((d) => wanted + d).find(free);
      l.element.style.display = row === undefined ? 'none' : '';
      if (row === undefined) continue;
      placed.push({ left, row, half: l.half });
      l.element.setAttribute('x', left);
      l.element.setAttribute('y', row);
    }
  };
  const line = (classes, points, closed) => {
    const element = make('path', classes, shapesLayer);
    draws.push(() => element.setAttribute('d', path(points(), closed)));
  };

  // A sphere is its circle and two of its great circles; of one that is much larger than the view, a
  // ground, the part near the middle.
  const ring = (center, radius, a, b) => () => Array.from({ length: 49 }, (_, i) => {
    const t = i * Math.PI / 24;
    return plus(plus(center, a, radius * Math.cos(t)), b, radius * Math.sin(t));
  });
  const addSphere = (s, classes) => {
    if (s.radius < 4 * reach) {
      const circle = make('circle', classes, shapesLayer);
      draws.push(() => {
        const [x, y] = project(s.center);
        circle.setAttribute('cx', x);
        circle.setAttribute('cy', y);
        circle.setAttribute('r', Math.max(0.5, s.radius * scale));
      });
      line(`${classes} thin`, ring(s.center, s.radius, right, back), true);
      line(`${classes} thin`, ring(s.center, s.radius, right, up), true);
      label(s.label, () => plus(s.center, axes[1], s.radius), -5);
      return;
    }
    const out = unit(minus(middle, s.center));
    const a = unit(cross(out, Math.abs(dot(out, right)) < 0.9 ? right : up));
    const b = cross(out, a);
    const on = (u, v) => {
      const direction = unit(plus(plus(out, a, u * reach / s.radius), b, v * reach / s.radius));
      return plus(s.center, direction, s.radius);
    };
    for (let i = -3; i <= 3; ++i) {
      const steps = Array.from({ length: 13 }, (_, k) => (k - 6) / 4);
      line(`${classes} thin`, () => steps.map((k) => on(i / 2, k)), false);
      line(`${classes} thin`, () => steps.map((k) => on(k, i / 2)), false);
    }
    label(s.label, () => on(-1.1, 1.1), -5);
  };
  const addBox = (s, classes) => {
    const corner = (i) => [0, 1, 2].map((k) => ((i >> k) & 1 ? s.upper : s.lower)[k]);
    for (const edges of [[0, 1, 3, 2, 0], [4, 5, 7, 6, 4], [0, 4], [1, 5], [2, 6], [3, 7]])
      line(classes, () => edges.map(corner), false);
    label(s.label, () => plus(s.lower, minus(s.upper, s.lower), 0.5), -5);
  };
  // Of a plane the part that is nearest to the middle.
  const addPlane = (s, classes) => {
    const n = unit(s.normal);
    const foot = plus(middle, n, dot(minus(s.point, middle), n));
    const a = unit(cross(n, Math.abs(dot(n, right)) < 0.9 ? right : up));
    const b = cross(n, a);
    const on = (u, v) => plus(plus(foot, a, u * reach), b, v * reach);
    for (let i = -3; i <= 3; ++i) {
      line(`${classes} thin`, () => [on(i / 2, -1.5), on(i / 2, 1.5)], false);
      line(`${classes} thin`, () => [on(-1.5, i / 2), on(1.5, i / 2)], false);
    }
    label(s.label, () => on(-1.1, 1.1), -5);
  };
  for (const s of data.shapes) {
    const classes = s.met ? 'outline met' : 'outline';
    if (s.center) {
      if (finite([...s.center, s.radius])) addSphere(s, classes);
    } else if (s.normal) {
      if (finite([...s.point, ...s.normal])) addPlane(s, classes);
    } else if (s.lower && finite([...s.lower, ...s.upper])) {
      addBox(s, classes);
    }
  }

  // Eye, window and lights.
  const dotAt = (classes, at, radius) => {
    const element = make('circle', classes, raysLayer);
    element.setAttribute('r', radius);
    draws.push(() => {
      const [x, y] = project(at);
      element.setAttribute('cx', x);
      element.setAttribute('cy', y);
    });
  };
  const { center, right: wide, up: tall } = data.window;
  line('frame', () => [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(
    ([u, v]) => plus(plus(center, wide, u / 2), tall, v / 2)), true);
  label(data.words.window, () => plus(plus(center, wide, -0.5), tall, 0.5), -4);
  dotAt('dot', data.eye, 4);
  label(data.words.eye, () => data.eye, -8);
  for (const light of data.lights)
    if (finite(light.at) && length(minus(light.at, middle)) < 6 * reach) {
      dotAt('lamp', light.at, 5);
      label(light.label, () => light.at, -9);
    }

  // Rays, with a tip that says where they go, and a wide line that is easy to meet.
  const drawn = rays.map((r) => {
    const group = make('g', `segment-group`, raysLayer);
    const shown = make('path', `segment kind${r.kind}`, group);
    const tip = make('path', `tip kind${r.kind}`, group);
    const touch = make('path', 'touch', group);
    const width = r.kind < 3 ? 1.2 + 1.6 * Math.sqrt(Math.min(1, Math.abs(r.weight))) : 1.1;
    shown.setAttribute('stroke-width', width);
    draws.push(() => {
      const [a, b] = [project(r.from), project(r.to)];
      const d = `M${a[0].toFixed(1)} ${a[1].toFixed(1)}L${b[0].toFixed(1)} ${b[1].toFixed(1)}`;
      shown.setAttribute('d', d);
      touch.setAttribute('d', d);
      const [x, y] = [b[0] - a[0], b[1] - a[1]];
      const l = Math.hypot(x, y);
      const [ux, uy] = l > 0 ? [x / l, y / l] : [0, 0];
      const size = Math.min(7, l / 2);
      const at = r.endless ? 1 : 0.6;
      const [px, py] = [a[0] + at * x, a[1] + at * y];
      tip.setAttribute('d', `M${px} ${py}L${px - size * (ux + 0.45 * uy)} ${py - size * (uy - 0.45 * ux)}` +
        `L${px - size * (ux - 0.45 * uy)} ${py - size * (uy + 0.45 * ux)}Z`);
    });
    touch.addEventListener('click', () => { if (!dragged) find(r.ray); });
    return { ray: r.ray, kind: r.kind, group };
  });

  const draw = () => { aim(); for (const step of draws) step(); placeLabels(); };
  let waiting = false;
  const redraw = () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => { waiting = false; draw(); });
  };

  // One ray chosen, in drawing and tree.
  const choose = (ray) => {
    for (const d of drawn) d.group.classList.toggle('chosen', d.ray === ray);
    for (const node of document.querySelectorAll('.ray.chosen')) node.classList.remove('chosen');
    if (ray) document.getElementById(ray)?.classList.add('chosen');
  };
  const find = (ray) => {
    const node = document.getElementById(ray);
    for (let e = node; e; e = e.parentElement) if (e.tagName === 'DETAILS') e.open = true;
    choose(ray);
    node.scrollIntoView({ block: 'start', behavior: 'smooth' });
    node.querySelector('summary').focus({ preventScroll: true });
  };
  for (const node of document.querySelectorAll('.ray')) {
    const summary = node.querySelector('summary');
    summary.addEventListener('pointerenter', () => choose(node.id));
    summary.addEventListener('focus', () => choose(node.id));
  }

  // Turning: pointer, keys, buttons.
  const lift = (by) => { view.lift = Math.max(-1.5, Math.min(1.5, view.lift + by)); };
  const zoom = (by) => { view.zoom = Math.max(0.1, Math.min(50, view.zoom * by)); };
  const pointers = new Map();
  let dragged = false;
  svg.addEventListener('pointerdown', (e) => { pointers.set(e.pointerId, [e.clientX, e.clientY]); dragged = false; });
  svg.addEventListener('pointermove', (e) => {
    const before = pointers.get(e.pointerId);
    if (!before) return;
    const [dx, dy] = [e.clientX - before[0], e.clientY - before[1]];
    if (!dragged && Math.hypot(dx, dy) < 4) return;
    if (!dragged) svg.setPointerCapture(e.pointerId);
    dragged = true;
    const others = [...pointers].filter(([id]) => id !== e.pointerId).map(([, p]) => p);
    if (others.length > 0) {
      const away = (p) => Math.hypot(p[0] - others[0][0], p[1] - others[0][1]);
      zoom(Math.max(1, away([e.clientX, e.clientY])) / Math.max(1, away(before)));
    } else {
      view.turn -= dx / 120;
      lift(dy / 120);
    }
    pointers.set(e.pointerId, [e.clientX, e.clientY]);
    redraw();
  });
  for (const name of ['pointerup', 'pointercancel'])
    svg.addEventListener(name, (e) => pointers.delete(e.pointerId));
  svg.addEventListener('wheel', (e) => {
    if (!e.ctrlKey) return;
    e.preventDefault();
    zoom(Math.exp(-e.deltaY / 300));
    redraw();
  }, { passive: false });
  const keys = {
    ArrowLeft: () => { view.turn += 0.12; }, ArrowRight: () => { view.turn -= 0.12; },
    ArrowUp: () => lift(-0.1), ArrowDown: () => lift(0.1),
    '+': () => zoom(1.2), '=': () => zoom(1.2), '-': () => zoom(1 / 1.2),
  };
  svg.addEventListener('keydown', (e) => {
    if (!keys[e.key] || e.ctrlKey || e.metaKey || e.altKey) return;
    e.preventDefault();
    keys[e.key]();
    redraw();
  });
  const views = {
    eye: () => { view.turn = 0; view.lift = 0; }, above: () => { view.turn = 0; view.lift = 1.5; },
    side: () => { view.turn = Math.PI / 2; view.lift = 0; }, closer: () => zoom(1.4), farther: () => zoom(1 / 1.4),
  };
  for (const button of document.querySelectorAll('[data-view]'))
    button.addEventListener('click', () => { views[button.dataset.view](); redraw(); });
  for (const box of document.querySelectorAll('[data-kind]'))
    box.addEventListener('change', () => {
      for (const d of drawn)
        if (d.kind === Number(box.dataset.kind)) d.group.style.display = box.checked ? '' : 'none';
    });
  for (const button of document.querySelectorAll('[data-fold]'))
    button.addEventListener('click', () => {
      for (const node of document.querySelectorAll('.ray')) node.open = button.dataset.fold === 'open';
    });

  new ResizeObserver(redraw).observe(svg);
  draw();
  document.documentElement.dataset.ready = String(drawn.length);
})();
