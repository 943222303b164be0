"""Renders a scene with Mitsuba's vectorised mode each time a line comes in, of a seed and perhaps other samples and a file for the picture, and answers with wall and processor seconds."""
import sys
import time

import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")
scene = mi.load_file(sys.argv[1])
print(mi.__version__, flush=True)
for line in sys.stdin:
    words = line.split()
    seed, samples, file = int(words[0]), int(words[1] if len(words) > 1 else sys.argv[2]), words[2] if len(words) > 2 else ""
    wall, processor = time.perf_counter(), time.process_time()
    picture = np.array(mi.render(scene, spp=samples, seed=seed))
    seconds = time.perf_counter() - wall, time.process_time() - processor
    if file:
        mi.Bitmap(picture).write(file)
    print(*seconds, flush=True)
