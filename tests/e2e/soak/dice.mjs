// Numbers by chance from a seed: the same seed always gives the same order of actions.

/** Dice (the generator of Park and Miller, 1988). */
export class Dice {
  #state;

  /** @param {number} seed from 1 */
  constructor(seed) {
    this.#state = (seed * 7_919) % 2_147_483_647;
  }

  /** A whole number from 0 up to one that is left out. */
  roll(below) {
    this.#state = (this.#state * 48_271) % 2_147_483_647;
    return this.#state % below;
  }

  /** Whether one of so many cases came up. */
  oneIn(cases) {
    return this.roll(cases) === 0;
  }

  /** One of a list. */
  pick(list) {
    return list[this.roll(list.length)];
  }

  /** One of the values of `[weight, value]` pairs, the heavier the more often. */
  weighed(pairs) {
    let left = this.roll(pairs.reduce((sum, [weight]) => sum + weight, 0));
    for (const [weight, value] of pairs) {
      left -= weight;
      if (left < 0) {
        return value;
      }
    }
    return undefined;
  }
}
