import { useEffect, useState } from "preact/hooks";
import { get, Refusal } from "../api/client";
import type { PropertyValues } from "../api/types";
import { complain } from "../state/messages";
import { revision } from "../state/store";

/** What stands at a place of the document, asked for again whenever the text changes; null until it is known. */
export function useValue(pointer: string | null): PropertyValues | null {
  const [answer, setAnswer] = useState<PropertyValues | null>(null);
  const now = revision.value;
  useEffect(() => {
    if (pointer === null || now < 0) return setAnswer(null);
    const abort = new AbortController();
    get<PropertyValues>("value", { pointer }, abort.signal).then(setAnswer, (error: unknown) => {
      // The place may be gone: deleted, or the text has an error just now.
      if (!(error instanceof Refusal)) complain(error);
      else if (error.status === 404) setAnswer(null);
    });
    return () => abort.abort();
  }, [pointer, now]);
  return answer?.pointer === pointer ? answer : null;
}
