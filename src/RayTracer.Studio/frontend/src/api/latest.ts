/** Sends one request at a time. What arrives meanwhile is merged into one waiting request, so that the newest always wins and none piles up. */
export class Latest<T> {
  private waiting: T | undefined;
  private running: Promise<void> | undefined;

  /**
   * @param send sends a request; what it throws goes to `failed`
   * @param merge joins a waiting request with a newer one; without it the newer one replaces it
   * @param rest what is waited for after each request, though another one may wait
   */
  constructor(
    private readonly send: (request: T) => Promise<unknown>,
    private readonly failed: (error: unknown) => void,
    private readonly merge: (older: T, newer: T) => T = (_, newer) => newer,
    private readonly rest?: () => Promise<void>,
  ) {}

  push(request: T): void {
    this.waiting = this.waiting === undefined ? request : this.merge(this.waiting, request);
    this.running ??= this.run();
  }

  /** Ends when nothing is under way and nothing waits. */
  async settled(): Promise<void> {
    await this.running;
  }

  private async run(): Promise<void> {
    while (this.waiting !== undefined) {
      const request = this.waiting;
      this.waiting = undefined;
      try {
        await this.send(request);
        await this.rest?.();
      } catch (error) {
        this.failed(error);
      }
    }
    this.running = undefined;
  }
}
