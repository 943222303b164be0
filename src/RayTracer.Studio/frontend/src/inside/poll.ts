import { useEffect, useState } from "preact/hooks";
import { get } from "../api/client";
import { complain } from "../state/messages";

/** Asks again and again while the component is shown. */
export function usePoll<T>(path: string, milliseconds: number): T | null {
  const [answer, setAnswer] = useState<T | null>(null);
  useEffect(() => {
    let timer = 0;
    let isGone = false;
    const ask = async () => {
      try {
        const now = await get<T>(path);
        if (!isGone) setAnswer(now);
      } catch (error) {
        complain(error);
      }
      if (!isGone) timer = window.setTimeout(() => void ask(), milliseconds);
    };
    void ask();
    return () => {
      isGone = true;
      clearTimeout(timer);
    };
  }, [path, milliseconds]);
  return answer;
}
