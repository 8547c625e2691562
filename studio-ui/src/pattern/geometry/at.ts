/** An item of a list that must be there. */
export function at<T>(list: readonly T[], index: number): T {
  if (!(index >= 0 && index < list.length))
    throw new RangeError(`Item ${index} was asked for; the list has ${list.length}.`);
  return list[index] as T;
}
