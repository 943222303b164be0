import { dismiss, messages } from "../state/messages";
import { texts } from "../texts";
import { Button } from "../ui/Button";

/** Messages over the window, read out as they come. */
export function Messages() {
  return (
    <div class="messages" role="log" aria-live="polite" aria-label={texts.messages.label}>
      {messages.value.map((m) => (
        <div class={`message ${m.kind}`} role={m.kind === "error" ? "alert" : "status"} key={m.id}>
          <span>{m.text}</span>
          <Button label={texts.messages.dismiss} icon="close" onClick={() => dismiss(m.id)} />
        </div>
      ))}
    </div>
  );
}
