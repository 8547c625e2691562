"""The studio: pattern and garment side by side in a browser, served from this machine.

In here: `models` (what is asked and answered), `worker` (processes that work), `bench` (the work), `app` (the
web side). The client is built from studio-ui/ into client/. May import every room below cli.
"""
