/** Numbers with the bounds of their errors, rounded as `haptonic.units.uncertain` does. */

const MOST_DECIMALS = 6;
const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** A sentence of a result with minus signs and powers of ten. */
export function typeset(text: string): string {
  const powers = text.replace(/(?<=\d)e([+-]?\d+)\b/g, (_, exponent: string) => `×${powerOfTen(Number(exponent))}`);
  return signed(powers);
}

/** A text with a minus sign instead of the hyphen before each negative number; not within words, dates and names. */
export function signed(text: string): string {
  return text.replace(/(?<![\w.)])-(?=\.?\d)/g, "−");
}

/** A power of ten: 10⁻³. */
export function powerOfTen(exponent: number): string {
  const digits = Array.from(String(Math.abs(exponent)), (digit) => RAISED[Number(digit)]);
  return `10${exponent < 0 ? "⁻" : ""}${digits.join("")}`;
}

/** A number at an axis: 0.25, −3, or 2.5×10⁻⁷. */
export function tickText(value: number): string {
  const [digits = "", exponent] = String(Number(value.toPrecision(12))).split("e");
  return signed(digits) + (exponent === undefined ? "" : `×${powerOfTen(Number(exponent))}`);
}

/** Value and bound, both in the unit of the text: the bound rounded up to one digit, to two after a 1, the value like it. */
export function uncertain(value: number, bound: number): string {
  if (!(Number.isFinite(bound) && bound > 0)) return signed(value.toFixed(3));
  bound = Math.max(bound, 10 ** -MOST_DECIMALS);
  let power = Math.floor(Math.log10(bound) + 1e-9);
  if (bound < 2 * 10 ** power) power -= 1;
  let digit = Math.ceil(bound / 10 ** power - 1e-9);
  if (digit === 10) [digit, power] = [1, power + 1];
  const decimals = Math.min(Math.max(-power, 0), MOST_DECIMALS);
  const place = 10 ** Math.max(power, 0);
  const rounded = place > 1 ? Math.round(value / place) * place : value; // 106400 ± 400
  return `${signed(rounded.toFixed(decimals))} ± ${(digit * 10 ** power).toFixed(decimals)}`;
}
