// The time of the run: a slider, and playing with the real feed.

export const clockText = (seconds) => {
  const whole = Math.floor(seconds), two = (value) => String(value).padStart(2, '0');
  const rest = `${two(Math.floor(whole / 60) % 60)}:${two(whole % 60)}`;
  return whole >= 3600 ? `${Math.floor(whole / 3600)}:${rest}` : rest;
};

export class Timeline {
  // `show(time)` is called whenever the time changes.
  constructor(elements, path, show) {
    Object.assign(this, elements);
    this.path = path;
    this.show = show;
    this.total = path.totalSeconds;
    this.slider.max = this.total || 1;
    this.slider.addEventListener('input', () => this.set(Number(this.slider.value)));
    this.playButton.addEventListener('click', () => this.toggle());
    this.beforeButton.addEventListener('click', () => this.step(-1));
    this.nextButton.addEventListener('click', () => this.step(1));
    this.set(this.total);
  }

  get isPlaying() { return this.last !== undefined; }

  set(time) {
    this.time = Math.max(0, Math.min(this.total, time));
    this.slider.value = this.time;
    this.clock.textContent = `${clockText(this.time)} / ${clockText(this.total)}`;
    this.show(this.time);
  }

  // To the end of the next move, or of the one before.
  step(by) {
    this.pause();
    const { path } = this, move = path.moveAt(this.time);
    if (move < 0) return;
    const isInside = this.time > path.begin[move] && this.time < path.begin[move + 1];
    const to = by > 0 ? move + 1 : isInside ? move : move - 1;
    this.set(path.begin[Math.max(0, Math.min(path.moves, to))]);
  }

  toggle() {
    if (this.isPlaying) return this.pause();
    if (this.time >= this.total) this.set(0);
    this.playButton.textContent = '⏸';
    this.playButton.title = 'Pause (space)';
    this.last = performance.now();
    requestAnimationFrame((now) => this.#tick(now));
  }

  pause() {
    this.last = undefined;
    this.playButton.textContent = '▶';
    this.playButton.title = 'Play (space)';
  }

  #tick(now) {
    if (!this.isPlaying) return;
    const passed = Math.max(0, now - this.last) / 1000;
    this.last = now;
    this.set(this.time + passed * Number(this.speed.value));
    if (this.time >= this.total) return this.pause();
    requestAnimationFrame((next) => this.#tick(next));
  }
}
