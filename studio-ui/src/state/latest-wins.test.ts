import { describe, expect, it } from "vitest";
import { LatestWins } from "./latest-wins";

interface Sent {
  state: number;
  signal: AbortSignal;
  answer: (value: string) => void;
  fail: (error: Error) => void;
}

function bench() {
  const sent: Sent[] = [];
  const shown: [number, string][] = [];
  const failed: number[] = [];
  const busy: boolean[] = [];
  const controller = new LatestWins<number, string>(
    (state, signal) => new Promise((answer, fail) => sent.push({ state, signal, answer, fail })),
    (answer, state) => shown.push([state, answer]),
    (_, state) => failed.push(state),
    (now) => busy.push(now),
  );
  return { sent, shown, failed, busy, controller };
}

const settled = () => new Promise((resolve) => setTimeout(resolve, 0));
const at = (sent: Sent[], k: number): Sent => {
  const found = sent[k];
  if (found === undefined) throw new Error(`Only ${sent.length} requests were sent`);
  return found;
};

describe("LatestWins", () => {
  it("has one request under way, and of those that come meanwhile sends only the last", async () => {
    const { sent, shown, controller } = bench();
    for (let state = 1; state <= 50; state += 1) controller.request(state);
    expect(sent.map((each) => each.state)).toEqual([1]);
    at(sent, 0).answer("one");
    await settled();
    expect(sent.map((each) => each.state)).toEqual([1, 50]);
    at(sent, 1).answer("fifty");
    await settled();
    expect(shown).toEqual([
      [1, "one"],
      [50, "fifty"],
    ]);
    expect(controller.busy).toBe(false);
  });

  it("drops the answer that was under way at a reset, and shows those of later requests", async () => {
    const { sent, shown, controller } = bench();
    controller.request(1);
    controller.request(2);
    controller.reset();
    expect(at(sent, 0).signal.aborted).toBe(true);
    controller.request(3);
    at(sent, 0).answer("stale");
    await settled();
    expect(sent.map((each) => each.state)).toEqual([1, 3]);
    at(sent, 1).answer("three");
    await settled();
    expect(shown).toEqual([[3, "three"]]);
  });

  it("goes on with what waits after a failure", async () => {
    const { sent, failed, shown, controller } = bench();
    controller.request(1);
    controller.request(2);
    at(sent, 0).fail(new Error("no"));
    await settled();
    at(sent, 1).answer("two");
    await settled();
    expect(failed).toEqual([1]);
    expect(shown).toEqual([[2, "two"]]);
  });

  it("may be asked again while an answer is shown", async () => {
    const shown: number[] = [];
    const answers: (() => void)[] = [];
    const controller: LatestWins<number, null> = new LatestWins<number, null>(
      () => new Promise((resolve) => answers.push(() => resolve(null))),
      (_, state) => {
        shown.push(state);
        if (state === 1) controller.request(2);
      },
      () => {},
    );
    controller.request(1);
    answers[0]?.();
    await settled();
    answers[1]?.();
    await settled();
    expect(shown).toEqual([1, 2]);
    expect(answers).toHaveLength(2);
  });
});
