/** JSON pointers (RFC 6901). */

import type { Json } from "../api/types";

export const escapeKey = (key: string) => key.replaceAll("~", "~0").replaceAll("/", "~1");
export const unescapeKey = (key: string) => key.replaceAll("~1", "/").replaceAll("~0", "~");

export const join = (pointer: string, ...keys: (string | number)[]) =>
  pointer + keys.map((key) => `/${escapeKey(String(key))}`).join("");

export const split = (pointer: string): string[] => (pointer === "" ? [] : pointer.slice(1).split("/").map(unescapeKey));

export const parent = (pointer: string) => pointer.slice(0, Math.max(0, pointer.lastIndexOf("/")));

export const last = (pointer: string) => unescapeKey(pointer.slice(pointer.lastIndexOf("/") + 1));

/** Whether `inner` is `outer` or a part of it. */
export const contains = (outer: string, inner: string) => inner === outer || inner.startsWith(`${outer}/`);

/** The value at a pointer; undefined where there is none. */
export function at(value: Json | undefined, pointer: string): Json | undefined {
  for (const key of split(pointer)) {
    if (value === null || typeof value !== "object") return undefined;
    value = Array.isArray(value) ? value[Number(key)] : value[key];
  }
  return value;
}
