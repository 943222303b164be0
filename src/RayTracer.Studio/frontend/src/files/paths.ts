/** Paths of files, with the separators of whatever system the server runs on. */

const separator = (path: string) => (path.includes("\\") && !path.includes("/") ? "\\" : "/");

export const folderOf = (path: string) => path.slice(0, Math.max(0, path.lastIndexOf(separator(path))));
export const nameOf = (path: string) => path.slice(path.lastIndexOf(separator(path)) + 1);
export const joinPath = (folder: string, name: string) => (folder.endsWith(separator(folder)) ? folder + name : folder + separator(folder) + name);

/** The extension in lower case, without the dot; empty where there is none. */
export function extensionOf(path: string): string {
  const name = nameOf(path);
  const dot = name.lastIndexOf(".");
  return dot > 0 ? name.slice(dot + 1).toLowerCase() : "";
}

export const withExtension = (path: string, extension: string) => {
  const old = extensionOf(path);
  return `${old ? path.slice(0, -old.length - 1) : path}.${extension}`;
};

/** A path as a scene file should write it: from the scene's folder, if both lie on the same root; with slashes. */
export function relativeTo(scene: string | null, path: string): string {
  const target = path.replaceAll("\\", "/").split("/");
  const from = scene?.replaceAll("\\", "/").split("/").slice(0, -1);
  if (!from || from[0] !== target[0]) return target.join("/");
  let shared = 0;
  while (shared < from.length && shared < target.length - 1 && from[shared] === target[shared]) shared++;
  if (shared <= 1) return target.join("/");
  return [...from.slice(shared).map(() => ".."), ...target.slice(shared)].join("/");
}
