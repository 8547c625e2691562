"""Layers of a PDF that a reader can show and hide: optional content groups (ISO 32000-1, 8.11).

reportlab has no name for them, so its objects are given the entries: a form that is drawn belongs to a group,
and the document's catalog lists the groups.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from swifttailor.making.drawing import Drawing
from swifttailor.making.pdf_canvas import draw, printable


class PdfLayers:
    """Forms of a canvas, each in a layer of its own or in none."""

    def __init__(self, canvas: Any, box: tuple[float, float, float, float]) -> None:
        """Prepares a canvas.

        Args:
            canvas: Of reportlab.
            box: Left, bottom, right and top of all that is drawn, points.
        """
        self._canvas, self._box = canvas, box
        self._groups: list[Any] = []
        self.forms: list[str] = []
        """Names of the forms, in the order in which they are drawn."""

    def add(self, whole: Drawing) -> None:
        """Draws something once, to be placed on many pages; into the layer that it names, if it does."""
        from reportlab.pdfbase.pdfdoc import PDFDictionary, PDFName, PDFStream, PDFString, xObjectName

        name = f"sheet{len(self.forms)}"
        left, bottom, right, top = self._box
        self._canvas.beginForm(name, left, bottom, right, top)
        draw(self._canvas, whole)
        self._canvas.endForm()
        self.forms.append(name)
        if not whole.layer:
            return
        document = self._canvas._doc
        group = PDFDictionary({"Type": PDFName("OCG"), "Name": PDFString(printable(f"Size {whole.layer}"))})
        reference = document.Reference(group, f"layer{len(self._groups)}")
        self._groups.append(reference)
        form = document.idToObject[xObjectName(name)]
        form.Contents = PDFStream(content=form.stream)
        form.Contents.dictionary["OC"] = reference

    def finish(self) -> None:
        """Tells the document of its layers, all of them shown."""
        from reportlab.pdfbase.pdfdoc import PDFArray, PDFDictionary, PDFString

        if not self._groups:
            return
        catalog = self._canvas._doc.Catalog
        shown = PDFDictionary(
            {"Name": PDFString("Sizes"), "Order": PDFArray(self._groups), "ON": PDFArray(self._groups)}
        )
        catalog.OCProperties = PDFDictionary({"OCGs": PDFArray(self._groups), "D": shown})
        catalog.__NoDefault__ = [*_entries(catalog), "OCProperties"]


def _entries(catalog: Any) -> Sequence[str]:
    return list(catalog.__NoDefault__)
