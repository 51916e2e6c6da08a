"""cost.py SCENE FRAMES: as cost.cpp, from Python."""
import sys
import time

import numpy as np
import taut

cloth = taut.Cloth(sys.argv[1], threads=1)
out = np.empty((cloth.info.vertex_count, 3), np.float32)
begin = time.process_time()
for _ in range(int(sys.argv[2])):
    frame = cloth.step()
    cloth.positions(out)
print(f'Python: {1000 * (time.process_time() - begin) / int(sys.argv[2]):.3f} ms, {frame.state_hash:016x}')
