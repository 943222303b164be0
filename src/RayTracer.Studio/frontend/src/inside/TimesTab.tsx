import { texts } from "../texts";
import { usePoll } from "./poll";

interface TimesAnswer {
  rows: { figure: string; settings: string; reportSeconds: number; seconds: number | null }[];
}

/** The report's times beside this machine's. */
export function TimesTab() {
  const answer = usePoll<TimesAnswer>("times", 2000);
  return <div class="pad">{answer?.rows?.length ?? texts.times.none}</div>;
}
