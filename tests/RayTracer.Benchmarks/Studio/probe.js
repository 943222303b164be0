// What is measured within the page, so that nothing of the tools that drive the browser is counted.
() => {
  const canvas = document.querySelector("canvas.picture");
  const stage = document.querySelector("[role=application]");
  const box = () => canvas.getBoundingClientRect();
  const point = (kind, x, y, buttons) => new PointerEvent(kind, {
    bubbles: true, cancelable: true, composed: true, pointerId: 1, pointerType: "mouse", isPrimary: true,
    clientX: x, clientY: y, button: kind === "pointermove" ? -1 : 0, buttons });
  const send = (kind, x, y, buttons) => stage.dispatchEvent(point(kind, x, y, buttons));
  const sleep = ms => new Promise(done => setTimeout(done, ms));

  // Seconds until the next painted frame of which something is so.
  const painted = (isIt, limit = 5000) => new Promise(done => {
    const start = performance.now();
    const watch = new MutationObserver(() => {
      if (!isIt(canvas.dataset)) return;
      watch.disconnect();
      done(performance.now() - start);
    });
    watch.observe(canvas, { attributes: true, attributeFilter: ["data-painted"] });
    setTimeout(() => { watch.disconnect(); done(limit); }, limit);
  });
  stage.setPointerCapture = () => {};
  stage.releasePointerCapture = () => {};
  const frame = () => new Promise(requestAnimationFrame);

  window.probe = {
    async orbit(seconds) {
      const { left, top, width, height } = box();
      const [x, y] = [left + width / 2, top + height / 2];
      send("pointerdown", x, y, 1);
      const before = Number(canvas.dataset.painted);
      const start = performance.now();
      for (let i = 0; performance.now() - start < seconds * 1000; i++) {
        await frame();
        send("pointermove", x + 60 * Math.sin(i / 20), y + 20 * Math.cos(i / 20), 1);
      }
      const rate = (Number(canvas.dataset.painted) - before) / ((performance.now() - start) / 1000);
      send("pointerup", x, y, 0);
      await sleep(600);
      return rate;
    },
    async drags(count) {
      const { left, top, width, height } = box();
      const [x, y] = [left + width / 2, top + height / 2];
      send("pointerdown", x, y, 1);
      send("pointermove", x + 8, y, 1);
      await sleep(300);
      const times = [];
      for (let i = 0; i < count; i++) {
        const seen = painted(d => d.preview === "true");
        send("pointermove", x + 10 + 3 * i, y, 1);
        times.push(await seen);
        await sleep(120 + 7 * (i % 9));
      }
      send("pointerup", x, y, 0);
      await sleep(600);
      return times;
    },
    async releases(count) {
      const times = [];
      for (let i = 0; i < count; i++) {
        const { left, top, width, height } = box();
        const [x, y] = [left + width / 2, top + height / 2];
        send("pointerdown", x, y, 1);
        for (let j = 0; j < 12; j++) {
          await frame();
          send("pointermove", x + 4 * j, y, 1);
        }
        const seen = painted(d => d.preview === "false");
        send("pointerup", x + 44, y, 0);
        times.push(await seen);
        await sleep(400);
      }
      return times;
    },
    async colours(count) {
      const field = document.querySelector("input[type=color]");
      const times = [];
      for (let i = 0; i < count; i++) {
        const seen = painted(() => true);
        field.value = `#${(0x406080 + i * 0x0a0503).toString(16)}`;
        field.dispatchEvent(new Event("input", { bubbles: true }));
        times.push(await seen);
        await sleep(2500);
      }
      return times;
    },
  };
}
