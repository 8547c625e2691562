"""The network: its shape, its training half in torch, its file and the runtime without torch."""
