/**
 * How often a hand's moves are sent: a little more often than pictures come. Further requests would show nothing, and each takes some milliseconds of the
 * processor from the pictures (measured: 5 on the way through browser and server).
 */

const longest = 50;

// So that a picture begins with a move that is not older than this part of the time between two.
const part = 0.75;

/** The time from a picture to the next while something moves, in milliseconds, and the rests that depend on it. */
export class Pace {
  private between = 0;
  private last = -Infinity;
  private wake: (() => void) | undefined;
  private isUrgent = false;

  /** A picture has been painted. */
  painted(now: number): void {
    const gone = Math.min(now - this.last, longest / part);
    this.between += (gone - this.between) * 0.3;
    this.last = now;
  }

  /** Waits until the next move may be sent. */
  async rest(): Promise<void> {
    if (!this.isUrgent) {
      await new Promise<void>((resolve) => {
        this.wake = resolve;
        setTimeout(resolve, this.between * part);
      });
    }
    this.wake = undefined;
    this.isUrgent = false;
  }

  /** Ends the rest, or the one that a request under way would have: what is sent next must not wait. */
  hurry(): void {
    this.isUrgent = true;
    this.wake?.();
  }
}

export const pace = new Pace();
