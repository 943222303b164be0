"""Renders a scene with Mitsuba's vectorised mode each time a line with a seed comes in, and answers with wall and processor seconds."""
import sys
import time

import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")
scene = mi.load_file(sys.argv[1])
samples = int(sys.argv[2])
print(mi.__version__, flush=True)
for line in sys.stdin:
    wall, processor = time.perf_counter(), time.process_time()
    np.array(mi.render(scene, spp=samples, seed=int(line)))
    print(time.perf_counter() - wall, time.process_time() - processor, flush=True)
