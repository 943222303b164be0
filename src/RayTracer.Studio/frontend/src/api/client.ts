/** Requests to the server that this page came from. Each carries the secret of this launch. */

import type { Json } from "./types";

const tokenName = "studio-token";

/** An answer that says no; `body` is what the server sent with it. */
export class Refusal extends Error {
  constructor(readonly status: number, message: string, readonly body: Record<string, Json>) {
    super(message);
  }
}

/** The secret arrives in the address's fragment, which no server sees; it is kept for reloads and taken out of the address bar. */
function takeToken(): string {
  const inAddress = /[#&]token=([\w.~+/=-]+)/.exec(location.hash)?.[1];
  if (inAddress) {
    sessionStorage.setItem(tokenName, inAddress);
    const rest = location.hash.replace(/[#&]token=[^&]*/, "").replace(/^[#&]/, "");
    history.replaceState(null, "", location.pathname + (rest && `#${rest}`));
  }
  return inAddress ?? sessionStorage.getItem(tokenName) ?? "";
}

export const token = takeToken();

// Whether the server has taken the secret: one of an earlier launch is of no use to others.
let isKnown = false;

/** A link to a pixel, on a slide say, has no secret: another window of this browser on the same Studio gives it. Nobody else hears the question. */
export function shareToken(): void {
  const windows = new BroadcastChannel("studio-windows");
  windows.onmessage = ({ data }: MessageEvent<{ wants?: boolean; token?: string }>) => {
    if (data.wants && isKnown) windows.postMessage({ token });
    if (data.token && !token && !sessionStorage.getItem(tokenName)) {
      sessionStorage.setItem(tokenName, data.token);
      location.reload();
    }
  };
  if (!token) windows.postMessage({ wants: true });
}

export type Query = Record<string, string | number | null | undefined>;

export function address(path: string, query: Query = {}): string {
  const given = Object.entries(query).filter(([, value]) => value !== null && value !== undefined);
  const text = new URLSearchParams(given.map(([key, value]) => [key, String(value)])).toString();
  return `/api/${path}${text ? `?${text}` : ""}`;
}

async function send(url: string, init: RequestInit): Promise<Response> {
  const headers = new Headers(init.headers);
  headers.set("X-Studio-Token", token);
  const response = await fetch(url, { ...init, headers });
  isKnown ||= response.ok;
  if (response.ok) return response;
  const text = await response.text();
  let body: Record<string, Json> = {};
  try {
    body = JSON.parse(text) as Record<string, Json>;
  } catch {
    // A refusal by the guard is plain text.
  }
  throw new Refusal(response.status, typeof body.error === "string" ? body.error : text || response.statusText, body);
}

export async function get<T>(path: string, query?: Query, signal?: AbortSignal): Promise<T> {
  return (await (await send(address(path, query), signal ? { signal } : {})).json()) as T;
}

export async function getBlob(path: string, query?: Query): Promise<Blob> {
  return (await send(address(path, query), {})).blob();
}

export async function post<T = { revision: number }>(path: string, body: object = {}): Promise<T> {
  const response = await send(address(path), {
    method: "POST",
    body: JSON.stringify(body),
    headers: { "Content-Type": "application/json" },
  });
  const text = await response.text();
  return (text ? JSON.parse(text) : {}) as T;
}

export async function upload<T>(path: string, query: Query, bytes: Blob): Promise<T> {
  const headers = { "Content-Type": "application/octet-stream" };
  return (await (await send(address(path, query), { method: "POST", body: bytes, headers })).json()) as T;
}

/** Reports to the server that the window closes; beacons cannot carry headers, so the secret goes in the body. */
export function sayGoodbye(): void {
  navigator.sendBeacon("/api/bye", token);
}
