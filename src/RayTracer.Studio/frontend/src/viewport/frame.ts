/** The wire format of a frame: 32 bytes of header, little endian, then RGBA rows from the top. */

export const headerSize = 32;
const magic = 0x31465452; // "RTF1"

export interface FrameHeader {
  version: number;
  width: number;
  height: number;
  /** Of the whole picture; a preview is smaller. */
  pictureWidth: number;
  pictureHeight: number;
  isPreview: boolean;
  isLast: boolean;
  samples: number;
  /** The number of the document that it shows, up to 24 bits. */
  document: number;
}

export function readHeader(bytes: ArrayBuffer): FrameHeader {
  if (bytes.byteLength < headerSize) throw new Error("The frame is shorter than its header.");
  const view = new DataView(bytes);
  const number = (i: number) => view.getUint32(4 * i, true);
  if (number(0) !== magic) throw new Error("This is not a frame.");
  const flags = number(6);
  const header = {
    version: number(1),
    width: number(2),
    height: number(3),
    pictureWidth: number(4),
    pictureHeight: number(5),
    isPreview: (flags & 1) !== 0,
    isLast: (flags & 2) !== 0,
    samples: number(7),
    document: flags >>> 8,
  };
  if (bytes.byteLength !== headerSize + 4 * header.width * header.height) throw new Error("The size of the frame differs from its header.");
  return header;
}
