"""``swifttailor``, whose studio's workers load no networks before they are asked for something."""

import sys

if __name__ == "__main__":  # workers run this file again, under another name
    from swifttailor.cli.main import run
    from swifttailor.studio import service
    from swifttailor.studio.worker.handle import Worker

    service.Worker = lambda **options: Worker(**options | {"warm": False})
    sys.exit(run(sys.argv[1:]))
