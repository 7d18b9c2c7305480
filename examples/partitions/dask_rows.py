"""A task over a data set in partitions, spread over the workers of a Dask cluster.

    python dask_rows.py "skid speed" OUTPUT_FOLDER FILE...

Each FILE is one partition, CSV or Parquet, with columns named as for `--rows` (`distance[ft]`, `friction`). Each
becomes a file of the same name in OUTPUT_FOLDER with the results beside the inputs: the same numbers to the bit as a
single process gives.
Needs `pip install 'dynamics-cli[dask]'`.
"""

import sys
from pathlib import Path

try:
    from dask import compute, delayed
    from dask.distributed import Client, LocalCluster
except ImportError:
    sys.exit("this script needs Dask: pip install 'dynamics-cli[dask]'")

from dynamics_cli import run_rows


def answer(command: str, source: str, target: str) -> str:
    """Answer one partition, on whichever worker."""
    if not source.endswith(".parquet"):
        Path(target).write_bytes(run_rows(command, Path(source).read_bytes()))
        return target
    from pyarrow import BufferOutputStream, BufferReader, csv, parquet

    # The shortest text of a double reads back as that double, so going by CSV changes no number.
    rows = BufferOutputStream()
    csv.write_csv(parquet.read_table(source), rows)
    answers = run_rows(command, rows.getvalue().to_pybytes())
    parquet.write_table(csv.read_csv(BufferReader(answers)), target)
    return target


def main() -> None:
    """Answer every partition on a local cluster; on another one, give its address to `Client`."""
    if len(sys.argv) < 4:
        sys.exit('usage: python dask_rows.py "skid speed" OUTPUT_FOLDER FILE...')
    command, folder, *files = sys.argv[1:]
    Path(folder).mkdir(parents=True, exist_ok=True)
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster):
        work = [delayed(answer)(command, file, str(Path(folder) / Path(file).name)) for file in files]
        for target in compute(*work):
            print(target)


if __name__ == "__main__":
    main()
