"""The web side of the studio: who may ask, what is asked, where it goes."""
