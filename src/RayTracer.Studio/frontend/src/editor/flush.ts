let flush: () => Promise<void> = () => Promise.resolve();

/** The editor says how to send what was typed and is not on the server yet. */
export const onFlush = (work: () => Promise<void>) => (flush = work);

/** Waits until the server knows all that was typed. */
export const flushEditor = () => flush();
