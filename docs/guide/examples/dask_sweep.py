#!/usr/bin/env python3
"""Maps the package of a kernel over a Dask cluster: dask_sweep.py [SAMPLES [WORKERS]]

The kernel is inputs/rotation/rotation.cpp:
    symreal generate rotation.cpp --package rotation && pip install ./rotation
A cluster of several machines needs its address in place of LocalCluster, and the package on each of them.
"""
import sys

import dask.array
import numpy
from dask.distributed import Client, LocalCluster

import rotation


def main(samples=1_000_000, workers=2):
    angles = dask.array.linspace(-numpy.pi, numpy.pi, samples, chunks=-(-samples//(4*workers)))
    inputs = angles[:, None]  # a row for each sample
    outputs = inputs.map_blocks(rotation.compute, chunks=(inputs.chunks[0], (rotation.output_count,)),
                                meta=numpy.empty((0, 0)))
    with LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        swept = outputs.compute()
        print(f"{len(swept)} samples on {len(client.scheduler_info()['workers'])} workers, largest {swept.max():.6f}")
    alone = rotation.compute(inputs.compute(scheduler="synchronous"))
    print("equal to one process:", swept.tobytes() == alone.tobytes())


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
