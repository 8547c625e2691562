/** Undo and redo: a list of states with labels, and where we stand in it. Pure functions. */

export interface HistoryEntry<T> {
  id: number;
  label: string;
  /** Milliseconds since 1970. */
  at: number;
  value: T;
}

export interface History<T> {
  entries: HistoryEntry<T>[];
  /** The entry that is shown; those after it can be redone. */
  index: number;
}

const KEPT = 100;
let lastId = 0;

export function started<T>(label: string, value: T): History<T> {
  return { entries: [entry(label, value)], index: 0 };
}

/** After the shown entry comes this one; what could have been redone is gone. */
export function pushed<T>(history: History<T>, label: string, value: T): History<T> {
  const kept = history.entries.slice(0, history.index + 1);
  const entries = [...kept, entry(label, value)].slice(-KEPT);
  return { entries, index: entries.length - 1 };
}

/** Entries that `which` holds of, with another value: what was worked out of them has arrived. */
export function amended<T>(
  history: History<T>,
  which: (value: T) => boolean,
  change: (value: T) => T,
): History<T> {
  const entries = history.entries.map((each) =>
    which(each.value) ? { ...each, value: change(each.value) } : each,
  );
  return { ...history, entries };
}

export function movedTo<T>(history: History<T>, index: number): History<T> {
  return { ...history, index: Math.max(0, Math.min(index, history.entries.length - 1)) };
}

export const canUndo = (history: History<unknown>): boolean => history.index > 0;
export const canRedo = (history: History<unknown>): boolean => history.index < history.entries.length - 1;

function entry<T>(label: string, value: T): HistoryEntry<T> {
  lastId += 1;
  return { id: lastId, label, at: Date.now(), value };
}
