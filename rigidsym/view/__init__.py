"""Everything that shows: HTML, LaTeX's cards, SVG, matplotlib and plotly; one palette."""
