"""The theory behind the page: one file a chapter, in Markdown with equations in TeX."""
