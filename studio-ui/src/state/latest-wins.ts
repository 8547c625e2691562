/**
 * One request in flight and at most one waiting; the latest state wins.
 *
 * While an answer is under way newer states replace the one that waits, so that a fast hand never makes a
 * queue. An answer is shown if it is newer than what is shown; after `reset` all older answers are dropped.
 */
export class LatestWins<State, Answer> {
  private epoch = 0;
  private waiting: State | null = null;
  private controller: AbortController | null = null;

  constructor(
    private readonly send: (state: State, signal: AbortSignal) => Promise<Answer>,
    private readonly show: (answer: Answer, state: State) => void,
    private readonly fail: (error: unknown, state: State) => void,
    private readonly busyChanged: (busy: boolean) => void = () => {},
  ) {}

  get busy(): boolean {
    return this.controller !== null;
  }

  /** Wants the answer for this state, as soon as the one under way is there. */
  request(state: State): void {
    this.waiting = state;
    if (this.controller === null) this.next();
  }

  /** Forgets what waits and whatever is under way: its answer will not be shown. */
  reset(): void {
    this.epoch += 1;
    this.waiting = null;
    this.controller?.abort();
    this.controller = null;
    this.busyChanged(false);
  }

  private next(): void {
    const state = this.waiting;
    if (state === null) {
      this.busyChanged(false);
      return;
    }
    this.waiting = null;
    const epoch = this.epoch;
    const controller = new AbortController();
    this.controller = controller;
    this.busyChanged(true);
    this.send(state, controller.signal).then(
      (answer) => this.finish(epoch, () => this.show(answer, state)),
      (error) => this.finish(epoch, () => this.fail(error, state)),
    );
  }

  private finish(epoch: number, deliver: () => void): void {
    if (epoch !== this.epoch) return;
    this.controller = null;
    try {
      deliver();
    } finally {
      if (epoch === this.epoch && this.controller === null) this.next();
    }
  }
}
