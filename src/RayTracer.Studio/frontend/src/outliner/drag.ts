/** Things of the outline that are dragged: their pointers go with them. */

const kind = "application/x-studio-thing";

export function dragThing(e: DragEvent, pointer: string): void {
  e.dataTransfer!.setData(kind, pointer);
  e.dataTransfer!.effectAllowed = "link";
}

/** Whether it is a thing that is dragged; which one, the browser tells when it is dropped. */
export const draggedThing = (e: DragEvent) => e.dataTransfer?.types.includes(kind) ?? false;

export const droppedThing = (e: DragEvent) => e.dataTransfer?.getData(kind) || null;
