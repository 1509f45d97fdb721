/** Numbers with the bounds of their errors, rounded as `haptonic.units.uncertain` does. */

const MOST_DECIMALS = 6;

/** Value and bound, both in the unit of the text: the bound rounded up to one digit, to two after a 1. */
export function uncertain(value: number, bound: number): string {
  if (!(Number.isFinite(bound) && bound > 0)) return value.toFixed(3);
  bound = Math.max(bound, 10 ** -MOST_DECIMALS);
  let power = Math.floor(Math.log10(bound) + 1e-9);
  if (bound < 2 * 10 ** power) power -= 1;
  let digit = Math.ceil(bound / 10 ** power - 1e-9);
  if (digit === 10) [digit, power] = [1, power + 1];
  const decimals = Math.min(Math.max(-power, 0), MOST_DECIMALS);
  return `${value.toFixed(decimals)} ± ${(digit * 10 ** power).toFixed(decimals)}`;
}
