"""The studio: a local server and one page for studies, analyses and their results.

The page gets its parameters, analyses and results from the declarations: `haptonic.studio.form` describes the
keys, `haptonic.studio.offers` the analyses, and `haptonic.studio.answers` any result.
"""
