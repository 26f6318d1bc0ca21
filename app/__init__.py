"""The page: what-if exploration of tyre/road contact in a browser (`panel serve app`)."""
