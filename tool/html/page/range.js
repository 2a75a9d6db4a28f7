// The stretch of an axis that a picture shows, and how it is moved: wheel, drag, keys, buttons.
class ViewRange {
  constructor(length, changed) {
    this.length = Math.max(length, 1);
    this.least = Math.min(1, this.length);
    this.changed = changed;
    this.fit();
  }
  fit() { this.set(0, this.length); }
  set(from, to) {
    const width = Math.min(Math.max(to - from, this.least), this.length);
    this.from = Math.min(Math.max((from + to - width) / 2, 0), this.length - width);
    this.to = this.from + width;
    this.changed();
  }
  // `about` is a share of the stretch: it stays where it is.
  zoom(factor, about = 0.5) {
    const width = this.to - this.from, next = Math.min(Math.max(width / factor, this.least), this.length);
    const from = this.from + (width - next) * about;
    this.set(from, from + next);
  }
  pan(share) {
    const step = share * (this.to - this.from);
    this.set(this.from + step, this.to + step);
  }
  show(at) { if (at < this.from || at >= this.to) this.pan((at - this.from) / (this.to - this.from) - 0.5); }
  share(at) { return (at - this.from) / (this.to - this.from); }
}

// Zooming by the wheel waits for the focus, or Control: a page that one scrolls through stays one.
function moveByPointer(canvas, range, shareAt, scroll) {
  canvas.addEventListener("wheel", event => {
    if (document.activeElement !== canvas && !event.ctrlKey) return;
    event.preventDefault();
    if (event.shiftKey) scroll(event.deltaY || event.deltaX);
    else range.zoom(Math.exp(-event.deltaY / 300), Math.min(Math.max(shareAt(event.offsetX), 0), 1));
  }, {passive: false});
  let last = null;
  canvas.addEventListener("pointerdown", event => { last = {x: event.offsetX, y: event.offsetY}; canvas.moved = 0; });
  addEventListener("pointerup", () => { last = null; });
  canvas.addEventListener("pointermove", event => {
    if (!last || !(event.buttons & 1)) return;
    canvas.moved += Math.abs(event.offsetX - last.x) + Math.abs(event.offsetY - last.y);
    range.pan(shareAt(last.x) - shareAt(event.offsetX));
    scroll(last.y - event.offsetY);
    last = {x: event.offsetX, y: event.offsetY};
  });
}

const rangeKeys = {
  "+": range => range.zoom(1.6), "=": range => range.zoom(1.6), "-": range => range.zoom(1 / 1.6),
  "0": range => range.fit(), ArrowLeft: range => range.pan(-0.2), ArrowRight: range => range.pan(0.2),
};
function moveByKeys(canvas, range, more) {
  canvas.addEventListener("keydown", event => {
    const action = more[event.key] || rangeKeys[event.key];
    if (!action || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    action(range);
  });
}

const rangeButtons = (range, what) => [
  button("+", () => range.zoom(1.6), {"aria-label": `Zoom in: ${what}`, title: "Zoom in"}),
  button("−", () => range.zoom(1 / 1.6), {"aria-label": `Zoom out: ${what}`, title: "Zoom out"}),
  button("Fit", () => range.fit(), {"aria-label": `Show all: ${what}`}),
];

// Round marks on an axis, at most about `count`.
function marks(from, to, count) {
  const rough = (to - from) / count, power = 10 ** Math.floor(Math.log10(rough));
  const step = Math.max(1, [1, 2, 5, 10].map(factor => factor * power).find(each => each >= rough));
  const result = [];
  for (let at = Math.ceil(from / step) * step; at <= to; at += step) result.push(at);
  return result;
}
