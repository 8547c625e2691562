"""How a garment is to look by a text: colours, prints, ribs and flecks."""
