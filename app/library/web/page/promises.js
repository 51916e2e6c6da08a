// Both promises as numbers, and the bits beside those of the program.
const byId = (id) => document.getElementById(id);
const percent = (value) => `${(100 * value).toFixed(3)} %`;
const KEPT = 240;

export class Promises {
  /** `natives` has the program's hashes by their frames, or is nothing where it has computed no such frames. */
  begin(bound, natives) {
    this.bound = bound;
    this.natives = natives;
    this.stretches = [];
    this.hasDiffered = false;
    byId('hash').textContent = byId('native').textContent = '–';
    byId('second').textContent = '0';
    this.#say('', '\u00a0');
  }

  add(frame, isSteered) {
    this.stretches.push(frame.max_surface_stretch);
    if (this.stretches.length > KEPT) this.stretches.shift();
    byId('stretch-promise').classList.toggle('broken', !frame.is_bound_kept);
    byId('contact-promise').classList.toggle('broken', frame.measured_crossings > 0);
    byId('stretch').textContent = `${percent(frame.max_surface_stretch)} of ${100 * this.bound} %`;
    byId('crossings').textContent = String(frame.measured_crossings);
    byId('gap').textContent = Number.isFinite(frame.smallest_distance_m)
      ? `${(1000 * frame.smallest_distance_m).toFixed(2)} mm` : 'far apart';
    if (frame.frame % 60 === 0) this.#compare(frame, isSteered);
    this.drawing ??= requestAnimationFrame(() => this.#draw());  // frames may come faster than pictures
  }

  #compare(frame, isSteered) {
    const second = frame.frame / 60, native = isSteered ? undefined : this.natives?.[frame.frame];
    byId('second').textContent = String(second);
    byId('hash').textContent = frame.state_hash;
    byId('native').textContent = native ?? '–';
    if (native) {
      this.hasDiffered ||= native !== frame.state_hash;
      this.#say(this.hasDiffered ? 'differs' : 'same',
        this.hasDiffered ? 'Other bits than on our machine' : '✓ The same bits as on our machine');
    } else if (isSteered) {
      this.#say('', 'Steered by you: nothing to compare');
    } else {
      this.#say('', this.natives ? 'We computed no further' : 'Compared as made, in 0, 1 and 10 m/s');
    }
  }

  #say(name, text) {
    byId('verdict').className = name;
    byId('verdict').textContent = text;
  }

  // The last four seconds below the line of the bound.
  #draw() {
    this.drawing = null;
    const { width, height } = byId('curve'), context = byId('curve').getContext('2d');
    const x = (k) => (k + KEPT - this.stretches.length) / (KEPT - 1) * width;
    const y = (stretch) => height - (height - 10) * Math.max(stretch, 0) / this.bound;
    context.clearRect(0, 0, width, height);
    context.lineWidth = 2;
    context.strokeStyle = '#b3261e';
    context.setLineDash([6, 6]);
    context.beginPath();
    context.moveTo(0, y(this.bound));
    context.lineTo(width, y(this.bound));
    context.stroke();
    context.setLineDash([]);
    context.lineWidth = 3;
    context.strokeStyle = '#1f7a4d';
    context.beginPath();
    this.stretches.forEach((stretch, k) => context.lineTo(x(k), y(stretch)));
    context.stroke();
    context.lineTo(width, height);
    context.lineTo(x(0), height);
    context.fillStyle = 'rgba(31, 122, 77, .14)';
    context.fill();
  }
}
