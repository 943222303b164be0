/** Paints at most once in each frame of the screen, and always the newest picture. */
export class Painter<T> {
  private newest: T | undefined;

  constructor(
    private readonly schedule: (paint: () => void) => void,
    private readonly paint: (picture: T) => void,
  ) {}

  push(picture: T): void {
    const isScheduled = this.newest !== undefined;
    this.newest = picture;
    if (isScheduled) return;
    this.schedule(() => {
      const picture = this.newest!;
      this.newest = undefined;
      this.paint(picture);
    });
  }
}
