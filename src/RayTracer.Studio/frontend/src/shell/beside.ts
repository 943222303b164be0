interface Size {
  width: number;
  height: number;
}

interface Frame extends Size {
  left: number;
  top: number;
}

const gap = 12;

/** Where a box hides nothing of what it explains: below, above, to the right or to the left of it; in its lower corner where there is no room. */
export function besideFrame(frame: Frame, box: Size, window: Size): { left: number; top: number } {
  const within = (value: number, size: number, limit: number) => Math.max(gap, Math.min(value, limit - size - gap));
  const [right, bottom] = [frame.left + frame.width, frame.top + frame.height];
  const across = within(frame.left + (frame.width - box.width) / 2, box.width, window.width);
  const down = within(frame.top + (frame.height - box.height) / 2, box.height, window.height);
  if (bottom + box.height + 2 * gap <= window.height) return { left: across, top: bottom + gap };
  if (frame.top >= box.height + 2 * gap) return { left: across, top: frame.top - box.height - gap };
  if (right + box.width + 2 * gap <= window.width) return { left: right + gap, top: down };
  if (frame.left >= box.width + 2 * gap) return { left: frame.left - box.width - gap, top: down };
  return { left: within(right - box.width - gap, box.width, window.width), top: within(bottom - box.height - gap, box.height, window.height) };
}
