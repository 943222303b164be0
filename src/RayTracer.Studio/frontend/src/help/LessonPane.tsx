import { texts } from "../texts";
import { Button } from "../ui/Button";
import { HelpArticle, type Place } from "./HelpArticle";
import { isLesson, lesson, readBeside } from "./lesson";
import { helpAt } from "../state/store";

/** A lesson beside its scene, which follows what is tried. */
export function LessonPane() {
  const go = (place: Place) => {
    if (isLesson(place.page)) readBeside(place.page);
    else helpAt.value = place;
  };
  return (
    <div class="lesson-pane">
      <Button label={texts.left.closeLesson} showLabel kind="plain" icon="close" onClick={() => (lesson.value = "")} />
      <HelpArticle place={{ page: lesson.value }} go={go} />
    </div>
  );
}
