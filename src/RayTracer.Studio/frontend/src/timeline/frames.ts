/** The frame that is shown, as the timeline and keys change it. */

import { post } from "../api/client";
import { Latest } from "../api/latest";
import { attempt, complain } from "../state/messages";
import { time } from "../state/store";

const showing = new Latest<number>((frame) => post("timeline/frame", { frame }), complain);

/** Shows a frame. While one is on its way, only the newest waits. */
export const showFrame = (frame: number) => showing.push(Math.max(0, Math.round(frame)));

export const stepFrame = (by: number) => showFrame((time.value?.frame ?? 0) + by);

export const togglePlay = () => attempt(() => post("timeline/play", { isPlaying: !time.value?.isPlaying }));
